"""Which numbers of an input an answer leaves, at the precision that it was typed with."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from gripcourse.grading.comparison import Comparison
from gripcourse.grading.unwritten import carried_here
from gripcourse.text.units import factor

Array: TypeAlias = NDArray[np.float64]

# A wrong number is looked for between a tenth and ten times the right one.
_SPAN: Final = np.geomspace(0.1, 10.0, 1601)
_FINEST: Final = 5e-6
# Rounded inputs that move a result further leave nothing to tell it by.
_MOST_SPREAD: Final = 0.02


@dataclass(frozen=True, slots=True)
class Span:
    """What one answer leaves of an input: from … to, SI."""

    low: float
    high: float


def reach(comparison: Comparison) -> float:
    """Return how far a typed number may be from what the formula gives at the right input.

    Digits may be cut off, and the other inputs stand for more digits than were typed.
    """
    answer, policy, follows = comparison.answer, comparison.policy, comparison.follows
    half_unit = max(
        comparison.manner.half_unit(answer, policy),
        comparison.manner.lost_zeros(answer, policy),
        _FINEST * abs(comparison.value),
    )
    spread = (follows.high - follows.low) / 2
    if not (math.isfinite(spread) and follows.value):
        return 2 * policy.last_digit * half_unit
    share = min(spread / abs(follows.value), _MOST_SPREAD)
    return 2 * policy.last_digit * half_unit + share * abs(comparison.value)


def spans(comparison: Comparison, name: str) -> Iterator[Span]:
    """Yield the ranges of an input in which a student's other numbers give the answer."""
    tried = float(comparison.follow_through.evaluation.values[name]) * _SPAN
    size = factor(comparison.quantity.unit)
    away = carried_here(comparison, name, tried) - comparison.value * size
    half = reach(comparison) * size
    for place in np.flatnonzero(np.sign(away[:-1]) * np.sign(away[1:]) < 0).tolist():
        yield _between(tried, away, place, half)


def _between(tried: Array, away: Array, place: int, half: float) -> Span:
    """Return the range round a crossing, on the straight line between two tried values."""
    first, second = float(tried[place]), float(tried[place + 1])
    before, after = float(away[place]), float(away[place + 1])
    slope = (after - before) / (second - first)
    root = first - before / slope
    # The line bends between tried values; its sagitta is far below their distance.
    width = abs(half / slope) + 1e-4 * abs(second - first)
    return Span(root - width, root + width)


def overlaps(found: Sequence[Span]) -> Iterator[tuple[float, float]]:
    """Yield the middle and the width of what spans have in common, once for each span's start."""
    for start in found:
        inside = [span for span in found if span.low <= start.low <= span.high]
        low, high = max(span.low for span in inside), min(span.high for span in inside)
        yield (low + high) / 2, high - low
