"""Where the points of a mechanism are: lets and points in the order in which they can be found."""

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from gripcourse.formula.evaluate import Column
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.proofs.equilibrium.model import (
    Circles,
    Mechanism,
    Place,
    Point,
    formulas_of_point,
)

Array = NDArray[np.float64]


def order_of(mechanism: Mechanism) -> tuple[tuple[str, ...], frozenset[str]]:
    """Return the lets and points in the order in which they can be found, and what cannot be."""
    left = dict(needs(mechanism))
    order: list[str] = []
    while ready := [one for one, names in left.items() if not names & _given_by(left, mechanism)]:
        order += ready
        for one in ready:
            del left[one]
    return tuple(order), frozenset(left)


def needs(mechanism: Mechanism) -> Iterator[tuple[str, frozenset[str]]]:
    """Yield each let and each point with the names that it is found from."""
    for name, formula in mechanism.lets.items():
        yield name, frozenset(formula.names)
    for name, point in mechanism.points.items():
        match point:
            case Place(x, y):
                yield name, frozenset({*x.names, *y.names})
            case Circles(around, radii):
                centres = {f"{centre}_{axis}" for centre in around for axis in "xy"}
                yield name, frozenset({*radii[0].names, *radii[1].names, *centres})


def _given_by(found: Mapping[str, object], mechanism: Mechanism) -> frozenset[str]:
    """Return the names that are known once these lets and points are."""
    points = (name for name in found if name in mechanism.points)
    lets = (name for name in found if name in mechanism.lets)
    return frozenset({*lets, *(f"{name}_{axis}" for name in points for axis in "xy")})


def ordered_formulas(one: Mechanism) -> Iterator[tuple[str, Formula]]:
    """Yield positions, then lets and points in the order in which they can be found."""
    for position, state in one.positions.items():
        for name, formula in state.items():
            yield f"position.{position}.{name}", formula
    for name in order_of(one)[0]:
        if name in one.lets:
            yield f"let.{name}", one.lets[name]
        if name in one.points:
            yield from formulas_of_point(name, one.points[name])


def placed(
    mechanism: Mechanism,
    position: str,
    values: Mapping[str, Array],
    columns: Mapping[str, Column],
) -> dict[str, Array]:
    """Add lets and the coordinates of points to what is known.

    Args:
        mechanism: whose points.
        position: one of its positions.
        values: of the quantities in SI, each of shape (n,).
        columns: of the catalogues.

    Returns:
        The values, and further names of the same shape; NaN where circles do not meet.
    """
    known = dict(values)
    for name, formula in mechanism.positions[position].items():
        known[name] = evaluate_formula(formula, "", values, columns)
    for name in order_of(mechanism)[0]:
        if name in mechanism.lets:
            known[name] = evaluate_formula(mechanism.lets[name], "", known, columns)
        if name in mechanism.points:
            x, y = _found(mechanism.points[name], known, columns)
            known[f"{name}_x"], known[f"{name}_y"] = x, y
    return known


def _found(
    point: Point, known: Mapping[str, Array], columns: Mapping[str, Column]
) -> tuple[Array, Array]:
    def value(formula: Formula) -> Array:
        return evaluate_formula(formula, "", known, columns)

    match point:
        case Place(x, y):
            return value(x), value(y)
        case Circles((first, second), (near, far), is_left):
            start = known[f"{first}_x"], known[f"{first}_y"]
            end = known[f"{second}_x"], known[f"{second}_y"]
            return intersection(start, end, value(near), value(far), 1 if is_left else -1)


def intersection(
    start: tuple[Array, Array], end: tuple[Array, Array], near: Array, far: Array, side: int
) -> tuple[Array, Array]:
    """Return where two circles meet, left (1) or right (-1) of the way between their centres."""
    with np.errstate(all="ignore"):
        across = end[0] - start[0], end[1] - start[1]
        distance = np.hypot(*across)
        along = (near**2 - far**2 + distance**2) / (2 * distance)
        height = side * np.sqrt(near**2 - along**2)
        ahead = across[0] / distance, across[1] / distance
        x = start[0] + along * ahead[0] - height * ahead[1]
        y = start[1] + along * ahead[1] + height * ahead[0]
    return np.asarray(x), np.asarray(y)
