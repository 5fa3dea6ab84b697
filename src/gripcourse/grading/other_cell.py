"""A number that stands in two cells: it may have been written into the wrong one."""

import math
from collections.abc import Collection
from typing import Final

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.explain import Weighed
from gripcourse.grading.rounding import typed_half_unit
from gripcourse.text.units import factor

# How common it is, on the scale of the priors of slips: from the cell beside, from elsewhere.
_BESIDE, _ELSEWHERE = 3.0, 1.0
_SAME: Final = 1e-9
# Results that are alike so far come from one calculation.
_ALIKE: Final = 1e-6
_RIGHT: Final = 0.02


def weigh_other_cell(comparison: Comparison) -> tuple[str | None, float]:
    """Weigh that an answer is the number of another one.

    Returns:
        The other answer and the weight; None and 0 where no other has the same number.
    """
    order = [one.id for one in comparison.plan.answered]
    place = order.index(comparison.quantity.id)
    beside = {*order[max(0, place - 1) : place], *order[place + 1 : place + 2]}
    same = [name for name in order if _holds_the_same(comparison, name, beside)]
    half_unit = typed_half_unit(comparison.answer, comparison.policy)
    if not same or not half_unit:
        return None, 0.0
    near = [name for name in same if name in beside]
    elsewhere = (len(same) - len(near)) / max(1, len(order) - len(beside))
    prior = _BESIDE * len(near) / max(1, len(beside)) + _ELSEWHERE * elsewhere
    return (near or same)[0], prior / (2 * half_unit)


def is_number_of(comparison: Comparison, other: str, method: Weighed) -> bool:
    """Tell whether a wrong method computes what another answer is, as its own formula does.

    The height at the other end of a range is what the next answer asks for.
    """
    if method.of != comparison.quantity.id:
        return False
    unit = factor(comparison.plan.quantities[other].unit)
    numbers = (
        comparison.follow_through.numbers.computed.get(other, math.nan),
        comparison.follow_through.known.get(other, math.nan),
    )
    return any(math.isclose(method.value, one / unit, rel_tol=_ALIKE) for one in numbers)


def _holds_the_same(comparison: Comparison, name: str, beside: Collection[str]) -> bool:
    """Tell whether another cell has the same number, and not because it happens so.

    A size or a count is short and met by chance: it was copied only from or into the cell above or
    below.
    """
    quantity = comparison.plan.quantities[name]
    number = comparison.follow_through.known.get(name)
    if number is None or name == comparison.quantity.id or quantity.kind is Kind.VERDICT:
        return False
    if name not in beside and any(map(_is_short, (quantity, comparison.quantity))):
        return False
    if not math.isclose(number / factor(quantity.unit), comparison.value, rel_tol=_SAME):
        return False
    right = comparison.reference_values.get(name, math.nan)
    if math.isclose(right / factor(quantity.unit), comparison.reference, rel_tol=_SAME):
        return False  # both cells ask for one number: neither was mistaken for the other
    return math.isclose(number, right, rel_tol=_RIGHT) or not _rests_on(comparison, name)


def _is_short(quantity: Quantity) -> bool:
    return quantity.exact or quantity.integer


def _rests_on(comparison: Comparison, name: str) -> bool:
    """Tell whether another answer is computed from this one: then it has its number from here."""
    waiting, seen = [name], set[str]()
    while waiting:
        one = waiting.pop()
        if one == comparison.quantity.id:
            return True
        if one not in seen:
            seen.add(one)
            waiting += comparison.plan.inputs[one]
    return False
