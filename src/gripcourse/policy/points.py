"""How the points of the sections fall on their quantities."""

from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Quantity
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan

Array = NDArray[np.float64]


def points_of(plan: Plan, policy: Policy) -> Mapping[str, float]:
    """Return the points of every marked quantity of a plan, by id.

    Main results have the points that the policy declares, whatever else the section asks for. What
    is left of a section is shared by weight: the quantity's own, else its kind's.
    """
    marked = plan.asked
    fixed: dict[str, float] = {}
    weights: dict[str, float] = {}
    for quantity in marked:
        _count(quantity, policy, fixed, weights)
    points: dict[str, float] = {}
    shares: dict[tuple[str, float | None, float], float] = {}  # most of a section have the same
    for quantity in marked:
        section = quantity.section
        own, weight = policy.main_points.get(quantity.id), weight_of(quantity, policy)
        share = shares.get((section, own, weight))
        if share is None:
            all_fixed = np.asarray(fixed.get(section, 0.0))
            all_weights = np.asarray(weights.get(section, 0.0))
            share = float(shares_of(quantity, policy, all_fixed, all_weights))
            shares[section, own, weight] = share
        points[quantity.id] = share
    return points


def _count(
    quantity: Quantity, policy: Policy, fixed: dict[str, float], weights: dict[str, float]
) -> None:
    own = policy.main_points.get(quantity.id)
    table, value = (weights, weight_of(quantity, policy)) if own is None else (fixed, own)
    table[quantity.section] = table.get(quantity.section, 0.0) + value


def shares_of(quantity: Quantity, policy: Policy, fixed: Array, weights: Array) -> Array:
    """Return the points of a quantity in each of n variants that have it.

    Args:
        quantity: a marked one.
        policy: with the points of its section.
        fixed: sum of the points that the policy declares for quantities of the section, shape (n,).
        weights: sum of the weights of the others, shape (n,).
    """
    section = policy.section_points[quantity.section]
    own = policy.main_points.get(quantity.id)
    if section == 0:
        return np.zeros_like(weights)  # a section that is not marked
    if own is None:
        return (section - fixed) * weight_of(quantity, policy) / np.where(weights, weights, 1.0)
    # Where a section asks for nothing else, its main results have all of it.
    return np.where(weights, own, section * own / np.where(fixed, fixed, 1.0))


def weight_of(quantity: Quantity, policy: Policy) -> float:
    """Return the weight of a quantity in its section: its own, else its kind's."""
    return policy.weights.get(quantity.id, policy.kind_weights[quantity.kind])


def main_points_by_section(
    quantities: Iterable[Quantity], main_points: Mapping[str, float]
) -> dict[str, float]:
    """Return the sum of the declared points of quantities, by section."""
    sums: dict[str, float] = {}
    for quantity in {one.id: one for one in quantities}.values():
        if quantity.id in main_points:
            sums[quantity.section] = sums.get(quantity.section, 0.0) + main_points[quantity.id]
    return sums
