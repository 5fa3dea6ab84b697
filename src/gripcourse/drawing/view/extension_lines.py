"""Where extension lines begin: on a line of the drawing, wherever the declared point lies.

Lengths are millimetres of the thing itself.
"""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from gripcourse.course.view import Side
from gripcourse.drawing.paper.strokes import Stroke, points_of
from gripcourse.drawing.paper.text import Point

_ON = 0.05  # how near to a line a point lies on it
_UPRIGHT = {Side.LEFT, Side.RIGHT}


def begun(point: Point, side: Side, strokes: Sequence[Stroke]) -> Point:
    """Return where the extension line of a point begins: at the nearest line that it meets.

    Args:
        point: as it is declared.
        side: of the view, that the dimension stands on.
        strokes: of the face.

    Returns:
        The point itself where it lies on a line, or where its extension line meets none.
    """
    across = 1 if side in _UPRIGHT else 0  # the coordinate that an extension line keeps
    met = [one for stroke in strokes for one in _met(stroke, point[across], across)]
    nearest = min(met, key=lambda one: abs(one - point[1 - across]), default=math.nan)
    if math.isnan(nearest) or abs(nearest - point[1 - across]) <= _ON:
        return point
    return (nearest, point[1]) if across else (point[0], nearest)


def _met(stroke: Stroke, level: float, across: int) -> Iterator[float]:
    """Yield where a stroke meets the straight line at a level of one coordinate."""
    for start, end in pairwise(points_of(stroke)):
        low, high = sorted((start[across], end[across]))
        if not low - _ON <= level <= high + _ON:
            continue
        if high - low <= _ON:
            yield from (start[1 - across], end[1 - across])
            continue
        share = min(1.0, max(0.0, (level - start[across]) / (end[across] - start[across])))
        yield start[1 - across] + (end[1 - across] - start[1 - across]) * share


def reach(strokes: Sequence[Stroke], side: Side) -> tuple[Point, Point]:
    """Return the outermost points of strokes along a dimension of a side, and nearest to it."""
    along = 1 if side in _UPRIGHT else 0
    outward = -1.0 if side in {Side.LEFT, Side.BELOW} else 1.0
    points = [point for stroke in strokes for point in points_of(stroke)]

    def first(sign: float) -> Point:
        extreme = min(sign * point[along] for point in points)
        there = [point for point in points if sign * point[along] <= extreme + _ON]
        return max(there, key=lambda point: outward * point[1 - along])

    return first(1.0), first(-1.0)
