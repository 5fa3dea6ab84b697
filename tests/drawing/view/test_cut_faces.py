"""Cut faces that touch are told apart by their hatching (GOST 2.306)."""

import math
from itertools import combinations
from typing import TYPE_CHECKING

import shapely

from gripcourse.drawing.paper.document import LineKind
from support.each import each

if TYPE_CHECKING:
    from ezdxf.document import Drawing

    from conftest import Draw

TOUCHING = 0.05  # mm of paper
SEEN = 0.5  # mm of paper: a shorter common edge is a corner


def faces(document: "Drawing") -> list[tuple[shapely.Geometry, tuple[int, float]]]:
    """Every hatched face of a sheet with the angle and the spacing of its lines."""
    found = []
    for one in document.modelspace().query(f'HATCH[layer=="{LineKind.HATCH}"]'):
        rings = [[(x, y) for x, y, _ in path.vertices] for path in one.paths]
        line = one.pattern.lines[0]
        spacing = round(math.hypot(line.offset.x, line.offset.y), 2)
        face = shapely.Polygon(rings[0], rings[1:]).buffer(0)
        found.append((face, (round(line.angle) % 180, spacing)))
    return found


@each("any_variants", "any_variant")
def test_faces_that_touch_are_hatched_differently(draw: "Draw", any_variant: str) -> None:
    for (one, look), (other, other_look) in combinations(faces(draw(any_variant).view.document), 2):
        edge = one.boundary.intersection(other.buffer(TOUCHING)).length
        assert look != other_look or edge < SEEN, (one.centroid.wkt, other.centroid.wkt)
