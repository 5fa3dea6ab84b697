"""What is hatched of cut parts: as much as nothing in front of them covers. Lengths in mm."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import shapely

from gripcourse.course.view import Face
from gripcourse.drawing.paper.strokes import box_of, settled_point
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.placed_shapes import Shown

_SMALLEST = 1e-3  # mm²


@dataclass(frozen=True, slots=True)
class Cut:
    """A cut face: its outer ring, then its holes, and which way its hatch leans."""

    rings: Sequence[Sequence[Point]]
    hatch: str


def cut_faces(shapes: Sequence[Shown], face: Face) -> Iterator[Cut]:
    """Yield what is seen of the cut faces of a view.

    Args:
        shapes: what lies in front comes later.
        face: the view.
    """
    here = [one for one in shapes if one.face is face]
    for number, one in enumerate(here):
        if one.hatch and one.ring:
            reach = box_of(one.ring)
            covers = [
                shapely.Polygon(other.outline.mask).buffer(0)
                for other in here[number + 1 :]
                if other.outline.mask and other.box.overlaps(reach)
            ]
            seen = shapely.Polygon(one.ring).buffer(0).difference(shapely.union_all(covers))
            for piece in shapely.get_parts(seen):
                if piece.area > _SMALLEST:
                    yield cut_of(piece, one.hatch)


def cut_of(piece: shapely.Polygon, hatch: str) -> Cut:
    """Return a polygon as a cut face."""
    return Cut([corners_of(ring) for ring in (piece.exterior, *piece.interiors)], hatch)


def corners_of(ring: shapely.Geometry) -> list[Point]:
    """Return the corners of a ring, each once."""
    return [settled_point((float(x), float(y))) for x, y in shapely.get_coordinates(ring)[:-1]]
