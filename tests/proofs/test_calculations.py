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


def test_a_torque_that_is_printed_wrongly_is_named(calculation: PrintedCalculation) -> None:
    changed = replace(calculation, expected={**calculation.expected, "gear_torque": (999, 0.5)})
    [problem] = differences(changed)
    assert problem.file == f"variants/schemes/{SCHEME}/worked_example.toml"
    assert problem.key == "corrected.expected.gear_torque"
    assert "comes out as 585 N·m; 999 N·m is printed" in str(problem.what)
    assert "Compare the formula of gear_torque" in str(problem.remedy)
    assert prove_calculation(changed).verdict is Verdict.FAILS


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
