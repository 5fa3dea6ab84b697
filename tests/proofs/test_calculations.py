"""A printed number that does not come out is a problem: what came out, and what is printed."""

from dataclasses import replace

import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention
from gripcourse.proofs.calculations import (
    PrintedCalculation,
    broken_by,
    calculations,
    differences,
    prove_calculation,
    silent_examples,
)
from gripcourse.proofs.model import Verdict
from gripcourse.solver.solve import solve_variant

SCHEME = "rack_parallelogram"


@pytest.fixture(scope="module")
def calculation(course: Course) -> PrintedCalculation:
    """The guide's example, errata corrected."""
    found = {one.plan.convention: one for one in calculations(course, (), SCHEME)}
    return found[Convention.CORRECTED]


def test_a_scheme_without_an_example_has_nothing_to_compare(course: Course) -> None:
    bare = {name: replace(one, example=None) for name, one in course.schemes.items()}
    assert list(calculations(replace(course, schemes=bare), ())) == []


def test_an_example_that_expects_nothing_is_open(course: Course) -> None:
    assert list(silent_examples(course)) == []
    scheme = course.schemes[SCHEME]
    assert scheme.example is not None
    silent = replace(scheme.example, expected={key: {} for key in scheme.example.expected})
    changed = replace(course, schemes={SCHEME: replace(scheme, example=silent)})
    (result,) = silent_examples(changed)
    assert (result.verdict, result.compared) == (Verdict.OPEN, 0)
    assert result.proof.file == f"variants/schemes/{SCHEME}/worked_example.toml"
    assert "no number" in str(result.note)


def test_a_torque_that_is_printed_wrongly_is_named(calculation: PrintedCalculation) -> None:
    changed = replace(calculation, expected={**calculation.expected, "gear_torque": (999, 0.5)})
    [problem] = differences(changed)
    assert problem.file == f"variants/schemes/{SCHEME}/worked_example.toml"
    assert problem.key == "corrected.expected.gear_torque"
    assert "comes out as 585 N·m; 999 N·m is printed" in str(problem.what)
    assert "Compare the formula of gear_torque" in str(problem.remedy)
    assert prove_calculation(changed).verdict is Verdict.FAILS


def test_what_only_follows_from_a_wrong_number_is_told_beside_it(
    calculation: PrintedCalculation,
) -> None:
    """A part of the example that begins with a wrong number: one sentence, not one for each."""
    values = solve_variant(calculation.plan, calculation.known)
    doubled = {**calculation.known, "grip_force": 2 * values["grip_force"]}
    later = solve_variant(calculation.plan, doubled)
    expected = {name: (later[name], 1e-9) for name in ("drive_force", "grip_force", "gear_torque")}
    [problem] = differences(replace(calculation, expected=expected))
    assert problem.key == "corrected.expected.grip_force"
    assert "these would come out, too: gear_torque, drive_force" in str(problem.what)
    assert "Compare the formula of grip_force" in str(problem.remedy)


def test_two_numbers_that_are_wrong_for_themselves_are_two_problems(
    calculation: PrintedCalculation,
) -> None:
    values = solve_variant(calculation.plan, calculation.known)
    expected = {name: (2 * values[name], 1e-9) for name in ("grip_force", "gear_torque")}
    expected["gear_torque"] = (3 * values["gear_torque"], 1e-9)
    found = [one.key for one in differences(replace(calculation, expected=expected))]
    assert found == ["corrected.expected.grip_force", "corrected.expected.gear_torque"]


def test_a_number_without_a_value_is_named(calculation: PrintedCalculation) -> None:
    without = replace(calculation, known={**calculation.known, "friction": 0.0})
    assert any("has no value here" in str(one.what) for one in differences(without))


def test_a_value_breaks_a_calculation_where_a_printed_number_depends_on_it(
    calculation: PrintedCalculation,
) -> None:
    right = solve_variant(calculation.plan, calculation.known)["grip_force"]
    found = broken_by(
        calculation,
        {"grip_force": (right, right * 2, float("nan")), "overall_length": (1.0,), "mass": (1.0,)},
    )
    assert found["grip_force"] == (False, True, True)
    assert found["overall_length"] == (False,)
    assert found["mass"] == (False,)  # it is known: no formula gives it


def test_a_route_that_leads_elsewhere_is_a_problem(calculation: PrintedCalculation) -> None:
    plan = calculation.plan
    gain = plan.quantities["force_gain"]
    assert gain.route is not None
    lost = replace(gain, route=plan.quantities["drive_force"].formula)
    answered = tuple(lost if one.id == lost.id else one for one in plan.answered)
    [problem] = differences(replace(calculation, plan=replace(plan, answered=answered)))
    assert problem.key == "quantity.force_gain.route"
    assert "The route gives" in str(problem.what)
