"""Tolerances derived from honest students, and what they cost in wrong methods accepted.

For every quantity that is computed: which share of honest answers is refused now, and the narrowest
band that refuses none. Where no relative band is wide enough, because the value is a small
difference of large ones, an absolute one is proposed.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import TypeAlias

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Quantity, Tolerance
from gripcourse.machine.jobs.pools import pool_for
from gripcourse.machine.jobs.workers import all_done, in_order, run_each
from gripcourse.policy.bands import tolerance_of
from gripcourse.policy.model import Policy
from gripcourse.simulation.honest import hands_of, work_honestly
from gripcourse.simulation.model import Mix
from gripcourse.simulation.tally import AnswerTally, tally_of
from gripcourse.solver.plan import plan_of
from gripcourse.variants.model import Variant

_AT_A_TIME = 256  # variants of one composition
# So many variants take some seconds; this is for a mistake of ours.
_SECONDS_PER_GROUP = 600.0
_STEPS = (1.0, 2.0, 5.0, 10.0)  # of round absolute tolerances

Done: TypeAlias = Callable[[], None]
"""Called once for each variant that was done."""


@dataclass(frozen=True, slots=True)
class AuditedBand:
    """The audit of one quantity.

    Attributes:
        quantity: its declaration, in one of the schemes that have it.
        tally: what was counted.
        now: the tolerance that applies now.
        proposed: the narrowest that refuses no honest answer; the present one where there were too
            few answers to narrow it, or where it is an absolute one that refuses none.
        by_absolute: whether it is the absolute part that does it.
        price: share of the wrong methods that the proposed one accepts; NaN of no wrong method.
        ill_conditioned: whether rounded inputs spread the value over more than the mix calls wide.
    """

    quantity: Quantity
    tally: AnswerTally
    now: Tolerance
    proposed: Tolerance
    by_absolute: bool
    price: float
    ill_conditioned: bool

    @property
    def changes(self) -> bool:
        """Whether the policy would have to be changed."""
        return self.proposed != self.now


@dataclass(frozen=True, slots=True)
class ToleranceAudit:
    """The audit of a course: how many variants and ways of working, and each quantity."""

    variants: int
    ways: int
    quantities: tuple[AuditedBand, ...]

    @property
    def refuses(self) -> bool:
        """Whether the policy refuses honest answers now."""
        return any(one.tally.refused for one in self.quantities)


@dataclass(frozen=True, slots=True)
class _Desk:
    """What every job needs; `only` names the quantities that are looked at, empty for all."""

    course: Course
    policy: Policy
    mix: Mix
    only: frozenset[str]


@dataclass(frozen=True, slots=True)
class _Group:
    """Variants of one composition."""

    composition: Composition
    variants: Sequence[Variant]


def audit_tolerances(
    course: Course,
    policy: Policy,
    mix: Mix,
    variants: Sequence[Variant],
    workers: int,
    on_done: Done = lambda: None,
) -> ToleranceAudit:
    """Let honest students answer variants and try every wrong method.

    Args:
        course: whose quantities are audited.
        policy: how far numbers may be from the typed ones, floors, and the bands that apply now.
        mix: ways of working, and the bands that may be proposed.
        variants: that are answered.
        workers: how many processes; with one everything happens in this one.
        on_done: called as the work goes on.
    """
    context = _Desk(course, policy, mix, frozenset())
    first = {
        quantity.id: _audited(quantity, tally, policy, mix)
        for quantity, tally in _counted(context, variants, workers, on_done)
    }
    # What an absolute tolerance lets through is known only once it is proposed.
    absolute = {name: one.proposed for name, one in first.items() if one.by_absolute}
    tried = replace(policy, tolerances={**policy.tolerances, **absolute})
    second = replace(context, policy=tried, only=frozenset(absolute))
    prices = {
        quantity.id: tally.accepted / tally.slips if tally.slips else math.nan
        for quantity, tally in (_counted(second, variants, workers) if absolute else ())
    }
    audited = (replace(one, price=prices.get(name, one.price)) for name, one in first.items())
    return ToleranceAudit(len(variants), hands_of(mix).figures.size, tuple(audited))


def _counted(
    context: _Desk, variants: Sequence[Variant], workers: int, on_done: Done = lambda: None
) -> Iterator[tuple[Quantity, AnswerTally]]:
    """Yield what was counted of each quantity over all compositions."""
    tallies: dict[str, tuple[Quantity, AnswerTally]] = {}
    groups = list(_groups(variants))

    def tick(number: int) -> None:
        for _ in groups[number].variants:
            on_done()

    jobs = run_each(
        _count,
        groups,
        context,
        workers=workers,
        seconds=_SECONDS_PER_GROUP,
        pool=pool_for(workers),
    )
    for quantity, tally in chain.from_iterable(in_order(all_done(jobs), tick)):
        before = tallies.get(quantity.id)
        tallies[quantity.id] = (quantity, tally if before is None else before[1] + tally)
    yield from tallies.values()


def _count(group: _Group, context: _Desk) -> list[tuple[Quantity, AnswerTally]]:
    plan = plan_of(context.course, group.composition)
    asked = [
        one
        for one in plan.answered
        if one.kind is Kind.FORMULA and (not context.only or one.id in context.only)
    ]
    if not asked:
        return []
    given = [one.given for one in group.variants]
    honest = work_honestly(plan, given, hands_of(context.mix), context.policy)
    return [(one, tally_of(honest, one, context.policy, context.mix.bands)) for one in asked]


def _groups(variants: Sequence[Variant]) -> Iterator[_Group]:
    """Yield variants of one composition together, not too many at a time."""
    groups: dict[Composition, list[Variant]] = {}
    for one in variants:
        groups.setdefault(one.composition, []).append(one)
    for composition, group in groups.items():
        for start in range(0, len(group), _AT_A_TIME):
            yield _Group(composition, group[start : start + _AT_A_TIME])


def _audited(quantity: Quantity, tally: AnswerTally, policy: Policy, mix: Mix) -> AuditedBand:
    now = tolerance_of(quantity, policy)
    declared = quantity.tolerance.relative if quantity.tolerance is not None else 0.0
    sound = [place for place, refused in enumerate(tally.refused_by_band) if not refused]
    own = policy.tolerances.get(quantity.id) or quantity.tolerance
    # An absolute part of its own says that no relative one fits: there is nothing to narrow.
    is_absolute = own is not None and own.absolute > 0
    kept = not tally.refused and (is_absolute or tally.answers < mix.answers)
    if kept or (sound and max(mix.bands[sound[0]], declared) == now.relative):
        proposed, accepted = now, tally.accepted
    elif sound:
        # What a declaration allows has a reason that no calculation knows: a chart that is read.
        proposed = replace(now, relative=max(mix.bands[sound[0]], declared))
        accepted = tally.accepted_by_band[sound[0]]
    else:
        proposed = replace(now, absolute=round_up(tally.short_by))
        accepted = tally.accepted
    return AuditedBand(
        quantity=quantity,
        tally=tally,
        now=now,
        proposed=proposed,
        by_absolute=proposed.absolute != now.absolute,
        price=float(accepted / tally.slips) if tally.slips else math.nan,
        ill_conditioned=tally.widest > mix.wide,
    )


def round_up(value: float) -> float:
    """Return the next round number that is not below a positive one: 1, 2 or 5 of its power."""
    power = math.floor(math.log10(value))
    return next(
        float(f"{step:g}e{power}") for step in _STEPS if step * 10.0**power >= value * (1 - 1e-12)
    )


def to_write(one: AuditedBand, policy: Policy) -> Tolerance:
    """Return what a policy says for a proposal.

    The floor of the unit stays where it is written: only an absolute part of its own counts.
    """
    own = policy.tolerances.get(one.quantity.id) or one.quantity.tolerance
    kept = own.absolute if own is not None else 0.0
    return Tolerance(one.proposed.relative, one.proposed.absolute if one.by_absolute else kept)
