"""A work is one file of a student, and the last grading of it that was not taken back stands."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import UTC, datetime

import pytest

from gripcourse.gradebook.apply import with_marks
from gripcourse.gradebook.model import Attempt, GradebookEntry, Mark, latest_marks
from gripcourse.gradebook.works import latest_judged, points_of, standing_of, works_of
from gripcourse.grading.model import Outcome, Report

MakeReport = Callable[..., Report]
MakeMark = Callable[..., Mark]
MakeAttempts = Callable[..., Sequence[Attempt]]


def numbered(attempts: Sequence[Attempt]) -> list[Attempt]:
    return [replace(one, number=number) for number, one in enumerate(attempts, start=1)]


def test_grading_the_first_file_again_does_not_make_it_the_last(
    report: MakeReport, attempts: MakeAttempts
) -> None:
    mended = report(bore=(Outcome.CORRECT, 2.0, 2.0))
    kept = numbered(attempts(report(), report(digest="b" * 64), mended))
    first, second = works_of(kept)["s01"]
    assert (first.number, first.first.number, first.attempt.number) == (1, 1, 3)
    assert (second.number, second.attempt.number) == (2, 2)
    assert latest_judged(kept)["s01"].digest == "b" * 64


def test_a_last_file_that_could_not_be_judged_leaves_the_one_before(
    report: MakeReport, attempts: MakeAttempts
) -> None:
    broken = replace(report(digest="b" * 64), judged=False, findings=())
    assert latest_judged(numbered(attempts(report(), broken)))["s01"].number == 1


def test_what_was_said_of_the_time_outlives_the_regrade_that_it_was_said_after(
    report: MakeReport, attempts: MakeAttempts
) -> None:
    """Whoever takes a regrade back says nothing about when works were handed in."""
    said = datetime(2026, 12, 1, 18, tzinfo=UTC)
    kept = numbered(attempts(*[report(digest=one * 64) for one in "abaa"]))
    kept[2] = replace(kept[2], regrade=1)
    kept[3] = replace(kept[3], regrade=1, handed_in=said, handed_in_said=True)
    first, second = works_of(standing_of(kept, {1}))["s01"]
    assert (first.attempt.number, first.handed_in) == (1, said)
    assert (second.attempt.number, second.handed_in) == (2, None)
    assert standing_of(kept, set()) == tuple(kept)
    assert standing_of(kept[3:], {1}) == ()


@pytest.mark.parametrize("credit", [None, 0.0, 0.25, 1.0])
def test_points_of_a_work_are_those_of_its_report(
    report: MakeReport, attempts: MakeAttempts, mark: MakeMark, credit: float | None
) -> None:
    (kept,) = numbered(attempts(report()))
    entries = [
        GradebookEntry(mark("drawing", credit), kept),
        GradebookEntry(mark("bore", 0.5), kept),
    ]
    sums, told = points_of(kept.results, latest_marks(entries)), with_marks(report(), entries)
    assert (sums.score, sums.max_score, sums.open_points) == (
        told.score,
        told.max_score,
        told.open_points,
    )
