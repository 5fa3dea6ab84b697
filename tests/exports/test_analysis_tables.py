"""What works say about the assignment leaves as tables, and a regrade as before and after."""

from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime

import pytest

from gripcourse.exports.analysis_tables import analysis_tables, history_tables
from gripcourse.exports.make_report_result import grades_result
from gripcourse.exports.results_tables import csv_tables
from gripcourse.gradebook.journal import Regrade, Signed
from gripcourse.gradebook.model import Attempt, Fingerprints
from gripcourse.gradebook.results import Result
from gripcourse.grading.model import Flag, FlagCode, Outcome, Report, Timing
from gripcourse.slips.model import SlipId
from gripcourse.text.words import Words, message

Change = Callable[..., Report]
NOW = datetime(2026, 12, 1, 9, tzinfo=UTC)
SAID = datetime(2026, 11, 30, 18, tzinfo=UTC)


def attempt(student: str, digest: str, points: float, regrade: int | None = None) -> Attempt:
    results = (
        Result("force", Outcome.CORRECT, points, 4.0),
        Result("verdict", Outcome.CORRECT, 0.0, 0.0),
        Result("drawing", Outcome.MANUAL, 0.0, 4.0),
    )
    prints = Fingerprints("c", "p", "e")
    return Attempt(
        student, 1, "1", "x", "f", digest, NOW, prints, True, results, regrade, handed_in=NOW
    )


def test_slips_are_counted_once_a_work_and_never_of_anothers_workbook(
    perfect: Report, wrong: Change, with_finding: Change
) -> None:
    slip = SlipId.declared("one_jaw")
    once = with_finding(wrong(perfect, "drive_force", 1.0), "drive_force", slip=slip)
    anothers = Flag(FlagCode.ISSUED_TO_OTHER, message("Another's."))
    reports = [perfect, once, wrong(perfect, "drive_force", 1.0), replace(once, flags=(anothers,))]
    table = analysis_tables(grades_result(reports, Words("en")))["slips"]
    rows = table[table["quantity"] == "drive_force"]
    assert set(rows["wrong"]) == {2}
    assert sum(rows["students"]) == 2


def test_of_a_students_attempts_the_one_that_counts_is_asked(
    perfect: Report, wrong: Change
) -> None:
    timing = Timing(1, 2, False, None, None, 0, 0.0, "")
    reports = [perfect, replace(wrong(perfect, "drive_force", 1.0), timing=timing)]
    tables = analysis_tables(grades_result(reports, Words("en")))
    assert set(tables["items"]["works"]) == {1}
    assert tables["slips"].empty


def test_tables_of_a_batch_are_csv_too(perfect: Report) -> None:
    tables = analysis_tables(grades_result([perfect] * 3, Words("en")))
    assert list(tables) == ["items", "slips", "reliability", "difficulty"]
    written = csv_tables(tables)
    assert b"facility_without" in written["items.csv"]
    assert all(one.startswith(b"\xef\xbb\xbf") for one in written.values())


@pytest.mark.parametrize("undone", [False, True])
def test_a_regrade_is_told_before_and_after(*, undone: bool) -> None:
    attempts = [
        attempt("s1", "a", 2.0),
        attempt("s1", "b", 1.0),
        replace(attempt("s1", "a", 4.0, regrade=1), handed_in=None),
        attempt("s2", "c", 4.0),
        attempt("s2", "c", 4.0, regrade=1),
        # A person said after the regrade when it was handed in.
        replace(attempt("s2", "c", 4.0, regrade=1), handed_in=SAID, handed_in_said=True),
    ]
    attempts = [replace(one, number=number) for number, one in enumerate(attempts, start=1)]
    signed = Signed("head", NOW, "why")
    journal = [Regrade(1, None, signed), *([Regrade(2, 1, signed)] if undone else [])]
    tables = history_tables(attempts, journal)
    (row,) = tables["regrades"].to_dict("records")
    assert (row["quantity"], row["works"], row["changed"]) == ("force", 2, 1)
    assert (row["before"], row["after"]) == (0.75, 1.0)
    assert row["undone"] is undone
    times = tables["times"]
    assert list(times["student"]) == ["s1", "s1", "s2"]
    assert list(times["work"]) == [1, 2, 1]
    assert list(times["of"]) == [2, 2, 1]
    assert list(times["handed_in"]) == [NOW.isoformat(), NOW.isoformat(), SAID.isoformat()]
    assert list(times["said"]) == [False, False, True]
