"""Constants as people shorten them: 10 for 9.81 on the right formula is coarse, and no slip."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from gripcourse.course.quantity import Kind
from gripcourse.formula.tree import Formula, Name, walk
from gripcourse.grading.comparison import Comparison, ExpectedRange, Judgement, conclude
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.rounding import typed_half_unit, without_zeros
from gripcourse.slips.rewrite import number, renamed
from gripcourse.text.words import message


@dataclass(frozen=True, slots=True)
class Shortened:
    """A formula with one constant as people shorten it; its value in SI."""

    name: str
    value: float
    formula: Formula


def with_shortened(
    formula: Formula, habits: Mapping[str, tuple[float, ...]]
) -> Iterator[Shortened]:
    """Yield a formula with the constants that it uses as people shorten them, one at a time."""
    for name, values in habits.items():
        if name in formula.names or any(part == Name(name) for part in walk(formula.tree)):
            for value in values:
                tree = renamed(formula.tree, {name: number(value)})
                yield Shortened(name, value, Formula("", tree, formula.units))


def shortened_in(comparison: Comparison) -> tuple[Shortened, Against] | None:
    """Return the shortened constant that a number was computed with, and from whose numbers.

    The number must be met as exactly as it was typed: the band is wide enough for other mistakes.
    """
    formula = comparison.plan.reference_formula(comparison.quantity.id)
    if formula is None or comparison.quantity.kind is not Kind.FORMULA or not comparison.value:
        return None
    for one in with_shortened(formula, comparison.policy.habits):
        exact = comparison.at_reference(one.formula)
        if _meets(comparison, comparison.at_own(one.formula)):
            return one, Against.OWN_INPUTS
        if _meets(comparison, ExpectedRange(exact, exact, exact)):
            return one, Against.REFERENCE
    return None


def judge_shortened(comparison: Comparison) -> Judgement | None:
    """Conclude that a number is right but for a constant that was shortened too far."""
    found = shortened_in(comparison)
    if found is None:
        return None
    one, against = found
    said = message(
        "Right, but with {value} for {title}, which is too coarse here.",
        value=one.value,
        title=comparison.plan.quantities[one.name].title if one.name != "pi" else "π",
    )
    return conclude(comparison, Outcome.ROUGH, against, comparison.policy.rough_credit, said)


def _meets(comparison: Comparison, result: ExpectedRange) -> bool:
    answer, policy = comparison.answer, comparison.policy
    half_unit = max(
        typed_half_unit(answer, policy), without_zeros(answer, policy), 1e-6 * abs(comparison.value)
    )
    away = abs(comparison.value - result.nearest(comparison.value))
    return math.isfinite(result.value) and away <= 2 * policy.last_digit * half_unit
