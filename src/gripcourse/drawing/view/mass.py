"""The mass of what a general view draws: from its bodies, their thicknesses and one density.

A body with a depth is a plate; one that lies all through is turned about the axis, which lies along
x or, where a view is upright, along y. What the bodies of a part share counts once; what phantom
lines show counts nothing.
"""

import math
from collections import defaultdict
from collections.abc import Mapping

import numpy as np
import shapely
import shapely.affinity

from gripcourse.course.view import View
from gripcourse.drawing.view.bodies import Piece, Scene, pieces_of
from gripcourse.drawing.view.made_of import made_of
from gripcourse.drawing.view.numbers import numbers_at
from gripcourse.solver.plan import Plan

_CUBIC = 1e-9  # m³ in a mm³
_TWO = 2.0
_FAR = 1e6  # mm, beyond anything drawn


def mass_of(plan: Plan, view: View, solved: Mapping[str, float]) -> float | None:
    """Return the mass of a variant in kg; None where the view does not tell a density.

    Args:
        plan: of the variant.
        view: of its scheme.
        solved: its values in declared units.
    """
    if not view.density or not view.bodies:
        return None
    numbers = numbers_at(plan, view, solved, view.position)
    values = {name: np.atleast_1d(one) for name, one in numbers.values.items()}
    scene = Scene(values, plan.columns, 1, frozenset())
    around = numbers.number(view.around, "") if view.around is not None else None
    mass = 0.0
    for part in view.parts:
        if part.positions and view.position not in part.positions:
            continue
        unseen = {one.key for one in part.shapes if one.line == "phantom"}
        pieces = [one for one in pieces_of(part, scene) if one.key not in unseen]
        copies = (around or _TWO) / _TWO if part.mirrored else 1.0
        volume = _volume(pieces, upright=view.upright)
        mass += copies * volume * _CUBIC * made_of(part, view, numbers).density
    return mass


def _volume(pieces: list[Piece], *, upright: bool) -> float:
    """Return the volume of the pieces of one part, mm³."""
    row = np.array([0])
    layers: dict[tuple[float, float], list[shapely.Geometry]] = defaultdict(list)
    for one in pieces:
        if np.isfinite(one.box).all():
            depth = float(np.ravel(one.low)[0]), float(np.ravel(one.high)[0])
            layers[depth].append(one.solid(row)[0])
    return sum(
        _turned(shapely.union_all(solids), upright=upright)
        if math.isinf(high)
        else float(shapely.area(shapely.union_all(solids))) * _TWO * (high - low)
        for (low, high), solids in layers.items()
    )


def _turned(region: shapely.Geometry, *, upright: bool) -> float:
    """Return the volume that a region and its mirror image sweep about the axis, mm³."""
    lying = shapely.affinity.rotate(region, -90, origin=(0, 0)) if upright else region
    found = 0.0
    for side in (shapely.box(-_FAR, 0.0, _FAR, _FAR), shapely.box(-_FAR, -_FAR, _FAR, 0.0)):
        half = shapely.intersection(lying, side)
        found += math.pi * abs(shapely.centroid(half).y) * half.area if half.area else 0.0
    return found
