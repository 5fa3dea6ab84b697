"""What waits for a person: unmarked items, and marks to look at again."""

from collections.abc import Callable, Sequence

from gripcourse.gradebook.model import Attempt, Mark
from gripcourse.gradebook.store import Gradebook
from gripcourse.gradebook.waiting import waiting
from gripcourse.grading.model import Outcome, Report

MakeReport = Callable[..., Report]
MakeMark = Callable[..., Mark]
MakeAttempts = Callable[..., Sequence[Attempt]]


def listed(book: Gradebook) -> list[tuple[str, str, bool]]:
    return [
        (one.student, one.quantity, one.again) for one in waiting(book.attempts(), book.entries())
    ]


def test_manual_items_and_what_we_could_not_judge_wait(
    book: Gradebook, report: MakeReport, attempts: MakeAttempts
) -> None:
    book.add_attempts(attempts(report("s02"), report("s01")))
    assert listed(book) == [
        ("s01", "stroke", False),
        ("s01", "drawing", False),
        ("s02", "stroke", False),
        ("s02", "drawing", False),
    ]
    assert waiting(book.attempts(), ())[0].file == "inbox/s01.xlsx"


def test_a_marked_item_waits_no_more(
    book: Gradebook, report: MakeReport, attempts: MakeAttempts, mark: MakeMark
) -> None:
    book.add_attempts(attempts(report()))
    book.add_marks([mark()])
    assert listed(book) == [("s01", "stroke", False)]


def test_a_withdrawn_mark_waits_again(
    book: Gradebook, report: MakeReport, attempts: MakeAttempts, mark: MakeMark
) -> None:
    book.add_attempts(attempts(report()))
    book.add_marks([mark(), mark(credit=None, comment="не тот файл")])
    assert ("s01", "drawing", False) in listed(book)


def test_a_mark_before_a_new_file_is_to_be_looked_at_again(
    book: Gradebook, report: MakeReport, attempts: MakeAttempts, mark: MakeMark
) -> None:
    book.add_attempts(attempts(report()))
    book.add_marks([mark(), mark("bore", 1.0, comment="другой каталог")])
    book.add_attempts(attempts(report(digest="b" * 64)))
    assert listed(book) == [
        ("s01", "bore", True),
        ("s01", "stroke", False),
        ("s01", "drawing", True),
    ]
    book.add_marks([mark(attempt=2)])
    assert ("s01", "drawing", True) not in listed(book)


def test_only_the_last_file_that_could_be_judged_waits(
    book: Gradebook, report: MakeReport, attempts: MakeAttempts
) -> None:
    judged = report(stroke=(Outcome.CORRECT, 1.0, 1.0))
    book.add_attempts(attempts(report(digest="b" * 64), judged))
    assert listed(book) == [("s01", "drawing", False)]


def test_nothing_waits_in_an_empty_gradebook(book: Gradebook) -> None:
    assert listed(book) == []
