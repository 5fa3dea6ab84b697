"""Whether the bodies of a general view go through one another, for many variants at once.

The bodies are those that the view draws (`bodies`). They are compared two by two in every position
of the kinematics, with the object among them, where they share a depth. Parts that `meets` declares
may overlap, and what a part touches it may press into a little; a part does not overlap itself, but
may its own copy on the other side of the axis.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import shapely
from numpy.typing import NDArray

from gripcourse.course.model import Scheme
from gripcourse.course.view import View
from gripcourse.drawing.view.bodies import (
    Geometries,
    Piece,
    Scene,
    boxes_overlap,
    names_of,
    pieces_of,
)
from gripcourse.drawing.view.numbers import values_at
from gripcourse.formula.evaluate import Array, Column
from gripcourse.solver.solve import Values

TOLERANCE = 0.01  # mm: what touches is no interference
PRESSED = 0.2  # mm that a part may stand in what it presses on
_CHUNK = 2048  # variants whose bodies are held at once


@dataclass(frozen=True, slots=True)
class PartPair:
    """Two parts by id, in order, and a position of the kinematics; empty where there is none."""

    first: str
    second: str
    position: str


@dataclass(frozen=True, slots=True)
class Interference:
    """Two bodies that go through one another by `overlap` mm."""

    pair: PartPair
    overlap: float


@dataclass(frozen=True, slots=True)
class Overlaps:
    """What was found in n variants.

    Attributes:
        count: n.
        pairs: those that overlap in any variant: by how many mm in each, shape (n,), 0 for not at
            all. Two bodies overlap by the shorter side of the smallest rectangle, however turned,
            round the largest region that both fill.
    """

    count: int
    pairs: Mapping[PartPair, Array]

    @property
    def worst(self) -> Array:
        """The deepest overlap of each variant in mm, shape (n,); 0 for none."""
        return np.asarray(np.max([np.zeros(self.count), *self.pairs.values()], axis=0))

    @property
    def clear(self) -> NDArray[np.bool_]:
        """Which variants have no interference, shape (n,)."""
        return np.asarray(self.worst == 0)

    def of(self, row: int) -> Interference | None:
        """Return the deepest overlap of one variant."""
        pair = max(self.pairs, key=lambda one: float(self.pairs[one][row]), default=None)
        if pair is None or self.pairs[pair][row] == 0:
            return None
        return Interference(pair, float(self.pairs[pair][row]))


def interference(scheme: Scheme, columns: Mapping[str, Column], values: Values) -> Overlaps:
    """Find the bodies that go through one another in variants of one scheme.

    Args:
        scheme: of the variants; one whose view does not say that it shows bodies has none.
        columns: catalogue columns in SI.
        values: of quantities in SI, single numbers or arrays of shape (n,). Variants may have
            different options: what one of them does not have is NaN (`together`).
    """
    size = _size(values)
    found: dict[PartPair, Array] = {}
    for start in range(0, size, _CHUNK):
        rows = slice(start, min(start + _CHUNK, size))
        part = {name: one[rows] if np.ndim(one) else one for name, one in values.items()}
        for pair, depth in _pairs(_scenes(scheme, columns, part)):
            whole = found.setdefault(pair, np.zeros(size))
            whole[rows] = np.maximum(whole[rows], depth)
    return Overlaps(size, found)


def together(scheme: Scheme, groups: Sequence[tuple[Values, int]]) -> dict[str, Array]:
    """Put variants with different options behind one another, as far as their bodies need it.

    Args:
        scheme: of all of them.
        groups: values of variants with the same options in SI, and how many variants they are.

    Returns:
        Arrays of shape (n,), NaN where the variant's options do not bring a quantity.
    """
    needed = _needed(scheme)
    names = {name for values, _ in groups for name in values if name in needed}
    nothing = np.asarray(np.nan)
    return {
        name: np.concatenate(
            [np.broadcast_to(values.get(name, nothing), count) for values, count in groups]
        )
        for name in sorted(names)
    }


def crossed_outlines(
    scheme: Scheme, columns: Mapping[str, Column], values: Values
) -> Mapping[tuple[str, str], NDArray[np.bool_]]:
    """Find outlines that cross themselves in variants of one scheme; see `interference`.

    Returns:
        By file and key of a shape, in which variants, shape (n,); only those that do at all.
    """
    size = _size(values)
    found: dict[tuple[str, str], NDArray[np.bool_]] = {}
    for pieces in _scenes(scheme, columns, values).values():
        for piece in pieces:
            there = np.flatnonzero(np.isfinite(piece.box).all(axis=0))
            wrong = np.zeros(size, dtype=np.bool_)
            if piece.kind == "polygon":
                wrong[there] = ~shapely.is_valid(piece.outline(there))
            if wrong.any():
                place = (piece.part.file, piece.key)
                found[place] = found.get(place, wrong) | wrong
    return found


def _size(values: Values) -> int:
    return max((np.size(one) for one in values.values()), default=1)


def _pairs(scenes: Mapping[str, Sequence[Piece]]) -> Iterator[tuple[PartPair, Array]]:
    for number, (position, pieces) in enumerate(scenes.items()):
        for first, second in combinations(pieces, 2):
            if _may_collide(first, second) and (number == 0 or not _is_known(first, second)):
                depth = _depth(first, second)
                if depth is not None and (depth := _beyond(depth, first, second)).any():
                    yield PartPair(first.part.id, second.part.id, position), depth


def _scenes(
    scheme: Scheme, columns: Mapping[str, Column], values: Values
) -> Mapping[str, Sequence[Piece]]:
    """Return the pieces of a scheme's view in each position."""
    view, motion = scheme.view, scheme.kinematics
    if view is None or not view.bodies:
        return {}
    size, moving = _size(values), _moving(scheme, view)
    positions = tuple(motion.at) if motion is not None else ("",)
    scenes = {
        one: Scene(values_at(scheme, columns, view, values, one), columns, size, moving)
        for one in positions
    }
    return {
        position: [
            piece
            for part in view.parts
            if not part.positions or position in part.positions
            for piece in pieces_of(part, scenes[part.placed_at or position])
        ]
        for position in positions
    }


def _moving(scheme: Scheme, view: View) -> frozenset[str]:
    """Return the names that depend on the position of the drive."""
    motion = scheme.kinematics
    if motion is None:
        return frozenset()
    moving, needed = {motion.drive}, _inputs(scheme, view)
    while new := {name for name, names in needed.items() if names & moving} - moving:
        moving |= new
    return frozenset(moving)


def _needed(scheme: Scheme) -> set[str]:
    """Return the names that a scheme's bodies and their positions are computed from."""
    if scheme.view is None:
        return set()
    found = {name for names in _inputs(scheme, scheme.view).values() for name in names}
    found |= {name for part in scheme.view.parts for name in names_of(part)}
    if scheme.kinematics is not None:
        found |= {name for one in scheme.kinematics.at.values() for name in one.names}
    return found


def _inputs(scheme: Scheme, view: View) -> dict[str, set[str]]:
    """Return what each coordinate and each measure is computed from."""
    coordinates = scheme.kinematics.coordinates if scheme.kinematics is not None else ()
    needed = {one.id: set(one.formula.names) for one in coordinates}
    for name, measure in view.measures.items():
        needed[name] = {one for formula in measure.formulas for one in formula.names}
    return needed


def _may_collide(first: Piece, second: Piece) -> bool:
    if first.part.id in second.part.meets or second.part.id in first.part.meets:
        return False
    if first.part is second.part:
        return first.side > second.side
    # Two pairs of copies: what the other copy of the first part does follows by symmetry.
    return first.side > 0 or not second.part.mirrored


def _is_known(first: Piece, second: Piece) -> bool:
    """Tell whether what two pieces do in the first position holds in all."""
    return (
        first.is_fixed
        and second.is_fixed
        and not first.part.positions
        and not second.part.positions
    )


def _beyond(depth: Array, first: Piece, second: Piece) -> Array:
    """Return the overlaps that are more than the pressure of one that holds the other."""
    for one, other in ((first, second), (second, first)):
        if other.part.id in one.part.touches:
            return np.asarray(np.where(depth > PRESSED + one.enters, depth, 0.0))
    return depth


def _depth(first: Piece, second: Piece) -> Array | None:
    """Return by how many mm two pieces overlap in each variant; None where they never do."""
    shared = np.minimum(first.high, second.high) - np.maximum(first.low, second.low)
    near = boxes_overlap(first.box, second.box) & (shared > TOLERANCE)
    rows = np.flatnonzero(near)
    if not len(rows):
        return None
    common = shapely.intersection(first.solid(rows), second.solid(rows))
    # Twice the area over the circumference: the width of a strip, half the side of a square.
    deep = 2 * shapely.area(common) > TOLERANCE * shapely.length(common)
    if not deep.any():
        return None
    found = np.zeros(near.shape)
    found[rows[deep]] = _shorter_sides(common[deep])
    return found


def _shorter_sides(regions: Geometries) -> Array:
    """Return the shorter side of the smallest rectangle round the largest part of each region."""
    parts, place = shapely.get_parts(regions, return_index=True)
    flat = shapely.get_dimensions(parts) == len("xy")
    parts, place = parts[flat], place[flat]
    found, largest = np.zeros(len(regions)), np.zeros(len(regions))
    np.maximum.at(largest, place, shapely.area(parts))
    chosen = shapely.area(parts) == largest[place]
    corners = shapely.get_coordinates(shapely.oriented_envelope(parts[chosen])).reshape(-1, 5, 2)
    sides = np.hypot(*(corners[:, 1:3] - corners[:, :2]).T)
    np.maximum.at(found, place[chosen], sides.min(axis=0))
    return found
