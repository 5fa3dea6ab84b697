"""A forgotten root is found in the number of somebody who works in millimetres."""

import math

import pytest

from gripcourse.course.model import Course
from gripcourse.formula.evaluate import evaluate as value_of
from gripcourse.policy.model import Policy
from gripcourse.policy.slips import SlipKind
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.practical import practical_ratio
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate, to_si
from gripcourse.text.units import dimension


@pytest.mark.parametrize(
    ("asked", "found", "ratio"),
    [
        ("mm", "mm**2", 1e3),
        ("N", "N", 1.0),
        ("MPa", "N", 1e6),
        ("mm", "1/s", 1e-3),
        ("s", "s", 1.0),
    ],
)
def test_a_number_of_practical_units_is_taken_for_one_of_the_asked_unit(
    asked: str, found: str, ratio: float
) -> None:
    assert practical_ratio(dimension(asked), dimension(found)) == pytest.approx(ratio)


def test_square_millimetres_written_as_millimetres_are_among_the_candidates(
    plan: Plan, policy: Policy
) -> None:
    assert plan.scheme.example is not None
    given = {one.id: plan.scheme.example.given[one.id] for one in plan.givens}
    values = {name: float(one) for name, one in evaluate(plan, to_si(plan, given)).values.items()}
    force, pressure = values["drive_force"], values["supply_pressure"]
    area = force / pressure / values["cylinder_efficiency"]
    typed = 4 / math.pi * area * 1e6  # mm², written into a cell for millimetres
    found = [
        one
        for one in candidates_of(plan, "bore_required", policy.slips)
        if one.id.kind == SlipKind.POWER
    ]
    results = [float(value_of(one.formula, "mm", values, plan.columns)) * 1e3 for one in found]
    assert any(math.isclose(one, typed, rel_tol=1e-9) for one in results)


def test_a_forgotten_square_beside_an_entry_of_a_table_is_found_in_megapascals(
    course: Course, policy: Policy
) -> None:
    """The stress of a screw: its core diameter stands in a table, in millimetres."""
    example = course.schemes["screw"].example
    assert example is not None
    plan = make_plan(course, "screw", example.options)
    given = {one.id: example.given[one.id] for one in plan.givens}
    values = {name: float(one) for name, one in evaluate(plan, to_si(plan, given)).values.items()}
    core = plan.columns["trapezoidal_thread.core_diameter"]
    [row] = (core.sizes == values["thread_diameter_first"]).nonzero()[0]
    diameter = 1e3 * float(core.values[row])
    pull = 4 * values["nut_force"] / (math.pi * diameter**2)
    twist = 16 * 1e3 * values["screw_torque_first"] / (math.pi * diameter**3)
    found = [
        1e-6 * float(value_of(one.formula, "MPa", values, plan.columns))
        for one in candidates_of(plan, "screw_stress", policy.slips)
        if one.id.kind == SlipKind.POWER
    ]
    for typed in (math.sqrt(pull + 3 * twist**2), math.sqrt(pull**2 + 3 * twist)):
        assert any(math.isclose(one, typed, rel_tol=1e-9) for one in found)
