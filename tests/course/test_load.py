"""Files that cannot be read, and what a loaded course holds."""

import codecs
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.compose import compose, option_sets, part_ids
from gripcourse.course.model import Convention, Course, Kind

if TYPE_CHECKING:
    from conftest import Draft

SECTION = "variants/sections/pin.toml"
SCHEME = "variants/schemes/rack_parallelogram/scheme.toml"
POLICY = "grader/policy.toml"
EXAMPLE = "variants/schemes/rack_parallelogram/worked_example.toml"


@pytest.mark.parametrize(
    "file", [SECTION, SCHEME, EXAMPLE, "variants/course.toml", "variants/errata.toml", POLICY]
)
def test_a_syntax_error_is_the_only_problem_of_a_course_that_lacks_the_file(
    draft: "Draft", file: str
) -> None:
    problem = draft.append(file, "[quantity").problem()
    assert problem.file == file
    assert str(problem.what).startswith("This is not valid TOML: ")
    assert "line" in str(problem.what)
    assert str(problem.remedy) == "Mend the line that is named."


def test_an_option_that_cannot_be_read_is_missed_by_its_schemes(draft: "Draft") -> None:
    file = "variants/options/parallel_grip_model.toml"
    found = [(one.file, one.key) for one in draft.append(file, "[quantity").problems()]
    assert found == [(file, ""), (SCHEME, "options")]


def test_faults_of_other_files_are_told_beside_a_syntax_error(draft: "Draft") -> None:
    draft.edit(SECTION, "[quantity.pin_length]", "[quantity.pin_length")
    draft.edit("variants/sections/grip_object.toml", 'unit = "kg"', 'unit = "kgg"')
    draft.edit(SCHEME, "integer = true", "intger = true")
    assert {problem.file for problem in draft.problems()} == {
        SECTION,
        "variants/sections/grip_object.toml",
        SCHEME,
    }


@pytest.mark.parametrize("file", ["variants/course.toml", SCHEME, EXAMPLE, POLICY])
def test_a_missing_file_is_named(draft: "Draft", file: str) -> None:
    problem = draft.remove(file).problem()
    assert problem.file == file
    assert str(problem.what) == "The file is missing."


@pytest.mark.parametrize("file", ["variants/course.toml", SECTION, SCHEME, POLICY])
def test_a_file_in_another_encoding_is_named(draft: "Draft", file: str) -> None:
    text = (draft.root / file).read_text(encoding="utf-8")
    problem = draft.put(file, (text + "# длина").encode("cp1251", errors="replace")).problem()
    assert problem.file == file
    assert str(problem.what) == "The file is not UTF-8."


def test_an_editor_may_mark_a_file_as_utf_8(draft: "Draft") -> None:
    for file in (SECTION, SCHEME, POLICY, "variants/catalogues/pin.csv"):
        draft.put(file, codecs.BOM_UTF8 + (draft.root / file).read_bytes())
    assert draft.problems() == ()


def test_a_course_without_schemes_says_only_that(draft: "Draft") -> None:
    for path in (draft.root / "variants/schemes").glob("*/*"):
        path.unlink()
    for path in (draft.root / "variants/schemes").iterdir():
        path.rmdir()
    problem = draft.problem()
    assert problem.file == "variants/schemes"
    assert str(problem.what) == "The course has no scheme."


def test_an_option_chooses_among_parts(course: Course) -> None:
    scheme = course.schemes["rack_parallelogram"]
    hydraulic = compose(course, scheme, {"drive": "hydraulic"})
    pneumatic = compose(course, scheme, {"drive": "pneumatic"})
    assert hydraulic["rod"].kind is Kind.CHOICE
    assert pneumatic["rod"].kind is Kind.PICK
    assert hydraulic.keys() == pneumatic.keys()


def test_a_scheme_changes_single_keys_of_a_shared_declaration(course: Course) -> None:
    shared = course.parts["drive_force"].quantities["force_ratio"]
    changed = course.schemes["rack_parallelogram"].overrides["force_ratio"]
    assert [printed.erratum for printed in changed.as_printed] == ["E11"]
    assert shared.as_printed == ()
    assert changed.formula == shared.formula
    assert changed.slips == shared.slips
    assert compose(course, course.schemes["rack_parallelogram"], {})["force_ratio"] == changed


def test_every_combination_of_options_is_known(course: Course) -> None:
    found = list(option_sets(course.schemes["rack_parallelogram"]))
    assert len(found) == 2 * 5 * 6 * 5 * 2 * 2
    assert len({tuple(options.items()) for options in found}) == len(found)
    assert {options["drive"] for options in found} == {"hydraulic", "pneumatic"}


def test_a_part_that_two_choices_bring_is_there_once(course: Course) -> None:
    scheme = course.schemes["rack_parallelogram"]
    both = {"grip_model": "prism_across", "jaw_shape": "prism"}
    assert part_ids(scheme, both).count("prism_angle") == 1
    assert compose(course, scheme, both)["jaw_angle"].kind is Kind.GIVEN
    assert scheme.overrides["finger_force_right"].source.work == "derived"  # of two choices


def test_only_constants_that_are_used_are_quantities_of_a_scheme(course: Course) -> None:
    for scheme in course.schemes.values():
        for options in option_sets(scheme):
            declared = compose(course, scheme, options)
            constants = {name for name, one in declared.items() if one.kind is Kind.CONSTANT}
            assert constants <= course.constants.keys()


def test_the_worked_example_is_data(course: Course) -> None:
    example = course.schemes["rack_parallelogram"].example
    assert example is not None
    assert example.given["mass"] == 60
    assert example.chosen[Convention.CORRECTED] == {"lever_thickness": 20}
    assert example.expected[Convention.CORRECTED]["grip_force"] == (3900, 1e-9)
