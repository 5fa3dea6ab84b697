"""One factor in formulas that are alike: a habit that has no name costs once.

Whoever takes 3.71 times the right number at both ends of a range has done one thing wrongly, though
nobody knows what. Two numbers that are wrong for two reasons are as many times the right ones by
chance only: their factors scatter by e to the 1.5, so that one pair of 250 agrees within half a per
cent, and fewer the more figures are written.
"""

import math
from collections.abc import Sequence
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.rounding import reach_of
from gripcourse.grading.same_slip import likenesses
from gripcourse.grading.submission_case import (
    GradingCase,
    JudgedAnswer,
    cost_already,
    in_order_of_steps,
    is_unexplained,
)
from gripcourse.text.words import message

# Relative: of a factor that is known less narrowly another may be the same by chance.
_NARROW: Final = 0.005


def same_factor_once(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Let a wrong factor without a name cost the first of the formulas that are alike.

    Args:
        case: the submission.
        judged: every answer.

    Returns:
        The same in the same order.
    """
    wrong = [
        (one, found)
        for one in in_order_of_steps(case, judged)
        if one.quantity.kind is Kind.FORMULA
        and is_unexplained(case, one)
        and (found := _factor(one.comparison)) is not None
    ]
    repeated: dict[str, JudgedAnswer] = {}
    for place, (later, factor) in enumerate(wrong):
        for first, other in wrong[:place]:
            if first.quantity.id not in repeated and _is_one(case, first, later, other, factor):
                repeated[later.quantity.id] = _carried(case, later, first)
                break
    return [repeated.get(one.quantity.id, one) for one in judged]


def _factor(comparison: Comparison | None) -> tuple[float, float] | None:
    """Return between which bounds the factor lies that a number is wrong by; None if too far."""
    if comparison is None or not comparison.value:
        return None
    below, above = reach_of(comparison.answer, comparison.policy)
    ends = comparison.follows.low, comparison.follows.high
    if not all(map(math.isfinite, ends)) or ends[0] * ends[1] <= 0:
        return None
    value = comparison.value
    factors = [typed / end for typed in (value - below, value + above) for end in ends]
    low, high = min(factors), max(factors)
    return (low, high) if high - low <= _NARROW * min(abs(low), abs(high)) else None


def _is_one(
    case: GradingCase,
    first: JudgedAnswer,
    later: JudgedAnswer,
    one: tuple[float, float],
    other: tuple[float, float],
) -> bool:
    """Tell whether two answers of formulas that are alike are wrong by one factor."""
    if one[0] > other[1] or other[0] > one[1]:
        return False
    return not set(likenesses(case, first)).isdisjoint(likenesses(case, later))


def _carried(case: GradingCase, later: JudgedAnswer, first: JudgedAnswer) -> JudgedAnswer:
    said = message(
        "Wrong by the same factor as {title}; that has cost already.",
        title=first.quantity.short_title,
    )
    return cost_already(case, later, first.quantity.id, said)
