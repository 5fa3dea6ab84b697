"""Cylinders and motors; they are symbols, not to scale, but for the path of the rod."""

import math
from collections.abc import Iterator
from typing import Final

from gripcourse.drawing.diagram.joints import JOINT, hatching
from gripcourse.drawing.diagram.marks import (
    Letter,
    Mark,
    Mask,
    Path,
    angle_of,
    between,
    circle,
    head_along,
    place,
    polar,
)
from gripcourse.drawing.diagram.places import PlacedElement
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.text import Point

_HALF: Final = 4.2  # of the height of a cylinder
_PISTON: Final = 1.8  # length of the piston
_ROOM: Final = 1.0  # between piston and end cover
_GAP: Final = 4.0  # of the rod that stays outside
_PORT: Final = 2.0
_FLOW: Final = 7.0  # from the body to the tail of the arrow of the pressure
_MOTOR: Final = 4.5  # radius of a motor
# The letter M in a motor (GOST 2.722), as lines from its middle.
_LETTER: Final = ((-1.4, -1.6), (-1.4, 1.6), (0.0, -0.4), (1.4, 1.6), (1.4, -1.6))


def cylinder(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a cylinder whose rod ends at the point and comes out along `turn`.

    The body is long enough for the path of the rod over all positions.
    """
    turn = shape.angles["turn"]
    along = (math.cos(turn), math.sin(turn))
    path = [
        (x - shape.at[0]) * along[0] + (y - shape.at[1]) * along[1] for x, y in shape.stops["at"]
    ]
    front, stroke = min(path) - _GAP, max(path) - min(path)
    rear = front - stroke - _PISTON - 2 * _ROOM - 4.0
    piston = (rear + _ROOM) - min(path)  # from the end of the rod, wherever that is
    yield from _body(shape.at, turn, (rear, front), (piston, 0.0))
    yield from _pressure(shape, shape.at, turn, (rear, front))
    if shape.element.words["base"] == "fixed":
        ends = place(((rear, _HALF + 1.5), (rear, -_HALF - 1.5)), shape.at, turn)
        yield Path(ends, LineKind.OUTLINE)
        yield from hatching(ends[1], ends[0], "left")


def floating_cylinder(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a cylinder between the eyes of two moving links."""
    start, end = shape.through[0], shape.through[-1]
    turn, length = angle_of(start, end), math.dist(start, end)
    rear = min(JOINT + 2.0, length / 6)
    front = rear + 0.62 * (length - rear)
    yield from _body(start, turn, (rear, front), (between((rear, 0), (front, 0))[0], length))
    box = ((rear, -_HALF), (front, -_HALF), (front, _HALF), (rear, _HALF))
    yield Mask(place(box, start, turn))
    yield Path((start, polar(start, rear, turn)), LineKind.OUTLINE, under=True)
    yield from _pressure(shape, start, turn, (rear, front))


def _body(
    origin: Point, turn: float, ends: tuple[float, float], rod: tuple[float, float]
) -> Iterator[Path]:
    """Yield body, ports, piston and rod along an axis; ends as distances from the origin."""
    rear, front = ends
    box = ((rear, -_HALF), (front, -_HALF), (front, _HALF), (rear, _HALF))
    yield Path(place(box, origin, turn), LineKind.OUTLINE, closed=True)
    piston = rod[0]
    disc = ((piston, -_HALF), (piston + _PISTON, -_HALF), (piston + _PISTON, _HALF),
            (piston, _HALF))  # fmt: skip
    yield Path(place(disc, origin, turn), LineKind.OUTLINE, closed=True)
    yield Path(place(((piston + _PISTON, 0), (front, 0)), origin, turn), LineKind.OUTLINE)
    yield Path(place(((front, 0), (rod[1], 0)), origin, turn), LineKind.OUTLINE, under=True)
    for x in (rear + _ROOM, front - _ROOM):
        yield Path(place(((x, -_HALF), (x, -_HALF - _PORT)), origin, turn), LineKind.THIN)


def _pressure(
    shape: PlacedElement, origin: Point, turn: float, ends: tuple[float, float]
) -> Iterator[Mark]:
    """Draw the pressure that works: behind the piston, or on the side of its rod."""
    if not shape.symbol:
        return
    x = ends[0] + _ROOM if shape.element.words["rod"] == "pushes" else ends[1] - _ROOM
    port, tip, tail = place(((x, -_HALF), (x, -_HALF - _PORT), (x, -_HALF - _FLOW)), origin, turn)
    yield Path((tail, tip), LineKind.THIN)
    yield head_along(tip, angle_of(tail, port))
    yield Letter(shape.symbol, (tail, between(tail, tip)), ((tail, tip),))


def motor(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a motor beyond the end of a shaft; `turn` points from the shaft to the motor."""
    turn = shape.angles["turn"]
    shaft = shape.numbers["shaft"]
    centre = polar(shape.at, shaft + _MOTOR, turn)
    yield Path((shape.at, polar(shape.at, shaft, turn)), LineKind.OUTLINE)
    yield circle(centre, _MOTOR, LineKind.OUTLINE)
    yield Path(tuple((centre[0] + x, centre[1] + y) for x, y in _LETTER), LineKind.THIN)
    ends = place(((_MOTOR, 3.5), (_MOTOR, -3.5)), centre, turn)
    yield Path(ends, LineKind.OUTLINE)
    yield from hatching(ends[0], ends[1], "left")
