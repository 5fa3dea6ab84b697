"""A section across the axis: what a plane cuts of the bodies of a view near a place.

Millimetres of the thing itself; x is the distance from the plane of the main view, y stands as in
the main view, round the place. What lies all through in depth is turned about the axis.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import shapely
import shapely.affinity

from gripcourse.course.view import HATCHES, View, ViewPart
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Box, Line, Stroke, points_of, settled_point
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.bodies import Piece, Scene, pieces_of
from gripcourse.drawing.view.contents import Seen
from gripcourse.drawing.view.cut_faces import Cut, corners_of, cut_of

_FAR = 1e5  # mm, beyond anything drawn
_NEAR = 1e-3
_SMALLEST = 1e-2  # mm²
_SLIVER = 0.1  # height of what is left out at the rim, in reaches
_BEYOND = 0.12  # how far axes reach beyond what they are axes of, in reaches
_WAVE, _SWING = 6, 0.02  # chords and height of a line of break, in its lengths
_HATCHES = tuple(filter(None, HATCHES))


@dataclass(frozen=True, slots=True)
class CutThrough:
    """What a plane cuts: strokes, faces to be hatched, and the pin that it cuts along."""

    seen: Sequence[Seen]
    cuts: Sequence[Cut]
    pin: Box | None


@dataclass(frozen=True, slots=True)
class _Slice:
    """What is cut of one piece; a pin is cut along its axis and left whole (GOST 2.305)."""

    part: str
    region: shapely.Geometry
    is_pin: bool
    is_whole: bool


def cut_through(view: View, scene: Scene, at: Point, reach: float) -> CutThrough:
    """Cut the bodies of a view across the axis.

    Args:
        view: of the scheme.
        scene: its numbers, of one variant.
        at: the place in the main view; the plane keeps its x.
        reach: how far up and down from the place it is shown.
    """
    window = shapely.box(-_FAR, -reach, _FAR, reach)
    slices = [one for part in view.parts for one in _slices(part, view, scene, at, reach)]
    left = [
        replace(one, region=shapely.intersection(one.region, window)) for one in _uncovered(slices)
    ]
    left = [one for one in left if _is_shown(one, reach)]
    pins = [shapely.bounds(one.region) for one in left if one.is_pin]
    hatched = [one for one in left if not one.is_whole]
    hatches = dict(zip([one.part for one in hatched], _leanings(hatched), strict=True))
    polygons = [(one, piece) for one in left for piece in _polygons(one.region)]
    seen = list(_once(edge for _, piece in polygons for edge in _edges(piece, reach)))
    if seen:
        seen += [Seen(one, LineKind.CENTRE) for one in _axes(polygons, reach, has_pin=bool(pins))]
    cuts = [cut_of(piece, hatches[one.part]) for one, piece in polygons if not one.is_whole]
    return CutThrough(seen, cuts, _box(pins[0]) if pins else None)


def _slices(part: ViewPart, view: View, scene: Scene, at: Point, reach: float) -> Iterator[_Slice]:
    if part.positions and view.position not in part.positions:
        return
    unseen = {one.key for one in part.shapes if one.line == "phantom"}
    whole = {one.key for one in part.shapes if one.whole}
    plane = shapely.LineString([(at[0], -_FAR), (at[0], _FAR)])
    for one in pieces_of(part, scene):
        left, bottom, right, top = (float(side) for side in one.box[:, 0])
        is_met = left < at[0] < right and bottom < at[1] + reach and at[1] - reach < top
        if one.key in unseen or not is_met:  # nor is a piece that the variant does not have
            continue
        cut = shapely.intersection(one.solid(np.array([0]))[0], plane)
        bands = [_band(one, *_span(line)) for line in shapely.get_parts(cut) if line.length > _NEAR]
        if bands:
            region = shapely.affinity.translate(shapely.union_all(bands), 0.0, -at[1])
            is_pin = one.kind == "pin"
            is_whole = is_pin or one.key in whole
            yield _Slice(part.piece_of or part.id, region, is_pin, is_whole)


def _box(bounds: Iterable[float]) -> Box:
    left, bottom, right, top = map(float, bounds)
    return Box(*settled_point((left, bottom)), *settled_point((right, top)))


def _span(line: shapely.Geometry) -> tuple[float, float]:
    _, bottom, _, top = shapely.bounds(line)
    return settled_point((float(bottom), float(top)))


def _band(one: Piece, bottom: float, top: float) -> shapely.Geometry:
    """Return what is cut of a piece between two heights: plates, or a ring about the axis."""
    low, high = settled_point((float(np.ravel(one.low)[0]), float(np.ravel(one.high)[0])))
    if math.isinf(high):
        inner, outer = sorted((abs(bottom), abs(top)))
        hole = shapely.Point(0, 0).buffer(inner if bottom * top > 0 else 0.0)
        return shapely.difference(shapely.Point(0, 0).buffer(outer), hole)
    plates = [shapely.box(low, bottom, high, top), shapely.box(-high, bottom, -low, top)]
    return shapely.union_all(plates)


def _uncovered(slices: Sequence[_Slice]) -> Iterator[_Slice]:
    """Yield each part once, less what pins and later parts take of it; pins last."""
    pins = shapely.union_all([one.region for one in slices if one.is_pin])
    names = list(dict.fromkeys(one.part for one in slices if not one.is_pin))
    taken = pins
    found = []
    for name in reversed(names):
        own = [one for one in slices if one.part == name and not one.is_pin]
        for is_whole in (False, True):  # what is cut takes precedence over what is left whole
            region = shapely.union_all([one.region for one in own if one.is_whole is is_whole])
            free = shapely.difference(region, taken)
            taken = shapely.union(taken, free)
            found.append(_Slice(name, free, is_pin=False, is_whole=is_whole))
    yield from reversed(found)
    for region in _polygons(pins):
        yield _Slice("", region, is_pin=True, is_whole=True)


def _is_shown(one: _Slice, reach: float) -> bool:
    """Tell whether a face is more than a sliver at the rim of what is shown."""
    if shapely.area(one.region) <= _SMALLEST:
        return False
    _, bottom, _, top = shapely.bounds(one.region)
    at_rim = bottom < _NEAR - reach or reach - _NEAR < top
    return bool(not at_rim or top - bottom > _SLIVER * reach)


def _leanings(slices: Sequence[_Slice]) -> Iterator[str]:
    """Yield the leaning of each part's hatch: another one than that of the parts beside it."""
    known: list[tuple[shapely.Geometry, str]] = []
    for one in slices:
        grown = shapely.buffer(one.region, _NEAR)
        beside = [hatch for region, hatch in known if shapely.intersects(region, grown)]
        hatch = min(_HATCHES, key=beside.count)
        known.append((one.region, hatch))
        yield hatch


def _once(edges: Iterable[Seen]) -> Iterator[Seen]:
    """Yield edges, each once: what is left whole shares some with what is cut beside it."""
    known = set()
    for edge in edges:
        ends = frozenset((round(x, 3), round(y, 3)) for x, y in points_of(edge.stroke))
        if ends not in known:
            known.add(ends)
            yield edge


def _polygons(region: shapely.Geometry) -> list[shapely.Polygon]:
    return [
        one
        for one in shapely.get_parts(region)
        if isinstance(one, shapely.Polygon) and one.area > _SMALLEST
    ]


def _edges(piece: shapely.Polygon, reach: float) -> Iterator[Seen]:
    """Yield the edges of a cut face; where the section is broken off, a line of break."""
    for ring in (piece.exterior, *piece.interiors):
        corners = corners_of(ring.simplify(_NEAR))
        for start, end in pairwise([*corners, corners[0]]):
            is_level = abs(end[1] - start[1]) < _NEAR
            if is_level and abs(abs(start[1]) - reach) < _NEAR:
                yield from (Seen(one, LineKind.THIN) for one in _wave(start, end))
            else:
                yield Seen(Line(start, end), LineKind.OUTLINE)


def _wave(start: Point, end: Point) -> Iterator[Stroke]:
    width = end[0] - start[0]
    steps = _WAVE * 2
    points = [
        settled_point(
            (
                start[0] + width * k / steps,
                start[1] + _SWING * abs(width) * math.sin(math.tau * 1.5 * k / steps),
            )
        )
        for k in range(steps + 1)
    ]
    yield from (Line(*pair) for pair in pairwise(points))


def _axes(
    polygons: Sequence[tuple[_Slice, shapely.Polygon]], reach: float, *, has_pin: bool
) -> Iterator[Line]:
    """Yield the axis of the pin and the middle plane."""
    beyond = _BEYOND * reach
    whole = _box(shapely.union_all([piece for _, piece in polygons]).bounds)
    yield Line((0.0, whole.bottom - beyond), (0.0, whole.top + beyond))
    if has_pin:
        yield Line((whole.left - beyond, 0.0), (whole.right + beyond, 0.0))
