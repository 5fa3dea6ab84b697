"""How often another honest reading of a quantity matters: differs beyond the tolerance.

One that never differs is no question at all; one that always does is worth a sentence on the sheet.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.quantity import Alternative, Quantity
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.policy.bands import bands
from gripcourse.policy.model import Policy
from gripcourse.solver.family import Member
from gripcourse.solver.sizes import choose
from gripcourse.variants.answers import Group
from gripcourse.variants.feasible import Array


@dataclass(frozen=True, slots=True)
class ReadingCount:
    """In how many of the variants that have a quantity another reading gives another answer."""

    scheme: str
    quantity: str
    alternative: str
    differs: int
    variants: int

    @property
    def share(self) -> float:
        """Share of the variants, 0 to 1."""
        return self.differs / self.variants if self.variants else 0.0


def count_readings(groups: Sequence[Group], policy: Policy) -> tuple[ReadingCount, ...]:
    """Count the declared alternatives over solved variants, those that differ oftenest first."""
    counts: dict[tuple[str, str, str], ReadingCount] = {}
    for group in groups:
        for member in group.family.answered:
            right = member.of(group.values[member.quantity.id])
            for other in member.quantity.alternatives:
                value = _value(member, member.quantity, other, group)
                reach = bands(member.quantity, right, policy)
                with np.errstate(invalid="ignore"):  # what gives no number is no answer
                    differs = int(np.sum(np.abs(value - right) > reach))
                key = (member.plan.scheme.id, member.quantity.id, other.id)
                before = counts.get(key, ReadingCount(*key, 0, 0))
                counts[key] = ReadingCount(
                    *key, before.differs + differs, before.variants + len(right)
                )
    return tuple(sorted(counts.values(), key=lambda one: (-one.share, one.scheme, one.quantity)))


def _value(member: Member, quantity: Quantity, other: Alternative, group: Group) -> Array:
    """Compute what a reading gives, SI, in every variant that has the quantity."""
    names = {*other.formula.names, *member.inputs}
    values = {name: member.of(group.values[name]) for name in names}
    value = evaluate_formula(other.formula, quantity.unit, values, member.plan.columns)
    return choose(member.plan, quantity, value, values)
