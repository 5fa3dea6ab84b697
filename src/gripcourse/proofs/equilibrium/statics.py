"""Sums of forces and moments of every body, solved for all reactions of many variants at once."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.formula.evaluate import Column
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import Formula
from gripcourse.proofs.equilibrium.model import GROUND, Load, Mechanism
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

    sums = _sums(mechanism, known, count, value)
    solved, is_solved, weakest = _solved(sums.matrix, sums.right)
    names = mechanism.unknowns
    loose = frozenset(
        name for name, share in zip(names, weakest, strict=True) if abs(share) > np.sqrt(_RANK)
    )
    reactions = {name: solved[:, column] for column, name in enumerate(names)}
    for joint in mechanism.joints:
        found = {last: reactions[f"{joint.id}_{last}"] for last in joint.unknowns}
        for last, amount in results(joint, known, found, value).items():
            reactions[f"{joint.id}_{last}"] = np.broadcast_to(amount, count)
    return Solution(reactions, is_solved, loose)


def _solved(matrix: Array, right: Array) -> tuple[Array, NDArray[np.bool_], Array]:
    """Solve all systems that have one solution.

    Returns:
        Solutions, shape (n, size), NaN where there is none; where there is one; and of the first
        that has none, or many, how much each unknown could change without being noticed.
    """
    size = matrix.shape[1]
    sound = np.isfinite(np.concatenate([matrix, right[..., None]], axis=2)).all(axis=(1, 2))
    safe = np.where(sound[:, None, None], matrix, np.eye(size))
    # Rows of moments and columns of couples have other units: compared by their own size.
    rows = np.abs(safe).max(axis=2, keepdims=True)
    scaled = safe / np.where(rows > 0, rows, 1.0)
    columns = np.abs(scaled).max(axis=1, keepdims=True)
    _, singular, basis = np.linalg.svd(scaled / np.where(columns > 0, columns, 1.0))
    regular: NDArray[np.bool_] = singular[:, -1] > _RANK * singular[:, 0]
    wrong = np.flatnonzero(np.logical_and(sound, np.logical_not(regular)))
    weakest = basis[wrong[0], -1] if len(wrong) else np.zeros(size)
    is_solved = np.logical_and(sound, regular)
    safe = np.where(is_solved[:, None, None], safe, np.eye(size))
    known = np.where(is_solved[:, None], right, np.nan)
    return np.linalg.solve(safe, known[..., None])[..., 0], is_solved, weakest


@dataclass(frozen=True, slots=True)
class _Sums:
    """Sums of all variants: matrix and right side, shapes (n, size, size) and (n, size).

    Attributes:
        rows: the first of the three rows of each body.
        columns: of each unknown.
    """

    matrix: Array
    right: Array
    rows: Mapping[str, int]
    columns: Mapping[str, int]

    def add(self, body: str, column: str, wrench: Wrench, sense: float) -> None:
        """Let an unknown act on a body; the ground needs no sums."""
        if body != GROUND:
            for part in range(3):
                place = self.rows[body] + part
                self.matrix[:, place, self.columns[column]] += sense * wrench[part]

    def load(self, body: str, wrench: Wrench, sense: float) -> None:
        """Let what is known act on a body."""
        if body != GROUND:
            for part in range(3):
                self.right[:, self.rows[body] + part] -= sense * wrench[part]


def _sums(mechanism: Mechanism, known: Mapping[str, Array], count: int, value: Value) -> _Sums:
    """Write down three sums for each body, then the relations."""
    size = mechanism.equation_count
    sums = _Sums(
        matrix=np.zeros((count, size, size)),
        right=np.zeros((count, size)),
        rows={body: 3 * number for number, body in enumerate(mechanism.bodies)},
        columns={name: number for number, name in enumerate(mechanism.unknowns)},
    )
    for joint in mechanism.joints:
        wrenches = unit_wrenches(joint, known, value)
        for last, wrench in zip(joint.unknowns, wrenches, strict=True):
            for body, sense in zip(joint.between, (1.0, -1.0), strict=True):
                sums.add(body, f"{joint.id}_{last}", wrench, sense)
    for load in mechanism.loads:
        wrench = _of_load(load, known, count, value)
        sums.load(load.on, wrench, 1.0)
        sums.load(load.source, wrench, -1.0)
    for number, relation in enumerate(mechanism.relations, 3 * len(mechanism.bodies)):
        for name, factor in relation.factors.items():
            sums.matrix[:, number, sums.columns[name]] = value(factor)
        sums.right[:, number] = value(relation.gives)
    return sums


def _of_load(load: Load, known: Mapping[str, Array], count: int, value: Value) -> Wrench:
    amount, zero = value(load.amount), np.zeros(count)
    if load.direction is None:
        return zero, zero, amount
    angle = value(load.direction)
    x, y = known[f"{load.at}_x"], known[f"{load.at}_y"]
    return force_at(x, y, amount * np.cos(angle), amount * np.sin(angle))
