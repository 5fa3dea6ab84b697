"""A measurement in memory, cut into parts that can be done beside each other.

A part is a whole cohort of one generator: its variants are drawn, its works judged and compared
with each other where it is measured. So nothing but the measurement travels, and a worker that has
made the wrong methods of a formula has them for all parts that it does.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from gripcourse.course.model import Course
from gripcourse.machine.jobs.pools import pool_for
from gripcourse.machine.jobs.workers import all_done, in_order, run_each
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.confusion import GraderEvaluation, evaluate
from gripcourse.simulation.foreign.judge import judge_foreign
from gripcourse.simulation.foreign.measures import ForeignEvaluation, evaluate_foreign
from gripcourse.simulation.in_memory import SECONDS_PER_STUDENT, judge_in_memory
from gripcourse.simulation.misses import misses_csv
from gripcourse.simulation.model import Mix
from gripcourse.simulation.strategies import StrategyScore, scores_of


class Doers(StrEnum):
    """Who works in a part."""

    OWN = "own"  # students who make the grader's own kinds of mistakes
    FOREIGN = "foreign"  # those of the second generator
    NOBODY = "nobody"  # people who compute nothing


@dataclass(frozen=True, slots=True)
class CohortPart:
    """A cohort and who works in it; cohorts of one size and seed are issued the same variants."""

    doers: Doers
    size: int
    seed: int


@dataclass(frozen=True, slots=True)
class MeasuredPart:
    """What came out of a part.

    Attributes:
        own, foreign, scores: what its doers were measured by; nothing of others.
        table: the misses of the first generator as CSV.
    """

    own: GraderEvaluation | None = None
    foreign: ForeignEvaluation | None = None
    scores: tuple[StrategyScore, ...] = ()
    table: str = ""


@dataclass(frozen=True, slots=True)
class Bench:
    """What every part is measured with.

    Attributes:
        course: whose schemes are drawn.
        policy: that is measured.
        mix: how students work, and what the grader is held to.
        scheme: only this one; None for all.
    """

    course: Course
    policy: Policy
    mix: Mix
    scheme: str | None


@dataclass(frozen=True, slots=True)
class _SharedBench:
    """What every part needs; `on_done` is of use only where all is done in this process."""

    bench: Bench
    on_done: Callable[[], None]


def measure_parts(
    parts: Sequence[CohortPart], bench: Bench, workers: int, on_done: Callable[[], None]
) -> tuple[MeasuredPart, ...]:
    """Let cohorts work and measure the grader by each.

    Args:
        parts: cohorts.
        bench: what they are measured with.
        workers: how many processes.
        on_done: called after each student of the two generators.

    Returns:
        What came out, in the order of the parts, however many processes there were.
    """
    pool = pool_for(workers)
    is_here = pool is None or workers == 0
    shared = _SharedBench(bench, on_done if is_here else _nothing)
    seconds = SECONDS_PER_STUDENT * max((part.size for part in parts), default=1)
    jobs = run_each(_measured, parts, shared, workers=workers, seconds=seconds, pool=pool)

    def tell(place: int) -> None:
        for _ in range(0 if is_here or parts[place].doers is Doers.NOBODY else parts[place].size):
            on_done()

    return in_order(all_done(jobs), tell)


def _measured(part: CohortPart, shared: _SharedBench) -> MeasuredPart:
    bench, mix = shared.bench, shared.bench.mix
    room = make_classroom(bench.course, bench.policy, mix, part.size, part.seed, bench.scheme)
    match part.doers:
        case Doers.OWN:
            judged = judge_in_memory(room, 0, shared.on_done)
            own = evaluate(judged, mix)
            schemes = {name: one.variant.scheme for name, one in room.context.register.items()}
            return MeasuredPart(own=own, table=misses_csv(own.misses, schemes))
        case Doers.FOREIGN:
            works = judge_foreign(room.context, part.seed, 0, shared.on_done)
            return MeasuredPart(foreign=evaluate_foreign(works, mix))
        case Doers.NOBODY:
            return MeasuredPart(scores=scores_of(room.context, 0, part.seed))


def together(measured: Sequence[MeasuredPart]) -> GraderEvaluation | None:
    """Count parts together; None where no part was of the first generator."""
    total: GraderEvaluation | None = None
    for one in _of_own(measured):
        total = one if total is None else total + one
    if total is None:
        return None
    foreign: ForeignEvaluation | None = None
    for other in (one.foreign for one in measured if one.foreign is not None):
        foreign = other if foreign is None else foreign + other
    scores = tuple(score for one in measured for score in one.scores)
    return replace(total, foreign=foreign, strategies=scores)


def _of_own(measured: Sequence[MeasuredPart]) -> Iterator[GraderEvaluation]:
    return (one.own for one in measured if one.own is not None)


def _nothing() -> None:
    """Say nothing: a worker cannot reach who waits."""
