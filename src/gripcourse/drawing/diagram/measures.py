"""Forces, moments, lengths and angles of a diagram, each with the symbol of its quantity."""

import math
from collections.abc import Iterator
from typing import Final

from gripcourse.drawing.diagram.marks import (
    HEAD,
    ArcMark,
    Letter,
    Mark,
    Path,
    angle_of,
    between,
    chain,
    circle,
    head_along,
    polar,
)
from gripcourse.drawing.diagram.places import PlacedElement
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.text import Point

_FORCE_HEAD: Final = (3.2, 1.0)
_LEAST_FORCE: Final = 5.0  # mm of an arrow, at least
_OVER: Final = 1.2  # how far extension lines reach over the dimension line
_SHORT: Final = 7.5  # a dimension line with arrows inside is at least so long
_TAIL: Final = 4.0  # of arrows that stand outside
_AROUND: Final = (0, 15, -15, 30, -30, 50, -50, 75, -75)  # degrees from where it is asked for
_SMALLEST: Final = math.radians(1.5)  # an angle that cannot be seen is not drawn


def force(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a force along `turn`; the point is its tip or its tail, `shift` to the left of it.

    Where it has room for `most` only, it is so long, but never without its line.
    """
    turn, room = shape.angles["turn"], shape.lengths.get("most", math.inf)
    long = min(shape.numbers["long"], max(room, _LEAST_FORCE))
    at = polar(shape.at, shape.numbers["shift"], turn + math.pi / 2)
    is_tip = shape.element.words["end"] == "tip"
    tail, tip = (polar(at, -long, turn), at) if is_tip else (at, polar(at, long, turn))
    yield Path((tail, polar(tip, -_FORCE_HEAD[0], turn)), LineKind.OUTLINE)
    yield head_along(tip, turn, _FORCE_HEAD)
    places = tuple(between(tail, tip, share) for share in (0.25, 0.0, 0.5, 0.75, 1.0))
    yield Letter(shape.symbol, places, ((tail, tip),))


def moment(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a moment about the point as an arc with an arrow."""
    radius, start, sweep = shape.numbers["radius"], shape.angles["start"], shape.angles["sweep"]
    sense = math.copysign(1, sweep)
    bend = sense * _FORCE_HEAD[0] / radius
    arc = ArcMark(shape.at, radius, start, sweep - bend, LineKind.OUTLINE)
    yield arc
    tip = polar(shape.at, radius, start + sweep)
    yield head_along(tip, start + sweep + sense * math.pi / 2 - bend / 2, _FORCE_HEAD)
    yield Letter(
        shape.symbol,
        tuple(polar(shape.at, radius, start + share * sweep) for share in (0.5, 0.25, 0.75, 0, 1)),
        (chain(arc),),
    )


def length(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a dimension between two points, along their line or along one axis.

    It lies beyond both of them and beyond the point that it is to pass.
    """
    start, end = shape.through[0], shape.through[-1]
    along = shape.element.words["along"]
    turn = {"x": 0.0, "y": math.pi / 2}.get(along, angle_of(start, end))
    normal = (-math.sin(turn), math.cos(turn))
    # The dimension line lies beyond the end that reaches farther to its side.
    shift = shape.numbers["shift"]
    heights = [one[0] * normal[0] + one[1] * normal[1] for one in (start, end)]
    passed = [x * normal[0] + y * normal[1] for x, y in shape.points.get("past", ())]
    level = max(heights + passed) if shift >= 0 else min(heights + passed)
    feet = [_moved(one, normal, level + shift - height)
            for one, height in zip((start, end), heights, strict=True)]  # fmt: skip
    for one, foot in zip((start, end), feet, strict=True):
        if math.dist(one, foot) > _OVER / 2:
            beyond = polar(foot, _OVER, angle_of(one, foot))
            yield Path((one, beyond), LineKind.DIMENSION)
    yield from _arrows(feet[0], feet[1])
    shares = (0.5, 0.35, 0.65, 0.2, 0.8, 0.0, 1.0)
    places = tuple(between(feet[0], feet[1], share) for share in shares)
    yield Letter(shape.symbol, places, ((feet[0], feet[1]),))


def _moved(point: Point, normal: Point, distance: float) -> Point:
    return point[0] + normal[0] * distance, point[1] + normal[1] * distance


def _arrows(start: Point, end: Point) -> Iterator[Mark]:
    """Draw a dimension line; where it is too short, its arrows stand outside."""
    turn = angle_of(start, end)
    if math.dist(start, end) >= _SHORT:
        yield Path((start, end), LineKind.DIMENSION)
        yield head_along(start, turn + math.pi)
        yield head_along(end, turn)
        return
    reach = HEAD[0] + _TAIL - 2
    yield Path((polar(start, -reach, turn), polar(end, reach, turn)), LineKind.DIMENSION)
    yield head_along(start, turn)
    yield head_along(end, turn + math.pi)


def angle(shape: PlacedElement) -> Iterator[Mark]:
    """Draw an angle from `start` over `sweep`, with the lines that it lies between."""
    radius, start, sweep = shape.numbers["radius"], shape.angles["start"], shape.angles["sweep"]
    if abs(sweep) < _SMALLEST:
        return
    for one in (start, start + sweep):
        yield Path((shape.at, polar(shape.at, radius + _OVER, one)), LineKind.DIMENSION)
    bend = HEAD[0] / radius / 2
    sense = math.copysign(1, sweep)
    if abs(sweep) * radius >= 2 * HEAD[0] + 1:
        yield ArcMark(shape.at, radius, start, sweep, LineKind.DIMENSION)
        yield head_along(polar(shape.at, radius, start), start - sense * (math.pi / 2 - bend))
        yield head_along(polar(shape.at, radius, start + sweep),
                   start + sweep + sense * (math.pi / 2 - bend))  # fmt: skip
    else:
        tail = sense * (HEAD[0] + 1.5) / radius
        yield ArcMark(shape.at, radius, start - tail, sweep + 2 * tail, LineKind.DIMENSION)
        yield head_along(polar(shape.at, radius, start), start + sense * (math.pi / 2 - bend))
        yield head_along(polar(shape.at, radius, start + sweep),
                   start + sweep - sense * (math.pi / 2 - bend))  # fmt: skip
    middle = start + sweep / 2
    places = [polar(shape.at, radius, one)
              for one in (middle, start + sweep, start, start + sweep / 4)]  # fmt: skip
    drawn = ArcMark(shape.at, radius, start, sweep, LineKind.DIMENSION)
    yield Letter(shape.symbol, tuple(places), (chain(drawn),))


def radius(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a radius from the centre to the rim along `turn`."""
    turn, reach = shape.angles["turn"], shape.lengths["radius"]
    rim = polar(shape.at, reach, turn)
    yield Path((shape.at, rim), LineKind.DIMENSION)
    yield head_along(rim, turn)
    places = tuple(between(shape.at, rim, share) for share in (0.6, 0.4, 0.8))
    yield Letter(shape.symbol, places, ((shape.at, rim),))


def diameter(shape: PlacedElement) -> Iterator[Mark]:
    """Name a circle by a leader with an arrow at its rim, met along `turn` or not far from it."""
    reach = shape.lengths["diameter"] / 2
    turns = [shape.angles["turn"] + math.radians(one) for one in _AROUND]
    tips = tuple((polar(shape.at, reach, turn), turn) for turn in turns)
    rim = chain(circle(shape.at, reach, LineKind.OUTLINE))
    yield Letter(shape.symbol, (tips[0][0],), (rim,), tips, shape.numbers["long"])


def joint_name(shape: PlacedElement) -> Iterator[Mark]:
    """Write the name of a joint, by which texts speak of it."""
    yield Letter(shape.element.words["name"], (shape.at,), is_quantity=False)


def letter(shape: PlacedElement) -> Iterator[Mark]:
    """Write a symbol near a point."""
    yield Letter(shape.symbol, (shape.at,))
