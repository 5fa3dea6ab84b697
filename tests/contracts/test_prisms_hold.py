"""Two prisms touch every object that they hold on their faces, as drawn.

The faces are taken from the outlines of the general view, the points of contact from the object's
radius and the angle of the prism alone: neither knows the formulas of the other.
"""

from collections.abc import Iterator

import numpy as np
import shapely

from gripcourse.course.catalogue import columns_of
from gripcourse.course.model import Course
from gripcourse.drawing.view.bodies import Piece, Scene, pieces_of
from gripcourse.drawing.view.numbers import values_at
from gripcourse.variants.answers import Group, solve_groups
from gripcourse.variants.model import Variant

ALONG = (-0.1, 0.0, 0.1)  # mm on either side of the point of contact
NEAR = 0.05  # mm: the chords of a circle
TOUCHING = 0.005  # mm from the object: the chord of a face of a prism that turns is 0.8 mm at least
HELD = {"at_min": ("object", "diameter_min"), "at_max": ("largest_object", "diameter_max")}


def test_the_prisms_of_every_issued_variant_touch_its_objects_on_their_faces(
    course: Course, issued: tuple[Variant, ...]
) -> None:
    prismatic = [one for one in issued if one.options.get("jaw_shape") == "prism"]
    assert len({one.scheme for one in prismatic}) > 6
    missed = [
        f"{prismatic[int(group.rows[place])].id}: {name}"
        for group in solve_groups(course, prismatic)
        for place, name in missing(course, group)
    ]
    assert missed == []


def test_the_prisms_on_turning_levers_touch_every_object_on_both_faces(
    course: Course, issued: tuple[Variant, ...]
) -> None:
    turning = [one for one in issued if one.scheme == "prism_lever"]
    missed = [
        f"{turning[int(group.rows[place])].id}: {name}"
        for group in solve_groups(course, turning)
        for place, name in untouched(course, group)
    ]
    assert turning
    assert missed == []


def untouched(course: Course, group: Group) -> Iterator[tuple[int, str]]:
    """Yield the variants whose tilted prisms do not hold an object on two faces, and of which one.

    Two faces of a prism of angle α touch a circle in two directions that are π − α apart; where a
    face ends before it touches, or stands in the object, there is no such chord near the circle.
    """
    count = group.family.size
    values = {name: np.broadcast_to(one, count) for name, one in group.values.items()}
    for position, (held, name) in HELD.items():
        found = pieces(course, group.family.scheme, values, position)
        jaws = [one for one in found if one.part.id == "prism" and one.side == 1]
        [circle] = [one for one in found if one.part.id == held]
        for place in range(count):
            row = np.array([place])
            jaw = shapely.union_all([one.solid(row)[0] for one in jaws])
            centre, radius = circle.outline(row)[0].centroid, values[name][place] * 500
            ring = centre.buffer(radius + TOUCHING, 256)
            chords = shapely.get_parts(shapely.line_merge(jaw.boundary.intersection(ring)))
            feet = [one.interpolate(0.5, normalized=True) for one in chords]
            ways = [np.arctan2(one.y - centre.y, one.x - centre.x) for one in feet]
            if (
                len(feet) != 2
                or min(one.length for one in chords) < 2 * ALONG[-1]
                or max(abs(centre.distance(one) - radius) for one in feet) > TOUCHING
                or abs(np.pi - abs(ways[0] - ways[1]) - values["prism_angle"][place]) > TOUCHING
            ):
                yield place, name


def missing(course: Course, group: Group) -> Iterator[tuple[int, str]]:
    """Yield the variants whose jaws do not reach a point of contact, and of which object."""
    count = group.family.size
    values = {name: np.broadcast_to(one, count) for name, one in group.values.items()}
    jaws, objects = faces(course, group.family.scheme, values)
    angle = values["jaw_angle"]
    for place in range(count):
        row = np.array([place])
        own = [one.solid(row)[0] for one in jaws if np.isfinite(one.box[:, place]).all()]
        jaw = shapely.union_all(own)
        middle = objects.outline(row)[0].centroid
        side = np.sign(jaw.centroid.y)
        sine, cosine = np.sin(angle[place]), np.cos(angle[place])
        smallest = values["diameter_min"][place] * 500
        for name in ("diameter_min", "diameter_max"):
            radius = values[name][place] * 500
            height = (smallest - radius) / sine + radius * sine  # the ridge stays where it is
            for way in (-1, 1):
                at = np.array([middle.x + way * radius * cosine, side * height])
                face = np.array([way * sine, -side * cosine])
                points = [shapely.Point(at + step * face) for step in ALONG]
                if max(shapely.distance(jaw.boundary, points)) > NEAR:
                    yield place, name


def faces(
    course: Course, scheme_id: str, values: dict[str, np.ndarray]
) -> tuple[list[Piece], Piece]:
    """Return the pieces of the jaw above the axis and the smallest object, both held."""
    found = pieces(course, scheme_id, values, "at_min")
    jaws = [one for one in found if one.part.enters is not None and one.side == 1]
    [smallest] = [one for one in found if one.part.id == "object"]
    return jaws, smallest


def pieces(
    course: Course, scheme_id: str, values: dict[str, np.ndarray], position: str
) -> list[Piece]:
    """Return all pieces of the general view in a position."""
    scheme, columns = course.schemes[scheme_id], columns_of(course.catalogues)
    view = scheme.view
    assert view is not None
    held = values_at(scheme, columns, view, values, position)
    scene = Scene(held, columns, len(next(iter(values.values()))), frozenset())
    return [piece for part in view.parts for piece in pieces_of(part, scene)]
