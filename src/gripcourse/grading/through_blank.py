"""What an answer is through steps that were left blank, as people compute them.

Who writes a step down has the next answer judged from the number in its cell, whatever was lost on
the way to it. Who leaves it blank is not judged more strictly: half of 3.14 may be the right angle
that a difference of near numbers was computed with.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.formula.tree import Formula
from gripcourse.grading.blank_ways import BlankWay, ways_through
from gripcourse.grading.comparison import NOWHERE, Comparison, ExpectedRange
from gripcourse.grading.rounding import kept_figures
from gripcourse.grading.shortened import EXACTLY, uses_constant, with_constants
from gripcourse.grading.unwritten import unwritten_before
from gripcourse.policy.bands import computed_band_rule, within
from gripcourse.solver.plan import Plan
from gripcourse.solver.size_numbers import choose_number
from gripcourse.text.units import factor


@dataclass(frozen=True, slots=True)
class ThroughBlank:
    """What an answer is by a way.

    Attributes:
        way: how the steps before it were computed.
        expected: the answer, in the declared unit; of a choice what is required.
        constant: that takes some step out of its band as it was shortened; empty for none.
    """

    way: BlankWay
    expected: ExpectedRange
    constant: str

    @property
    def coarse(self) -> bool:
        """Whether a step would have been too coarse in its cell."""
        return self.way.coarse or bool(self.constant)


def through_blank(comparison: Comparison) -> Iterator[ThroughBlank]:
    """Yield what an answer is by each way through the steps before it that were left blank."""
    blank, exact = _blank_steps(comparison), _exactly(comparison)
    if not blank or not _is_near(comparison, exact.value):
        return
    for way in ways_through(comparison.plan, comparison.policy, (*blank, comparison.quantity)):
        found, constant = _computed(comparison, blank, way)
        for constants in _of_the_answer(comparison, way.constants):
            here = _result(comparison, comparison.quantity, found, constants)
            moved = here / factor(comparison.quantity.unit) - exact.value
            if math.isfinite(moved):
                too = constant or _too_coarse(comparison, comparison.quantity, found, constants)
                yield ThroughBlank(way, exact.moved(moved), too)


def _blank_steps(comparison: Comparison) -> list[Quantity]:
    """Return what leads to an answer through no number of the student's, in order."""
    before = set(unwritten_before(comparison))
    steps = [one for name, one in comparison.plan.quantities.items() if name in before]
    return steps if any(one.kind.answered for one in steps) else []


def _exactly(comparison: Comparison) -> ExpectedRange:
    """Return what follows if every blank step was computed exactly, of a choice what it needs."""
    if comparison.quantity.kind is not Kind.CHOICE:
        return comparison.follows
    formula = comparison.plan.reference_formula(comparison.quantity.id)
    return NOWHERE if formula is None else comparison.at_own(formula)


def _is_near(comparison: Comparison, exact: float) -> bool:
    """Tell whether an answer may be led to by what is lost on the way."""
    if comparison.quantity.kind is Kind.CHOICE:
        return math.isfinite(exact)
    return abs(comparison.value - exact) <= comparison.widest_round(exact)


def _of_the_answer(
    comparison: Comparison, constants: Mapping[str, float]
) -> tuple[Mapping[str, float], ...]:
    """Return what constants may be shortened to in the answer's own formula."""
    own = uses_constant(comparison.plan, comparison.quantity.id, constants)
    return (constants, EXACTLY) if own else (EXACTLY,)


def _computed(
    comparison: Comparison, blank: Sequence[Quantity], way: BlankWay
) -> tuple[dict[str, float], str]:
    """Compute the blank steps by a way.

    Returns:
        All numbers, SI, and a constant that takes some step out of its band; empty for none.
    """
    found, constant = dict(comparison.follow_through.numbers.values), ""
    for one in blank:
        if one.id in way.formulas:
            found[one.id] = _read_otherwise(comparison.plan, one, way.formulas[one.id], found)
        else:
            found[one.id] = _result(comparison, one, found, way.constants)
            constant = constant or _too_coarse(comparison, one, found, way.constants)
        if way.figures and one.kind is Kind.FORMULA and not (one.exact or one.integer):
            scale = factor(one.unit)
            found[one.id] = scale * kept_figures(found[one.id] / scale, way.figures, cut=way.cut)
    return found, constant


def _read_otherwise(
    plan: Plan, quantity: Quantity, formula: Formula, found: Mapping[str, float]
) -> float:
    """Compute a blank step by another formula, SI."""
    result = evaluate_number(formula, quantity.unit, found, plan.columns)
    return choose_number(plan, quantity, result, found)


def _result(
    comparison: Comparison,
    quantity: Quantity,
    found: Mapping[str, float],
    constants: Mapping[str, float],
) -> float:
    """Compute a step from other numbers, SI; of the answer that is a choice what it needs."""
    plan = comparison.plan
    formula = with_constants(plan, quantity.id, constants)
    if formula is None:
        return found[quantity.id]
    result = evaluate_number(formula, quantity.unit, found, plan.columns)
    if quantity.choice is None or quantity.id == comparison.quantity.id:
        return result
    return choose_number(plan, quantity, result, found)


def _too_coarse(
    comparison: Comparison,
    quantity: Quantity,
    found: Mapping[str, float],
    constants: Mapping[str, float],
) -> str:
    """Return the constant which, shortened, takes a step out of its band; empty for none."""
    plan, scale = comparison.plan, factor(quantity.unit)
    for name, value in constants.items():
        if uses_constant(plan, quantity.id, (name,)):
            exact = _result(comparison, quantity, found, EXACTLY) / scale
            shortened = _result(comparison, quantity, found, {name: value}) / scale
            half_width = computed_band_rule(quantity, comparison.policy).round(exact)
            if not within(shortened, exact, half_width):
                return name
    return ""
