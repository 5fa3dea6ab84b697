"""How far the results of wrong methods lie from the right one, variant by variant.

A slip that gives nearly the right number would be accepted, and a right answer could be taken for
the slip: neither is fair, so such a variant is not handed out.
"""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.policy.bands import bands
from gripcourse.policy.model import Policy
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.model import Candidate
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import choose, reference_rounding
from gripcourse.variants.answers import Group
from gripcourse.variants.feasible import Array, Mask


@dataclass(frozen=True, slots=True)
class NearSlip:
    """A slip in the variants of a group.

    Attributes:
        quantity: that it concerns.
        slip: its id, unique within the quantity.
        kind: of generic slip, or that of declared ones.
        is_size: whether the answer is a size taken from a series, where another method often leads
            to the same size; such a slip refuses nothing.
        near: the variants in which it comes too near to the right result, shape (k,).
    """

    quantity: str
    slip: str
    kind: str
    is_size: bool
    near: Mask


@dataclass(frozen=True, slots=True)
class SlipCount:
    """In how many of the variants that have a quantity a slip comes too near."""

    quantity: str
    slip: str
    kind: str
    is_size: bool
    near: int
    variants: int

    @property
    def share(self) -> float:
        """Share of the variants, 0 to 1."""
        return self.near / self.variants


def near_slips(
    group: Group, policy: Policy, kinds: Collection[str] | None = None
) -> Iterator[NearSlip]:
    """Compute every slip of a group at the right values of its inputs.

    Args:
        group: solved variants.
        policy: bands, generic slips, and how many bands away is far enough.
        kinds: the kinds of slips to look at; None for all.
    """
    for quantity in group.plan.answered:
        right = group.values[quantity.id]
        reach = policy.variants.slip_bands * bands(quantity, right, policy)
        for slip in _slips(group.plan, quantity, policy, kinds):
            wrong = _value(group, quantity, slip)
            with np.errstate(invalid="ignore"):  # a slip that gives no number misleads nobody
                near = np.abs(wrong - right) < reach
            yield NearSlip(quantity.id, str(slip.id), slip.kind, quantity.kind is Kind.CHOICE, near)


def too_near(group: Group, policy: Policy) -> dict[tuple[str, str], Mask]:
    """Return by quantity and slip which variants must be refused for it."""
    kinds = policy.variants.keep_apart
    return {
        (one.quantity, one.slip): one.near
        for one in near_slips(group, policy, kinds)
        if not one.is_size and one.near.any()
    }


def count_slips(groups: Sequence[Group], policy: Policy) -> tuple[SlipCount, ...]:
    """Count slips of all kinds over a table; those that never come near are counted too."""
    counts: dict[tuple[str, str], SlipCount] = {}
    for group in groups:
        for one in near_slips(group, policy):
            before = counts.get((one.quantity, one.slip))
            counts[one.quantity, one.slip] = SlipCount(
                one.quantity,
                one.slip,
                one.kind,
                one.is_size,
                int(one.near.sum()) + (before.near if before else 0),
                len(one.near) + (before.variants if before else 0),
            )
    return tuple(sorted(counts.values(), key=lambda one: (-one.share, one.quantity, one.slip)))


def _slips(
    plan: Plan, quantity: Quantity, policy: Policy, kinds: Collection[str] | None
) -> Iterator[Candidate]:
    slips = policy.slips
    if kinds is not None:
        wanted = {kind: one for kind, one in slips.kinds.items() if kind in kinds}
        slips = replace(slips, kinds=wanted)
    for one in candidates_of(plan, quantity.id, slips):
        if kinds is None or one.kind in kinds:
            yield one


def _value(group: Group, quantity: Quantity, slip: Candidate) -> Array:
    """Compute what a slip gives, SI, shape (k,)."""
    plan = group.plan
    value = evaluate_formula(slip.formula, quantity.unit, group.values, plan.columns)
    if quantity.choice is not None:
        value = choose(value, quantity.choice, reference_rounding(quantity, plan.convention), plan)
    return np.broadcast_to(value, group.rows.shape)
