"""From a shape's numbers to its strokes and to what it covers. Lengths in mm, angles in degrees."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gripcourse.drawing.paper.strokes import Arc, Line, Stroke, on_circle, points_of
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
    """Draw a bar of even width along a chain of points, round at both ends."""
    middle = [*_points(needs["through"])]
    half = needs["width"][0] / 2
    left, right = _beside(middle, half), _beside(middle, -half)
    first, last = _direction(middle[0], middle[1]), _direction(middle[-2], middle[-1])
    ends = (
        Arc(middle[-1], half, last - _QUARTER, last + _QUARTER),
        Arc(middle[0], half, first + _QUARTER, first + 3 * _QUARTER),
    )
    strokes: tuple[Stroke, ...] = (*_chain(left), *_chain(right), *ends)
    mask = (*right, *points_of(ends[0]), *reversed(left), *points_of(ends[1]))
    return Outline(strokes, mask=mask)


def _section(needs: Mapping[str, Sequence[float]]) -> Outline:
    """Draw a rectangle half way between two points, its length along them."""
    first, *_, last = _points(needs["through"])
    turn, half = _direction(first, last), needs["length"][0] / 2
    middle = ((first[0] + last[0]) / 2, (first[1] + last[1]) / 2)
    ends = [on_circle(middle, along, turn) for along in (-half, half)]
    left, right = (_beside(ends, needs["width"][0] / 2 * side) for side in (1, -1))
    return _closed([*right, *reversed(left)])


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
    "polygon": _polygon,
    "line": _line,
    "arc": _arc,
    "sector": _sector,
    "section": _section,
    "broken": _broken,
}


def _beside(middle: Sequence[Point], distance: float) -> list[Point]:
    """Return the chain beside a chain, on its left where the distance is positive."""
    directions = [_direction(*pair) for pair in pairwise(middle)]
    chain = [on_circle(middle[0], distance, directions[0] + _QUARTER)]
    for corner, before, after in zip(middle[1:], directions, directions[1:], strict=False):
        bend = (after - before + _FULL_TURN / 2) % _FULL_TURN - _FULL_TURN / 2
        across = before + bend / 2 + _QUARTER
        reach = distance / max(_SHARPEST, math.cos(math.radians(bend / 2)))
        chain.append(on_circle(corner, reach, across))
    chain.append(on_circle(middle[-1], distance, directions[-1] + _QUARTER))
    return chain


def _direction(start: Point, end: Point) -> float:
    return math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))


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
