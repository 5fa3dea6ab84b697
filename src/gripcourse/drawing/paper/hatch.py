"""The lines of a hatch inside closed rings."""

import math
from collections.abc import Iterator, Sequence

from gripcourse.drawing.paper.strokes import settled_point
from gripcourse.drawing.paper.text import Point

Segment = tuple[Point, Point]


def hatch_lines(
    rings: Sequence[Sequence[Point]], angle: float, spacing: float
) -> Iterator[Segment]:
    """Yield the parts of parallel lines that lie inside an odd number of rings.

    Args:
        rings: closed polygons, the last point joined to the first.
        angle: of the lines, degrees from x.
        spacing: distance of neighbouring lines; one of them runs through the origin.
    """
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    turned = [
        [settled_point((x * cosine + y * sine, y * cosine - x * sine)) for x, y in ring]
        for ring in rings
    ]
    heights = [across for ring in turned for _, across in ring]
    if not heights:
        return
    for number in range(math.ceil(min(heights) / spacing), math.floor(max(heights) / spacing) + 1):
        across = number * spacing
        crossings = sorted(_crossings(turned, across))
        for low, high in zip(crossings[::2], crossings[1::2], strict=False):
            yield (
                settled_point((low * cosine - across * sine, low * sine + across * cosine)),
                settled_point((high * cosine - across * sine, high * sine + across * cosine)),
            )


def _crossings(rings: Sequence[Sequence[Point]], across: float) -> Iterator[float]:
    """Yield where the line at this height crosses an edge; an edge holds its lower end only."""
    for ring in rings:
        for (x0, y0), (x1, y1) in zip(ring, [*ring[1:], ring[0]], strict=True):
            if min(y0, y1) <= across < max(y0, y1):
                yield x0 + (x1 - x0) * (across - y0) / (y1 - y0)
