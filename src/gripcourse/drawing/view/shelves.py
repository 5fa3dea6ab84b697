"""Where the shelves of leaders stand so that no leader line runs through what is written.

Lengths are millimetres of paper, in the coordinates of the face.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import Point

Numbers = NDArray[np.float64]

_STEP: Final = 1.0  # from one place of a shelf to the next
_AROUND: Final = 30.0  # mm that a shelf is moved at most
_MOVES: Final = np.arange(-_AROUND, _AROUND + _STEP, _STEP)
_THROUGH: Final = 1e5  # what a line through a mark costs; a shelf that is moved, its square


@dataclass(frozen=True, slots=True)
class LeaderShelf:
    """A shelf that is looked for a place.

    Attributes:
        at: the point that its line begins at.
        width: of the shelf.
        left: where it begins now.
    """

    at: Point
    width: float
    left: float


@dataclass(frozen=True, slots=True, eq=False)
class Places:
    """Where a shelf can stand: (places,) each.

    Attributes:
        lefts: where it begins.
        knees: where its line meets it.
        costs: what speaks against it; infinite where it cannot be.
    """

    lefts: Numbers
    knees: Numbers
    costs: Numbers


def places_in(
    level: float, never: Sequence[Box], rather_not: Sequence[Box]
) -> Callable[[LeaderShelf], Places]:
    """Return what tells where a shelf can stand in a row; it is asked about many again.

    Args:
        level: height of the row.
        never: what no line may run through.
        rather_not: what as few lines as can be run through.
    """
    closed, dear = _edges(never), _edges(rather_not)

    @cache
    def places(shelf: LeaderShelf) -> Places:
        at, here = shelf.at, shelf.left + _MOVES
        nearer = np.abs(at[0] - here) <= np.abs(at[0] - here - shelf.width)
        ends = np.where(nearer, here, here + shelf.width)
        costs = _MOVES**2 + _THROUGH * _through(at, ends, level, dear)
        costs[_through(at, ends, level, closed) > 0] = np.inf
        return Places(here, ends, costs)

    return places


def apart(
    shelves: Sequence[LeaderShelf],
    level: float,
    gap: float,
    places: Callable[[LeaderShelf], Places],
) -> list[float] | None:
    """Return where each shelf begins, in the same order and as near to where it stood as can be.

    Args:
        shelves: from left to right.
        level: height of the row of shelves.
        gap: from one shelf to the next.
        places: see `places_in`.

    Returns:
        None where every row lets a line through what it may not, or two lines cross.
    """
    if not shelves:
        return None
    here = places(shelves[0])
    total, ways = here.costs, list[NDArray[np.intp]]()
    for before, shelf in pairwise(shelves):
        left, here = here, places(shelf)
        fits = (left.lefts + before.width + gap)[:, None] <= here.lefts
        fits &= ~_cross(before.at, left.knees, shelf.at, here.knees, level)
        cost = np.where(fits, total[:, None], np.inf)
        ways.append(cost.argmin(axis=0))
        total = cost.min(axis=0) + here.costs
    if not np.isfinite(total).any():
        return None
    chosen = [int(total.argmin())]
    for way in reversed(ways):
        chosen.append(int(way[chosen[-1]]))
    moved = _MOVES[chosen[::-1]]
    return [float(shelf.left + by) for shelf, by in zip(shelves, moved, strict=True)]


def _through(at: Point, ends: Numbers, level: float, edges: Numbers) -> NDArray[np.intp]:
    """Return how many boxes the lines from a point to places on a level run through.

    Args:
        at: where all lines begin.
        ends: (lines,); where on the level each ends.
        level: its height.
        edges: of the boxes; see `_edges`.
    """
    rise = level - at[1]
    low = np.maximum(edges[1], min(at[1], level))
    high = np.minimum(edges[3], max(at[1], level))
    if not rise:
        return np.zeros(len(ends), dtype=np.intp)
    met = low < high
    heights = np.stack((low[met], high[met]))[:, :, None]
    xs = at[0] + (ends - at[0]) * (heights - at[1]) / rise
    within = (xs.min(axis=0) < edges[2, met, None]) & (edges[0, met, None] < xs.max(axis=0))
    return np.asarray(within.sum(axis=0))


def _edges(boxes: Sequence[Box]) -> Numbers:
    """Return left, bottom, right and top edges of boxes: (4, boxes)."""
    sides = [(box.left, box.bottom, box.right, box.top) for box in boxes]
    return np.array(sides, dtype=np.float64).reshape(-1, 4).T


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
