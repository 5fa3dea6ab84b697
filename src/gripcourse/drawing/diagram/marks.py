"""What a diagram consists of before it is written: lines, arcs, black shapes, and letters to place.

Everything is in millimetres of paper, x along the axis, y upwards, angles in radians.
"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TypeAlias

from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.text import Point

_STEP = math.pi / 24  # of an arc that is taken for a chain of chords
_NEAR = 1e-9


@dataclass(frozen=True, slots=True)
class Path:
    """A chain of straight lines.

    Attributes:
        points: two or more.
        line: what it means.
        closed: whether the last point is joined to the first.
        under: whether it disappears behind the rings of joints and behind masks.
    """

    points: tuple[Point, ...]
    line: LineKind
    closed: bool = False
    under: bool = False


@dataclass(frozen=True, slots=True)
class ArcMark:
    """A part of a circle from `start`, counter-clockwise over `sweep`."""

    centre: Point
    radius: float
    start: float
    sweep: float
    line: LineKind


@dataclass(frozen=True, slots=True)
class Fill:
    """A black polygon."""

    points: tuple[Point, ...]


@dataclass(frozen=True, slots=True)
class RingMark:
    """The circle of a joint; what is `under` ends at it."""

    centre: Point
    radius: float
    line: LineKind


@dataclass(frozen=True, slots=True)
class Letter:
    """A symbol to be written near one of several places, the best first."""

    symbol: str
    places: tuple[Point, ...]


@dataclass(frozen=True, slots=True)
class Mask:
    """A polygon that nobody sees; what is `under` ends at its edge."""

    points: tuple[Point, ...]


Mark: TypeAlias = Path | ArcMark | Fill | RingMark | Mask | Letter


def circle(centre: Point, radius: float, line: LineKind) -> ArcMark:
    """Return a whole circle."""
    return ArcMark(centre, radius, 0.0, math.tau, line)


def is_circle(arc: ArcMark) -> bool:
    """Tell whether an arc goes all the way round."""
    return abs(arc.sweep) >= math.tau - _NEAR


def polar(centre: Point, radius: float, angle: float) -> Point:
    """Return the point at a distance and an angle from another."""
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)


def angle_of(start: Point, end: Point) -> float:
    """Return the direction from one point to another."""
    return math.atan2(end[1] - start[1], end[0] - start[0])


def between(start: Point, end: Point, share: float = 0.5) -> Point:
    """Return the point that divides a line."""
    return start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])


def place(shape: Iterable[Point], origin: Point, turn: float) -> tuple[Point, ...]:
    """Turn a shape about its own origin and put it where it belongs."""
    cos, sin = math.cos(turn), math.sin(turn)
    return tuple((origin[0] + x * cos - y * sin, origin[1] + x * sin + y * cos) for x, y in shape)


def mirrored(mark: Mark) -> Mark:
    """Return the mark on the other side of the axis."""
    match mark:
        case Path() | Fill() | Mask():
            return replace(mark, points=tuple((x, -y) for x, y in mark.points))
        case ArcMark(centre, _, start, sweep):
            return replace(mark, centre=(centre[0], -centre[1]), start=-start - sweep)
        case RingMark(centre):
            return replace(mark, centre=(centre[0], -centre[1]))
        case Letter():
            return replace(mark, places=tuple((x, -y) for x, y in mark.places))


def shifted(mark: Mark, x: float, y: float) -> Mark:
    """Return the mark moved."""
    match mark:
        case Path() | Fill() | Mask():
            return replace(mark, points=tuple((one[0] + x, one[1] + y) for one in mark.points))
        case ArcMark(centre) | RingMark(centre):
            return replace(mark, centre=(centre[0] + x, centre[1] + y))
        case Letter():
            return replace(mark, places=tuple((one[0] + x, one[1] + y) for one in mark.places))


def chain(mark: Mark) -> tuple[Point, ...]:
    """Return the points of what is drawn, arcs as chords; of letters, nothing."""
    match mark:
        case Path(points, _, closed):
            return (*points, points[0]) if closed else points
        case Fill(points):
            return (*points, points[0])
        case ArcMark(centre, radius, start, sweep):
            steps = max(2, math.ceil(abs(sweep) / _STEP))
            return tuple(polar(centre, radius, start + sweep * k / steps) for k in range(steps + 1))
        case RingMark(centre, radius):
            return chain(ArcMark(centre, radius, 0.0, math.tau, LineKind.OUTLINE))
        case Letter() | Mask():
            return ()


def cut_under(marks: Iterable[Mark]) -> Iterator[Mark]:
    """Yield what is seen of the marks: what is under a ring or a mask ends at its edge."""
    all_marks = list(marks)
    covers = [mark for mark in all_marks if isinstance(mark, (RingMark, Mask))]
    for mark in all_marks:
        if isinstance(mark, Path) and mark.under:
            yield from _cut(mark, covers)
        elif not isinstance(mark, Mask):
            yield mark


def _cut(path: Path, covers: Iterable[RingMark | Mask]) -> Iterator[Path]:
    points = chain(path)
    for start, end in pairwise(points):
        for a, b in _outside(start, end, covers):
            yield Path((a, b), path.line)


def _outside(
    start: Point, end: Point, covers: Iterable[RingMark | Mask]
) -> Iterator[tuple[Point, Point]]:
    """Yield the parts of a line that nothing covers."""
    covered = sorted(one for cover in covers for one in _shares(start, end, cover))
    at = 0.0
    for enter, leave in (*covered, (1.0, 1.0)):
        if enter > at + _NEAR:
            yield between(start, end, at), between(start, end, enter)
        at = max(at, leave)


def _shares(start: Point, end: Point, cover: RingMark | Mask) -> Iterator[tuple[float, float]]:
    """Yield the shares of a line between which it runs inside a ring or a mask."""
    if isinstance(cover, Mask):
        crossed = sorted({0.0, 1.0, *_crossings(start, end, cover.points)})
        for enter, leave in pairwise(crossed):
            if _is_inside(between(start, end, (enter + leave) / 2), cover.points):
                yield enter, leave
    elif (found := _in_ring(start, end, cover)) is not None:
        yield found


def _crossings(start: Point, end: Point, corners: tuple[Point, ...]) -> Iterator[float]:
    """Yield the shares of a line at which it crosses the edges of a polygon."""
    ux, uy = end[0] - start[0], end[1] - start[1]
    for a, b in zip(corners, (*corners[1:], corners[0]), strict=True):
        vx, vy, wx, wy = b[0] - a[0], b[1] - a[1], a[0] - start[0], a[1] - start[1]
        cross = ux * vy - uy * vx
        if abs(cross) > _NEAR and 0 <= (wx * uy - wy * ux) / cross <= 1:
            share = (wx * vy - wy * vx) / cross
            if 0 < share < 1:
                yield share


def _is_inside(point: Point, corners: tuple[Point, ...]) -> bool:
    x, y = point
    left_of = 0
    for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
        if min(ay, by) <= y < max(ay, by):
            left_of += x < ax + (bx - ax) * (y - ay) / (by - ay)
    return left_of % 2 == 1


def _in_ring(start: Point, end: Point, ring: RingMark) -> tuple[float, float] | None:
    """Return the shares of a line between which it runs inside a ring."""
    along = (end[0] - start[0], end[1] - start[1])
    off = (start[0] - ring.centre[0], start[1] - ring.centre[1])
    square = along[0] ** 2 + along[1] ** 2
    half = along[0] * off[0] + along[1] * off[1]
    rest = half**2 - square * (off[0] ** 2 + off[1] ** 2 - ring.radius**2)
    if square < _NEAR or rest <= 0:
        return None
    enter, leave = (-half - math.sqrt(rest)) / square, (-half + math.sqrt(rest)) / square
    return (max(enter, 0.0), min(leave, 1.0)) if leave > 0 and enter < 1 else None
