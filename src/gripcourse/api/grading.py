"""Grading a batch, as a program asks for it: what `Course.grade` does."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from datetime import UTC, date, datetime
from pathlib import Path

from gripcourse.api.choices import today_here, whole_number
from gripcourse.api.sources import FileLike, path_of, place_of, workbooks
from gripcourse.course.model import Course
from gripcourse.exports.report_result import GradesResult
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.marks.batch_wish import BatchWish

# Every call imports what it needs itself, as in `api.course`.
# ruff: noqa: PLC0415


@dataclass(frozen=True, slots=True)
class GradingWanted:
    """What a program wants to be graded, and how; see `Course.grade` for each."""

    files: FileLike | Iterable[FileLike]
    out: str | Path | None
    gradebook: str | Path | None
    graded_on: date | None
    wish: BatchWish
    workers: int
    on_done: Callable[[object], None]


def grade_wanted(
    course: Course, policy: Policy, words: Words, wanted: GradingWanted
) -> GradesResult:
    """Grade a batch, keep it where it is to be kept and write what is to be written.

    Args:
        course: by which.
        policy: likewise.
        words: the language of the sentences in the result.
        wanted: what and how.

    Raises:
        UsageError: a path does not exist, or the wish cannot be fulfilled.
        RegisterError: the register cannot be used.
        GradebookError: the gradebook cannot be used.
    """
    from gripcourse.batch.comparing import comparing_apart
    from gripcourse.batch.graded import reports_of
    from gripcourse.usecases.grading.batch_tables import batch_result
    from gripcourse.usecases.grading.grade import grade, write_results
    from gripcourse.usecases.marks.gradebook import keep
    from gripcourse.usecases.marks.opening import as_wished, grading_of

    folder = None if wanted.out is None else path_of(wanted.out)
    workers = whole_number("workers", wanted.workers, 0)
    sources, others = workbooks(wanted.files)
    place = None if wanted.gradebook is None else place_of(wanted.gradebook)
    context, times = as_wished(wanted.wish, sources, grading_of(course, policy), place, workers)
    with comparing_apart(context, None) as comparing:
        graded = grade(sources, context, workers, wanted.on_done, comparing=comparing)
        if place is not None:
            graded = keep(graded, context, place, datetime.now(UTC), times)
        graded = comparing.entered(graded)
    reports = reports_of(graded)
    if folder is not None:
        day = wanted.graded_on or today_here()
        reports = write_results(
            graded, context, folder, day, workers, lambda _: None, passed_over=others
        ).reports
    failed = [one.incident for one in graded if one.incident]
    return batch_result(reports, words, context, others, failed)
