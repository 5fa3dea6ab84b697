"""How densely the numbers that people type lie at an answer, where they compute a result.

They round, or cut digits off; a cell loses the zeros at the end; and what nothing explains may be
anywhere.
"""

import math
from typing import Final

from gripcourse.grading.comparison import Comparison, ExpectedRange

# The last digits of a number differ by the route: 3.14159 for pi.
_FINEST: Final = 5e-6
# Of the value: few digits are no rounding of what lies farther off, 1 is none of 0.54.
_COARSEST: Final = 0.1
# Zeros that a cell has lost go on for three more digits at least.
_SHORTEST: Final = 1e-3
# A short number in a cell may have lost zeros of three figures, or of as many as the calculator
# has, or may have been typed so coarsely.
_ZEROS_LOST, _EXACT, _COARSE = 0.67, 0.3, 0.03
# The same of somebody whose other numbers all have as many figures.
_LOST_AS_OTHERS, _EXACT_UNLIKE_OTHERS = 0.95, 0.02
# Few round large whole numbers to the figures that are asked.
_ROUND_NUMBERS = 0.2
_SLACK: Final = 1e-9  # relative: what floating point leaves of equal numbers
# Spreads: farther off a log-normal density would be 0, and no other explanation could be weighed.
_FARTHEST: Final = 10.0


def density(comparison: Comparison, result: ExpectedRange) -> float:
    """Return how densely typed numbers lie at an answer, for people who compute this result."""
    if comparison.value == 0:
        return 0.0  # it has no last digit, and says nothing about where it comes from
    manner = comparison.manner
    rounded = manner.lost_zeros(comparison.answer, comparison.policy, manner.figures)
    as_typed = _as_typed(comparison, result)
    if rounded == 0:
        return as_typed
    # Zeros end a number by rounding, or by chance: each with one in ten.
    by_chance = (1 - _ROUND_NUMBERS) * comparison.answer.half_unit / rounded
    share = _ROUND_NUMBERS / (_ROUND_NUMBERS + by_chance)
    return share * _density(comparison, result, rounded) + (1 - share) * as_typed


def _as_typed(comparison: Comparison, result: ExpectedRange) -> float:
    value = comparison.value
    finest = _FINEST * abs(value)
    figures = comparison.manner.figures
    fine = max(comparison.manner.half_unit(comparison.answer, comparison.policy, figures), finest)
    coarse = max(min(comparison.answer.half_unit, _COARSEST * abs(value)), finest)
    if coarse <= fine:
        return _density(comparison, result, fine)
    lost, exact = (_LOST_AS_OTHERS, _EXACT_UNLIKE_OTHERS) if figures else (_ZEROS_LOST, _EXACT)
    return (
        lost * _density(comparison, result, fine)
        + exact * _density(comparison, result, max(finest, _SHORTEST * coarse))
        + _COARSE * _density(comparison, result, coarse)
    )


def _density(comparison: Comparison, result: ExpectedRange, half_unit: float) -> float:
    nearest = result.nearest(comparison.value)
    distance = abs(comparison.value - nearest)
    width = result.high - result.low
    cut = 2 * half_unit * comparison.policy.last_digit
    slack = _SLACK * abs(comparison.value)
    cuts_off = comparison.manner.cuts_off
    found = 0.0
    if distance <= half_unit + slack:
        found += (1 - cuts_off) / (width + 2 * half_unit)
    # What is cut off is written nearer to zero than it is.
    if half_unit < cut and distance <= cut + slack and abs(comparison.value) <= abs(nearest):
        found += cuts_off / (width + 2 * cut)
    return found


def unexplained(comparison: Comparison) -> float:
    """Return how densely wrong numbers that nothing explains lie at an answer.

    They scatter log-normally about the right one, and none is impossible; either sign may be wrong
    too.
    """
    size = abs(comparison.value)
    right = abs(
        comparison.reference if math.isfinite(comparison.reference) else comparison.expected
    )
    if size == 0 or right == 0 or not math.isfinite(right):
        return 1.0 / (size or 1.0)
    spread = comparison.policy.slips.spread
    away = min(abs(math.log(size / right) / spread), _FARTHEST)
    return math.exp(-away * away / 2) / (2 * size * spread * math.sqrt(2 * math.pi))


def furthest_met(comparison: Comparison) -> float:
    """Return how far from a result a typed number can be that it still speaks for."""
    half_units = (
        comparison.answer.half_unit,
        comparison.manner.half_unit(comparison.answer, comparison.policy),
        comparison.manner.lost_zeros(comparison.answer, comparison.policy),
        _FINEST * abs(comparison.value),
    )
    return max(half_units) * max(1.0, 2 * comparison.policy.last_digit) + _SLACK * abs(
        comparison.value
    )
