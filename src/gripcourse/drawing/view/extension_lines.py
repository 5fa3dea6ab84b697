"""Where extension lines begin: on a line of the drawing, wherever the declared point lies.

Lengths are millimetres of the thing itself.
"""

import math
from collections.abc import Iterator, Sequence

from gripcourse.course.view import Side
from gripcourse.drawing.paper.strokes import Arc, Line, Stroke, points_of
from gripcourse.drawing.paper.text import Point

_ON = 0.05  # how near to a line a point lies on it
_FULL_TURN, _TURN = 360.0, 0.5  # degrees; how far beyond the end of an arc still counts
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
    if isinstance(stroke, Line):
        yield from _line_met(stroke, level, across)
    else:
        yield from _arc_met(stroke, level, across)


def _line_met(line: Line, level: float, across: int) -> Iterator[float]:
    start, end = line.start, line.end
    low, high = sorted((start[across], end[across]))
    if low - _ON <= level <= high + _ON:
        if high - low <= _ON:
            yield from (start[1 - across], end[1 - across])
        else:
            share = min(1.0, max(0.0, (level - start[across]) / (end[across] - start[across])))
            yield start[1 - across] + (end[1 - across] - start[1 - across]) * share


def _arc_met(arc: Arc, level: float, across: int) -> Iterator[float]:
    away = level - arc.centre[across]
    if abs(away) <= arc.radius + _ON:
        reach_along = math.sqrt(max(0.0, arc.radius**2 - away**2))
        for along in (reach_along, -reach_along):
            x, y = (along, away) if across else (away, along)
            turn = (math.degrees(math.atan2(y, x)) - arc.low) % _FULL_TURN
            if turn <= arc.high - arc.low + _TURN or turn >= _FULL_TURN - _TURN:
                yield arc.centre[1 - across] + along


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
