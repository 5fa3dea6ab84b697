"""How the points of the sections fall on their quantities."""

from collections.abc import Mapping

from gripcourse.course.quantity import Quantity
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan


def points_of(plan: Plan, policy: Policy) -> Mapping[str, float]:
    """Return the points of every marked quantity of a plan, by id.

    The points of a section are shared by weight: the quantity's own, else its kind's.
    """
    marked = (*plan.answered, *plan.manual)
    totals: dict[str, float] = {}
    for quantity in marked:
        totals[quantity.section] = totals.get(quantity.section, 0.0) + weight_of(quantity, policy)
    return {
        quantity.id: policy.section_points[quantity.section]
        * weight_of(quantity, policy)
        / (totals[quantity.section] or 1.0)
        for quantity in marked
    }


def weight_of(quantity: Quantity, policy: Policy) -> float:
    """Return the weight of a quantity in its section: its own, else its kind's."""
    return policy.weights.get(quantity.id, policy.kind_weights[quantity.kind])
