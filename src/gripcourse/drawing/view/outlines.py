"""From a shape's numbers to its strokes and to what it covers. Lengths in mm, angles in degrees."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gripcourse.drawing.paper.strokes import (
    Arc,
    Line,
    Stroke,
    on_circle,
    points_of,
    settled_angle,
)
from gripcourse.drawing.paper.text import Point

_FULL_TURN, _QUARTER = 360.0, 90.0
_AXIS_BEYOND = 1.25  # how far the axes of a pin reach, in radii
_WAVES, _WAVE_STEPS = 1.5, 24  # of a line of break, and the chords that it is drawn in
_WAVE = 0.12  # how far it swings, of the width of what it breaks off
_SHARPEST = 0.25  # smallest cosine of half a bend whose corner is still drawn pointed


@dataclass(frozen=True, slots=True)
class Outline:
    """What a shape looks like.

    Attributes:
        strokes: in the line of the shape.
        axes: in the line of centres.
        mask: the closed polygon that it covers; empty for one that covers nothing.
    """

    strokes: tuple[Stroke, ...]
    axes: tuple[Stroke, ...] = ()
    mask: tuple[Point, ...] = ()


def outline(kind: str, needs: Mapping[str, Sequence[float]]) -> Outline:
    """Draw a shape from the numbers of its keys, points as x and y in turn."""
    return _OUTLINES[kind](needs)


def _box(needs: Mapping[str, Sequence[float]]) -> Outline:
    (left, right), (bottom, top) = needs["x"], needs["y"]
    return _closed([(left, bottom), (right, bottom), (right, top), (left, top)])


def _polygon(needs: Mapping[str, Sequence[float]]) -> Outline:
    return _closed(_points(needs["corners"]))


def _line(needs: Mapping[str, Sequence[float]]) -> Outline:
    return Outline(_chain(_points(needs["through"])))


def _circle(needs: Mapping[str, Sequence[float]]) -> Outline:
    circle = Arc(_point(needs["at"]), needs["diameter"][0] / 2)
    return Outline((circle,), mask=tuple(points_of(circle)[:-1]))


def _pin(needs: Mapping[str, Sequence[float]]) -> Outline:
    circle = Arc(_point(needs["at"]), needs["diameter"][0] / 2)
    (x, y), reach = circle.centre, circle.radius * _AXIS_BEYOND
    axes = (Line((x - reach, y), (x + reach, y)), Line((x, y - reach), (x, y + reach)))
    return Outline((circle,), axes, tuple(points_of(circle)[:-1]))


def _arc(needs: Mapping[str, Sequence[float]]) -> Outline:
    return Outline((_turned(needs),))


def _sector(needs: Mapping[str, Sequence[float]]) -> Outline:
    arc = _turned(needs)
    if arc.is_circle:
        return Outline((arc,), mask=tuple(points_of(arc)[:-1]))
    rim = points_of(arc)
    sides: tuple[Stroke, ...] = (Line(arc.centre, rim[0]), Line(rim[-1], arc.centre))
    return Outline((arc, *sides), mask=(arc.centre, *rim))


def _bar(needs: Mapping[str, Sequence[float]]) -> Outline:
    """Draw a bar of even width along a chain of points, round at both ends and outside of bends."""
    middle = [*_points(needs["through"])]
    half = needs["width"][0] / 2
    there, back = _side(middle, half), _side(middle[::-1], half)
    strokes = [*there, _end(middle[-2], middle[-1], half), *back, _end(middle[1], middle[0], half)]
    return Outline(tuple(strokes), mask=_along(strokes))


def _side(middle: Sequence[Point], half: float) -> Iterator[Stroke]:
    """Yield the right side of a bar, in its direction; it is drawn round where it is outside."""
    directions = [_direction(*pair) for pair in pairwise(middle)]
    last = on_circle(middle[0], half, directions[0] - _QUARTER)
    for corner, before, after in zip(middle[1:], directions, directions[1:], strict=False):
        bend = (after - before + _FULL_TURN / 2) % _FULL_TURN - _FULL_TURN / 2
        if bend > 0:
            arc = Arc(corner, half, before - _QUARTER, before - _QUARTER + bend)
            first, *_, end = points_of(arc)
            yield from (Line(last, first), arc)
        else:
            reach = half / max(_SHARPEST, math.cos(math.radians(bend / 2)))
            end = on_circle(corner, reach, before + bend / 2 - _QUARTER)
            yield Line(last, end)
        last = end
    yield Line(last, on_circle(middle[-1], half, directions[-1] - _QUARTER))


def _end(before: Point, end: Point, half: float) -> Arc:
    along = _direction(before, end)
    return Arc(end, half, along - _QUARTER, along + _QUARTER)


def _taper(needs: Mapping[str, Sequence[float]]) -> Outline:
    """Draw two circles and the lines that touch both from outside, with what lies between them."""
    start, end = _point(needs["start"]), _point(needs["end"])
    first, second = (width / 2 for width in needs["widths"])
    length = math.dist(start, end)
    if length <= abs(first - second):
        return _circle({"at": start if first > second else end, "diameter": [max(needs["widths"])]})
    along = _direction(start, end)
    lean = settled_angle(math.degrees(math.acos((first - second) / length)))
    ends = (
        Arc(end, second, along - lean, along + lean),
        Arc(start, first, along + lean, along - lean + _FULL_TURN),
    )
    (below, *_, above), (over, *_, under) = (points_of(one) for one in ends)
    strokes = (Line(under, below), ends[0], Line(above, over), ends[1])
    return Outline(strokes, mask=_along(strokes))


def _along(strokes: Sequence[Stroke]) -> tuple[Point, ...]:
    """Return the corners of what strokes enclose, each of which begins where the last one ends."""
    return tuple(point for stroke in strokes for point in points_of(stroke)[:-1])


def _section(needs: Mapping[str, Sequence[float]]) -> Outline:
    """Draw a rectangle half way between two points, its length along them."""
    first, *_, last = _points(needs["through"])
    turn, half = _direction(first, last), needs["length"][0] / 2
    middle = ((first[0] + last[0]) / 2, (first[1] + last[1]) / 2)
    ends = [on_circle(middle, along, turn) for along in (-half, half)]
    across = needs["width"][0] / 2
    sides = ((ends[0], -_QUARTER), (ends[1], -_QUARTER), (ends[1], _QUARTER), (ends[0], _QUARTER))
    return _closed([on_circle(end, across, turn + side) for end, side in sides])


def _broken(needs: Mapping[str, Sequence[float]]) -> Outline:
    """Draw the line of break of a local section; the lines of its other edges are others' lines."""
    (broken, edge), (bottom, top) = needs["x"], needs["y"]
    swing, step = _WAVE * (edge - broken), (top - bottom) / _WAVE_STEPS
    wave = [
        (broken + swing * math.sin(math.tau * _WAVES * k / _WAVE_STEPS), bottom + step * k)
        for k in range(_WAVE_STEPS + 1)
    ]
    return Outline(_chain(wave), mask=(*wave, (edge, top), (edge, bottom)))


_OUTLINES: Mapping[str, Callable[[Mapping[str, Sequence[float]]], Outline]] = {
    "box": _box,
    "circle": _circle,
    "pin": _pin,
    "bar": _bar,
    "taper": _taper,
    "polygon": _polygon,
    "line": _line,
    "arc": _arc,
    "sector": _sector,
    "section": _section,
    "broken": _broken,
}


def _direction(start: Point, end: Point) -> float:
    return settled_angle(math.degrees(math.atan2(end[1] - start[1], end[0] - start[0])))


def _turned(needs: Mapping[str, Sequence[float]]) -> Arc:
    low, high = needs["angles"]
    turn = min(high - low, _FULL_TURN)
    return Arc(_point(needs["at"]), needs["radius"][0], low, low + turn)


def _closed(corners: Sequence[Point]) -> Outline:
    return Outline(_chain([*corners, corners[0]]), mask=tuple(corners))


def _chain(points: Sequence[Point]) -> tuple[Line, ...]:
    return tuple(Line(*pair) for pair in pairwise(points))


def _points(flat: Sequence[float]) -> list[Point]:
    return list(zip(flat[::2], flat[1::2], strict=True))


def _point(flat: Sequence[float]) -> Point:
    return flat[0], flat[1]
