"""How far the number in a student's calculator may be from the number in the cell."""

import math

from gripcourse.course.policy import Policy
from gripcourse.submission.model import Answer

_MORE = 5.0  # a digit more is ten times; binary fractions are not exact


def reach_of(answer: Answer, policy: Policy) -> float:
    """Return how far the number behind an answer may be from the typed one, in the declared unit.

    A spreadsheet drops the zeros of 5.00, so that a short number is no proof of a coarse one: a
    number counts as written with at least the figures that the policy asks for. But the zeros at
    the end of 102000 may only hold the place of digits that were rounded away.
    """
    half_unit = max(typed_half_unit(answer, policy), without_zeros(answer, policy))
    return 2 * policy.last_digit * half_unit


def typed_half_unit(answer: Answer, policy: Policy) -> float:
    """Return half a unit of the last digit that an answer counts as written with."""
    if answer.value is None:
        return 0.0
    return min(answer.half_unit, figure_half_unit(answer.value, policy.figures))


def without_zeros(answer: Answer, policy: Policy) -> float:
    """Return half a unit of the last digit before the zeros that end a whole number.

    Digits that the policy asks for count though they are zeros; 0 where no other zero is there.
    """
    if answer.value is None or answer.figures is None:
        return 0.0
    half_unit = figure_half_unit(answer.value, max(answer.figures, policy.figures))
    return half_unit if half_unit > answer.half_unit * _MORE else 0.0


def figure_half_unit(value: float, figures: int) -> float:
    """Return half a unit of the last of so many significant figures of a value; 0 for zero."""
    if value == 0 or not math.isfinite(value):
        return 0.0
    return 0.5 * 10.0 ** (math.floor(math.log10(abs(value))) - figures + 1)
