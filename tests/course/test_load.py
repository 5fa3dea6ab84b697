"""Files that cannot be read, and what a loaded course holds."""

import codecs
from itertools import combinations, product
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.compose import compose, part_ids
from gripcourse.course.model import Course
from gripcourse.course.option_sets import option_sets, pair_option_sets
from gripcourse.course.quantity import Convention, Kind, Quantity
from gripcourse.errors import UsageError
from gripcourse.solver.plan import default_options
from gripcourse.usecases.solving.solve import solve_scheme

if TYPE_CHECKING:
    from support.drafts import Draft

SECTION = "variants/sections/pin.toml"
SCHEME = "variants/schemes/rack_parallelogram/scheme.toml"
DRAWINGS = "variants/sections/drawings.toml"
POLICY = "grader/policy.toml"
EXAMPLE = "variants/schemes/rack_parallelogram/worked_example.toml"
DIAGRAM = "variants/schemes/rack_parallelogram/diagram.toml"
LOAD_OF = {"friction": "upward_load", "contact": "contact_grip"}  # the part that declares it


@pytest.mark.parametrize(
    "file", [SECTION, SCHEME, EXAMPLE, "variants/course.toml", "variants/errata.toml", POLICY]
)
def test_a_syntax_error_is_the_only_problem_of_a_course_that_lacks_the_file(
    draft: "Draft", file: str
) -> None:
    problem = draft.append(file, "[quantity").problem()
    assert problem.file == file
    assert str(problem.key).startswith("line ")
    assert problem.excerpt.strip() == "[quantity"
    assert "A bracket" in str(problem.what)
    assert str(problem.remedy).startswith("Compare this line")


def test_an_option_that_cannot_be_read_is_missed_by_its_schemes(draft: "Draft") -> None:
    file = "variants/options/parallel_grip_model.toml"
    problems = draft.append(file, "[quantity").problems()
    assert [one.file for one in problems] == [file, SCHEME]
    assert problems[1].key == "options"


def test_faults_of_other_files_are_told_beside_a_syntax_error(draft: "Draft") -> None:
    draft.edit(SECTION, "[quantity.pin_length]", "[quantity.pin_length")
    draft.edit("variants/sections/grip_object.toml", 'unit = "kg"', 'unit = "kgg"')
    draft.edit(SCHEME, "integer = true", "intger = true")
    assert {problem.file for problem in draft.problems()} == {
        SECTION,
        "variants/sections/grip_object.toml",
        SCHEME,
    }


@pytest.mark.parametrize("file", ["variants/course.toml", SCHEME, POLICY])
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


def test_a_course_file_without_its_key_parts_names_them_all(draft: "Draft") -> None:
    draft.put("variants/course.toml", b"")
    found = {one.key for one in draft.problems() if one.file == "variants/course.toml"}
    assert {"id", "language", "title", "section"} <= found


def test_a_worked_example_states_only_what_differs_from_the_defaults(draft: "Draft") -> None:
    part = "variants/sections/grip_object.toml"
    course = (
        draft.edit(EXAMPLE, "mass = 60\n", "").edit(part, "default = 20", "default = 45").load()
    )
    example = course.schemes["rack_parallelogram"].example
    assert example is not None
    assert example.given["mass"] == 45


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
    changed = course.schemes["rack_parallelogram"].overrides["drive_force"]["force_ratio"]
    assert [printed.erratum for printed in changed.as_printed] == ["E11"]
    assert shared.as_printed == ()
    assert changed.formula == shared.formula
    assert changed.explain != shared.explain
    assert (changed.symbol, changed.title) == (shared.symbol, shared.title)
    assert compose(course, course.schemes["rack_parallelogram"], {})["force_ratio"] == changed


def test_a_change_holds_in_whichever_part_declares_the_quantity(draft: "Draft") -> None:
    course = draft.append(SCHEME, '[override.lifting_load]\nsymbol = "G_1"').load()
    for model, quantities in by_grip_model(course).items():
        changed = quantities["lifting_load"]
        shared = course.parts[LOAD_OF[model]].quantities["lifting_load"]
        assert changed.symbol.of("en") == "G_1"
        assert changed.formula == shared.formula
        assert changed.slips == shared.slips
    friction, contact = by_grip_model(course).values()
    assert friction["lifting_load"].formula != contact["lifting_load"].formula


def test_a_change_may_name_the_part_that_it_is_right_for(draft: "Draft") -> None:
    change = '[override.lifting_load]\nparts = ["upward_load"]\nformula = "2*mass*gravity"'
    course = draft.append(SCHEME, f"{change}\nas_printed = []").load()
    friction, contact = by_grip_model(course).values()
    formula = friction["lifting_load"].formula
    assert formula is not None
    assert formula.text == "2*mass*gravity"
    assert contact["lifting_load"] is course.parts["contact_grip"].quantities["lifting_load"]


def test_a_scheme_changes_what_a_part_of_it_has_changed(draft: "Draft") -> None:
    draft.append(DRAWINGS, '[override.gear_torque]\nsymbol = "T_1"')
    assert "gear_torque" in str(draft.problem().what)  # the scheme's own is not a part's
    draft.edit(DRAWINGS, "gear_torque", "lifting_load").append(
        SCHEME, '[override.lifting_load]\nunit = "kN"'
    )
    changed = by_grip_model(draft.load())["friction"]["lifting_load"]
    assert (changed.symbol.of("en"), changed.unit) == ("T_1", "kN")
    assert changed.file == SCHEME


def test_a_part_may_say_how_the_links_move(draft: "Draft") -> None:
    text = (draft.root / SCHEME).read_text(encoding="utf-8")
    scheme, mark, motion = text.partition("[kinematics]")
    draft.put(SCHEME, scheme.encode()).append(DRAWINGS, mark + motion)
    moving = draft.load().schemes["rack_parallelogram"].kinematics
    assert moving is not None
    assert moving.file == DRAWINGS
    draft.edit(DRAWINGS, 'output = "jaw_pin_y"', 'output = "jaw_pin_z"')
    assert draft.problem().file == DRAWINGS
    draft.edit(DRAWINGS, '"jaw_pin_z"', '"jaw_pin_y"').append(SCHEME, mark + motion)
    problem = draft.problem()
    assert (problem.file, problem.key) == (SCHEME, "kinematics")
    assert str(problem.what) == "'kinematics' is declared more than once."
    assert DRAWINGS in str(problem.remedy)


def by_grip_model(course: Course) -> dict[str, dict[str, Quantity]]:
    """Compose the rack gripper with either model of the grip."""
    scheme = course.schemes["rack_parallelogram"]
    assert scheme.example is not None
    return {
        model: compose(course, scheme, {**scheme.example.options, "grip_model": model})
        for model in ("friction", "contact")
    }


def test_every_combination_of_options_is_known(course: Course) -> None:
    scheme = course.schemes["rack_parallelogram"]
    ids = [option.id for option in scheme.options]
    choices = ([choice.id for choice in option.choices] for option in scheme.options)
    all_of_them = [dict(zip(ids, chosen, strict=True)) for chosen in product(*choices)]
    allowed = [one for one in all_of_them if not any(rule.broken_by(one) for rule in scheme.rules)]
    assert list(option_sets(scheme)) == allowed
    assert 1 < len(allowed) < len(all_of_them)


def test_few_combinations_show_any_two_choices_together(course: Course) -> None:
    for scheme in course.schemes.values():
        everything = {
            pair for options in option_sets(scheme) for pair in combinations(options.items(), 2)
        }
        few = list(pair_option_sets(scheme))
        assert {pair for options in few for pair in combinations(options.items(), 2)} == everything
        assert {choice for options in few for choice in options.items()} == {
            choice for options in option_sets(scheme) for choice in options.items()
        }
        assert len(few) <= 60


def test_a_part_that_two_choices_bring_is_there_once(course: Course) -> None:
    scheme = course.schemes["rack_parallelogram"]
    both = {"grip_model": "prism_across", "jaw_shape": "prism"}
    assert part_ids(scheme, both).count("prism_angle") == 1
    assert compose(course, scheme, both)["jaw_angle"].kind is Kind.GIVEN
    for model in ("contact", "contact_exact"):
        changed = compose(course, scheme, {**both, "grip_model": model})["finger_force_right"]
        assert changed.source.work == "derived"


def test_only_constants_that_are_used_are_quantities_of_a_scheme(course: Course) -> None:
    for scheme in course.schemes.values():
        for options in option_sets(scheme):
            declared = compose(course, scheme, options)
            constants = {name for name, one in declared.items() if one.kind is Kind.CONSTANT}
            assert constants <= course.constants.keys()


def test_a_scheme_may_do_without_a_worked_example(draft: "Draft") -> None:
    (draft.root / EXAMPLE).unlink()
    course = draft.load()
    (scheme,) = course.schemes.values()
    assert scheme.example is None
    first = {option.id: option.choices[0].id for option in scheme.options}
    assert default_options(scheme) == first
    with pytest.raises(UsageError, match="These values are not set"):
        solve_scheme(course, scheme.id, {}, {}, None)


def test_only_a_symmetric_diagram_has_its_parts_on_both_sides(draft: "Draft") -> None:
    def sides() -> set[str]:
        (scheme,) = draft.load().schemes.values()
        assert scheme.diagram is not None
        return {one.mirror for one in scheme.diagram.elements if one.kind == "contact"}

    assert sides() == {"both"}
    draft.edit(DIAGRAM, "symmetric = true", "symmetric = false")
    assert sides() == {"none"}


def test_the_worked_example_is_data(course: Course) -> None:
    example = course.schemes["rack_parallelogram"].example
    assert example is not None
    assert example.given["mass"] == 60
    assert example.chosen[Convention.CORRECTED] == {"lever_thickness": 20}
    assert example.expected[Convention.CORRECTED]["grip_force"] == (3900, 1e-9)
