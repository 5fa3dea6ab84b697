"""Where the shelves of leaders stand so that no leader line runs through what is written.

Lengths are millimetres of paper, in the coordinates of the face.
"""

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import Point

Numbers = NDArray[np.float64]

_STEP: Final = 1.0  # from one place of a shelf to the next
_AROUND: Final = 30.0  # mm that a shelf is moved at most
_THROUGH: Final = 1e5  # what a line through a mark costs; a shelf that is moved, its square


def apart(
    places: Sequence[tuple[Point, float, float]],
    level: float,
    gap: float,
    never: Sequence[Box],
    rather_not: Sequence[Box],
) -> list[float] | None:
    """Return where each shelf begins, in the same order and as near to where it stood as can be.

    Args:
        places: of each shelf the point that its line begins at, its width, and where it begins now.
        level: height of the row of shelves.
        gap: from one shelf to the next.
        never: what no line may run through.
        rather_not: what as few lines as can be run through.

    Returns:
        None where every row lets a line through what it may not, or two lines cross.
    """
    moves = np.arange(-_AROUND, _AROUND + _STEP, _STEP)
    total, ways = np.zeros(1), list[NDArray[np.intp]]()
    lefts, knees = np.full(1, -np.inf), np.zeros(1)
    before: tuple[Point, float] = ((0.0, 0.0), 0.0)
    for at, width, left in places:
        here = left + moves
        ends = np.where(np.abs(at[0] - here) <= np.abs(at[0] - here - width), here, here + width)
        own = moves**2 + _THROUGH * _through(at, ends, level, rather_not)
        own[_through(at, ends, level, never) > 0] = np.inf
        apart_enough = lefts[:, None] + before[1] + gap <= here[None, :]
        if ways:
            apart_enough &= ~_cross(before[0], knees, at, ends, level)
        cost = np.where(apart_enough, total[:, None], np.inf)
        ways.append(cost.argmin(axis=0))
        total = cost.min(axis=0) + own
        lefts, knees, before = here, ends, (at, width)
    if not ways or not np.isfinite(total).any():
        return None
    chosen = [int(total.argmin())]
    for way in reversed(ways[1:]):
        chosen.append(int(way[chosen[-1]]))
    moved = moves[chosen[::-1]]
    return [float(left + by) for (_, _, left), by in zip(places, moved, strict=True)]


def _through(at: Point, ends: Numbers, level: float, boxes: Sequence[Box]) -> NDArray[np.intp]:
    """Return how many boxes the lines from a point to places on a level run through."""
    found = np.zeros(len(ends), dtype=np.intp)
    rise = level - at[1]
    for box in boxes:
        low, high = max(box.bottom, min(at[1], level)), min(box.top, max(at[1], level))
        if low < high and rise:
            xs = [at[0] + (ends - at[0]) * (y - at[1]) / rise for y in (low, high)]
            found += (np.minimum(*xs) < box.right) & (box.left < np.maximum(*xs))
    return found


def _cross(
    first: Point, knees: Numbers, second: Point, ends: Numbers, level: float
) -> NDArray[np.bool_]:
    """Tell which lines from one point to a level cross which lines from another one."""
    height = max(first[1], second[1])
    if height >= level:
        return np.zeros((len(knees), len(ends)), dtype=np.bool_)
    one = first[0] + (knees - first[0]) * (height - first[1]) / (level - first[1])
    other = second[0] + (ends - second[0]) * (height - second[1]) / (level - second[1])
    return np.asarray((one[:, None] - other[None, :]) * (knees[:, None] - ends[None, :]) <= 0)
