"""Bodies that press on a round object, as their working surfaces are chosen; they touch to scale.

Such a body has one face across the direction in which it presses, or the two faces of a vee. A face
is flat, convex, concave, or a round bar across the object. The body behind it is a symbol.
"""

import math
from collections.abc import Iterator
from typing import Final

from gripcourse.drawing.diagram.joints import edge
from gripcourse.drawing.diagram.marks import Mark, Mask, Path, angle_of, place, polar
from gripcourse.drawing.diagram.places import PlacedElement
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.text import Point

_STEPS: Final = 16  # chords of an arc
_NARROW: Final = 2.0  # half of the length of a face, at least
_DEPTH: Final = 0.35  # of the smallest object's radius that a concave face may embrace
_ROOM: Final = 0.96  # of a radius that a face may take up
_LIP: Final = 1.25  # how far the faces of a vee reach beyond the largest object's contacts
_BAR: Final = 5.0  # thickness of a bar, at most
_VEE_BACK: Final = 0.35  # of the length of a face: how thick a vee is behind its apex
_RELIEF: Final = 0.9  # how far a convex face of a vee stands out of it, at most
_PAD: Final = 4.0  # half of the length of a convex face of a vee, at most
_AXIS: Final = 1.8  # how far the axis of a bar reaches over its ends


def contact(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a body; its face is towards the centre of the object that it `holds`.

    The centre and the point `at` where a face across the direction would touch give the radius of
    the object; the faces of a vee, whose half angle is `angle`, touch it elsewhere.
    """
    centre = shape.points["holds"][0]
    turn, radius = angle_of(shape.at, centre), math.dist(shape.at, centre)
    half_angle = shape.angles.get("angle")
    if half_angle is None:
        yield from _face(shape, shape.at, turn, shape.numbers["long"] / 2)
    elif shape.element.words["surface"] == "flat":
        yield from _vee(shape, centre, turn, radius)
    else:
        yield from _two_faces(shape, centre, turn, radius)


def _face(shape: PlacedElement, at: Point, turn: float, half: float) -> Iterator[Mark]:
    """Draw one face with the body behind it; it touches at the point and looks along `turn`."""
    surface = shape.element.words["surface"]
    front = _front(shape, surface, half)
    reach = front[-1][1]
    back = -shape.numbers["thick"]
    if surface == "crossed":
        back = min(back, -min(2 * shape.lengths["radius"], _BAR))
        ends = place(((back / 2, reach + _AXIS), (back / 2, -reach - _AXIS)), at, turn)
        yield Path(ends, LineKind.CENTRE)
    elif surface == "convex":
        back += min(x for x, _ in front)
    corners = (*front, (back, reach), (back, -reach))
    yield Path(place(corners, at, turn), edge(shape), closed=True)
    yield Mask(place(corners, at, turn))


def _front(shape: PlacedElement, surface: str, half: float) -> tuple[Point, ...]:
    """Return the line of a face from its right end to its left, the contact at the origin."""
    if surface not in {"convex", "concave"}:
        return (0.0, -half), (0.0, half)
    radius = shape.lengths["radius"]
    half = min(half, _ROOM * radius)
    if surface == "concave":
        depth = min(_DEPTH * shape.lengths["smallest"] / 2, radius)
        half = min(half, math.sqrt(radius**2 - (radius - depth) ** 2))
    sense = 1 if surface == "concave" else -1
    across = [half * (2 * k / _STEPS - 1) for k in range(_STEPS + 1)]
    return tuple((sense * (radius - math.sqrt(radius**2 - y**2)), y) for y in across)


def _vee(shape: PlacedElement, centre: Point, turn: float, radius: float) -> Iterator[Mark]:
    """Draw a vee whose flat faces touch an object of that radius."""
    half_angle = shape.angles["angle"]
    mouth = shape.lengths.get("mouth", _LIP * shape.lengths["largest"] * math.cos(half_angle)) / 2
    deep, back = mouth / math.tan(half_angle), -shape.numbers["thick"]
    apex = polar(centre, -radius / math.sin(half_angle), turn)
    outer = ((deep, mouth), (back, mouth), (back, -mouth), (deep, -mouth))
    corners = place(((0.0, 0.0), *outer), apex, turn)
    yield Path(corners, edge(shape), closed=True)
    yield Mask(corners)


def _two_faces(shape: PlacedElement, centre: Point, turn: float, radius: float) -> Iterator[Mark]:
    """Draw the two faces of a vee that are not flat, and the bridge that carries them."""
    lean = math.pi / 2 - shape.angles["angle"]
    contacts = [polar(centre, -radius, turn + side * lean) for side in (-1, 1)]
    room = math.dist(*contacts) / 2 / math.cos(lean) * _ROOM
    half = max(_NARROW, min(shape.numbers["long"] / 4, room))
    for contact in contacts:
        yield from _face(shape, contact, angle_of(contact, centre), half)
    # The backs of both faces lie on two lines that meet behind the apex.
    behind = radius + shape.numbers["thick"]
    corner = polar(centre, -behind / math.cos(lean), turn)
    backs = [polar(centre, -behind, turn + side * lean) for side in (-1, 1)]
    yield Path((backs[0], corner, backs[1]), edge(shape))
    yield Mask((*contacts, backs[1], corner, backs[0]))


def vee(shape: PlacedElement) -> Iterator[Mark]:
    """Draw a vee block: its apex at the point, its bisector along `turn`.

    Faces with a `radius` are convex; they touch the object where flat ones would.
    """
    half, face = shape.lengths["length"], shape.angles["angle"] / 2
    contact = shape.lengths["diameter"] / 2 / math.tan(face)
    along = [(x * math.cos(face) - y * math.sin(face), x * math.sin(face) + y * math.cos(face))
             for x, y in _vee_face(shape, half, contact)]  # fmt: skip
    back = -_VEE_BACK * half
    wide = max(y for _, y in along)
    mirrored = [(x, -y) for x, y in reversed(along)]
    corners = (*along, (back, wide), (back, -wide), *mirrored)
    yield Path(place(corners, shape.at, shape.angles["turn"]), edge(shape), closed=True)


def _vee_face(shape: PlacedElement, length: float, contact: float) -> list[Point]:
    """Return a face from the apex on: along it, and behind it where it is convex."""
    radius = shape.lengths.get("radius")
    if radius is None:
        return [(0.0, 0.0), (length, 0.0)]
    half = min(_PAD, _ROOM * radius, contact, length - contact)
    if radius > _RELIEF:
        half = min(half, math.sqrt(radius**2 - (radius - _RELIEF) ** 2))
    depth = radius - math.sqrt(radius**2 - half**2)
    arc = [half * (2 * k / _STEPS - 1) for k in range(_STEPS + 1)]
    pad = [(contact + x, radius - math.sqrt(radius**2 - x**2)) for x in arc]
    return [(0.0, depth), *pad, (length, depth)]
