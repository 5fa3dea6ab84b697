"""Regrades, publications and histories, as a program asks for them."""

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.api.choices import a_text, nothing, whole_number
from gripcourse.api.course import Course
from gripcourse.api.refusals import refusals_said
from gripcourse.api.sources import FileLike, place_of, workbooks
from gripcourse.api.withdrawing import joins_said_by

if TYPE_CHECKING:
    from gripcourse.batch.context import GradingContext
    from gripcourse.batch.kept_reports import KeptReports
    from gripcourse.gradebook.journal import Published, Regrade
    from gripcourse.gradebook.model import Attempt
    from gripcourse.gradebook.timing import Waiver
    from gripcourse.usecases.marks.history import Event
    from gripcourse.usecases.marks.regrade import Regrading

# Every call imports what it needs itself, as in `api.course`.
# ruff: noqa: PLC0415


@refusals_said
def regrade(  # noqa: PLR0913 (the last ones are what everybody leaves as they are)
    course: Course,
    files: FileLike | Iterable[FileLike],
    gradebook: str | Path,
    *,
    whose: Mapping[str, str] | None = None,
    pattern: str | None = None,
    either_version: bool | None = None,
    workers: int = 0,
    on_done: Callable[[object], None] = nothing,
) -> "Regrading":
    """Grade works again by today's course and policy, and change no grade.

    Marks of persons count on both sides. What an earlier regrade by the very same course found out
    of a file is taken over, where the course's folder is still as it was loaded.

    Args:
        course: by which.
        files: paths of files and folders, or bytes with their names.
        gradebook: path or database URL.
        whose: ids of students by file, where a person says who handed it in.
        pattern: where your own paths say whose a file is; as for `Course.grade`.
        either_version: of what was issued anew, whether the version counts that gives more; None
            as the gradebook says, else the workbook's own version.
        workers: how many processes; 0 for none but this one.
        on_done: called with each file when it is graded.

    Raises:
        GripcourseError: the gradebook or the register cannot be used.
    """
    from gripcourse.usecases.marks.batch_wish import BatchWish
    from gripcourse.usecases.marks.opening import grading_of
    from gripcourse.usecases.marks.regrade import as_decided
    from gripcourse.usecases.marks.regrade import regrade as ask

    workers = whole_number("workers", workers, 0)
    sources, _ = workbooks(files)
    context = grading_of(course.definition, course.policy)
    pairs = tuple(f"{file}={student}" for file, student in (whose or {}).items())
    place = place_of(gradebook)
    said = None if pattern is None else a_text("pattern", pattern)
    wish = BatchWish(pairs, pattern=said, either_version=either_version)
    context = as_decided(context, sources, place, wish)
    kept = _earlier(course, context, workers)
    return ask(sources, context, place, workers, datetime.now(UTC), on_done, kept=kept)


def _earlier(course: Course, context: "GradingContext", workers: int) -> "KeptReports | None":
    """Return what earlier regrades found out; None where the course's folder has changed."""
    from gripcourse.usecases.grading.unchanged import open_earlier
    from gripcourse.usecases.grading.versions import versions_of

    # Whoever may not write there looks, too, but pays for every look.
    with suppress(OSError):
        versions = versions_of(course.root)
        today = Course.load(course.root)
        if (today.definition, today.policy) == (course.definition, course.policy):
            earlier = open_earlier(course.root / "private", context, versions, workers=workers)
            return None if earlier is None else earlier.reports
    return None


@refusals_said
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
    from gripcourse.usecases.marks.regrade import apply_regrade as enter

    signed = Signed(by, datetime.now(UTC), why)
    return enter(regrading, place_of(gradebook), signed, allow_lower=allow_lower)


@refusals_said
def undo_regrade(
    gradebook: str | Path,
    *,
    by: str,
    why: str,
    allow_lower: bool = False,
    course: Course | None = None,
) -> "Regrade":
    """Take the last regrade back, by a new entry.

    Args:
        gradebook: path or database URL.
        by: who takes it back.
        why: the reason, kept for good.
        allow_lower: whether results that students were told since may get worse.
        course: that says which ids were joined as those of one person; None where none was.

    Raises:
        GripcourseError: no reason is given, there is nothing to take back, or a published result
            would get worse; nothing was changed.
    """
    from gripcourse.gradebook.journal import Signed
    from gripcourse.usecases.marks.regrade import undo_regrade as undo

    signed = Signed(by, datetime.now(UTC), why)
    return undo(place_of(gradebook), signed, joins_said_by(course), allow_lower=allow_lower)


@refusals_said
def publish(
    gradebook: str | Path, *, by: str, students: Iterable[str] = (), course: Course | None = None
) -> "tuple[Published, ...]":
    """Record that students know their results: from now on only a regrade changes them.

    Args:
        gradebook: path or database URL.
        by: who tells them.
        students: ids; none for everybody.
        course: that says which ids were joined as those of one person; None where none was.

    Raises:
        GripcourseError: of a student nothing has been graded.
    """
    from gripcourse.gradebook.journal import Signed
    from gripcourse.usecases.marks.regrade import publish as tell

    signed = Signed(by, datetime.now(UTC))
    return tell(place_of(gradebook), students, signed, joins_said_by(course))


@refusals_said
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
    from gripcourse.usecases.marks.opening import grading_of
    from gripcourse.usecases.marks.waive import waive as enter

    context = grading_of(course.definition, course.policy)
    waiver = Waiver(
        student, 0, until, withdrawn=False, person=by, done_at=datetime.now(UTC), why=why
    )
    return enter(waiver, place_of(gradebook), context.register, context.joins)


@refusals_said
def history(
    gradebook: str | Path, student: str, *, course: Course | None = None
) -> "tuple[Event, ...]":
    """Return everything that happened to a student's grade, oldest first.

    Args:
        gradebook: path or database URL.
        student: id.
        course: that says who left it, which ids were joined, and what changed in its policy; None
            where nobody was withdrawn.

    Raises:
        GripcourseError: the gradebook does not know the student.
    """
    from gripcourse.usecases.marks.history import history as ask
    from gripcourse.usecases.marks.opening import register_of

    place = place_of(gradebook)
    if course is None:
        return ask(place, student)
    register = register_of(course.root)
    known = register.by_student()
    said, course_id = register.withdrawals, register.course_id
    root = course.root
    return ask(place, student, known, withdrawals=said, course_id=course_id, root=root)
