"""Regrades and publications are entries: applied with a reason, taken back by another entry."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import datetime

import pytest

from gripcourse.gradebook.journal import (
    Signed,
    applied,
    keep_publication,
    keep_regrade,
    keep_undoing,
    publications,
    published_works,
    regrades,
)
from gripcourse.gradebook.model import Attempt, Fingerprints
from gripcourse.gradebook.store import Gradebook
from gripcourse.gradebook.works import points_of, works_of
from gripcourse.grading.model import Outcome, Report

MakeReport = Callable[..., Report]
MakeAttempts = Callable[..., Sequence[Attempt]]


@pytest.fixture
def signed(morning: datetime) -> Signed:
    return Signed("Петров", morning, "допуск был узок")


@pytest.fixture
def mended(report: MakeReport, attempts: MakeAttempts) -> Sequence[Attempt]:
    """What a work comes to by a course that was mended."""
    return attempts(report(bore=(Outcome.CORRECT, 2.0, 2.0)))


@pytest.fixture
def graded(book: Gradebook, report: MakeReport, attempts: MakeAttempts) -> Gradebook:
    book.add_attempts(attempts(report()))
    return book


def bore(book: Gradebook) -> Outcome:
    return works_of(book.standing())["s01"][0].attempt.by_quantity["bore"].outcome


def test_a_regrade_stands_until_it_is_taken_back_and_nothing_is_removed(
    graded: Gradebook, mended: Sequence[Attempt], signed: Signed
) -> None:
    (kept,) = keep_regrade(graded, mended, signed)
    assert (kept.number, kept.regrade, bore(graded)) == (2, 1, Outcome.CORRECT)
    (undone,) = keep_undoing(graded, replace(signed, why="не то"))
    assert (undone.number, undone.undoes, bore(graded)) == (2, 1, Outcome.WRONG)
    assert [one.number for one in graded.attempts()] == [1, 2]
    assert [one.signed.why for one in regrades(graded)] == ["допуск был узок", "не то"]
    assert applied(regrades(graded)) == ()


def test_what_was_taken_back_can_be_applied_again(
    graded: Gradebook, mended: Sequence[Attempt], signed: Signed
) -> None:
    for _ in range(2):
        keep_regrade(graded, mended, signed)
        keep_undoing(graded, signed)
    keep_regrade(graded, mended, signed)
    assert bore(graded) is Outcome.CORRECT
    assert [one.undoes for one in regrades(graded)] == [None, 1, None, 3, None]


def test_a_regrade_that_changes_nothing_leaves_no_entry(
    graded: Gradebook, mended: Sequence[Attempt], signed: Signed
) -> None:
    keep_regrade(graded, mended, signed)
    assert keep_regrade(graded, mended, signed) == ()
    assert len(regrades(graded)) == 1


def test_undoing_takes_back_the_last_one_that_stands_then_the_one_before(
    graded: Gradebook,
    mended: Sequence[Attempt],
    report: MakeReport,
    attempts: MakeAttempts,
    signed: Signed,
) -> None:
    keep_regrade(graded, mended, signed)
    keep_regrade(graded, attempts(report(bore=(Outcome.BLANK, 0.0, 2.0))), signed)
    taken = [keep_undoing(graded, signed) for _ in range(3)]
    assert [[one.undoes for one in some] for some in taken] == [[2], [1], []]
    assert bore(graded) is Outcome.WRONG


def test_what_graded_a_work_is_kept(
    graded: Gradebook, mended: Sequence[Attempt], signed: Signed
) -> None:
    versions = Fingerprints("c" * 64, "p" * 64, "e" * 64)
    keep_regrade(graded, [replace(one, fingerprints=versions) for one in mended], signed)
    assert [one.fingerprints.engine for one in graded.attempts()] == ["", "e" * 64]
    assert graded.attempts()[-1].fingerprints == versions


def test_a_student_is_told_a_result_once(graded: Gradebook, signed: Signed) -> None:
    (work,) = works_of(graded.standing())["s01"]
    sums = points_of(work.attempt.results, {})
    assert len(keep_publication(graded, {work: sums}, signed)) == 1
    assert keep_publication(graded, {work: sums}, signed) == ()
    (told,) = keep_publication(graded, {work: replace(sums, score=1.0)}, signed)
    assert (told.number, told.points) == (2, 1.0)
    assert len(publications(graded)) == 2
    assert published_works(graded) == {("s01", work.digest)}
