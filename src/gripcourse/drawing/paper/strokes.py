"""Straight lines and arcs in a plane: moved, hidden behind a polygon, measured.

Lengths are millimetres, angles degrees counter-clockwise from x. A point that a sine or the like
has a part in is settled: else a file would end in other digits on another processor.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gripcourse.drawing.paper.text import Point

DIGITS = 6  # of millimetres: what comes behind them hangs on the processor
_DEGREE_DIGITS = 9
_FULL_TURN = 360.0
_QUARTER = 90.0
_STEPS = 48  # chords of a full circle in an outline that hides
_NOTHING = 1e-6


@dataclass(frozen=True, slots=True)
class Line:
    """A straight line."""

    start: Point
    end: Point


@dataclass(frozen=True, slots=True)
class Arc:
    """A part of a circle, counter-clockwise from `low` to `high`; a circle from 0 to 360."""

    centre: Point
    radius: float
    low: float = 0.0
    high: float = _FULL_TURN

    @property
    def is_circle(self) -> bool:
        """Whether it is closed."""
        return self.high - self.low >= _FULL_TURN - _NOTHING


Stroke = Line | Arc


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle along the axes."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """Its size along x."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Its size along y."""
        return self.top - self.bottom

    @property
    def corners(self) -> tuple[Point, Point, Point, Point]:
        """Its corners, counter-clockwise from the lower left one."""
        return (
            (self.left, self.bottom),
            (self.right, self.bottom),
            (self.right, self.top),
            (self.left, self.top),
        )

    def joined(self, other: "Box") -> "Box":
        """Return the smallest box round both."""
        return Box(
            min(self.left, other.left),
            min(self.bottom, other.bottom),
            max(self.right, other.right),
            max(self.top, other.top),
        )

    def moved(self, by: Point) -> "Box":
        """Return the box at another place."""
        return Box(self.left + by[0], self.bottom + by[1], self.right + by[0], self.top + by[1])

    def grown(self, by: float) -> "Box":
        """Return the box with a margin."""
        return Box(self.left - by, self.bottom - by, self.right + by, self.top + by)

    def overlaps(self, other: "Box") -> bool:
        """Tell whether the two share more than an edge."""
        return (
            self.left < other.right - _NOTHING
            and other.left < self.right - _NOTHING
            and self.bottom < other.top - _NOTHING
            and other.bottom < self.top - _NOTHING
        )


def settled_point(point: Point) -> Point:
    """Return the point without the last digits, which processors compute differently."""
    return round(point[0], DIGITS), round(point[1], DIGITS)


def settled_angle(angle: float) -> float:
    """Return the angle without the last digits."""
    return round(angle, _DEGREE_DIGITS)


def settled(stroke: Stroke) -> Stroke:
    """Return the stroke without the last digits."""
    if isinstance(stroke, Line):
        return Line(settled_point(stroke.start), settled_point(stroke.end))
    return Arc(
        settled_point(stroke.centre),
        round(stroke.radius, DIGITS),
        settled_angle(stroke.low),
        settled_angle(stroke.high),
    )


def box_of(points: Iterable[Point]) -> Box:
    """Return the smallest box round points."""
    found = list(points)
    across, along = [one[0] for one in found], [one[1] for one in found]
    return Box(min(across), min(along), max(across), max(along))


def reach_of(stroke: Stroke) -> Box:
    """Return a box that a stroke does not leave; of an arc, that of its whole circle."""
    if isinstance(stroke, Line):
        (x0, y0), (x1, y1) = stroke.start, stroke.end
        return Box(min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1))
    (x, y), radius = stroke.centre, stroke.radius
    return Box(x - radius, y - radius, x + radius, y + radius)


def on_circle(centre: Point, radius: float, angle: float) -> Point:
    """Return the point of a circle in a direction."""
    turned = math.radians(angle)
    return settled_point(
        (centre[0] + radius * math.cos(turned), centre[1] + radius * math.sin(turned))
    )


def points_of(stroke: Stroke) -> list[Point]:
    """Return the points of a stroke: ends of a line, chords of an arc and where it is outermost."""
    if isinstance(stroke, Line):
        return [stroke.start, stroke.end]
    turn = stroke.high - stroke.low
    steps = max(2, math.ceil(_STEPS * turn / _FULL_TURN))
    angles = {settled_angle(stroke.low + turn * step / steps) for step in range(steps + 1)}
    first = math.ceil(stroke.low / _QUARTER)
    angles |= {_QUARTER * k for k in range(first, math.floor(stroke.high / _QUARTER) + 1)}
    return [on_circle(stroke.centre, stroke.radius, angle) for angle in sorted(angles)]


def mirrored(stroke: Stroke) -> Stroke:
    """Return the stroke on the other side of the axis y = 0."""
    if isinstance(stroke, Line):
        return Line(flipped(stroke.start), flipped(stroke.end))
    return Arc(flipped(stroke.centre), stroke.radius, -stroke.high, -stroke.low)


def flipped(point: Point) -> Point:
    """Return the point on the other side of the axis y = 0."""
    return point[0], -point[1]


def placed(stroke: Stroke, scale: float, by: Point) -> Stroke:
    """Return the stroke scaled about the origin and then moved."""
    if isinstance(stroke, Line):
        return Line(at_place(stroke.start, scale, by), at_place(stroke.end, scale, by))
    centre = at_place(stroke.centre, scale, by)
    return Arc(centre, stroke.radius * scale, stroke.low, stroke.high)


def at_place(point: Point, scale: float, by: Point) -> Point:
    """Return the point scaled about the origin and then moved."""
    return point[0] * scale + by[0], point[1] * scale + by[1]


def outside(stroke: Stroke, mask: Sequence[Point]) -> Iterator[Stroke]:
    """Yield the pieces of a stroke that a closed polygon does not cover."""
    yield from _pieces(stroke, mask, inner=False)


def covered(stroke: Stroke, mask: Sequence[Point]) -> Iterator[Stroke]:
    """Yield the pieces of a stroke that a closed polygon covers."""
    yield from _pieces(stroke, mask, inner=True)


def _pieces(stroke: Stroke, mask: Sequence[Point], *, inner: bool) -> Iterator[Stroke]:
    cuts = [0.0]
    for share in sorted([*_cuts(stroke, mask), 1.0]):
        if share - cuts[-1] > _NOTHING:
            cuts.append(share)
    cuts[-1] = 1.0
    kept: list[tuple[float, float]] = []
    for low, high in pairwise(cuts):
        if inside(_at(stroke, (low + high) / 2), mask) != inner:
            continue
        if kept and kept[-1][1] == low:
            kept[-1] = (kept[-1][0], high)
        else:
            kept.append((low, high))
    for low, high in kept:
        if high - low > _NOTHING:
            yield stroke if (low, high) == (0.0, 1.0) else _piece(stroke, low, high)


def runs_through(line: Line, boxes: Iterable[Box]) -> bool:
    """Tell whether a line shares more than an edge or a corner with one of some boxes."""
    reach = reach_of(line)
    (x0, y0), (x1, y1) = line.start, line.end
    along, up = x1 - x0, y1 - y0
    for box in boxes:
        if reach.overlaps(box):
            # How far the corners lie on the left of the line: beside it all are on one side.
            sides = [along * (y - y0) - up * (x - x0) for x, y in box.corners]
            if min(sides) < -_NOTHING and max(sides) > _NOTHING:
                return True
    return False


def runs_over(circle: Arc, box: Box) -> bool:
    """Tell whether a whole circle runs over a box: neither past it nor all round it."""
    x, y = circle.centre
    near = (min(max(x, box.left), box.right), min(max(y, box.bottom), box.top))
    far = max(math.dist(circle.centre, corner) for corner in box.corners)
    return math.dist(circle.centre, near) < circle.radius < far


def inside(point: Point, mask: Sequence[Point]) -> bool:
    """Tell whether a point lies in a closed polygon."""
    x, y = point
    found = False
    for (x0, y0), (x1, y1) in zip(mask, [*mask[1:], mask[0]], strict=True):
        if (y0 > y) != (y1 > y) and x < x0 + (x1 - x0) * (y - y0) / (y1 - y0):
            found = not found
    return found


def _at(stroke: Stroke, share: float) -> Point:
    if isinstance(stroke, Line):
        (x0, y0), (x1, y1) = stroke.start, stroke.end
        return x0 + (x1 - x0) * share, y0 + (y1 - y0) * share
    return on_circle(stroke.centre, stroke.radius, stroke.low + (stroke.high - stroke.low) * share)


def _piece(stroke: Stroke, low: float, high: float) -> Stroke:
    if isinstance(stroke, Line):
        return Line(_at(stroke, low), _at(stroke, high))
    turn = stroke.high - stroke.low
    return Arc(stroke.centre, stroke.radius, stroke.low + turn * low, stroke.low + turn * high)


def _cuts(stroke: Stroke, mask: Sequence[Point]) -> Iterator[float]:
    """Yield where a stroke crosses the edges of a polygon, as shares of its length.

    A crossing at a corner, where two edges meet, is on one of them at least: rounding may put it a
    little beyond the end of both.
    """
    for edge in zip(mask, [*mask[1:], mask[0]], strict=True):
        found = _line_cut(stroke, *edge) if isinstance(stroke, Line) else _arc_cut(stroke, *edge)
        yield from (share for share in found if 0 < share < 1)


def _line_cut(line: Line, first: Point, second: Point) -> Iterator[float]:
    ux, uy = line.end[0] - line.start[0], line.end[1] - line.start[1]
    vx, vy = second[0] - first[0], second[1] - first[1]
    wx, wy = first[0] - line.start[0], first[1] - line.start[1]
    cross = ux * vy - uy * vx
    if abs(cross) < _NOTHING**2:
        return
    if -_NOTHING <= (wx * uy - wy * ux) / cross <= 1 + _NOTHING:
        yield (wx * vy - wy * vx) / cross


def _arc_cut(arc: Arc, first: Point, second: Point) -> Iterator[float]:
    vx, vy = second[0] - first[0], second[1] - first[1]
    wx, wy = first[0] - arc.centre[0], first[1] - arc.centre[1]
    square, mixed = vx * vx + vy * vy, vx * wx + vy * wy
    rest = mixed * mixed - square * (wx * wx + wy * wy - arc.radius**2)
    # An edge that touches the arc parts it too: half way between two cuts it may lie on the edge.
    if abs(rest) < _NOTHING * square * arc.radius**2:
        rest = 0.0
    if rest < 0 or square < _NOTHING**2:
        return
    for root in (math.sqrt(rest), -math.sqrt(rest)):
        share = (root - mixed) / square
        if -_NOTHING <= share <= 1 + _NOTHING:
            angle = settled_angle(math.degrees(math.atan2(wy + vy * share, wx + vx * share)))
            yield ((angle - arc.low) % _FULL_TURN) / (arc.high - arc.low)
