"""One number that is asked for in two cells: computed wrongly once, it is one mistake.

The force at each of four points that stand alike is one calculation, written down four times.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.submission_case import GradingCase, JudgedAnswer, cost_already
from gripcourse.text.words import message

_SAME: Final = 1e-9


def same_numbers(case: GradingCase, judged: Sequence[JudgedAnswer]) -> Mapping[str, str]:
    """Return for each wrong answer that only repeats an earlier one the first of them, by id.

    Both ask for one number, by the reference and at the student's own numbers, and both cells hold
    one other number.
    """
    mistaken = {
        one.quantity.id: one.comparison
        for one in judged
        if one.quantity.kind is Kind.FORMULA
        and one.comparison is not None
        and one.judgement.outcome.traits.mistake
    }
    wrong = [mistaken[name] for name in case.plan.quantities if name in mistaken]
    found: dict[str, str] = {}
    for place, later in enumerate(wrong):
        for first in wrong[:place]:
            if first.quantity.id not in found and _repeats(later, first):
                found[later.quantity.id] = first.quantity.id
                break
    return found


def _asks_the_same(one: Comparison, other: Comparison) -> bool:
    """Tell whether two answers ask for one number, by the reference and at the student's own."""
    return (
        one.quantity.unit == other.quantity.unit
        and math.isclose(one.reference, other.reference, rel_tol=_SAME)
        and math.isclose(one.expected, other.expected, rel_tol=_SAME)
    )


def _repeats(later: Comparison, first: Comparison) -> bool:
    # Zeros are typed for many reasons.
    is_same = later.value != 0 and math.isclose(later.value, first.value, rel_tol=_SAME)
    return is_same and _asks_the_same(later, first)


def same_number_once(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Let a wrong number that stands in several cells cost the first of them.

    Args:
        case: the submission.
        judged: every answer.

    Returns:
        The same in the same order.
    """
    found = same_numbers(case, judged)
    return [
        one if one.quantity.id not in found else _repeated(case, one, found[one.quantity.id])
        for one in judged
    ]


def _repeated(case: GradingCase, judged: JudgedAnswer, first: str) -> JudgedAnswer:
    said = message(
        "The same wrong number as in {title}; that has cost already.",
        title=case.plan.quantities[first].short_title,
    )
    return cost_already(case, judged, first, said)
