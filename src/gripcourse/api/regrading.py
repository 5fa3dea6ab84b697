"""Regrades, publications and histories, as a program asks for them."""

from collections.abc import Iterable
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.api.course import Course
from gripcourse.api.sources import FileLike, workbooks

if TYPE_CHECKING:
    from gripcourse.gradebook.journal import Published, Regrade
    from gripcourse.gradebook.model import Attempt
    from gripcourse.gradebook.timing import Waiver
    from gripcourse.usecases.history import Event
    from gripcourse.usecases.regrade import Regrading

# Every call imports what it needs itself, as in `api.course`.
# ruff: noqa: PLC0415


def regrade(
    course: Course, files: Iterable[FileLike], gradebook: str | Path, *, workers: int = 0
) -> "Regrading":
    """Grade works again by today's course and policy, and write nothing.

    Args:
        course: by which.
        files: paths of files and folders, or bytes with their names.
        gradebook: path or database URL.
        workers: how many processes; 0 for none but this one.

    Raises:
        GripcourseError: the gradebook or the register cannot be used.
    """
    from gripcourse.usecases.opening import grading_of
    from gripcourse.usecases.regrade import regrade as ask

    sources, _ = workbooks(files)
    context = grading_of(course.definition, course.policy)
    return ask(sources, context, str(gradebook), workers, datetime.now(UTC))


def apply_regrade(
    regrading: "Regrading",
    gradebook: str | Path,
    *,
    by: str,
    why: str,
    allow_lower: bool = False,
) -> "tuple[Attempt, ...]":
    """Let what a regrade came to stand from now on.

    Args:
        regrading: as it was shown.
        gradebook: path or database URL.
        by: who applies it.
        why: the reason, kept for good.
        allow_lower: whether results that students were told may get worse.

    Raises:
        GripcourseError: no reason is given, or a published result would get worse; nothing was
            changed.
    """
    from gripcourse.gradebook.journal import Signed
    from gripcourse.usecases.regrade import apply_regrade as enter

    signed = Signed(by, datetime.now(UTC), why)
    return enter(regrading, str(gradebook), signed, allow_lower=allow_lower)


def undo_regrade(gradebook: str | Path, *, by: str, why: str) -> "Regrade":
    """Take the last regrade back, by a new entry.

    Raises:
        GripcourseError: no reason is given, or there is nothing to take back.
    """
    from gripcourse.gradebook.journal import Signed
    from gripcourse.usecases.regrade import undo_regrade as undo

    return undo(str(gradebook), Signed(by, datetime.now(UTC), why))


def publish(
    gradebook: str | Path, *, by: str, students: Iterable[str] = ()
) -> "tuple[Published, ...]":
    """Keep that students are told their results: from now on only a regrade changes them.

    Raises:
        GripcourseError: of a student nothing has been graded.
    """
    from gripcourse.gradebook.journal import Signed
    from gripcourse.usecases.regrade import publish as tell

    return tell(str(gradebook), students, Signed(by, datetime.now(UTC)))


def waive(
    course: Course,
    gradebook: str | Path,
    student: str,
    *,
    by: str,
    why: str,
    until: datetime | None = None,
) -> "Waiver":
    """Let a student's lateness cost nothing, at all or until a moment; the next grading shows it.

    Raises:
        GripcourseError: nobody knows the student, or no reason is given.
    """
    from gripcourse.gradebook.timing import Waiver
    from gripcourse.usecases.opening import grading_of
    from gripcourse.usecases.waive import waive as enter

    register = grading_of(course.definition, course.policy).register
    waiver = Waiver(
        student, 0, until, withdrawn=False, person=by, done_at=datetime.now(UTC), why=why
    )
    return enter(waiver, str(gradebook), register)


def history(gradebook: str | Path, student: str) -> "tuple[Event, ...]":
    """Return everything that happened to a student's grade, oldest first.

    Raises:
        GripcourseError: the gradebook does not know the student.
    """
    from gripcourse.usecases.history import history as ask

    return ask(str(gradebook), student)
