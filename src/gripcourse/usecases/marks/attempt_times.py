"""When attempts that are to be kept were handed in, under which id, and what is in doubt."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from datetime import datetime

from gripcourse.batch.context import GradingContext
from gripcourse.gradebook.joined import family
from gripcourse.gradebook.model import Attempt
from gripcourse.gradebook.timing import Waiver, lateness
from gripcourse.gradebook.works import StudentWork
from gripcourse.grading.model import Flag, FlagCode
from gripcourse.issuing.withdrawal import Join
from gripcourse.policy.time_rules import LateRule
from gripcourse.text.words import message
from gripcourse.usecases.marks.handed_in import HandingTime


def to_keep(attempt: Attempt, time: HandingTime | None, context: GradingContext) -> Attempt:
    """Return an attempt with its time, under the id under which it is kept where it is new.

    Args:
        attempt: as it was graded.
        time: of its file; None where nobody knows.
        context: the course.
    """
    return _under_its_sheet(_timed(attempt, time), context)


def doubts_about_time(
    work: StudentWork | None,
    time: HandingTime | None,
    context: GradingContext,
    deadline: datetime | None,
    waived: Sequence[Waiver],
) -> tuple[Flag, ...]:
    """Flag a work of which it is in doubt when it was handed in, where that costs something.

    Args:
        work: as it stands; None where the gradebook does not know it.
        time: of its file; None where nobody knows.
        context: the course.
        deadline: of the student; None for none.
        waived: the student's waivers, oldest first.
    """
    late = context.policy.late
    return (*_doubt(time, late, deadline, waived), *_two_times(work, context.joins))


def _timed(attempt: Attempt, handed_in: HandingTime | None) -> Attempt:
    if handed_in is None:
        return attempt
    return replace(attempt, handed_in=handed_in.at, handed_in_said=handed_in.said)


def _under_its_sheet(attempt: Attempt, context: GradingContext) -> Attempt:
    """Return a work that is to be kept under the id whose sheet it was made for.

    So it goes with the sheet where two who were joined are two again.
    """
    sheets = context.earlier.get(attempt.student, ()) if context.joins else ()
    made_for = (attempt.variant, attempt.version)
    kept_as = (one.issued_as for one in sheets if (one.variant.id, one.version) == made_for)
    return replace(attempt, kept_as=next(kept_as, ""))


def _doubt(
    time: HandingTime | None,
    rule: LateRule | None,
    deadline: datetime | None,
    waived: Sequence[Waiver],
) -> Iterator[Flag]:
    """Flag a work whose lateness depends on which of two moments its time means."""
    if time is None or time.later is None or time.doubt is None:
        return
    waiver = waived[-1] if waived else None
    fewer, more = (lateness(at, deadline, waiver, rule) for at in (time.at, time.later))
    if fewer == more:
        return
    what, remedy = time.doubt
    said = message(
        "{what} The work was handed in then: days late by the earlier moment {fewer}, by the later"
        " one {more}. The earlier one counts until somebody says when it was handed in. {remedy}",
        what=what,
        fewer=fewer[0],
        more=more[0],
        remedy=remedy,
    )
    yield Flag(FlagCode.TIME_DOUBTFUL, said)


def _two_times(work: StudentWork | None, joins: Sequence[Join]) -> Iterator[Flag]:
    """Flag a work that was handed in at two times, as was said under two ids of one person."""
    if work is None or not work.of_two:
        return
    ids = sorted(family({work.student}, joins) - {work.student})
    said = message(
        "Under two ids of one person, {ids} and {student}, two times were said at which the"
        " work was handed in. The earlier one counts until somebody says when it was.",
        ids=", ".join(ids),
        student=work.student,
    )
    yield Flag(FlagCode.TIME_DOUBTFUL, said)
