"""Correcting what was issued, as a program asks for it."""

from collections.abc import Iterable
from datetime import date, datetime
from pathlib import Path

from gripcourse.api.course import Course
from gripcourse.api.make_results import issue_result
from gripcourse.api.refusals import refusals_said
from gripcourse.api.results import IssueResult
from gripcourse.api.sources import FileLike, path_of

# Every call imports what it needs itself, as in `api.course`.
# ruff: noqa: PLC0415


@refusals_said
def reissue(  # noqa: PLR0913 (the last four are for those who need them)
    course: Course,
    students: Iterable[str],
    out: str | Path,
    *,
    by: str,
    why: str,
    variant: str = "",
    table: FileLike | None = None,
    deadline: date | None = None,
    today: date | None = None,
) -> IssueResult:
    """Issue a new version to students; what was handed out stays, and works on it count.

    Args:
        course: that issued the first version.
        students: ids of the register.
        out: folder to write a folder per student to.
        by: who issues it.
        why: the reason, kept for good.
        variant: id of another variant; empty for the row of each student's own.
        table: of variants; None for the course's main one.
        deadline: last day for handing in; None for everybody's own.
        today: day of the issue; None for today.

    Raises:
        GripcourseError: something cannot be used or cannot be done; nothing was issued.
    """
    from gripcourse.issuing.reissue import Correction
    from gripcourse.usecases.issuing.reissue import CorrectedOrder, reissue_order

    order = CorrectedOrder(
        correction=Correction(tuple(students), variant, why, by),
        table=course.table_source(table),
        out=path_of(out),
        today=today or datetime.now().astimezone().date(),
        deadline=deadline,
    )
    issuing = reissue_order(course.definition, course.policy, order, 0, lambda _: None)
    return issue_result(issuing, course.words)
