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
    scheme, columns = course.schemes[scheme_id], columns_of(course.catalogues)
    view = scheme.view
    assert view is not None
    held = values_at(scheme, columns, view, values, "at_min")
    scene = Scene(held, columns, len(values["jaw_angle"]), frozenset())
    jaws = [
        piece
        for part in view.parts
        if part.enters is not None
        for piece in pieces_of(part, scene)
        if piece.side == 1
    ]
    [smallest] = [
        piece for part in view.parts if part.id == "object" for piece in pieces_of(part, scene)
    ]
    return jaws, smallest
