"""The bodies of many variants at once: what a general view draws, as solid figures in its plane.

A body is made of the closed shapes of a part in the main face, less what is cut out of them. Every
shape of every copy of a part is one `Piece` whose numbers are arrays over the variants: shape (n,),
lengths in mm. A row of NaN says that the variant does not have the piece.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
import shapely
from numpy.typing import NDArray

from gripcourse.course.view import SHAPES, Expression, Face, Need, Repeat, Ring, ViewPart, ViewShape
from gripcourse.drawing.view.placed_shapes import MOST_COPIES
from gripcourse.formula.evaluate import Array, Column
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.solver.solve import Values
from gripcourse.text.units import factor

Geometries = NDArray[np.object_]
Rows = NDArray[np.intp]

_CHORDS = 64  # of a full circle
_QUARTER_CHORDS = 12  # of a quarter of a bar's round end
_FULL_TURN = 360.0


@dataclass(frozen=True, slots=True)
class Piece:
    """One solid shape of one copy of a part, in all variants.

    Attributes:
        part: that it belongs to.
        key, kind: of its shape.
        side: 1 where it was declared, -1 for the copy on the other side of the axis.
        points: its corners, or the middle line of a bar, shape (n, k, 2).
        half: half the width of a bar, shape (n,); None for what has corners.
        low, high: between which distances from the plane of the view it lies, on both sides of the
            plane, shape (n,).
        enters: how much deeper than by elasticity it may press into what it touches, shape (n,).
        voids: what is cut out of it.
        is_fixed: whether it stands where it stands in every position.
        box: left, bottom, right and top of it, shape (4, n).
    """

    part: ViewPart
    key: str
    kind: str
    side: int
    points: Array
    half: Array | None
    low: Array | float
    high: Array | float
    enters: Array | float
    voids: tuple["Piece", ...]
    is_fixed: bool
    box: Array

    def solid(self, rows: Rows) -> Geometries:
        """Return what it fills in some variants, which all have it."""
        found = self.outline(rows)
        if not shapely.is_valid(found).all():
            found = shapely.make_valid(found)
        for void in self.voids:
            cut = boxes_overlap(self.box[:, rows], void.box[:, rows])
            if cut.any():
                found[cut] = shapely.difference(found[cut], void.solid(rows[cut]))
        return found

    def outline(self, rows: Rows) -> Geometries:
        """Return the outline in some variants, with what is cut out, as it is declared."""
        if self.half is None:
            return np.asarray(shapely.polygons(self.points[rows]), dtype=np.object_)
        return np.asarray(
            shapely.buffer(
                shapely.linestrings(self.points[rows]),
                self.half[rows],
                quad_segs=_QUARTER_CHORDS,
            ),
            dtype=np.object_,
        )


def boxes_overlap(first: Array, second: Array) -> NDArray[np.bool_]:
    """Tell in which variants two boxes, of shape (4, n), share an inside; not where one is NaN."""
    return np.asarray(
        (first[0] < second[2])
        & (second[0] < first[2])
        & (first[1] < second[3])
        & (second[1] < first[3])
    )


@dataclass(frozen=True, slots=True)
class Scene:
    """What the formulas of a view are computed from.

    Attributes:
        values: by name in SI: quantities, coordinates, measures.
        columns: catalogue columns in SI.
        count: how many variants there are.
        moving: names that depend on the position of the drive.
    """

    values: Values
    columns: Mapping[str, Column]
    count: int
    moving: frozenset[str]

    def arrays(self, written: Sequence[Expression], unit: str = "mm") -> Array | None:
        """Compute formulas, shape (n, k); None where a name is not known."""
        if any(one is not None and not self.values.keys() >= set(one.names) for one in written):
            return None
        found = np.zeros((self.count, len(written)))
        for column, one in enumerate(written):
            if one is not None:
                result = evaluate_formula(one, unit, self.values, self.columns)
                found[:, column] = result / factor(unit)
        return found


def pieces_of(part: ViewPart, scene: Scene) -> Iterator[Piece]:
    """Yield the pieces of a part, those where it is declared first."""
    main = [shape for shape in part.shapes if shape.face is Face.MAIN]
    for side in (1, -1) if part.mirrored else (1,):
        voids = {shape.key: list(_copies(part, shape, scene, side)) for shape in main if shape.void}
        for shape in main:
            if shape.body and not shape.void:
                depth = _written(part, shape)
                cut = [one for other in main if other.void and _written(part, other) == depth
                       for one in voids[other.key]]  # fmt: skip
                yield from _copies(part, shape, scene, side, tuple(cut))


def names_of(part: ViewPart) -> set[str]:
    """Return the names that the solid shapes of a part are computed from."""
    depth = {name for one in (*part.depth, part.enters) if one is not None for name in one.names}
    shapes = (shape for shape in part.shapes if shape.face is Face.MAIN)
    return depth.union(*(_names(shape) for shape in shapes))


def _names(shape: ViewShape) -> set[str]:
    written = [*shape.depth, *(one for found in shape.needs.values() for one in found)]
    for repeat in shape.repeats:
        written += [repeat.count, *(repeat.about if isinstance(repeat, Ring) else repeat.step)]
    return {name for one in written if one is not None for name in one.names}


def _written(part: ViewPart, shape: ViewShape) -> list[str]:
    return ["0" if one is None else one.text for one in shape.depth or part.depth]


def _copies(
    part: ViewPart, shape: ViewShape, scene: Scene, side: int, voids: tuple[Piece, ...] = ()
) -> Iterator[Piece]:
    rings = any(isinstance(one, Ring) for one in shape.repeats)
    needs = _needs(shape, scene)
    if needs is None or (rings and side < 0):  # what stands round a point is not mirrored
        return
    points, half = _FIGURES[shape.kind](needs), _half(needs) if shape.kind == "bar" else None
    depth = scene.arrays(shape.depth or part.depth)
    low, high = (0.0, np.inf) if depth is None or not depth.size else depth.T
    enters = 0.0 if part.enters is None else scene.arrays((part.enters,))
    enters = 0.0 if enters is None else np.ravel(enters)
    fixed = scene.moving.isdisjoint(_names(shape)) or bool(part.placed_at)
    for moves in product(*(_moves(one, scene) for one in shape.repeats)):
        moved = points
        for turn, about, shift in moves:
            moved = _turned(moved - about, turn) + about + shift
        moved = moved * np.array([1.0, side])
        box = _box(moved, half)
        yield Piece(
            part, shape.key, shape.kind, side, moved, half, low, high, enters, voids, fixed, box
        )


def _needs(shape: ViewShape, scene: Scene) -> Mapping[str, Array] | None:
    needs = {}
    for name, written in shape.needs.items():
        unit = "deg" if SHAPES[shape.kind][name] is Need.ANGLES else "mm"
        found = scene.arrays(written, unit)
        if found is None:
            return None
        needs[name] = found
    return needs


def _moves(repeat: Repeat | Ring, scene: Scene) -> list[tuple[Array, Array, Array]]:
    """Return the turn of each copy in degrees, the point it is about, and its shift."""
    counts = scene.arrays((repeat.count,), "")
    place = scene.arrays(repeat.about if isinstance(repeat, Ring) else repeat.step)
    if counts is None or place is None:
        return []
    count = np.minimum(np.round(counts[:, 0]), MOST_COPIES)
    most, nothing = int(np.nan_to_num(count).max(initial=0)), np.zeros(scene.count)
    found = []
    for time in range(most):
        there = np.where(time < count, 1.0, np.nan)[:, None, None]
        if isinstance(repeat, Ring):
            found.append((_FULL_TURN * time / count, place[:, None] * there, 0 * place[:, None]))
        else:
            found.append((nothing, 0 * place[:, None], place[:, None] * time * there))
    return found


def _turned(points: Array, angle: Array) -> Array:
    cosine, sine = np.cos(np.radians(angle))[:, None], np.sin(np.radians(angle))[:, None]
    x, y = points[..., 0], points[..., 1]
    return np.stack([x * cosine - y * sine, x * sine + y * cosine], axis=-1)


def _half(needs: Mapping[str, Array]) -> Array:
    return np.asarray(needs["width"][:, 0] / 2)


def _box(points: Array, half: Array | None) -> Array:
    beyond = 0.0 if half is None else half
    low, high = points.min(axis=1).T - beyond, points.max(axis=1).T + beyond
    return np.concatenate([low, high])


def _rectangle(needs: Mapping[str, Array]) -> Array:
    x, y = needs["x"], needs["y"]
    return np.stack([x[:, [0, 1, 1, 0]], y[:, [0, 0, 1, 1]]], axis=-1)


def _corners(needs: Mapping[str, Array]) -> Array:
    flat = needs.get("corners", needs.get("through"))
    if flat is None:
        raise LookupError(sorted(needs))
    return flat.reshape(len(flat), -1, 2)


def _circle(needs: Mapping[str, Array]) -> Array:
    angles = np.linspace(0.0, _FULL_TURN, _CHORDS, endpoint=False)
    return _on_circle(needs["at"], needs["diameter"] / 2, angles)


def _sector(needs: Mapping[str, Array]) -> Array:
    low, high = needs["angles"][:, :1], needs["angles"][:, 1:]
    angles = low + np.minimum(high - low, _FULL_TURN) * np.linspace(0.0, 1.0, _CHORDS + 1)
    rim = _on_circle(needs["at"], needs["radius"], angles)
    return np.concatenate([needs["at"][:, None], rim], axis=1)


def _taper(needs: Mapping[str, Array]) -> Array:
    start, end, radii = needs["start"], needs["end"], needs["widths"] / 2
    x, y = (end - start).T
    length = np.maximum(np.hypot(x, y), np.finfo(float).tiny)
    lean = np.arccos(np.clip((radii[:, 0] - radii[:, 1]) / length, -1.0, 1.0))
    along, lean = np.degrees(np.arctan2(y, x))[:, None], np.degrees(lean)[:, None]
    turned = np.linspace(-1.0, 1.0, _CHORDS // 2 + 1)
    far = _on_circle(end, radii[:, 1:], along + lean * turned)
    near = _on_circle(
        start, radii[:, :1], along + _FULL_TURN / 2 + (_FULL_TURN / 2 - lean) * turned
    )
    return np.concatenate([far, near], axis=1)


def _on_circle(centre: Array, radius: Array, angles: Array) -> Array:
    turned = np.radians(angles)
    around = np.stack([radius * np.cos(turned), radius * np.sin(turned)], axis=-1)
    return np.asarray(centre[:, None] + around)


_FIGURES = {
    "box": _rectangle,
    "circle": _circle,
    "pin": _circle,
    "bar": _corners,
    "taper": _taper,
    "polygon": _corners,
    "sector": _sector,
}
