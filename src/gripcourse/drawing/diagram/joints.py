"""Links, joints and guides as GOST 2.770 draws them; sizes of symbols are millimetres of paper."""

import math
from collections.abc import Iterator
from typing import Final

from gripcourse.drawing.diagram.marks import (
    ArcMark,
    Fill,
    Mark,
    Path,
    RingMark,
    angle_of,
    place,
    polar,
)
from gripcourse.drawing.diagram.places import PlacedElement
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.text import Point

JOINT: Final = 1.1  # radius of the ring of a joint
_SMALL_JOINT: Final = 0.8  # where it is another position
_PIN: Final = 0.75
_CORNER: Final = 3.2  # legs of the black corner of a rigid lever
_BULGE: Final = 2.0  # distance of its edge from the joint, at least
_FOOT: Final = (3.0, 2.2)  # height and half width of the support of a fixed joint
_HATCH: Final = (1.4, 1.6)  # pitch and length of the strokes of fixed ground


def edge(shape: PlacedElement) -> LineKind:
    """Return the line of a part: thick where it stands in the main position."""
    return LineKind.OUTLINE if shape.is_main else LineKind.THIN


def line_of(shape: PlacedElement) -> LineKind:
    """Return the line that an element asks for."""
    asked = LineKind(shape.element.words["line"].upper())
    return edge(shape) if asked is LineKind.OUTLINE else asked


def link(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a rod, or a lever whose inner joints do not bend: those have a black corner."""
    points, line = shape.through, line_of(shape)
    yield Path(points, line, under=True)
    if shape.element.words["corner"] == "rigid" and line is edge(shape) and shape.is_main:
        for before, at, after in zip(points, points[1:], points[2:], strict=False):
            first, second = angle_of(at, before), angle_of(at, after)
            yield _corner(at, first, math.remainder(second - first, math.tau))


def _corner(at: Point, first: float, gap: float) -> Fill:
    """Return the black corner between two arms; of nearly straight ones, beside the joint."""
    middle = first + gap / 2
    outer = max(_BULGE, _CORNER * math.cos(gap / 2))
    return Fill(
        (
            polar(at, JOINT, first),
            polar(at, _CORNER, first),
            polar(at, outer, middle),
            polar(at, _CORNER, first + gap),
            polar(at, JOINT, first + gap),
            polar(at, JOINT, middle),
        )
    )


def pivot(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a joint of two moving links."""
    yield RingMark(shape.at, JOINT if shape.is_main else _SMALL_JOINT, edge(shape))


def pin(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a pin that slides or rolls."""
    if shape.is_main:
        corners = (polar(shape.at, _PIN, k * math.tau / 16) for k in range(16))
        yield Fill(tuple(corners))
    else:
        yield ArcMark(shape.at, _PIN, 0.0, math.tau, LineKind.THIN)


def fixed_pivot(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a joint with the ground; `turn` points to the ground."""
    yield RingMark(shape.at, JOINT, LineKind.OUTLINE)
    height, half = (size * shape.numbers["size"] for size in _FOOT)
    turn = shape.angles["turn"]
    lean = math.atan2(half, height)
    left, right = place(((height, half), (height, -half)), shape.at, turn)
    yield Path((polar(shape.at, JOINT, turn + lean), left), LineKind.THIN)
    yield Path((polar(shape.at, JOINT, turn - lean), right), LineKind.THIN)
    ends = place(((height, half + 1), (height, -half - 1)), shape.at, turn)
    yield Path(ends, LineKind.OUTLINE)
    yield from hatching(ends[0], ends[1], "left")


def slider(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a block that slides along `turn`."""
    long, wide = shape.numbers["long"] / 2, shape.numbers["wide"] / 2
    corners = ((-long, -wide), (long, -wide), (long, wide), (-long, wide))
    yield Path(place(corners, shape.at, shape.angles["turn"]), edge(shape), closed=True)


def slot(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a slot round a line from pin to pin."""
    start, end = shape.through[0], shape.through[-1]
    turn, radius = angle_of(start, end), shape.numbers["wide"] / 2
    for side in (math.pi / 2, -math.pi / 2):
        yield Path((polar(start, radius, turn + side), polar(end, radius, turn + side)),
                   edge(shape))  # fmt: skip
    yield ArcMark(start, radius, turn + math.pi / 2, math.pi, edge(shape))
    yield ArcMark(end, radius, turn - math.pi / 2, math.pi, edge(shape))


def guide(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a straight guide: ground on both sides of what slides along `turn`."""
    long, gap = shape.numbers["long"] / 2, shape.numbers["gap"] / 2
    for side in (1, -1):
        ends = place(((-side * long, side * gap), (side * long, side * gap)), shape.at,
                     shape.angles["turn"])  # fmt: skip
        yield Path(ends, LineKind.OUTLINE)
        yield from hatching(ends[0], ends[1], "left")


def ground(shape: PlacedElement) -> Iterator[Mark]:
    """Draw what is fixed: a line with strokes on one side of it."""
    yield Path(shape.through, LineKind.OUTLINE)
    for start, end in zip(shape.through, shape.through[1:], strict=False):
        yield from hatching(start, end, shape.element.words["side"])


def hatching(start: Point, end: Point, side: str) -> Iterator[Path]:
    """Yield the strokes of the ground on the left or right side of a line."""
    turn, (pitch, long) = angle_of(start, end), _HATCH
    length = math.dist(start, end)
    count = max(2, round(length / pitch))
    lean = math.radians(135 if side == "left" else -135)
    for k in range(count):
        foot = polar(start, length * (k + 1) / count, turn)
        yield Path((foot, polar(foot, long, turn + lean)), LineKind.THIN)
