"""A virtual cohort as a folder: real workbooks to hand in, a register, and the truth beside them.

The grader is given the register and the workbooks, as of any real cohort; the truth is read after
it is done.
"""

import shutil
from collections.abc import Callable
from pathlib import Path

from gripcourse.batch.context import GradingContext
from gripcourse.batch.run import grade_files
from gripcourse.course.model import Course
from gripcourse.issuing.register import Register
from gripcourse.issuing.register_file import read_register_file, write_register_file
from gripcourse.machine.jobs.pools import pool_for
from gripcourse.machine.jobs.workers import all_done, in_order, run_each
from gripcourse.policy.model import Policy
from gripcourse.simulation.confusion import JudgedWork
from gripcourse.simulation.model import Conduct, SimulatedWork
from gripcourse.simulation.record import read_truth, write_truth
from gripcourse.simulation.student import Classroom, work_of
from gripcourse.simulation.write import write_work

# A workbook takes a tenth of a second to fill in; this is for a mistake of ours.
_SECONDS_PER_STUDENT = 120.0


def truth_path(out: Path) -> Path:
    """Return where it stands what the students did."""
    return out / "truth.jsonl"


def register_of(out: Path) -> Path:
    """Return where it stands what was issued."""
    return out / "register.json"


def submission_path(out: Path, student: str) -> Path:
    """Return the workbook that a student hands in."""
    return out / "submissions" / f"{student}.xlsx"


def write_cohort(
    room: Classroom, out: Path, workers: int, on_done: Callable[[], None] = lambda: None
) -> tuple[SimulatedWork, ...]:
    """Let a cohort work and write what it hands in.

    Args:
        room: the cohort.
        out: folder to write to.
        workers: how many processes; with one everything happens in this one.
        on_done: called after each student.

    Raises:
        OSError: the folder cannot be written.
    """
    register = Register(room.context.course.id, tuple(room.context.register.values()))
    write_register_file(register_of(out), register)
    jobs = run_each(
        _write_one,
        tuple(room.behaviours),
        (room, out),
        workers=workers,
        seconds=_SECONDS_PER_STUDENT,
        pool=pool_for(workers),
    )
    works = in_order(all_done(jobs), lambda _: on_done())
    for work in works:
        if work.owner != work.student:
            target = submission_path(out, work.student)
            shutil.copyfile(submission_path(out, work.owner), target)
    write_truth(truth_path(out), works)
    return works


def grade_cohort(
    out: Path, course: Course, policy: Policy, workers: int, on_done: Callable[[], None]
) -> tuple[JudgedWork, ...]:
    """Grade a cohort's workbooks as any others, and put what was done beside what was said.

    Args:
        out: folder that `write_cohort` wrote.
        course: that the cohort was issued.
        policy: that is measured.
        workers: how many processes.
        on_done: called after each workbook.

    Raises:
        GripcourseError: the folder holds no cohort of this course.
    """
    register = read_register_file(register_of(out), course.id).by_student()
    works = read_truth(truth_path(out))
    files = [submission_path(out, work.student) for work in works]
    graded = grade_files(
        files, GradingContext(course, policy, register), workers, lambda _: on_done()
    )
    return tuple(
        JudgedWork(work, one.report, one.incident) for work, one in zip(works, graded, strict=True)
    )


def _write_one(student: str, place: tuple[Classroom, Path]) -> SimulatedWork:
    """Write a student's workbook; one that is only copied is copied when all are there."""
    room, out = place
    work = work_of(student, room)
    if work.behaviour.conduct is not Conduct.COPIED_WORKBOOK:
        write_work(work, room, submission_path(out, student))
    return work
