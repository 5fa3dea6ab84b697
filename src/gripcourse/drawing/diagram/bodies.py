"""Solid bodies: plates, rollers, round objects, cups, coils, and what stands round an axis."""

import math
from collections.abc import Iterator
from typing import Final

from gripcourse.drawing.diagram.joints import JOINT, edge, line_of
from gripcourse.drawing.diagram.marks import (
    Letter,
    Mark,
    Path,
    RingMark,
    chain,
    circle,
    place,
    polar,
)
from gripcourse.drawing.diagram.places import PlacedElement
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.text import Point

_CROSS: Final = 2.0  # how far the axes of an object reach over its edge
_HATCH_PITCH: Final = 2.2
_LIP: Final = 0.34  # of a cup's height
_NECK: Final = 0.36  # of a cup's diameter


def plate(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a solid part by its corners; a box by two opposite ones."""
    corners = shape.through
    if len(corners) == 2:  # noqa: PLR2004 (opposite corners of a box)
        (left, low), (right, high) = corners
        corners = ((left, low), (right, low), (right, high), (left, high))
    yield Path(corners, line_of(shape), closed=True)
    if shape.element.words["hatch"] == "hatch":
        yield from _hatched(corners)


def _hatched(corners: tuple[Point, ...]) -> Iterator[Path]:
    """Yield lines at 45° over a convex shape."""
    sums = [x - y for x, y in corners]
    first = math.ceil(min(sums) / _HATCH_PITCH)
    last = math.floor(max(sums) / _HATCH_PITCH)
    for number in range(first, last + 1):
        crossed = sorted(_crossings(corners, number * _HATCH_PITCH))
        if len(crossed) >= 2:  # noqa: PLR2004 (a line enters and leaves)
            yield Path((crossed[0], crossed[-1]), LineKind.HATCH)


def _crossings(corners: tuple[Point, ...], level: float) -> Iterator[Point]:
    """Yield where the line x - y = level meets the edges of a shape."""
    for a, b in zip(corners, (*corners[1:], corners[0]), strict=True):
        before, after = a[0] - a[1] - level, b[0] - b[1] - level
        if before * after < 0:
            share = before / (before - after)
            yield a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])


def roller(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a roller with its axle."""
    radius = shape.lengths["diameter"] / 2
    yield circle(shape.at, max(radius, JOINT + 0.8), edge(shape))
    yield RingMark(shape.at, JOINT * 0.7, edge(shape))


def held_object(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a round object across its axis, with the axes of its circle."""
    radius, (x, y) = shape.lengths["diameter"] / 2, shape.at
    yield circle(shape.at, radius, edge(shape))
    if shape.is_main:
        reach = radius + _CROSS
        yield Path(((x, y - reach), (x, y + reach)), LineKind.CENTRE)


def cup(shape: PlacedElement) -> Iterator[Mark]:
    """Draw an elastic cup that opens downwards; its lip is at the point."""
    (x, y), height, radius = shape.at, shape.lengths["height"], shape.lengths["diameter"] / 2
    neck = 2 * _NECK * radius
    left = ((x - radius, y), (x - neck, y + _LIP * height), (x - neck / 2, y + height))
    right = tuple((2 * x - px, py) for px, py in reversed(left))
    yield Path((*left, *right), LineKind.OUTLINE)
    yield Path((left[1], right[1]), LineKind.THIN)


def coil(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a winding in section: a box with crossed lines."""
    (left, low), (right, high) = shape.through[0], shape.through[-1]
    corners = ((left, low), (right, low), (right, high), (left, high))
    yield Path(corners, LineKind.OUTLINE, closed=True)
    yield Path((corners[0], corners[2]), LineKind.THIN)
    yield Path((corners[1], corners[3]), LineKind.THIN)


def end_view(shape: PlacedElement) -> Iterator[Mark]:
    """Draw how many parts stand round an object, seen along the axis.

    Round the origin: where there is room for it shows when everything else is drawn.
    """
    centre = (0.0, 0.0)
    radius, count = 6.0, round(shape.numbers["count"])
    yield circle(centre, radius, LineKind.OUTLINE)
    for k in range(count):
        turn = math.pi / 2 + k * math.tau / count
        foot = polar(centre, radius, turn)
        yield Path(place(((0, -2.5), (0, 2.5), (1.6, 2.5), (1.6, -2.5)), foot, turn),
                   LineKind.OUTLINE, closed=True)  # fmt: skip
        yield Path((polar(centre, radius + 1.6, turn), polar(centre, radius + 7, turn)),
                   LineKind.OUTLINE)  # fmt: skip
        yield Path((centre, polar(centre, radius + 9, turn)), LineKind.CENTRE)
    if shape.symbol:
        rim = circle(centre, radius, LineKind.OUTLINE)
        yield Letter(shape.symbol, (polar(centre, radius, math.pi), polar(centre, radius, 0.0)),
                     (chain(rim),))  # fmt: skip
