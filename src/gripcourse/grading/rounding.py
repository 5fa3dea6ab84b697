"""How far the number in a student's calculator may be from the number in the cell."""

import math

from gripcourse.policy.model import Policy
from gripcourse.submission.model import Answer

_FINEST = 1e-6  # relative: what the route of a calculation makes of its last digits
_EDGE = 1e-12
_MORE = 5.0  # a digit more is ten times; binary fractions are not exact


def reach_of(answer: Answer, policy: Policy) -> tuple[float, float]:
    """Return how far below and above a typed number the one behind it may be, in the declared unit.

    Rounding moves a number by half a unit of its last digit at most; cutting off moves it by up to
    a whole one, but only towards zero. A spreadsheet drops the zeros of 5.00, so that a short
    number is no proof of a coarse one: a number counts as written with at least the figures that
    the policy asks for. But the zeros at the end of 102000 may only hold the place of lost digits.
    """
    half_unit = max(typed_half_unit(answer, policy), without_zeros(answer, policy))
    nearer, further = half_unit * inward(policy), 2 * policy.last_digit * half_unit
    is_negative = answer.value is not None and answer.value < 0
    return (further, nearer) if is_negative else (nearer, further)


def inward(policy: Policy) -> float:
    """Return how much nearer to zero a number may be than typed, in halves of its last unit."""
    return min(2 * policy.last_digit, 1.0)


def cuts_off(policy: Policy) -> bool:
    """Tell whether the policy thinks of people who cut digits off."""
    return 2 * policy.last_digit > 1.0


def endings(policy: Policy) -> tuple[bool, ...]:
    """Return whether digits may have been cut off, for each way in which people lose them."""
    return (False, True) if cuts_off(policy) else (False,)


def typed_half_unit(answer: Answer, policy: Policy, figures: int = 0) -> float:
    """Return half a unit of the last digit that an answer counts as written with.

    Args:
        answer: what was typed.
        policy: says with how many figures a number counts as written at least.
        figures: of the student's other numbers, as far as that is known.
    """
    if answer.value is None:
        return 0.0
    return min(answer.half_unit, figure_half_unit(answer.value, max(policy.figures, figures)))


def without_zeros(answer: Answer, policy: Policy, figures: int = 0) -> float:
    """Return half a unit of the last digit before the zeros that end a whole number.

    Digits that the policy asks for count though they are zeros, and as many as the student's other
    numbers have, as far as that is known; 0 where no other zero is there.
    """
    if answer.value is None or answer.figures is None:
        return 0.0
    half_unit = figure_half_unit(answer.value, max(answer.figures, policy.figures, figures))
    return half_unit if half_unit > answer.half_unit * _MORE else 0.0


def met_as_typed(answer: Answer, value: float, result: float, policy: Policy) -> bool:
    """Tell whether a result is a typed number as exactly as that was typed.

    Args:
        answer: what was typed.
        value: of it, in the declared unit.
        result: in the declared unit; NaN is met by nothing.
        policy: how people type.
    """
    half_unit = max(
        typed_half_unit(answer, policy), without_zeros(answer, policy), _FINEST * abs(value)
    )
    return abs(value - result) <= 2 * policy.last_digit * half_unit


def figure_half_unit(value: float, figures: int) -> float:
    """Return half a unit of the last of so many significant figures of a value; 0 for zero."""
    if value == 0 or not math.isfinite(value):
        return 0.0
    return 0.5 * 10.0 ** (math.floor(math.log10(abs(value))) - figures + 1)


def kept_figures(value: float, figures: int, *, cut: bool) -> float:
    """Return a value as it is written with so many significant figures: 355.35 as 355.4.

    Args:
        value: in the unit that it is written in.
        figures: how many are kept.
        cut: whether the others are cut off, not rounded.
    """
    unit = 2 * figure_half_unit(value, figures)
    if not unit:
        return value
    # Binary fractions are not exact: 355.35 is stored as something below it.
    units = math.floor(abs(value) / unit * (1 + _EDGE) + (0.0 if cut else 0.5))
    return math.copysign(units * unit, value)
