"""Judging a cohort of the second generator without files, as any other."""

import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import judge_read, methods_of
from gripcourse.batch.run import compared
from gripcourse.grading.unjudged import incident_report
from gripcourse.machine.jobs.pools import pool_for
from gripcourse.machine.jobs.workers import all_done, in_order, run_each
from gripcourse.simulation.foreign.cohort import draw_doings, work_of
from gripcourse.simulation.foreign.kinds import Doing
from gripcourse.simulation.foreign.model import JudgedForeign
from gripcourse.simulation.foreign.twins import same_by_value
from gripcourse.simulation.in_memory import SECONDS_PER_STUDENT, workbook_of


@dataclass(frozen=True, slots=True)
class _Room:
    context: GradingContext
    doings: Mapping[str, tuple[Doing, tuple[str, ...]]]
    seed: int


def judge_foreign(
    context: GradingContext, seed: int, workers: int, on_done: Callable[[], None] = lambda: None
) -> tuple[JudgedForeign, ...]:
    """Let a cohort work by the second generator, and judge it.

    Args:
        context: course, policy and what was issued.
        seed: the same seed gives the same works.
        workers: how many processes; with one everything happens in this one.
        on_done: called after each student.
    """
    doings = draw_doings(tuple(context.register.values()), seed)
    room = _Room(context, doings, seed)
    jobs = run_each(
        _judge_one,
        tuple(doings),
        room,
        workers=workers,
        seconds=SECONDS_PER_STUDENT,
        pool=pool_for(workers),
    )
    judged = in_order(all_done(jobs), lambda _: on_done())
    graded = compared([Graded(one.report, one.incident) for one in judged], context)
    return tuple(
        JudgedForeign(one.work, after.report, one.twins, after.incident)
        for one, after in zip(judged, graded, strict=True)
    )


def _judge_one(student: str, room: _Room) -> JudgedForeign:
    context = room.context
    work = work_of(student, room.doings, context, room.seed)
    issued = context.register[student]
    raw = workbook_of(student, context.register[work.owner], work.cells)
    try:
        report = judge_read(raw, issued, context)
    except Exception:  # noqa: BLE001 (ours, as in a real batch: counted, and the others go on)
        failed = incident_report(raw.file, "", issued)
        return JudgedForeign(work, failed, frozenset(), traceback.format_exc())
    plan, methods = methods_of(context, issued.variant)
    twins = same_by_value(plan, methods, issued.variant.given, work, report)
    return JudgedForeign(work, report, twins)
