"""How far the results of wrong methods lie from the right one, variant by variant.

A slip that gives nearly the right number would be accepted, and a right answer could be taken for
the slip: neither is fair, so such a variant is not handed out.
"""

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.policy.bands import bands
from gripcourse.policy.model import Policy
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.model import Candidate, SlipId
from gripcourse.solver.family import Family, Member, Rows
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.sizes import choose
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
        seldom: whether it is declared as one that seldom tells; it refuses nothing either.
        near: places of the variants of the group in which it comes too near to the right result.
        variants: how many of the group have it.
    """

    quantity: str
    slip: str
    kind: str
    is_size: bool
    seldom: bool
    near: Rows
    variants: int


@dataclass(frozen=True, slots=True)
class SlipCount:
    """In how many of the variants that have a quantity a slip comes too near.

    Of a size from a series, and where a course declares that it seldom tells, it is only counted.
    """

    quantity: str
    slip: str
    kind: str
    only_counted: bool
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
    for member in group.family.answered:
        quantity = member.quantity
        right = member.of(group.values[quantity.id])
        reach = policy.variants.slip_bands * bands(quantity, right, policy)
        places = np.arange(group.family.size)[member.at]
        seldom = {SlipId.declared(one.id) for one in quantity.slips if one.seldom}
        for where, plan, slips in _slips(group.family, member, policy, kinds):
            at = places[where]
            for slip in slips:
                wrong = _value(plan, quantity, slip, group, at)
                with np.errstate(invalid="ignore"):  # a slip that gives no number misleads nobody
                    near = np.abs(wrong - right[where]) < reach[where]
                is_size = quantity.kind is Kind.CHOICE
                yield NearSlip(
                    quantity.id,
                    str(slip.id),
                    slip.kind,
                    is_size,
                    seldom=slip.id in seldom,
                    near=at[near],
                    variants=len(at),
                )


def too_near(group: Group, policy: Policy) -> dict[tuple[str, str], Mask]:
    """Return by quantity and slip which variants must be refused for it."""
    found: dict[tuple[str, str], Mask] = {}
    for one in near_slips(group, policy, policy.variants.keep_apart):
        if not (one.is_size or one.seldom) and len(one.near):
            near = found.setdefault(
                (one.quantity, one.slip), np.zeros(group.family.size, dtype=np.bool_)
            )
            near[one.near] = True
    return found


def count_slips(groups: Sequence[Group], policy: Policy) -> tuple[SlipCount, ...]:
    """Count slips of all kinds over a table; those that never come near are counted too."""
    return summed_slips(
        SlipCount(
            *(one.quantity, one.slip, one.kind, one.is_size or one.seldom),
            *(len(one.near), one.variants),
        )
        for group in groups
        for one in near_slips(group, policy)
    )


def summed_slips(counts: Iterable[SlipCount]) -> tuple[SlipCount, ...]:
    """Add up counts of the same slip, the most frequent first."""
    found: dict[tuple[str, str], SlipCount] = {}
    for one in counts:
        before = found.get((one.quantity, one.slip))
        found[one.quantity, one.slip] = replace(
            one,
            near=one.near + (before.near if before else 0),
            variants=one.variants + (before.variants if before else 0),
        )
    return tuple(sorted(found.values(), key=lambda one: (-one.share, one.quantity, one.slip)))


def _slips(
    family: Family, member: Member, policy: Policy, kinds: Collection[str] | None
) -> Iterator[tuple[Rows, Plan, tuple[Candidate, ...]]]:
    """Yield slips of a quantity, and for which of the variants that have it they are.

    Declared ones are the same in every composition. What the generic kinds make of a formula
    depends on what else a composition has; compositions that are alike in this share it.
    """
    numbers = member.of(family.numbers)
    slips = policy.slips
    if kinds is not None:
        wanted = {kind: one for kind, one in slips.kinds.items() if kind in kinds}
        slips = replace(slips, kinds=wanted)
    if not slips.kinds:
        made = candidates_of(member.plan, member.quantity.id, slips)
        yield np.arange(len(numbers)), member.plan, _of_kinds(made, kinds)
        return
    alike: dict[int, tuple[Plan, tuple[Candidate, ...], list[int]]] = {}
    for number in np.unique(numbers):
        plan = plan_of(family.course, family.compositions[number])
        made = candidates_of(plan, member.quantity.id, slips)
        alike.setdefault(id(made), (plan, made, []))[2].append(int(number))
    for plan, made, found in alike.values():
        yield np.flatnonzero(np.isin(numbers, found)), plan, _of_kinds(made, kinds)


def _of_kinds(made: tuple[Candidate, ...], kinds: Collection[str] | None) -> tuple[Candidate, ...]:
    return tuple(one for one in made if kinds is None or one.kind in kinds)


def _value(plan: Plan, quantity: Quantity, slip: Candidate, group: Group, at: Rows) -> Array:
    """Compute what a slip gives, SI, at some places of a group."""
    outside = plan.step_ups[quantity.id].outside if quantity.steps_up else ()
    values = {name: group.values[name][at] for name in (*slip.formula.names, *outside)}
    value = evaluate_formula(slip.formula, quantity.unit, values, plan.columns)
    return np.broadcast_to(choose(plan, quantity, value, values), at.shape)
