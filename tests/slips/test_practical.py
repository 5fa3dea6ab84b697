"""A forgotten root is found in the number of somebody who works in millimetres."""

import math

import pytest

from gripcourse.formula.evaluate import evaluate as value_of
from gripcourse.policy.model import Policy
from gripcourse.policy.slips import SlipKind
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.practical import practical_ratio
from gripcourse.solver.plan import Plan
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
