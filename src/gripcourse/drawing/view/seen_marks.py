"""Where the leader of a part ends: on the part, as far as nothing lies in front of it there.

Lengths in mm.
"""

from collections.abc import Iterable, Sequence

import shapely
import shapely.ops

from gripcourse.course.view import Face
from gripcourse.drawing.paper.strokes import settled_point
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.placed_shapes import Shown

_CLEAR = 0.003  # of the figure's size, between a mark and the edge of what is seen: its dot
_MOVED = (0.02, 0.01, 0.005)  # of this size, the same where a mark is moved


def seen_mark(mark: Point, part: Sequence[Shown], later: Iterable[Shown], size: float) -> Point:
    """Return a mark of a part, or the nearest place where the part is seen.

    Args:
        mark: where it was declared.
        part: its solid shapes.
        later: shapes of the parts that may lie in front of it.
        size: of the whole figure.
    """
    own, at = _region(part), shapely.Point(mark)
    seen = shapely.difference(own, _region(later))
    edge = _CLEAR * size
    if not _is_inside(at, own, edge) or _is_inside(at, seen, edge):
        return mark  # at an edge of its own, on purpose, or all in the open
    for clear in _MOVED:
        room = shapely.buffer(seen, -clear * size)
        if not shapely.is_empty(room):
            place, _ = shapely.ops.nearest_points(room, at)
            return settled_point((place.x, place.y))
    return mark


def _is_inside(at: shapely.Point, region: shapely.Geometry, edge: float) -> bool:
    return bool(shapely.covers(shapely.buffer(region, -edge), at))


def _region(shapes: Iterable[Shown]) -> shapely.Geometry:
    masks = [one.outline.mask for one in shapes if one.face is Face.MAIN and one.outline.mask]
    return shapely.union_all([shapely.Polygon(mask).buffer(0) for mask in masks])
