"""A broken course: each fault is one problem, with its file, its key, what is wrong, what to do."""

import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.errors import Problem

if TYPE_CHECKING:
    from conftest import Draft

SECTIONS = "variants/sections/"
SCHEME = "variants/schemes/rack_parallelogram/scheme.toml"
EXAMPLE = "variants/schemes/rack_parallelogram/worked_example.toml"
COURSE = "variants/course.toml"


@dataclass(frozen=True, slots=True)
class Fault:
    """An edit of one file, and the problem that it must give."""

    file: str
    old: str
    new: str
    key: str
    what: str
    remedy: str


FAULTS = {
    "unknown name": Fault(
        f"{SECTIONS}friction_grip.toml",
        "dynamic_factor*lifting_load/(2*friction)",
        "dynamic_factor*lifting_load/(2*frictoin)",
        "quantity.grip_force.formula",
        "The name 'frictoin' is not known.",
        "Did you mean 'friction'?",
    ),
    "name of a quantity that is marked by a person": Fault(
        SCHEME,
        'formula = "5*module"',
        'formula = "5*module*kinematic_diagram"',
        "quantity.rack_height.formula",
        "The name 'kinematic_diagram' is not known.",
        "",
    ),
    "circle": Fault(
        f"{SECTIONS}friction_grip.toml",
        "mass*(gravity + acceleration)",
        "mass*(gravity + acceleration)*grip_force/grip_force",
        "quantity.grip_force.formula",
        "The formulas run in a circle: grip_force → lifting_load → grip_force.",
        "Express one of them without the others.",
    ),
    "quantity that is computed from itself": Fault(
        SCHEME,
        'formula = "5*module"',
        'formula = "5*module + 0*rack_height"',
        "quantity.rack_height.formula",
        "The formulas run in a circle: rack_height → rack_height.",
        "",
    ),
    "unlike things added": Fault(
        SCHEME,
        'formula = "grip_force*arm_length"',
        'formula = "grip_force + arm_length"',
        "quantity.gear_torque.formula",
        "'+' needs like with like",
        "Compare the units of both sides.",
    ),
    "wrong dimension": Fault(
        SCHEME,
        'formula = "grip_force*arm_length"',
        'formula = "grip_force*arm_length**2"',
        "quantity.gear_torque.formula",
        "The formula gives ",
        "Compare the units of both sides.",
    ),
    "wrong dimension of a slip": Fault(
        f"{SECTIONS}cylinder.toml",
        'formula = "pi*bore**2*piston_speed"',
        'formula = "pi*bore*piston_speed"',
        "quantity.supply_flow.slip.radius_for_diameter",
        "The formula gives ",
        "Compare the units of both sides.",
    ),
    "value where a condition belongs": Fault(
        f"{SECTIONS}pin.toml",
        'valid = "pin_diameter > 0"',
        'valid = "pin_diameter"',
        "quantity.pin_diameter.valid",
        "This must be a comparison.",
        "Mend the formula.",
    ),
    "condition where a value belongs": Fault(
        SCHEME,
        'formula = "5*module"',
        'formula = "5*module > 0"',
        "quantity.rack_height.formula",
        "This must be a value, not a comparison.",
        "Mend the formula.",
    ),
    "formula that cannot be read": Fault(
        f"{SECTIONS}bent_lever.toml",
        "sqrt(6*lever_bending_moment",
        "sqrt(6**lever_bending_moment**",
        "quantity.lever_thickness_required.formula",
        "",
        "Mend the formula.",
    ),
    "missing Russian title": Fault(
        f"{SECTIONS}friction_grip.toml",
        'ru = "масса объекта", ',
        "",
        "quantity.mass.title.ru",
        "The text in this language is missing.",
        "students read all of en, ru, uk",
    ),
    "empty title": Fault(
        f"{SECTIONS}friction_grip.toml",
        'title = { en = "mass of the object", ru = "масса объекта", uk = "маса об\'єкта" }',
        'title = ""',
        "quantity.mass.title",
        "This key is missing.",
        "Write it.",
    ),
    "language that the course does not have": Fault(
        f"{SECTIONS}friction_grip.toml",
        'ru = "масса объекта", ',
        'ru = "масса объекта", de = "Masse", ',
        "quantity.mass.title.de",
        "This is no language of the course.",
        "",
    ),
    "unknown key": Fault(
        SCHEME,
        "integer = true",
        "intger = true",
        "quantity.gear_teeth.intger",
        "This key means nothing here.",
        "Did you mean 'integer'?",
    ),
    "missing bounds": Fault(
        f"{SECTIONS}friction_grip.toml",
        "bounds = [0.001, 5000]",
        "",
        "quantity.mass.bounds",
        "This key is missing.",
        "physically thinkable",
    ),
    "bounds the wrong way round": Fault(
        f"{SECTIONS}friction_grip.toml",
        "bounds = [0.001, 5000]",
        "bounds = [5000, 0.001]",
        "quantity.mass.bounds",
        "The value has the wrong type.",
        "two numbers, the lower first",
    ),
    "unknown kind": Fault(
        f"{SECTIONS}friction_grip.toml",
        'section = "grip"\nkind = "formula"\nsymbol = "F"',
        'section = "grip"\nkind = "formulla"\nsymbol = "F"',
        "quantity.grip_force.kind",
        "There is no kind 'formulla'.",
        "Did you mean 'formula'?",
    ),
    "unknown unit": Fault(
        f"{SECTIONS}friction_grip.toml",
        'unit = "kg"',
        'unit = "kgg"',
        "quantity.mass.unit",
        "The unit 'kgg' is not known.",
        "for example 'N*m'",
    ),
    "unknown section": Fault(
        f"{SECTIONS}friction_grip.toml",
        'section = "grip"',
        'section = "gripp"',
        "quantity.mass.section",
        "The course has no section 'gripp'.",
        "Did you mean 'grip'?",
    ),
    "missing section": Fault(
        f"{SECTIONS}friction_grip.toml",
        'section = "grip"',
        "",
        "quantity.mass.section",
        "This key is missing.",
        "Write it.",
    ),
    "missing source": Fault(
        f"{SECTIONS}friction_grip.toml",
        'source = { work = "guide", equation = "2" }',
        "",
        "quantity.mass.source",
        "This key is missing.",
        "Write it.",
    ),
    "uncited work": Fault(
        f"{SECTIONS}friction_grip.toml",
        'work = "guide"',
        'work = "giude"',
        "quantity.mass.source.work",
        "The course cites no work 'giude'.",
        "Did you mean 'guide'?",
    ),
    "unknown catalogue column in a formula": Fault(
        f"{SECTIONS}flange_mounting.toml",
        'lookup(\\"flange.bolt_circle\\"',
        'lookup(\\"flange.bolt_cirkle\\"',
        "quantity.flange_bolt_circle.formula",
        "There is no catalogue column 'flange.bolt_cirkle'.",
        "Did you mean 'flange.bolt_circle'?",
    ),
    "unknown series": Fault(
        f"{SECTIONS}pin.toml",
        'series = "pin.diameter"',
        'series = "pin.diametre"',
        "quantity.pin_diameter.series",
        "There is no catalogue column 'pin.diametre'.",
        "Did you mean 'pin.diameter'?",
    ),
    "series of something that is no size": Fault(
        f"{SECTIONS}flange_mounting.toml",
        'series = "flange.base_diameter"',
        'series = "flange.outer_diameter"',
        "quantity.flange_size.series",
        "The column does not hold the sizes of its catalogue.",
        "Name the first column",
    ),
    "search in a column that does not grow": Fault(
        f"{SECTIONS}flange_mounting.toml",
        'at_least(\\"flange.torque\\", mount_torque)',
        'at_least(\\"shuffled.torque\\", mount_torque)',
        "quantity.flange_size.at_least",
        "The column 'shuffled.torque' does not grow from row to row.",
        "Only a growing column",
    ),
    "number of steps that is none": Fault(
        f"{SECTIONS}pin.toml",
        "at_most_steps = 2",
        'at_most_steps = "two"',
        "quantity.pin_diameter.at_most_steps",
        "The value has the wrong type.",
        "a number",
    ),
    "broken number of steps": Fault(
        f"{SECTIONS}pin.toml",
        "at_most_steps = 2",
        "at_most_steps = 2.5",
        "quantity.pin_diameter.at_most_steps",
        "The number of steps is 2.5.",
        "whole number",
    ),
    "rounding that is none": Fault(
        f"{SECTIONS}pin.toml",
        'rounding = "nearest"',
        'rounding = "neerest"',
        "quantity.pin_diameter.as_printed[1].rounding",
        "There is no rounding 'neerest'.",
        "Did you mean 'nearest'?",
    ),
    "symbol used twice": Fault(
        f"{SECTIONS}friction_grip.toml",
        'symbol = "a"',
        'symbol = "m"',
        "quantity.acceleration.symbol",
        "'m' (en, ru, uk) is the symbol of mass too",
        "a symbol of its own",
    ),
    "slip that is right": Fault(
        f"{SECTIONS}friction_grip.toml",
        'formula = "dynamic_factor*lifting_load/friction"',
        'formula = "dynamic_factor * lifting_load / (2*friction)"',
        "quantity.grip_force.slip.one_jaw_only",
        "The slip equals the right formula.",
        "",
    ),
    "two slips of one name": Fault(
        f"{SECTIONS}friction_grip.toml",
        'id = "friction_left_out"',
        'id = "one_jaw_only"',
        "quantity.grip_force.slip.one_jaw_only",
        "The slip has no id of its own.",
        "",
    ),
    "credit above one": Fault(
        f"{SECTIONS}friction_grip.toml",
        "credit = 0",
        "credit = 50",
        "quantity.lifting_load.slip[1].credit",
        "The credit is 50.",
        "from 0 to 1",
    ),
    "credit that is no number": Fault(
        f"{SECTIONS}friction_grip.toml",
        "credit = 0",
        'credit = "half"',
        "quantity.lifting_load.slip[1].credit",
        "The value has the wrong type.",
        "a number",
    ),
    "number that is none": Fault(
        COURSE,
        "value = 9.81",
        "value = nan",
        "constant.gravity.value",
        "The value has the wrong type.",
        "a number",
    ),
    "unknown erratum": Fault(
        f"{SECTIONS}pin.toml",
        'erratum = "E13"',
        'erratum = "E133"',
        "quantity.pin_diameter.as_printed.E133",
        "The course lists no erratum 'E133'.",
        "Did you mean 'E13'?",
    ),
    "part that does not exist": Fault(
        SCHEME,
        '"drawings"]',
        '"drawings", "drawing"]',
        "parts",
        "There is no part 'drawing'.",
        "Did you mean 'drawings'?",
    ),
    "part that is misspelt": Fault(
        SCHEME,
        '"pin", ',
        '"pinn", ',
        "parts",
        "There is no part 'pinn'.",
        "Did you mean 'pin'?",
    ),
    "option that does not exist": Fault(
        SCHEME,
        'options = ["cylinder_drive"]',
        'options = ["cylinder_drives"]',
        "options",
        "There is no shared option 'cylinder_drives'.",
        "Did you mean 'cylinder_drive'?",
    ),
    "change of something undeclared": Fault(
        SCHEME,
        "[[override.force_ratio.as_printed]]",
        "[[override.force_ration.as_printed]]",
        "override.force_ration",
        "No part of the scheme declares 'force_ration'.",
        "Did you mean 'force_ratio'?",
    ),
    "change of something that several parts declare": Fault(
        SCHEME,
        "[[override.force_ratio.as_printed]]",
        "[override.bore]\nbounds = [1, 2]\n[[override.force_ratio.as_printed]]",
        "override.bore",
        "More than one part declares 'bore'.",
        "Change it in the parts",
    ),
    "scheme named otherwise than its folder": Fault(
        SCHEME,
        'id = "rack_parallelogram"',
        'id = "rack"',
        "id",
        "The id 'rack' differs from the name of the folder.",
        "Give both the same name.",
    ),
    "name that no formula can use": Fault(
        COURSE,
        "[constant.gravity]",
        '[constant.min]\nsymbol = "g_m"\nunit = ""\nvalue = 1\nbounds = [0, 2]\n'
        'source = { work = "guide" }\ntitle = "least"\n[constant.gravity]',
        "constant.min",
        "A formula cannot use the name 'min'.",
        "Latin letters",
    ),
    "constant declared as a quantity too": Fault(
        COURSE,
        "[constant.gravity]",
        '[constant.pin_length]\nsymbol = "l_0"\nunit = "mm"\nvalue = 1\nbounds = [0, 2]\n'
        'source = { work = "guide" }\ntitle = "length"\n[constant.gravity]',
        "quantity.pin_length",
        "'pin_length' is declared more than once.",
        "Remove a part",
    ),
    "unknown language": Fault(
        COURSE,
        'language = "ru"',
        'language = "rus"',
        "language",
        "This is no language of the course.",
        "Did you mean 'ru'?",
    ),
    "unknown convention": Fault(
        COURSE,
        'convention = "corrected"',
        'convention = "correct"',
        "convention",
        "There is no convention 'correct'.",
        "Did you mean 'corrected'?",
    ),
    "unknown given in the worked example": Fault(
        EXAMPLE,
        "mass = 60",
        "mass = 60\nmas = 60",
        "given.mas",
        "The scheme has no given 'mas'.",
        "Did you mean 'mass'?",
    ),
    "missing given in the worked example": Fault(
        EXAMPLE,
        "mass = 60",
        "",
        "given.mass",
        "The example gives no value of 'mass'.",
        "takes the example's value",
    ),
    "unknown id among the expected numbers": Fault(
        EXAMPLE,
        "gear_torque = [585, 1e-9]",
        "gear_torqe = [585, 1e-9]",
        "corrected.expected.gear_torqe",
        "The scheme computes no 'gear_torqe'.",
        "Did you mean 'gear_torque'?",
    ),
    "expected number without its tolerated difference": Fault(
        EXAMPLE,
        "gear_torque = [585, 1e-9]",
        "gear_torque = 585",
        "corrected.expected.gear_torque",
        "The value has the wrong type.",
        "[3900, 0.5]",
    ),
    "unknown choice in the worked example": Fault(
        EXAMPLE,
        'drive = "hydraulic"',
        'drive = "hydraulics"',
        "options.drive",
        "There is no choice 'hydraulics'.",
        "Did you mean 'hydraulic'?",
    ),
    "unknown option in the worked example": Fault(
        EXAMPLE,
        'drive = "hydraulic"',
        'drive = "hydraulic"\ndrve = "hydraulic"',
        "options.drve",
        "has no option 'drve'.",
        "Did you mean 'drive'?",
    ),
    "worked example of an uncited work": Fault(
        EXAMPLE,
        'work = "guide"',
        'work = "guid"',
        "source.work",
        "The course cites no work 'guid'.",
        "Did you mean 'guide'?",
    ),
}


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
def test_a_fault_is_one_problem_with_its_place_and_remedy(draft: "Draft", fault: Fault) -> None:
    if "shuffled" in fault.new:
        _shuffle(draft)
    problem = draft.edit(fault.file, fault.old, fault.new).problem()
    if fault.key == "quantity.pin_length":  # the constant comes first, so the part doubles it
        assert problem.file == f"{SECTIONS}pin.toml"
    else:
        assert problem.file == fault.file
    assert problem.key == fault.key
    assert fault.what in str(problem.what)
    assert fault.remedy in str(problem.remedy)


def _shuffle(draft: "Draft") -> None:
    text = "# source: made up\n# mark: made up\nsize [mm],torque [N*m]\n10,30\n20,10\n"
    draft.put("variants/catalogues/shuffled.csv", text.encode())


def test_an_unknown_name_is_underlined(draft: "Draft") -> None:
    fault = FAULTS["unknown name"]
    problem = draft.edit(fault.file, fault.old, fault.new).problem()
    line, carets = problem.excerpt.splitlines()
    assert line[carets.index("^") : carets.rindex("^") + 1] == "frictoin"


def test_a_given_that_nobody_uses_is_named(draft: "Draft", said: Callable[[Problem], str]) -> None:
    text = (
        '[quantity.colour]\nsection = "grip"\nkind = "given"\nsymbol = "c"\nunit = ""\n'
        'bounds = [0, 1]\nsource = { work = "guide" }\ntitle = "colour"'
    )
    draft.append(f"{SECTIONS}pin.toml", text).edit(EXAMPLE, "mass = 60", "mass = 60\ncolour = 1")
    problem = draft.problem()
    assert (problem.file, problem.key) == (f"{SECTIONS}pin.toml", "quantity.colour")
    assert "No formula uses the given 'colour'." in said(problem)
    assert "Use it, or remove it" in said(problem)


def test_a_quantity_in_two_parts_is_named_at_the_later_one(draft: "Draft") -> None:
    text = (
        '[quantity.grip_force]\nsection = "grip"\nkind = "formula"\nsymbol = "F"\nunit = "N"\n'
        'formula = "dynamic_factor*lifting_load/(2*friction)"\nbounds = [0, 1e6]\n'
        'source = { work = "guide" }\ntitle = "grip force"'
    )
    problem = draft.append(f"{SECTIONS}pin.toml", text).problem()
    assert (problem.file, problem.key) == (f"{SECTIONS}pin.toml", "quantity.grip_force")
    assert str(problem.what) == "'grip_force' is declared more than once."
    assert "[override.grip_force]" in str(problem.remedy)


def test_a_missing_rubric_is_named_with_its_file(draft: "Draft") -> None:
    problem = draft.remove("grader/rubric/general_view.toml").problem()
    assert problem.file == f"{SECTIONS}drawings.toml"
    assert problem.key == "quantity.general_view_drawing.rubric"
    assert str(problem.what) == "There is no rubric 'general_view'."
    assert str(problem.remedy) == "Write grader/rubric/general_view.toml."


def test_a_part_that_no_scheme_uses_is_named(draft: "Draft") -> None:
    (draft.root / SECTIONS / "spare.toml").write_text("", encoding="utf-8")
    problem = draft.problem()
    assert problem.file == f"{SECTIONS}spare.toml"
    assert str(problem.what) == "No scheme uses this part."


def test_a_fault_of_a_shared_part_is_not_repeated_where_a_scheme_changes_it(
    draft: "Draft",
) -> None:
    file = f"{SECTIONS}drive_force.toml"
    old = 'ru = "силовое передаточное отношение P/F для расчёта привода", '
    problem = draft.edit(file, old, "").problem()
    assert (problem.file, problem.key) == (file, "quantity.force_ratio.title.ru")


def test_a_slip_of_an_empirical_formula_may_leave_a_name_out(draft: "Draft") -> None:
    slip = (
        '[[quantity.module_required.slip]]\nid = "form_left_out"\ncredit = 0\nhint = "Y"\n'
        'formula = "14*cbrt(gear_torque*load_factor/(gear_teeth**2*face_width_factor'
        '*tooth_stress_allowed))"\n'
    )
    before = "[[quantity.module_required.as_printed]]"
    draft.edit(SCHEME, before, slip + before)
    assert draft.problems() == ()


def test_five_faults_in_four_files_are_five_problems(draft: "Draft") -> None:
    broken = [
        FAULTS[name]
        for name in (
            "unknown name",
            "missing Russian title",
            "wrong dimension",
            "unknown series",
            "missing given in the worked example",
        )
    ]
    assert len({fault.file for fault in broken}) == 4
    for fault in broken:
        draft.edit(fault.file, fault.old, fault.new)
    found = {(problem.file, problem.key) for problem in draft.problems()}
    assert found == {(fault.file, fault.key) for fault in broken}
    assert len(draft.problems()) == 5


def test_the_reference_course_has_no_problem(draft: "Draft") -> None:
    assert draft.problems() == ()


def test_a_fault_of_a_shared_part_is_told_once_for_all_schemes(draft: "Draft") -> None:
    first = draft.root / "variants/schemes/rack_parallelogram"
    second = Path(shutil.copytree(first, first.with_name("another_rack")))
    scheme = second / "scheme.toml"
    text = scheme.read_text(encoding="utf-8").replace('"rack_parallelogram"', '"another_rack"')
    scheme.write_text(text, encoding="utf-8")
    assert draft.problems() == ()
    for name in ("unknown name", "symbol used twice", "unknown unit", "wrong dimension of a slip"):
        draft.edit(FAULTS[name].file, FAULTS[name].old, FAULTS[name].new)
    assert len(draft.problems()) == 4


def test_no_place_on_the_machine_is_named(draft: "Draft") -> None:
    fault = FAULTS["unknown unit"]
    problem = draft.edit(fault.file, fault.old, fault.new).problem()
    assert not Path(problem.file).is_absolute()
