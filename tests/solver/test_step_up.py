"""A choice that steps up takes the smallest size for which its condition holds.

By hand, for an index of 6: K = 23/20 + 0.615/6 = 1.2525, and τ = 8·F·6·K/(π·d²) = 60.12·F/(π·d²).
At 100 N that is 976.4 MPa for a wire of 1.4 mm, 747.5 for 1.6, 590.6 for 1.8 and 478.4 for 2 mm;
allowed are 0.4 of the strength: 760, 740, 720 and 700 MPa, or 0.36 where the wire is galvanised.
"""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from gripcourse.course.composition import Composition
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.formula.parse import formula_of
from gripcourse.solver.asked import deciding
from gripcourse.solver.condition_text import condition_text
from gripcourse.solver.family import evaluate_family, families_of
from gripcourse.solver.numbers import evaluate_numbers
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate, solve_variant, to_si
from gripcourse.text.words import Words
from gripcourse.variants.explain import why_infeasible

SPRINGS = Path(__file__).parents[1] / "support" / "spring_course"
USUAL = {"force": 100.0, "stress_assumed": 800.0, "index": 6.0}
# Force and assumed stress; the first wire that is thick enough, and the one that also holds.
BRIGHT = [
    ((60.0, 800.0), 1.2, 1.4),  # τ = 797.4 > 780, then 585.8
    ((100.0, 800.0), 1.6, 1.8),  # 747.5 > 740
    ((100.0, 1000.0), 1.4, 1.8),  # 976.4 > 760 and 747.5 > 740
    ((110.0, 800.0), 1.8, 1.8),  # 649.7 <= 720: the first will do
    ((130.0, 800.0), 1.8, 2.0),  # 767.8 > 720
    ((100.0, 5000.0), 1.0, 1.8),  # from the first of the series on
]


@pytest.fixture(scope="module")
def springs() -> Course:
    return load_course(SPRINGS)


@pytest.fixture(scope="module")
def plan(springs: Course) -> Plan:
    return make_plan(springs, "spring", {"wire": "bright"})


def given(force: float, assumed: float) -> dict[str, float]:
    return {"force": force, "stress_assumed": assumed, "index": 6.0}


@pytest.mark.parametrize(("loads", "first", "taken"), BRIGHT)
def test_the_smallest_size_that_satisfies_the_condition_is_taken(
    plan: Plan, loads: tuple[float, float], first: float, taken: float
) -> None:
    values = solve_variant(plan, given(*loads))
    assert values["wire"] == taken
    assert values["wire_required"] <= first
    assert math.isclose(values["stress"], 60.12 * loads[0] / (math.pi * taken**2), rel_tol=1e-12)
    alone = evaluate_numbers(plan, to_si(plan, given(*loads))).values["wire"]
    assert alone == pytest.approx(taken * 1e-3)


def test_many_variants_step_up_together(plan: Plan) -> None:
    forces, assumed = np.array([loads for loads, _, _ in BRIGHT]).T
    known = {"force": forces, "stress_assumed": assumed * 1e6, "index": np.array(6.0)}
    wires = evaluate(plan, known).values["wire"] * 1e3
    assert wires == pytest.approx([taken for _, _, taken in BRIGHT])


def test_what_is_computed_from_the_size_comes_after_it_and_all_else_before(plan: Plan) -> None:
    order = list(plan.quantities)
    up = plan.step_ups["wire"]
    assert set(up.between) == {"stress", "strength", "stress_allowed"}
    assert up.between.index("strength") < up.between.index("stress_allowed")
    assert set(up.outside) == {"force", "index", "curvature"}
    assert set(plan.inputs["wire"]) == {"wire_required", "force", "index", "curvature"}
    assert max(map(order.index, up.outside)) < order.index("wire")
    assert order.index("wire") < min(map(order.index, up.between))


def test_no_size_may_do(plan: Plan) -> None:
    """At 600 N the thickest wire of 2.5 mm bears 1837 MPa, and 660 are allowed."""
    assert math.isnan(solve_variant(plan, given(600.0, 5000.0))["wire"])
    [said] = why_infeasible(plan, given(600.0, 5000.0))
    assert str(said) == (
        "accepted wire (wire): no size of wire.diameter from 1.6 mm up to the last one, 2.5 mm, "
        "satisfies stress <= stress_allowed."
    )


def test_a_series_may_be_too_short_before_the_condition_is_asked(plan: Plan) -> None:
    [said] = why_infeasible(plan, given(600.0, 100.0))
    assert "has no entry for" in str(said)


def test_variants_of_all_options_step_up_each_by_its_own_formulas(springs: Course) -> None:
    """At 110 N a bright wire of 1.8 mm holds 649.7 MPa; galvanised, 648 are allowed: 2 mm."""
    choices = ["bright", "zinc", "zinc", "bright"]
    compositions = [Composition.of("spring", {"wire": one}) for one in choices]
    ((rows, family),) = families_of(springs, compositions)
    assert rows.tolist() == [0, 1, 2, 3]
    forces = np.array([110.0, 110.0, 100.0, 130.0])
    known = {
        "force": forces,
        "stress_assumed": np.full(4, 800e6),
        "index": np.full(4, 6.0),
    }
    wires = evaluate_family(family, known).values["wire"] * 1e3
    assert wires == pytest.approx([1.8, 2.0, 1.8, 2.0])


def test_a_size_that_somebody_chose_is_carried_on(plan: Plan) -> None:
    values = solve_variant(plan, {**USUAL, "wire": 1.6})
    assert values["stress"] == pytest.approx(747.5, abs=0.1)
    known = to_si(plan, {**USUAL, "wire": 1.6})
    assert float(evaluate(plan, known).computed["wire"]) == pytest.approx(1.8e-3)


def test_what_somebody_wrote_of_one_size_says_nothing_of_others(plan: Plan) -> None:
    """A wrong stress stands for the wire that it was computed with."""
    known = to_si(plan, {**USUAL, "stress": 10.0})
    assert float(evaluate(plan, known).computed["wire"]) == pytest.approx(1.8e-3)


def test_without_a_missing_number_no_size_is_taken(plan: Plan) -> None:
    known = to_si(plan, {**USUAL, "wire_required": 1.5}) | {"force": math.nan}
    assert math.isnan(evaluate(plan, known).values["wire"])
    assert math.isnan(evaluate_numbers(plan, known).values["wire"])


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "the first size not below d_req for which τ ≤ [τ]"),
        ("ru", "первое значение ряда не менее d_тр из тех, для которых τ ≤ [τ]"),
        ("uk", "перше значення ряду не менше ніж d_потр з тих, для яких τ ≤ [τ]"),
    ],
)
def test_the_sheet_says_for_which_sizes_the_condition_holds(
    plan: Plan, language: str, said: str
) -> None:
    assert deciding(plan.quantities["wire"], plan, Words(language)) == said


def test_a_strength_that_is_read_from_a_table_is_written_with_its_symbol(plan: Plan) -> None:
    wire = plan.quantities["wire"]
    assert wire.choice is not None
    condition = formula_of('stress <= 0.4*lookup("wire.strength", wire)', {})
    reading = replace(wire, choice=replace(wire.choice, condition=condition))
    assert condition_text(reading, plan, "en") == "τ ≤ 0.4 · σ_u(d)"
