"""What became of every file of a batch: graded, refused, left to a person, or not looked at."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum

from gripcourse.exports.csv_text import table_lines, text_cell
from gripcourse.grading.model import FlagCode, Report
from gripcourse.text.words import Message, Words


class Fate(StrEnum):
    """What became of a file; the value stands in JSON and in tables."""

    GRADED = "graded"
    REFUSED = "refused"
    TO_A_PERSON = "to_a_person"
    NOT_LOOKED_AT = "not_looked_at"


@dataclass(frozen=True, slots=True)
class FileAccount:
    """One file of a batch.

    Attributes:
        file: as it was found.
        fate: what became of it.
        student: id; empty where nobody can be told.
        why: code of the reason why it was not graded; empty for none.
        message: the reason in a sentence; None for none.
        needs_person: whether somebody must look at it before anybody is graded.
    """

    file: str
    fate: Fate
    student: str
    why: str
    message: Message | None
    needs_person: bool


def graded_account(report: Report) -> FileAccount:
    """Account for a file that was read."""
    codes = {flag.code for flag in report.flags}
    if report.judged:
        return FileAccount(report.file, Fate.GRADED, report.student, "", None, bool(codes))
    fate = Fate.REFUSED if FlagCode.REJECTED in codes else Fate.TO_A_PERSON
    first = report.flags[0]
    why = report.refusal or first.code.value
    return FileAccount(report.file, fate, report.student, why, first.message, needs_person=True)


def reason_of(account: FileAccount, words: Words) -> str:
    """Say why a file was not graded; nothing where it was."""
    return "" if account.message is None else words.say(account.message)


def files_lines(accounts: Iterable[FileAccount], words: Words) -> Iterator[str]:
    """Yield the lines of the table of what became of every file."""
    header = ("file", "fate", "student", "why", "message")
    rows = (
        (
            text_cell(one.file),
            one.fate.value,
            text_cell(one.student),
            one.why,
            text_cell(reason_of(one, words)),
        )
        for one in accounts
    )
    return table_lines(header, rows)
