"""Validating a course: every problem of every file, and nothing twice.

That the reference course has none is shown from the command line, once: it takes ten seconds. Here
the second course is broken, which is judged in two.
"""

import shutil
from collections.abc import Callable
from dataclasses import replace
from datetime import date
from pathlib import Path

import pytest
from sqlalchemy import text

from gripcourse.course.model import Course
from gripcourse.issuing.allotment import Terms, extend
from gripcourse.issuing.signature import key_path, make_key
from gripcourse.issuing.store import extend_register
from gripcourse.machine.database.home import gradebook_path
from gripcourse.machine.database.opening import open_engine
from gripcourse.usecases.authoring.check_lists import list_problems
from gripcourse.usecases.authoring.validate import scheme_problems, validated
from gripcourse.variants.model import Student, Variant

COURSE = Path(__file__).parents[3] / "examples" / "belt_drive"
SPACE = "variants/spaces/v_belt.toml"
SHAFT = "variants/sections/driven_shaft.toml"
FORCE_IN_N = 'symbol = "F_r"\nunit = "N"'


@pytest.fixture
def broken(tmp_path: Path) -> Callable[..., Path]:
    """Copy a course and replace text in its files: (file, old, new) each."""

    def make(*edits: tuple[str, str, str]) -> Path:
        root = Path(shutil.copytree(COURSE, tmp_path / "course"))
        for file, old, new in edits:
            written = (root / file).read_text(encoding="utf-8")
            assert old in written, file
            (root / file).write_text(written.replace(old, new, 1), encoding="utf-8")
        return root

    return make


def test_declarations_catalogues_and_policy_are_judged_together(
    broken: Callable[..., Path],
) -> None:
    root = broken(
        ("variants/sections/open_belt.toml", "asin((large_diameter", "asin((larg_diameter"),
        ("variants/catalogues/belt_count.csv", "# source:", "# from:"),
        ("grader/policy.toml", "total = 100", "total = 99"),
    )
    assert {(one.file, one.key) for one in validated(root).problems} == {
        ("variants/sections/open_belt.toml", "quantity.wrap_angle.formula"),
        ("variants/catalogues/belt_count.csv", "source"),
        ("grader/policy.toml", "points.section"),
    }


def test_a_changed_register_is_named_with_its_student(course: Course, tmp_path: Path) -> None:
    mine, key = replace(course, root=tmp_path), bytes(range(32))
    make_key(key_path(tmp_path), key)
    terms = Terms(key, date(2026, 9, 1), None)
    person, variant = Student("s01", "", "", "", "", ""), Variant("001", "", {}, {"mass": 55.0})
    extend_register(tmp_path, mine.id, lambda one: extend(one, [person], [variant], terms))
    assert list_problems(mine, None) == []
    with open_engine(str(gradebook_path(tmp_path))).begin() as connection:
        connection.execute(text("UPDATE register_issued SET given = '{\"mass\": 5}'"))
    (problem,) = list_problems(mine, None)
    assert str(problem.key) == "student s01"


def test_spaces_are_judged_when_the_course_is_sound(broken: Callable[..., Path]) -> None:
    space_fault = (SPACE, "[given.power]", "[given.powr]")
    found = validated(broken(space_fault)).problems
    assert found
    assert {one.file for one in found} == {SPACE}


def test_spaces_are_not_judged_against_a_broken_course(broken: Callable[..., Path]) -> None:
    root = broken(
        (SPACE, "[given.power]", "[given.powr]"),
        ("variants/sections/open_belt.toml", "asin((large_diameter", "asin((larg_diameter"),
    )
    found = validated(root)
    assert [one.file for one in found.problems] == ["variants/sections/open_belt.toml"]
    assert not found.computed


def test_numbers_and_spaces_do_not_wait_for_the_policy(broken: Callable[..., Path]) -> None:
    root = broken(
        (SPACE, "[given.power]", "[given.powr]"),
        ("variants/sections/open_belt.toml", "pi - 2*asin", "pi - 3*asin"),
        ("grader/policy.toml", "total = 100", "total = 99"),
    )
    found = validated(root)
    assert {one.file for one in found.problems} == {
        SPACE,
        "grader/policy.toml",
        "variants/schemes/flat_belt/worked_example.toml",
        "variants/schemes/v_belt/worked_example.toml",
    }
    assert not found.computed


UNKNOWN_UNIT = ("variants/schemes/v_belt/scheme.toml", 'unit = "mm"', 'unit = "mmm"')
"""Of the width of a V-belt, which decides nearly all of its drive but no angle."""


def test_a_wrong_formula_is_told_beside_a_wrong_declaration_of_something_else(
    broken: Callable[..., Path],
) -> None:
    wrong_shaft = ("variants/sections/driven_shaft.toml", '"2*total_tension', '"7*total_tension')
    found = {
        (one.file, str(one.key)) for one in validated(broken(UNKNOWN_UNIT, wrong_shaft)).problems
    }
    assert found == {
        (UNKNOWN_UNIT[0], "quantity.pitch_width.unit"),
        ("variants/schemes/flat_belt/worked_example.toml", "corrected.expected.shaft_force"),
    }, "of a V-belt the force is computed from its width"


def test_a_range_upside_down_is_told_beside_a_wrong_declaration(
    broken: Callable[..., Path],
) -> None:
    upside_down = (
        "variants/sections/driven_shaft.toml",
        "low = 30, high = 90",
        "low = 90, high = 30",
    )
    in_space = (SPACE, "low = 0.93\nhigh = 0.96", "low = 0.96\nhigh = 0.93")
    found = {
        (one.file, str(one.key))
        for one in validated(broken(UNKNOWN_UNIT, upside_down, in_space)).problems
    }
    assert found == {
        (UNKNOWN_UNIT[0], "quantity.pitch_width.unit"),
        ("variants/sections/driven_shaft.toml", "quantity.bearing_gap.range"),
        (SPACE, "given.efficiency"),
    }


def test_of_what_two_files_declare_the_two_are_told_alone(broken: Callable[..., Path]) -> None:
    title = ("variants/schemes/v_belt/scheme.toml", "[quantity.pitch_width]", SECOND_FORCE)
    found = [(one.file, str(one.key)) for one in validated(broken(title)).problems]
    assert found == [("variants/schemes/v_belt/scheme.toml", "quantity.shaft_force")]


SECOND_FORCE = """[quantity.shaft_force]
section = "shaft"
kind = "given"
symbol = "F_x"
unit = "mm"
bounds = [1, 2]
range = { values = [1, 2] }
source = { work = "textbook" }
title = "second force"

[quantity.pitch_width]"""


def test_rows_refused_for_one_wrong_formula_are_one_problem_of_the_table(
    broken: Callable[..., Path],
) -> None:
    root = broken(
        ("variants/sections/driven_shaft.toml", '"2*total_tension', '"7000*total_tension')
    )
    (told,) = [one for one in validated(root).problems if one.file == "variants/tables/main.csv"]
    assert str(told.key) == "rows 2–25 (24 in all), the first of them variant 001"
    assert "shaft_force" in str(told.what)


def test_an_example_that_does_not_come_out_is_told_with_what_was_computed(
    broken: Callable[..., Path],
) -> None:
    found = validated(broken(("variants/sections/open_belt.toml", "pi - 2*asin", "pi - 3*asin")))
    assert found.computed
    assert any("wrap_angle" in str(one.key) for one in found.problems)


def test_tables_of_variants_are_judged_with_row_and_column(broken: Callable[..., Path]) -> None:
    root = broken()
    tables = root / "variants" / "tables"
    (tables / "spare.csv").write_text("variant,scheme\n001,rack\n", encoding="utf-8")
    found = validated(root).problems
    assert found
    assert {one.file for one in found} == {"variants/tables/spare.csv"}


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("variants/sections/open_belt.toml", "asin((large_diameter", "asin((larg_diameter"),
        ("grader/policy.toml", "total = 100", "total = 99"),
        (SPACE, "[given.power]", "[given.powr]"),
        ("variants/tables/main.csv", "\n001,", "\n001,no_such_"),
    ],
)
def test_a_fault_is_found_after_the_course_was_found_sound(
    broken: Callable[..., Path], file: str, old: str, new: str
) -> None:
    root = broken()
    assert validated(root).problems == []
    path = root / file
    sound = path.read_text(encoding="utf-8")
    path.write_text(sound.replace(old, new, 1), encoding="utf-8")
    assert Path(file).name in {Path(one.file).name for one in validated(root).problems}
    path.write_text(sound, encoding="utf-8")
    assert validated(root).problems == []


# One of each kind of file that a course has, its tables apart: see above. Templates: see below.
MISTAKES = [
    ("variants/course.toml", 'id = "', 'id = 7 # "'),
    ("variants/sections/open_belt.toml", "asin((large_diameter", "asin(2*(large_diameter"),
    ("variants/schemes/flat_belt/worked_example.toml", "[49.7359,", "[94.7359,"),
    ("variants/schemes/v_belt/scheme.toml", "40*cbrt(torque_small)", "40*cbrt(torque_smal)"),
    ("variants/schemes/v_belt/drawing.toml", "v_belt.height", "v_belt.hight"),
    ("variants/published_cases.toml", "27320", "23720"),
    ("variants/proofs.toml", "torque_large*driven_speed", "torque_large*driven_sped"),
    ("variants/diagram/open_belt.toml", '"small_diameter"', '"smal_diameter"'),
    ("variants/drawing/drive.toml", "small_diameter/2", "smal_diameter/2"),
    ("variants/options/tensioning.toml", '["screw_tensioning"]', '["screw_tension"]'),
    ("variants/equilibrium/motor_base.toml", "hinge_arm_required", "hinge_arm_require"),
    ("variants/catalogues/v_belt.csv", "# source:", "# from:"),
    (SPACE, "[given.power]", "[given.powr]"),
    ("grader/policy.toml", "total = 100", "total = 99"),
]


@pytest.mark.usefixtures("same_templates")
@pytest.mark.parametrize(("file", "old", "new"), MISTAKES, ids=[file for file, _, _ in MISTAKES])
def test_a_mistake_is_told_alike_whatever_was_found_sound_before(
    broken: Callable[..., Path],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    file: str,
    old: str,
    new: str,
) -> None:
    assert validated(COURSE).problems == []
    root = broken((file, old, new))
    after = validated(root).problems
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "nothing"))
    assert after
    assert after == validated(root).problems


def test_what_a_scheme_leaves_behind_is_told_though_all_others_are_sound(
    broken: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert validated(COURSE).problems == []
    root = broken()
    shutil.rmtree(root / "variants" / "schemes" / "v_belt")
    after = validated(root).problems
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "nothing"))
    assert "There is no 'belt_power' in the course." in {str(one.what) for one in after}
    assert after == validated(root).problems


def test_a_template_is_judged_after_all_were_found_sound(broken: Callable[..., Path]) -> None:
    root = broken()
    assert validated(root).problems == []
    (root / "templates").mkdir(exist_ok=True)
    name = "assignment.html.j2"
    engine = Path(__file__).parents[3] / "templates" / name
    text_of_it = engine.read_text(encoding="utf-8") + "{{ no_such_value }}"
    (root / "templates" / name).write_text(text_of_it, encoding="utf-8")
    (problem,) = [one for one in validated(root).problems if one.file == f"templates/{name}"]
    assert "If you did not change this file, delete it" in str(problem.remedy)


def test_a_folder_without_a_course_has_one_problem(tmp_path: Path) -> None:
    [problem] = validated(tmp_path).problems
    assert (problem.file, str(problem.what)) == (
        "variants/course.toml",
        "The file is missing.",
    )


@pytest.mark.parametrize("scheme", ["plain_lever", "prism_lever"])
def test_a_scheme_alone_is_as_valid_as_the_course(course: Course, scheme: str) -> None:
    # Rules of shared options name choices that only other schemes offer.
    assert scheme_problems(course.root, scheme) == []


@pytest.mark.parametrize(
    ("edit", "key"),
    [
        # The unit of one thing is wrong: its slip, and what is computed from it, are not.
        (
            (SHAFT, FORCE_IN_N, 'symbol = "F_r"\nunit = "mm"'),
            "quantity.shaft_force.formula",
        ),
        (
            (SHAFT, FORCE_IN_N, 'symbol = "F_r"'),
            "quantity.shaft_force.unit",
        ),
        (
            (SHAFT, '"2*total_tension*sin(wrap_angle/2)"', '""'),
            "quantity.shaft_force.formula",
        ),
    ],
)
def test_of_faults_that_follow_from_one_the_root_is_told(
    broken: Callable[..., Path], edit: tuple[str, str, str], key: str
) -> None:
    found = validated(broken(edit)).problems
    assert [(one.file, str(one.key)) for one in found] == [(edit[0], key)]
