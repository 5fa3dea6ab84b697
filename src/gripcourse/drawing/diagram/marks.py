"""What a diagram consists of before it is written: lines, arcs, black shapes, and letters to place.

Everything is in millimetres of paper, x along the axis, y upwards, angles in radians.
"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TypeAlias

import shapely
from shapely.geometry.base import BaseGeometry

from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import DIGITS, settled_point
from gripcourse.drawing.paper.text import Point

Chain: TypeAlias = tuple[Point, ...]
"""Points joined by straight lines; a single one stands for itself."""

HEAD = (3.0, 0.55)  # length and half width of the arrow of a dimension
_STEP = math.pi / 24  # of an arc that is taken for a chain of chords
_NEAR = 1e-9
_QUARTER = 32  # chords of a quarter of a ring
_TURN_DIGITS = 12  # of angles


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
    """A symbol to be written near one of several places, the best first.

    Attributes:
        symbol: as declared.
        places: points of the thing that it names.
        names: what the thing looks like; the symbol stands nearer to it than to any other thing
            that has a symbol. Empty: the places themselves.
        tips: where the arrow of a leader may touch the thing, and the direction in which the leader
            goes from there; the first is the author's. Empty for a symbol that needs no leader
            unless it stands far away.
        long: of such a leader, at least.
        is_quantity: whether it is the symbol of a quantity, and not the name of a joint.
    """

    symbol: str
    places: tuple[Point, ...]
    names: tuple[Chain, ...] = ()
    tips: tuple[tuple[Point, float], ...] = ()
    long: float = 0.0
    is_quantity: bool = True

    @property
    def thing(self) -> tuple[Chain, ...]:
        """What it names, as chains of points."""
        return self.names or tuple((place,) for place in self.places)


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


def head_along(tip: Point, turn: float, size: tuple[float, float] = HEAD) -> Fill:
    """Return an arrow head whose tip points along `turn`."""
    long, half = size
    return Fill(place(((0, 0), (-long, half), (-long, -half)), tip, turn))


def head(tip: Point, tail: Point) -> Fill:
    """Return the arrow head at the tip of a leader that comes from `tail`."""
    return head_along(tip, angle_of(tail, tip))


def mirrored(mark: Mark) -> Mark:
    """Return the mark on the other side of the axis."""
    match mark:
        case Path() | Fill() | Mask():
            return replace(mark, points=_flipped(mark.points))
        case ArcMark(centre, _, start, sweep):
            return replace(mark, centre=(centre[0], -centre[1]), start=-start - sweep)
        case RingMark(centre):
            return replace(mark, centre=(centre[0], -centre[1]))
        case Letter():
            return replace(
                mark,
                places=_flipped(mark.places),
                names=tuple(map(_flipped, mark.names)),
                tips=tuple(((x, -y), -turn) for (x, y), turn in mark.tips),
            )


def _flipped(points: Chain) -> Chain:
    return tuple((x, -y) for x, y in points)


def shifted(mark: Mark, x: float, y: float) -> Mark:
    """Return the mark moved."""
    match mark:
        case Path() | Fill() | Mask():
            return replace(mark, points=moved(mark.points, x, y))
        case ArcMark(centre) | RingMark(centre):
            return replace(mark, centre=(centre[0] + x, centre[1] + y))
        case Letter():
            return replace(
                mark,
                places=moved(mark.places, x, y),
                names=tuple(moved(one, x, y) for one in mark.names),
                tips=tuple(((tip[0] + x, tip[1] + y), turn) for tip, turn in mark.tips),
            )


def settled(mark: Mark) -> Mark:
    """Return the mark without the last digits, which processors compute differently.

    Else a length that is written with two digits, or a letter that has two places equally good,
    would be another one on another machine.
    """
    match mark:
        case Path() | Fill() | Mask():
            return replace(mark, points=_settled(mark.points))
        case ArcMark(centre, radius, start, sweep):
            return replace(
                mark,
                centre=_settled((centre,))[0],
                radius=round(radius, DIGITS),
                start=round(start, _TURN_DIGITS),
                sweep=round(sweep, _TURN_DIGITS),
            )
        case RingMark(centre, radius):
            return replace(mark, centre=_settled((centre,))[0], radius=round(radius, DIGITS))
        case Letter():
            return replace(
                mark,
                places=_settled(mark.places),
                names=tuple(map(_settled, mark.names)),
                tips=tuple(
                    (_settled((tip,))[0], round(turn, _TURN_DIGITS)) for tip, turn in mark.tips
                ),
            )


def _settled(points: Chain) -> Chain:
    return tuple(map(settled_point, points))


def moved(points: Chain, x: float, y: float) -> Chain:
    """Return points moved."""
    return tuple((one[0] + x, one[1] + y) for one in points)


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


def corners(mark: Mark) -> tuple[Point, ...]:
    """Return points that reach as far as what is drawn; of letters, nothing."""
    if isinstance(mark, RingMark) or (isinstance(mark, ArcMark) and is_circle(mark)):
        (x, y), reach = mark.centre, mark.radius
        return (x - reach, y - reach), (x + reach, y + reach)
    return chain(mark)


def cut_under(marks: Iterable[Mark]) -> Iterator[Mark]:
    """Yield what is seen of the marks: what is under a ring or a mask ends at its edge."""
    all_marks = list(marks)
    covers = [_cover(mark) for mark in all_marks if isinstance(mark, (RingMark, Mask))]
    cover = shapely.union_all(covers)
    shapely.prepare(cover)
    for mark in all_marks:
        if isinstance(mark, Path) and mark.under:
            yield from _cut(mark, cover)
        elif not isinstance(mark, Mask):
            yield mark


def _cover(mark: RingMark | Mask) -> BaseGeometry:
    """Return what a mark hides."""
    if isinstance(mark, RingMark):
        return shapely.Point(mark.centre).buffer(mark.radius, quad_segs=_QUARTER)
    return shapely.Polygon(mark.points).buffer(0)


def _cut(path: Path, cover: BaseGeometry) -> Iterator[Path]:
    """Yield the pieces of a path that are not covered."""
    whole = shapely.LineString(chain(path))
    if not shapely.intersects(cover, whole):
        yield replace(path, under=False)
        return
    seen = whole.difference(cover)
    if seen.length >= whole.length - _NEAR:
        yield replace(path, under=False)
        return
    for piece in shapely.get_parts(seen):
        if piece.length > _NEAR:
            yield Path(tuple((float(x), float(y)) for x, y in piece.coords), path.line)
