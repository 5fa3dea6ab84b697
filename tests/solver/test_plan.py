"""A plan: every quantity of a scheme, inputs before what needs them."""

import pytest

from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.course.quantity import Convention, Kind
from gripcourse.errors import UsageError
from gripcourse.solver.plan import Plan, default_options, make_plan

SCHEME = "rack_parallelogram"
SIMPLE = "electromagnet"  # with two options


@pytest.mark.parametrize("convention", Convention)
def test_inputs_come_before_what_needs_them(course: Course, convention: Convention) -> None:
    """With every two choices together; `gripcourse validate --prove` orders all combinations."""
    for scheme in course.schemes.values():
        for options in pair_option_sets(scheme):
            plan = make_plan(course, scheme.id, options, convention)
            place = {name: number for number, name in enumerate(plan.quantities)}
            early = [
                (name, used)
                for name, inputs in plan.inputs.items()
                for used in inputs
                if place[used] >= place[name]
            ]
            assert early == []


def test_the_order_does_not_depend_on_chance(course: Course, plan: Plan) -> None:
    again = make_plan(course, SCHEME, plan.options)
    assert list(again.quantities) == list(plan.quantities)


def test_answers_stand_in_the_order_of_the_assignment(course: Course, plan: Plan) -> None:
    ranks = [section.id for section in course.sections]
    for quantities in (plan.answered, plan.givens, plan.manual):
        sections = [ranks.index(one.section) for one in quantities]
        assert sections == sorted(sections)
    place = {name: number for number, name in enumerate(plan.quantities)}
    drive = [place[one.id] for one in plan.answered if one.section == "drive"]
    assert drive == sorted(drive)


def test_every_quantity_is_asked_given_marked_or_constant(plan: Plan) -> None:
    groups = (plan.answered, plan.givens, plan.manual, plan.constants)
    named = [one.id for group in groups for one in group]
    unused = set(plan.quantities) - set(named)
    assert len(named) == len(set(named))
    assert all(plan.quantities[name].kind is Kind.CONSTANT for name in unused)


def test_constants_of_a_plan_are_those_of_its_convention(course: Course, plan: Plan) -> None:
    guide = make_plan(course, SCHEME, plan.options, Convention.AS_PRINTED)
    rules = {"least_jaw_width", "eye_factor", "slenderness_allowed"}
    assert {one.id for one in plan.constants} == {"gravity"} | rules
    assert {one.id for one in guide.constants} == {"gravity_printed"} | rules


def test_a_convention_decides_the_formula_and_its_inputs(course: Course, plan: Plan) -> None:
    guide = make_plan(course, SCHEME, plan.options, Convention.AS_PRINTED)
    assert plan.inputs["force_ratio"] == ("force_ratio_at_max", "force_ratio_at_min")
    assert guide.inputs["force_ratio"] == ("arm_length", "arm_angle_open", "pitch_radius")
    formula = guide.reference_formula("bearing_stress")
    assert formula is not None
    assert formula.text == "2*pin_force/(pi*pin_diameter_first*pin_length)"
    assert plan.reference_formula("bearing_stress") == plan.quantities["bearing_stress"].formula


def test_without_a_convention_the_course_decides(course: Course, plan: Plan) -> None:
    assert plan.convention is course.convention is Convention.CORRECTED


def test_the_worked_example_tells_the_default_options(course: Course) -> None:
    assert default_options(course.schemes[SIMPLE]) == {"load_case": "lift", "mounting": "flange"}


@pytest.mark.parametrize(
    ("scheme", "options", "what", "remedy"),
    [
        (
            "rack_parallelogramm",
            {"drive": "hydraulic"},
            "The course has no scheme 'rack_parallelogramm'.",
            "Did you mean 'rack_parallelogram'?",
        ),
        (
            SIMPLE,
            {"load_case": "sheer", "mounting": "flange"},
            "The option 'load_case' of the scheme electromagnet cannot be 'sheer'.",
            "Did you mean 'shear'?",
        ),
        (
            SIMPLE,
            {"mounting": "flange"},
            "The option 'load_case' of the scheme electromagnet cannot be ''.",
            "Known here: lift, shear.",
        ),
        (
            SIMPLE,
            {"load_case": "lift", "mounting": "flange", "load_cases": "lift"},
            "The scheme electromagnet has no option 'load_cases'.",
            "Did you mean 'load_case'?",
        ),
    ],
)
def test_what_does_not_exist_is_refused_with_a_suggestion(
    course: Course, scheme: str, options: dict[str, str], what: str, remedy: str
) -> None:
    with pytest.raises(UsageError) as refused:
        make_plan(course, scheme, options)
    [problem] = refused.value.problems
    assert str(problem.what) == what
    assert str(problem.remedy).startswith(remedy)


def test_all_wrong_options_are_told_at_once(course: Course) -> None:
    with pytest.raises(UsageError) as refused:
        make_plan(course, SIMPLE, {"load_case": "twist", "mounting": "flange", "colour": "red"})
    assert len(refused.value.problems) == 2
