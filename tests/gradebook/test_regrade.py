"""A regrade is compared item by item; what can no longer be judged is never applied."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import pytest

from gripcourse.gradebook.model import Attempt, Fingerprints, GradebookEntry, Mark, latest_marks
from gripcourse.gradebook.regrade import ChangedPart, Shift, WorkChange, change_of
from gripcourse.gradebook.works import works_of
from gripcourse.grading.model import Outcome, Report

MakeReport = Callable[..., Report]
MakeMark = Callable[..., Mark]
MakeAttempts = Callable[..., Sequence[Attempt]]
Compare = Callable[..., WorkChange]


@pytest.fixture
def compare(report: MakeReport, attempts: MakeAttempts) -> Compare:
    """Compare the usual report with another of the same bytes."""

    def made(now: Report, marks: Sequence[Mark] = (), **changes: object) -> WorkChange:
        old, new = attempts(report(), now)
        (work,) = works_of([old])["s01"]
        marked = latest_marks(GradebookEntry(one, old) for one in marks)
        return change_of(work, replace(new, **changes), marked, published=False)  # type: ignore[arg-type]

    return made


@pytest.mark.parametrize(
    ("bore", "direction"),
    [
        ((Outcome.CORRECT, 2.0, 2.0), Shift.RAISED),
        ((Outcome.BLANK, 0.0, 2.0), Shift.UNCHANGED),
        ((Outcome.WRONG, 0.0, 3.0), Shift.LOWERED),
    ],
)
def test_what_counts_is_the_share_of_all_points(
    compare: Compare, report: MakeReport, bore: tuple[Outcome, float, float], direction: Shift
) -> None:
    change = compare(report(bore=bore))
    assert change.direction is direction
    assert [one.quantity for one in change.items] == ["bore"]
    assert change.changes


def test_an_item_that_a_person_decided_moves_no_points(
    compare: Compare, report: MakeReport, mark: MakeMark
) -> None:
    change = compare(report(bore=(Outcome.CORRECT, 2.0, 2.0)), [mark("bore", 0.5)])
    assert change.direction is Shift.UNCHANGED
    assert change.before == change.after
    assert change.changes


def test_the_same_results_by_another_course_are_nothing_to_apply(
    compare: Compare, report: MakeReport
) -> None:
    change = compare(report(), fingerprints=Fingerprints("x" * 64, "d" * 64, "e" * 64))
    assert change.versions == (ChangedPart.ENGINE, ChangedPart.COURSE)
    assert not change.changes


def test_where_another_version_of_the_assignment_counts_nobody_has_changed_the_course(
    compare: Compare, report: MakeReport
) -> None:
    other = Fingerprints("x" * 64, "d" * 64, "c" * 64)
    change = compare(report(), version=2, fingerprints=other)
    assert ChangedPart.VERSION in change.versions
    assert ChangedPart.COURSE not in change.versions


def test_items_that_are_new_or_asked_no_longer_are_named(
    compare: Compare, report: MakeReport
) -> None:
    now = report(rod=(Outcome.CORRECT, 1.0, 1.0))
    now = replace(now, findings=tuple(one for one in now.findings if one.quantity != "bore"))
    items = {one.quantity: (one.before, one.after) for one in compare(now).items}
    assert (items["bore"][1], items["rod"][0]) == (None, None)


def test_what_cannot_be_judged_any_more_keeps_its_results(
    compare: Compare, report: MakeReport
) -> None:
    lost = compare(replace(report(), judged=False, findings=()))
    assert lost.is_lost
    assert not lost.changes
