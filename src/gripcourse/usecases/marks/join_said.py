"""What joining two ids, or taking it back, changes without anybody deciding it: said at once."""

from collections.abc import Collection, Mapping
from pathlib import Path, PurePath

from gripcourse.errors import CourseError, TableError
from gripcourse.gradebook.counted import CountedWork
from gripcourse.issuing.register import Register
from gripcourse.issuing.withdrawal import Withdrawal
from gripcourse.text.shown import shown
from gripcourse.text.words import Message, message
from gripcourse.usecases.marks.counting import works_that_count
from gripcourse.usecases.marks.opening import open_grading
from gripcourse.variants.model import Issued


def counted_now(root: Path, place: str, students: Collection[str]) -> Mapping[str, CountedWork]:
    """Return the works of students that count, by the course as it is now.

    Who is joined with somebody is nobody of their own. Of a course that cannot be used nothing is
    returned: a withdrawal needs nothing but its register.

    Args:
        root: folder of the course.
        place: of the gradebook, which is there.
        students: ids.

    Raises:
        RegisterError: the register cannot be used.
        GradebookError: the gradebook cannot be used.
    """
    try:
        context = open_grading(root)
        own = [one for one in students if one not in context.joined]
        return works_that_count(place, own, context)
    except (CourseError, TableError):
        return {}


def counting_said(
    before: Mapping[str, CountedWork], now: Mapping[str, CountedWork]
) -> tuple[Message, ...]:
    """Say which works count from now on, where these are others, or come to something else.

    Args:
        before: the works that counted, by student.
        now: those that count.
    """
    if _in_short(before) == _in_short(now):
        return ()
    said = message(
        "By the policy something else counts from now on. Before: {before}. Now: {now}.",
        before=_written(before),
        now=_written(now),
    )
    return (said,)


def deadline_said(wanted: Withdrawal, person: str, before: Register) -> tuple[Message, ...]:
    """Say that the later day of another id is no longer a person's, where it was.

    Args:
        wanted: takes the joining of its student with the person back.
        person: id.
        before: the register in which they are joined.
    """
    entry = before.by_student().get(person)
    if entry is None or entry.own_deadline is None:
        return ()
    own = entry.own_deadline
    since = next(one.at for one in reversed(before.joins) if one.student == wanted.student)
    if entry.version > 1 and entry.issued_on >= since.date():
        said = message(
            "{student} has the deadline {own} again. The sheet of version {version} was issued"
            " meanwhile and says {later}: if that is to hold, write it into"
            " variants/deadlines.csv.",
            student=person,
            own=own.isoformat(),
            version=entry.version,
            later=_day(entry),
        )
        return (said,)
    return (
        message(
            "{student} has the deadline {own} again, not {later}.",
            student=person,
            own=own.isoformat(),
            later=_day(entry),
        ),
    )


def _day(entry: Issued) -> str:
    return "—" if entry.deadline is None else entry.deadline.isoformat()


def _in_short(counted: Mapping[str, CountedWork]) -> list[tuple[str, float]]:
    """Return what counts, whoever it is of: a work that only changes hands is the same."""
    return sorted((one.attempt.digest, round(one.earned, 6)) for one in counted.values())


def _written(counted: Mapping[str, CountedWork]) -> str:
    return (
        "; ".join(
            f"{student} {shown(PurePath(one.attempt.file).name)} {one.earned:.4g} /"
            f" {one.sums.max_score:.4g}"
            for student, one in sorted(counted.items())
        )
        or "—"
    )
