import re
import stat
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.quantity import Convention
from gripcourse.course.read import read_course
from gripcourse.errors import UsageError
from gripcourse.issuing.signature import key_path, read_key
from gripcourse.machine.resources import COURSE_FOLDERS, course_root, skeleton_root
from gripcourse.policy.load import read_policy
from gripcourse.simulation.mix import read_mix
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.usecases.authoring import init
from gripcourse.usecases.authoring.init import empty_course, init_course
from gripcourse.variants.space import load_spaces

SECRET = bytes(range(32))
WORDS = Words("en")


def files_below(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def test_every_file_of_the_reference_course_is_copied_unchanged(tmp_path: Path) -> None:
    init_course(tmp_path / "mine", SECRET, WORDS, with_templates=True)
    for name in COURSE_FOLDERS:
        original = files_below(course_root() / name)
        assert original
        assert files_below(tmp_path / "mine" / name) == original


def test_templates_stay_with_the_program_until_somebody_changes_them(tmp_path: Path) -> None:
    """A copy would stay as it is when the program's become others, and fail with them."""
    init_course(tmp_path / "first", SECRET, WORDS)
    assert not (tmp_path / "first" / "templates").exists()
    own = {"student.html.j2": "<p>ours</p>", "style/ours.css": "p {}"}
    for name, text in own.items():
        path = tmp_path / "first" / "templates" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    same = (course_root() / "templates" / "cohort.html.j2").read_bytes()
    (tmp_path / "first" / "templates" / "cohort.html.j2").write_bytes(same)
    init_course(tmp_path / "second", SECRET, WORDS, source=tmp_path / "first")
    assert files_below(tmp_path / "second" / "templates").keys() == own.keys()
    init_course(tmp_path / "third", SECRET, WORDS, tmp_path / "first", with_templates=True)
    third = files_below(tmp_path / "third" / "templates")
    assert third.keys() == files_below(course_root() / "templates").keys() | own.keys()
    assert third["student.html.j2"] == b"<p>ours</p>"


def test_the_copy_is_a_course_itself(tmp_path: Path) -> None:
    init_course(tmp_path / "first", SECRET, WORDS)
    init_course(tmp_path / "second", SECRET, WORDS, source=course_root(tmp_path / "first"))
    second = files_below(tmp_path / "second")
    roster = {"variants/roster.csv"}
    assert files_below(tmp_path / "first").keys() - second.keys() == roster


def test_nobody_elses_students_are_taken_over(tmp_path: Path) -> None:
    source = tmp_path / "theirs"
    empty_course(source, bytes(32), WORDS)
    lists = ("students 2026.xlsx", "roster.xls", "roster.csv.bak", ".~lock.roster.csv#", "list.txt")
    for name in (*lists, "rosters/41.csv", "../grader/marks.csv", "catalogues/~$list.xlsx"):
        path = source / "variants" / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(b"Anna")
    for name in ("register.json", "gradebook.sqlite"):
        (source / "private" / name).write_text("Anna", encoding="utf-8")
    left = init_course(tmp_path / "mine", SECRET, WORDS, source=source)
    assert {"variants/roster.xls", "variants/rosters/", "grader/marks.csv"} < set(left)
    assert len(left) == len(lists) + 3
    mine, theirs = files_below(tmp_path / "mine"), files_below(source)
    assert [name for name, content in mine.items() if b"Anna" in content] == []
    assert read_key(key_path(tmp_path / "mine")) == SECRET
    assert {name for name in theirs if name.endswith(".toml")} < mine.keys()


def test_what_an_empty_course_is_made_of_is_a_course_itself() -> None:
    course, problems = read_course(skeleton_root())
    assert (course is not None, problems) == (True, [])


@pytest.mark.parametrize("language", LANGUAGES)
def test_an_empty_course_is_valid_and_explains_itself_in_one_language(
    tmp_path: Path, language: str
) -> None:
    empty_course(tmp_path / "mine", SECRET, Words(language))
    course = load_course(tmp_path / "mine")
    assert course.language == language
    assert (len(course.schemes), len(course.sections)) == (1, 2)
    assert read_policy(course)[1] == []
    assert len(load_spaces(course)) == 1
    assert read_mix(course)[1] == [], "virtual students need nothing that it does not have"
    cyrillic = re.compile("^#.*[а-яёіїєґ]", re.MULTILINE | re.IGNORECASE)
    commented = (tmp_path / "mine" / "variants" / "course.toml").read_text(encoding="utf-8")
    assert bool(cyrillic.search(commented)) == (language != "en")
    assert not re.search(r"^#(en|ru|uk) ", commented, re.MULTILINE)


def test_the_example_of_the_empty_course_comes_out(tmp_path: Path) -> None:
    empty_course(tmp_path / "mine", SECRET, WORDS)
    course = load_course(tmp_path / "mine")
    example = course.schemes["rod"].example
    assert example is not None
    plan = make_plan(course, "rod", example.options)
    values = solve_variant(plan, example.given)
    for name, (expected, difference) in example.expected[Convention.CORRECTED].items():
        assert values[name] == pytest.approx(expected, abs=difference + 1e-9)


def test_only_the_owner_reads_the_key(tmp_path: Path) -> None:
    init_course(tmp_path / "mine", SECRET, WORDS)
    key = key_path(tmp_path / "mine")
    assert read_key(key) == SECRET
    assert stat.S_IMODE(key.stat().st_mode) == 0o600


def test_version_control_leaves_the_private_folder_out(tmp_path: Path) -> None:
    init_course(tmp_path / "mine", SECRET, WORDS)
    ignored = (tmp_path / "mine" / ".gitignore").read_text(encoding="utf-8").splitlines()
    assert {"private/", "out/"} <= set(ignored)


def test_the_instructor_finds_a_guide(tmp_path: Path) -> None:
    init_course(tmp_path / "mine", SECRET, WORDS)
    guide = (tmp_path / "mine" / "README.md").read_text(encoding="utf-8")
    assert all(f"- `{name}/`: " in guide for name in COURSE_FOLDERS)


def test_missing_folders_above_are_made(tmp_path: Path) -> None:
    init_course(tmp_path / "2026" / "spring" / "mine", SECRET, WORDS)
    assert (tmp_path / "2026" / "spring" / "mine" / "grader").is_dir()


def test_an_empty_folder_is_filled_and_stays_the_same_folder(tmp_path: Path) -> None:
    target = tmp_path / "mine"
    target.mkdir()
    before = target.stat().st_ino
    init_course(target, SECRET, WORDS)
    assert target.stat().st_ino == before
    assert (target / "variants").is_dir()


def test_a_folder_in_use_is_refused_and_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("years of work", encoding="utf-8")
    with pytest.raises(UsageError, match="not empty"):
        init_course(tmp_path / "mine", SECRET, WORDS)
    assert files_below(tmp_path) == {"mine/thesis.txt": b"years of work"}


def test_a_file_of_that_name_is_refused_and_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("years of work", encoding="utf-8")
    with pytest.raises(UsageError, match="a file, not a folder"):
        init_course(tmp_path / "mine", SECRET, WORDS)
    assert files_below(tmp_path) == {"mine": b"years of work"}


def test_a_folder_below_a_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(UsageError, match="cannot be written"):
        init_course(tmp_path / "file" / "mine", SECRET, WORDS)


@pytest.mark.parametrize("exists", [False, True])
def test_nothing_is_left_behind_when_it_fails_half_way(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, exists: bool
) -> None:
    if exists:
        (tmp_path / "mine").mkdir()

    def full_disk(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(init, "write_text", full_disk)
    with pytest.raises(UsageError, match="The disk is full"):
        init_course(tmp_path / "mine", SECRET, WORDS)
    assert list(tmp_path.rglob("*")) == ([tmp_path / "mine"] if exists else [])
