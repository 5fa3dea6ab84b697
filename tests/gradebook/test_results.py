"""Results that nobody needs to look at are not read, and what is told of them is true."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import pytest
from sqlalchemy import event, update

from gripcourse.gradebook import schema
from gripcourse.gradebook.model import Attempt, says_the_same
from gripcourse.gradebook.results import (
    Result,
    ResultsToRead,
    digest_of_results,
    results_to_read,
    same_results,
)
from gripcourse.gradebook.store import Gradebook
from gripcourse.grading.model import Outcome, Report

MakeReport = Callable[..., Report]
MakeAttempts = Callable[..., Sequence[Attempt]]

FORCE = Result("force", Outcome.CORRECT, 2.0, 4.0)
BORE = Result("bore", Outcome.WRONG, 0.0, 2.0)


def refused() -> tuple[Result, ...]:
    raise AssertionError


@pytest.mark.parametrize(
    ("some", "others", "same"),
    [
        ((FORCE, BORE), (BORE, FORCE), True),
        ((FORCE,), (replace(FORCE, points=2.0 + 1e-9),), True),
        ((BORE,), (replace(BORE, points=-0.0),), True),
        ((FORCE,), (replace(FORCE, points=2.001),), False),
        ((FORCE,), (replace(FORCE, max_points=5.0),), False),
        ((FORCE,), (replace(FORCE, outcome=Outcome.CARRIED),), False),
        ((FORCE,), (replace(FORCE, quantity="bore"),), False),
        ((FORCE,), (FORCE, BORE), False),
        ((), (), True),
        ((), (BORE,), False),
    ],
)
def test_digests_are_equal_where_results_say_the_same(
    some: tuple[Result, ...], others: tuple[Result, ...], *, same: bool
) -> None:
    assert same_results(some, others) is same
    assert (digest_of_results(some) == digest_of_results(others)) is same
    unread = [ResultsToRead(digest_of_results(one), refused) for one in (some, others)]
    assert same_results(*unread) is same


def test_results_without_a_known_digest_are_read(report: MakeReport) -> None:
    known = results_to_read(report())
    unknown = ResultsToRead("", lambda: tuple(known))
    assert same_results(known, unknown)
    assert not same_results(unknown, [FORCE])
    assert digest_of_results(unknown) == known.digest


def test_unread_attempts_are_the_attempts(
    book: Gradebook, report: MakeReport, attempts: MakeAttempts
) -> None:
    mended = report(bore=(Outcome.CORRECT, 2.0, 2.0))
    unjudged = replace(report("s02"), judged=False, findings=())
    for one in (report(), mended, unjudged):
        book.add_attempts(attempts(one))
    assert book.unread_attempts(["s01", "s02"]) == book.attempts()
    assert [one.student for one in book.unread_attempts(["s02"])] == ["s02"]


def test_no_result_is_asked_for_where_the_digests_are_enough(
    book: Gradebook, report: MakeReport, attempts: MakeAttempts
) -> None:
    book.add_attempts(attempts(report("s01"), report("s02")))
    asked: list[str] = []

    @event.listens_for(book.engine, "before_cursor_execute")
    def look(_connection: object, _cursor: object, statement: str, *_: object) -> None:
        asked.append(statement)

    known = book.unread_attempts(["s01", "s02"])
    assert book.add_attempts(attempts(report("s01"), report("s02")), known) == ()
    mended = attempts(report("s02", bore=(Outcome.CORRECT, 2.0, 2.0)))
    (added,) = book.add_attempts(mended, known)
    assert (added.student, added.number) == ("s02", 2)
    assert not [one for one in asked if one.startswith("SELECT") and "gradebook_result" in one]


def test_what_was_kept_before_there_were_digests_is_compared_by_reading(
    book: Gradebook, report: MakeReport, attempts: MakeAttempts
) -> None:
    book.add_attempts(attempts(report()))
    with book.engine.begin() as connection:
        connection.execute(update(schema.attempts).values(results_digest=None))
    (known,) = book.unread_attempts(["s01"])
    (same,), (other,) = attempts(report()), attempts(report(bore=(Outcome.CORRECT, 2.0, 2.0)))
    assert says_the_same(known, same)
    assert not says_the_same(known, other)
    assert book.add_attempts([same], [known]) == ()
