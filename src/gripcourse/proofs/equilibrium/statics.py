"""Sums of forces and moments of every body, solved for all reactions of many variants at once."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.formula.evaluate import Column
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.proofs.equilibrium.model import GROUND, Mechanism
from gripcourse.proofs.equilibrium.wrenches import Value, Wrench, force_at, results, unit_wrenches

Array = NDArray[np.float64]

_RANK: Final = 1e-10  # singular values below this share of the largest are none


@dataclass(frozen=True, slots=True)
class Solution:
    """Reactions of a mechanism in one position.

    Attributes:
        reactions: by name, in SI, each of shape (n,); NaN where there is no solution.
        is_solved: where the equations have exactly one solution.
        loose: names of reactions that the equations leave open where they have none.
    """

    reactions: Mapping[str, Array]
    is_solved: NDArray[np.bool_]
    loose: frozenset[str]


def solve(
    mechanism: Mechanism, known: Mapping[str, Array], columns: Mapping[str, Column]
) -> Solution:
    """Solve the equilibrium of all bodies.

    Args:
        mechanism: with as many unknowns as equations.
        known: quantities, lets and coordinates of points in SI, each of shape (n,).
        columns: of the catalogues.
    """
    count = len(next(iter(known.values())))

    def value(formula: Formula) -> Array:
        return np.broadcast_to(evaluate_formula(formula, "", known, columns), count)

    matrix, right = _equations(mechanism, known, count, value)
    sound = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(right).all(axis=1)
    safe = np.where(sound[:, None, None], matrix, np.eye(matrix.shape[1]))
    # Rows of moments and columns of couples have other units: compared by their own size.
    rows = np.abs(safe).max(axis=2, keepdims=True)
    scaled = safe / np.where(rows > 0, rows, 1.0)
    sizes = np.abs(scaled).max(axis=1, keepdims=True)
    scaled = scaled / np.where(sizes > 0, sizes, 1.0)
    _, singular, basis = np.linalg.svd(scaled)
    regular = singular[:, -1] > _RANK * singular[:, 0]
    names = mechanism.unknowns
    wrong = np.flatnonzero(sound & ~regular)
    loose = frozenset(
        names[column]
        for column in range(len(names))
        if len(wrong) and abs(basis[wrong[0], -1, column]) > np.sqrt(_RANK)
    )
    is_solved = sound & regular
    safe = np.where(is_solved[:, None, None], safe, np.eye(matrix.shape[1]))
    solved = np.linalg.solve(safe, np.where(is_solved[:, None], right, np.nan)[..., None])[..., 0]
    reactions = {name: solved[:, column] for column, name in enumerate(names)}
    for joint in mechanism.joints:
        found = {last: reactions[f"{joint.id}_{last}"] for last in joint.unknowns}
        for last, amount in results(joint, known, found, value).items():
            reactions[f"{joint.id}_{last}"] = np.broadcast_to(amount, count)
    return Solution(reactions, is_solved, loose)


def _equations(
    mechanism: Mechanism, known: Mapping[str, Array], count: int, value: Value
) -> tuple[Array, Array]:
    """Return matrix and right side: three rows for each body, then the relations."""
    row_of = {body: 3 * number for number, body in enumerate(mechanism.bodies)}
    size = mechanism.equation_count
    matrix, right = np.zeros((count, size, size)), np.zeros((count, size))
    column_of = {name: number for number, name in enumerate(mechanism.unknowns)}
    for joint in mechanism.joints:
        wrenches = unit_wrenches(joint, known, value)
        for last, wrench in zip(joint.unknowns, wrenches, strict=True):
            column = column_of[f"{joint.id}_{last}"]
            for body, sense in zip(joint.between, (1.0, -1.0), strict=True):
                if body != GROUND:
                    for part in range(3):
                        matrix[:, row_of[body] + part, column] += sense * wrench[part]
    for load in mechanism.loads:
        amount = value(load.amount)
        wrench = (np.zeros(count), np.zeros(count), amount)
        if load.direction is not None:
            wrench = _of_force(known, load.at, amount, value(load.direction))
        for body, sense in ((load.on, -1.0), (load.source, 1.0)):
            if body != GROUND:
                for part in range(3):
                    right[:, row_of[body] + part] += sense * wrench[part]
    for number, relation in enumerate(mechanism.relations, 3 * len(mechanism.bodies)):
        for name, factor in relation.factors.items():
            matrix[:, number, column_of[name]] = value(factor)
        right[:, number] = value(relation.gives)
    return matrix, right


def _of_force(known: Mapping[str, Array], at: str, amount: Array, angle: Array) -> Wrench:
    x, y = known[f"{at}_x"], known[f"{at}_y"]
    return force_at(x, y, amount * np.cos(angle), amount * np.sin(angle))
