"""What became of every file of a batch, as a table."""

import csv
import io
from dataclasses import replace
from typing import TYPE_CHECKING

from gripcourse.exports.files import Fate, files_lines, graded_account
from gripcourse.grading.unjudged import disputed_report, rejected_report
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.submission.model import Rejected
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.grading.model import Report


def test_a_refused_file_has_the_code_of_its_reason() -> None:
    report = rejected_report(Rejected.because("a.xlsx", "d", WhyRefused.PASSWORD), None)
    account = graded_account(report)
    assert (account.fate, account.why, account.needs_person) == (Fate.REFUSED, "password", True)


def test_a_file_in_doubt_is_left_to_a_person() -> None:
    account = graded_account(disputed_report("a.xlsx", message("Who?"), "d"))
    assert (account.fate, account.why) == (Fate.TO_A_PERSON, "who_handed_in")


def test_a_graded_file_has_no_reason(perfect: "Report") -> None:
    account = graded_account(replace(perfect, flags=()))
    assert (account.fate, account.why, account.message) == (Fate.GRADED, "", None)
    assert not account.needs_person


def test_nothing_in_the_table_runs_and_each_reason_is_a_sentence() -> None:
    report = rejected_report(Rejected.because("=1+1.xlsx", "d", WhyRefused.PDF), None)
    text = "".join(files_lines([graded_account(report)], Words("en")))
    (row,) = csv.DictReader(io.StringIO(text, newline=""))
    assert row["file"] == "'=1+1.xlsx"
    assert row["message"] == "The file is a PDF document. Send the .xlsx workbook itself."
