"""What an author of another course gets wrong: each a sentence with file, key and remedy."""

import re
import shutil
from pathlib import Path

import pytest

from gripcourse.course.check import check_course
from gripcourse.course.read import read_course
from gripcourse.policy.load import read_policy
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.init import empty_course

COURSE = "variants/course.toml"
SCHEME = "variants/schemes/rod/scheme.toml"
POLICY = "grader/policy.toml"
PART = "variants/sections/tension.toml"
SPEED = """
[quantity.extra]
section = "loads"
kind = "formula"
symbol = "x"
unit = "kg*m"
formula = "FORMULA"
bounds = [0, 1e9]
source = { work = "textbook" }
title = { en = "x", ru = "x", uk = "x" }
"""
Edit = tuple[str, str, str]


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("sound") / "course"
    empty_course(root, bytes(32), Words("en"))
    return root


def problems(root: Path) -> list[tuple[str, str, str]]:
    course, found = read_course(root)
    assert course is not None
    found = [*found, *check_course(course), *read_policy(course)[1]]
    assert all(str(one.remedy) for one in found)
    return [(one.file, str(one.key), str(one.what)) for one in found]


@pytest.mark.parametrize(
    ("edits", "file", "key", "what"),
    [
        pytest.param([(SCHEME, 'symbol = "m"\n', "")],
                     SCHEME, "quantity.mass.symbol", "missing", id="no symbol"),
        pytest.param([(COURSE, r"\[constant\.gravity\].*?\n\n", "")],
                     SCHEME, "quantity.load.formula", "'gravity' is not known", id="no constant"),
        pytest.param([(COURSE, r"\[constant\.gravity\].*?\n\n", "")],
                     POLICY, "rounding.habits.gravity", "means nothing", id="its habits"),
        pytest.param([(COURSE, r'unit = "m/s\*\*2"', 'unit = "m/s^2s"')],
                     COURSE, "constant.gravity.unit", "m/s^2s", id="unit of what has habits"),
        pytest.param([(SCHEME, '"tension"', '"tention"')],
                     SCHEME, "parts", "'tention'", id="no such part"),
        pytest.param([(COURSE, r"\[title\]", 'convention = "as_printed"\n[title]')],
                     COURSE, "convention", "lists no errata", id="no erratum"),
        pytest.param([(COURSE, r"\[\[section\]\].*?\n\n", "")],
                     COURSE, "section", "has no section", id="no section"),
        pytest.param([(COURSE, 'id = "sizes"', 'id = "loads"')],
                     COURSE, "section[2].id", "Two sections have", id="one section twice"),
        pytest.param([(POLICY, "loads = 40\n", "")],
                     POLICY, "points.section.loads", "has no points", id="section without points"),
        pytest.param([(POLICY, "loads = 40", "loads = 0"), (POLICY, "sizes = 60", "sizes = 0")],
                     POLICY, "points.section", "No section has points", id="nothing has points"),
        pytest.param([(SCHEME, 'section = "loads"', 'section = "sizes"'),
                      ("variants/sections/tension.toml", 'section = "loads"', 'section = "sizes"')],
                     POLICY, "points.section.loads", "anything to mark", id="empty section"),
        pytest.param([(COURSE, r"\[title\]", '[[note]]\nquantities=["mas"]\ntext = "."\n[title]')],
                     COURSE, "note[1].quantities", "no quantity 'mas'", id="note on nothing"),
        pytest.param([(COURSE, r"\[title\]", '[[note]]\nschemes = ["red"]\ntext = "."\n[title]')],
                     COURSE, "note[1].schemes", "no scheme 'red'", id="note on no scheme"),
        pytest.param([(COURSE, r"\[title\]", '[[note]]\ndocuments = ["x"]\ntext = "."\n[title]')],
                     COURSE, "note[1].documents", "not printed in 'x'", id="note nowhere"),
        pytest.param([(SCHEME, "$", '[kinematics]\ndrive = "x"\nunit = "mm"\n[kinematics.at]\n')],
                     SCHEME, "kinematics.at", "has no position", id="motion without positions"),
        pytest.param([(SCHEME, "$", '[kinematics]\ndrive = "x"\nunit = "mm"\nat.up = "0*load"\n')],
                     SCHEME, "kinematics.at.up", "no position 'up'", id="unknown position"),
        pytest.param([(COURSE, "$", '[position.a]\ntitle = "a"\nline = "thick"\n'),
                      (COURSE, "$", '[position.b]\ntitle = "b"\nline = "thick"\n')],
                     COURSE, "position.b.line", "thick lines: a, b", id="two main positions"),
    ],
)  # fmt: skip
def test_it_is_told(
    sound: Path, tmp_path: Path, edits: list[Edit], file: str, key: str, what: str
) -> None:
    root = tmp_path / "course"
    shutil.copytree(sound, root)
    for name, old, new in edits:
        path = root / name
        text = path.read_text(encoding="utf-8")
        changed = text + new if old == "$" else re.sub(old, new, text, flags=re.DOTALL)
        assert changed != text
        path.write_text(changed, encoding="utf-8")
    found = problems(root)
    assert [one for one in found if one[:2] == (file, key) and what in one[2]], found


def test_one_given_has_one_unit_in_all_schemes(sound: Path, tmp_path: Path) -> None:
    root = tmp_path / "course"
    shutil.copytree(sound, root)
    folder = root / "variants" / "schemes"
    shutil.copytree(folder / "rod", folder / "bar")
    path = folder / "bar" / "scheme.toml"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace('id = "rod"', 'id = "bar"').replace('"kg"', '"g"'), "utf-8")
    ((file, key, what),) = problems(root)
    assert (file, key) == (SCHEME, "quantity.mass.unit")
    assert "'g' in variants/schemes/bar/scheme.toml" in what


@pytest.mark.parametrize("text", ["", "# to be written\n"])
def test_a_part_that_declares_nothing_is_one_problem_with_what_its_schemes_lack(
    sound: Path, tmp_path: Path, text: str
) -> None:
    root = tmp_path / "course"
    shutil.copytree(sound, root)
    (root / PART).write_text(text, encoding="utf-8")
    scheme = (root / SCHEME).read_text(encoding="utf-8")
    scheme += SPEED.replace("FORMULA", "mass*diameter + safety*diameter*mass")
    (root / SCHEME).write_text(scheme, encoding="utf-8")
    course, found = read_course(root)
    assert course is not None
    (told,) = (one for one in [*found, *check_course(course)] if one.file != POLICY)
    assert (told.file, str(told.key)) == (PART, "")
    assert "lack 2 names: diameter, safety." in str(told.what)


def test_an_empty_scheme_lacks_its_own_keys_and_nothing_that_is_drawn_of_it(
    sound: Path, tmp_path: Path
) -> None:
    root = tmp_path / "course"
    shutil.copytree(sound, root)
    (root / SCHEME).write_text("", encoding="utf-8")
    drawing = root / SCHEME.replace("scheme.toml", "diagram.toml")
    drawing.write_text('[point]\na = ["diameter", "diameter"]\n', encoding="utf-8")
    assert {key for file, key, _ in problems(root) if file == SCHEME} == {"id", "title", "task"}
    assert not [one for one in problems(root) if "diameter" in one[2]]


def test_a_constant_that_is_called_otherwise_now_is_suggested(sound: Path, tmp_path: Path) -> None:
    root = tmp_path / "course"
    shutil.copytree(sound, root)
    course_file = root / COURSE
    written = course_file.read_text(encoding="utf-8")
    course_file.write_text(written.replace("constant.gravity", "constant.gravitation"), "utf-8")
    course, _ = read_course(root)
    assert course is not None
    (told,) = check_course(course)
    assert str(told.remedy) == "Did you mean 'gravitation'?"


def test_a_percentage_beside_a_number_in_a_verdict_is_to_be_declared_as_a_share(
    sound: Path, tmp_path: Path
) -> None:
    root = tmp_path / "course"
    shutil.copytree(sound, root)
    part = (root / PART).read_text(encoding="utf-8")
    part = part.replace("stress <= allowed_stress", "0.05 <= extra and extra <= 0.35")
    (root / PART).write_text(part, encoding="utf-8")
    scheme = (root / SCHEME).read_text(encoding="utf-8")
    scheme += SPEED.replace("FORMULA", "stress/allowed_stress").replace('"kg*m"', '"%"')
    (root / SCHEME).write_text(scheme, encoding="utf-8")
    course, _ = read_course(root)
    assert course is not None
    (told,) = check_course(course)
    assert str(told.remedy).startswith("Declare extra as a share, without a unit")
