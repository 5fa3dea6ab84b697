"""Works of people who compute nothing, and what they earn: no strategy may pay."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from gripcourse.batch.context import GradingContext
from gripcourse.batch.one_file import judge_read
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.machine.jobs.pools import pool_for
from gripcourse.machine.jobs.workers import all_done, in_order, run_each
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Identity
from gripcourse.submission.raw import RawCell, RawWorkbook
from gripcourse.text.units import factor
from gripcourse.variants.model import Issued

# A work takes some hundredths of a second; this is for a mistake of ours.
SECONDS_PER_WORK = 120.0

_BLUR = 0.3  # standard deviation of the logarithm: right within a third
_WORKS = 34  # of each strategy, evenly taken from a larger cohort


class Strategy(StrEnum):
    """What is typed instead of what was computed; the answer to every question is yes."""

    LEAST = "least"  # the lower bound of each cell, the smallest of each series
    ZERO = "zero"
    HUNDREDTH = "hundredth"
    ONE = "one"
    SMALLEST = "smallest"  # the smallest of each series, nothing else
    ANOTHER = "another"  # what is right for another variant of the scheme
    BLURRED = "blurred"  # what is right, and a third off: by eye, or from a drawing


_CONSTANTS = {Strategy.ZERO: 0.0, Strategy.HUNDREDTH: 0.01, Strategy.ONE: 1.0}


@dataclass(frozen=True, slots=True)
class StrategyScore:
    """What a strategy earns: shares of the points that no person gives, mean and most."""

    strategy: Strategy
    works: int
    mean: float
    most: float


@dataclass(frozen=True, slots=True)
class _StrategyJob:
    strategy: Strategy
    student: str
    other: str
    seed: int


def scores_of(
    context: GradingContext, workers: int, seed: int, on_done: Callable[[], None] = lambda: None
) -> tuple[StrategyScore, ...]:
    """Let every strategy work with some of the issued variants, and judge what it hands in.

    Args:
        context: course, policy and what was issued.
        workers: how many processes.
        seed: of what is random.
        on_done: called after each work.
    """
    jobs = list(_jobs(context.register, seed))
    done = run_each(
        _share_of, jobs, context, workers=workers, seconds=SECONDS_PER_WORK,
        pool=pool_for(workers),
    )  # fmt: skip
    shares = in_order(all_done(done), lambda _: on_done())
    found = []
    for strategy in Strategy:
        own = [share for job, share in zip(jobs, shares, strict=True) if job.strategy is strategy]
        if own:
            found.append(StrategyScore(strategy, len(own), float(np.mean(own)), max(own)))
    return tuple(found)


def typed_by(
    strategy: Strategy,
    plan: Plan,
    right: Mapping[str, float],
    other: Mapping[str, float],
    rng: np.random.Generator,
) -> dict[str, float | str]:
    """Return what a strategy types, by quantity.

    Args:
        strategy: which.
        plan: of the variant.
        right: the right answers, in declared units.
        other: those of another variant; it may lack some.
        rng: for what is random.
    """
    typed = {
        one.id: _typed(strategy, plan, one, right, other, rng)
        for one in plan.answered
        if one.kind is not Kind.VERDICT
    }
    said = {one.id: "yes" for one in plan.answered if one.kind is Kind.VERDICT}
    return {name: value for name, value in typed.items() if value is not None} | said


def _typed(
    strategy: Strategy,
    plan: Plan,
    quantity: Quantity,
    right: Mapping[str, float],
    other: Mapping[str, float],
    rng: np.random.Generator,
) -> float | None:
    smallest = _smallest(plan, quantity)
    if strategy is Strategy.BLURRED:
        off = float(np.exp(rng.normal(0.0, _BLUR)))
        return right[quantity.id] * (1.0 if quantity.exact else off)
    if strategy is Strategy.ANOTHER:
        return other.get(quantity.id)
    if strategy is Strategy.LEAST:
        return quantity.bounds[0] if smallest is None else smallest
    return smallest if strategy is Strategy.SMALLEST else _CONSTANTS[strategy]


def _smallest(plan: Plan, quantity: Quantity) -> float | None:
    """Return the smallest entry of a decision's series, in the declared unit."""
    if quantity.choice is None:
        return None
    return float(plan.columns[quantity.choice.column].sizes.min()) / factor(quantity.unit)


def _jobs(register: Mapping[str, Issued], seed: int) -> Iterator[_StrategyJob]:
    for strategy in Strategy:
        for number, (student, mate) in enumerate(_pairs(register)):
            yield _StrategyJob(strategy, student, mate, seed + number)


def _pairs(register: Mapping[str, Issued]) -> Iterator[tuple[str, str]]:
    """Yield some students, each with another one of the same scheme."""
    schemes: dict[str, list[str]] = {}
    for student, issued in register.items():
        schemes.setdefault(issued.variant.scheme, []).append(student)
    pairs = [
        (student, mates[(place + 1) % len(mates)])
        for mates in schemes.values()
        for place, student in enumerate(mates)
        if len(mates) > 1
    ]
    yield from pairs[:: max(1, math.ceil(len(pairs) / _WORKS))]


def _share_of(job: _StrategyJob, context: GradingContext) -> float:
    """Return the share of the points that no person gives."""
    issued, other = context.register[job.student], context.register[job.other]
    plan = plan_of(context.course, issued.variant.composition)
    rng = np.random.default_rng(job.seed)
    right = solve_variant(plan, issued.variant.given)
    mate = plan_of(context.course, other.variant.composition)
    typed = typed_by(job.strategy, plan, right, solve_variant(mate, other.variant.given), rng)
    report = judge_read(_handed_in(issued, typed), issued, context)
    own = [one for one in report.findings if plan.quantities[one.quantity].kind.answered]
    return sum(one.points for one in own) / max(sum(one.max_points for one in own), 1e-9)


def _handed_in(issued: Issued, typed: Mapping[str, float | str]) -> RawWorkbook:
    variant, student = issued.variant, issued.student.id
    return RawWorkbook(
        file=f"{student}.xlsx",
        digest="",
        identity=Identity(student, variant.id, variant.scheme, variant.options, issued.signature),
        creator="",
        givens=_cells(variant.given),
        answers=_cells(typed),
        remarks=(),
    )


def _cells(values: Mapping[str, float | str]) -> dict[str, RawCell]:
    return {
        name: RawCell(value=value, number_format="General", error=False, formula="", cell=name)
        for name, value in values.items()
    }


def missed(scores: Sequence[StrategyScore], at_most: float) -> tuple[StrategyScore, ...]:
    """Return the strategies that earn more on average than they may."""
    return tuple(one for one in scores if one.mean > at_most)
