"""Judging a virtual cohort without files: from the cells on, everything is the real thing."""

import hashlib
import traceback
from collections.abc import Callable, Mapping

from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import judge_read
from gripcourse.batch.run import compared
from gripcourse.grading.unjudged import incident_report
from gripcourse.machine.jobs.pools import pool_for
from gripcourse.machine.jobs.workers import all_done, in_order, run_each
from gripcourse.simulation.confusion import JudgedWork
from gripcourse.simulation.model import SimulatedWork
from gripcourse.simulation.student import Classroom, work_of
from gripcourse.submission.model import Identity
from gripcourse.submission.raw import RawCell, RawWorkbook
from gripcourse.variants.model import Issued
from gripcourse.workbook.names import AUTHOR

# A student takes some hundredths of a second; this is for a mistake of ours.
SECONDS_PER_STUDENT = 120.0


def judge_in_memory(
    room: Classroom, workers: int, on_done: Callable[[], None] = lambda: None
) -> tuple[JudgedWork, ...]:
    """Let a cohort work and judge it, without writing or reading a file.

    Args:
        room: the cohort.
        workers: how many processes; with one everything happens in this one.
        on_done: called after each student.
    """
    jobs = run_each(
        judge_one,
        tuple(room.behaviours),
        room,
        workers=workers,
        seconds=SECONDS_PER_STUDENT,
        pool=pool_for(workers),
    )
    judged = in_order(all_done(jobs), lambda _: on_done())
    graded = compared([Graded(one.report, one.incident) for one in judged], room.context)
    return tuple(
        JudgedWork(one.work, after.report, after.incident)
        for one, after in zip(judged, graded, strict=True)
    )


def judge_one(student: str, room: Classroom) -> JudgedWork:
    """Let one student work and judge the work."""
    issued = room.context.register[student]
    work = work_of(student, room)
    raw = read_of(work, room.context.register[work.owner])
    try:
        return JudgedWork(work, judge_read(raw, issued, room.context))
    except Exception:  # noqa: BLE001 (ours, as in a real batch: counted, and the others go on)
        return JudgedWork(work, incident_report(raw.file, "", issued), traceback.format_exc())


def read_of(work: SimulatedWork, owner: Issued) -> RawWorkbook:
    """Return what would be read of the workbook that a student hands in.

    Args:
        work: what was done.
        owner: whose workbook it is.
    """
    typed = {one.quantity: one.typed for one in work.actions}
    return workbook_of(work.student, owner, typed)


def workbook_of(
    student: str, owner: Issued, typed: Mapping[str, float | str | None]
) -> RawWorkbook:
    """Return what would be read of a workbook.

    Args:
        student: who hands it in.
        owner: whose workbook it is.
        typed: what stands in the cells of answers.
    """
    return RawWorkbook(
        file=f"{student}.xlsx",
        # Equal bytes come from equal workbooks, and only a copied one is handed in twice.
        digest=hashlib.sha256(owner.student.id.encode()).hexdigest(),
        identity=Identity(
            student=owner.student.id,
            variant=owner.variant.id,
            scheme=owner.variant.scheme,
            options=owner.variant.options,
            signature=owner.signature,
        ),
        creator=AUTHOR,
        givens={name: _cell(name, value) for name, value in owner.variant.given.items()},
        answers={name: _cell(name, value) for name, value in typed.items()},
        remarks=(),
    )


def _cell(name: str, value: float | str | None) -> RawCell:
    return RawCell(value=value, number_format="General", error=False, formula="", cell=name)
