"""Measuring the grader of a course with virtual students, as a program asks for it."""

from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.api.course import Course
from gripcourse.api.refusals import refusals_said
from gripcourse.api.sources import FileLike, path_of

if TYPE_CHECKING:
    from gripcourse.simulation.confusion import GraderEvaluation
    from gripcourse.simulation.tolerance import ToleranceAudit

# Every call imports what it needs itself, as in `api.course`.
# ruff: noqa: PLC0415


@refusals_said
def simulate(
    course: Course,
    out: str | Path,
    *,
    count: int,
    seed: int,
    scheme: str | None = None,
    workers: int = 1,
) -> int:
    """Write the workbooks of virtual students and what each did; return how many there are.

    Raises:
        GripcourseError: the folder is in use, or the cohort cannot be made.
    """
    from gripcourse.usecases.measuring import virtual

    cohort = virtual.Cohort(count, seed, scheme)
    return virtual.simulate(
        course.definition, course.policy, cohort, path_of(out), workers, _no_progress
    )


@refusals_said
def evaluate(course: Course, folder: str | Path, *, workers: int = 0) -> "GraderEvaluation":
    """Grade the workbooks that `simulate` wrote, and set what was said against what was done.

    Raises:
        GripcourseError: the folder holds no cohort of this course.
    """
    from gripcourse.usecases.measuring import virtual

    return virtual.evaluate_folder(
        course.definition, course.policy, path_of(folder), workers, _no_progress
    )


@refusals_said
def evaluate_in_memory(
    course: Course, *, count: int, seed: int, scheme: str | None = None, workers: int = 1
) -> "GraderEvaluation":
    """Do the same with a new cohort and without any file."""
    from gripcourse.usecases.measuring import virtual

    cohort = virtual.Cohort(count, seed, scheme)
    return virtual.evaluate_in_memory(
        course.definition, course.policy, cohort, None, workers, _no_progress
    )


@refusals_said
def audit_tolerances(
    course: Course,
    *,
    table: FileLike | None = None,
    count: int = 2000,
    seed: int = 1,
    workers: int = 1,
    apply: bool = False,
) -> "ToleranceAudit":
    """Derive tolerances from honest students; write them into the policy where that is asked.

    Args:
        course: whose policy it is. After a change it has to be loaded again.
        table: of issued variants; None for the course's main one.
        count: of variants drawn besides.
        seed: of these.
        workers: how many processes.
        apply: whether to write what is proposed.

    Raises:
        GripcourseError: the table or the spaces cannot be used.
    """
    from gripcourse.usecases.measuring import tolerance

    sample = tolerance.ToleranceSample(course.table_source(table), count, seed)
    variants = tolerance.variants_of(course.definition, sample)
    found = tolerance.audit(course.definition, course.policy, variants, workers, _no_progress)
    if apply:
        tolerance.apply(found, course.definition, course.policy)
    return found


def _no_progress() -> None:
    """Show none."""
