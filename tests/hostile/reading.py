"""What is done with each spoiled workbook, in a worker too."""

import io
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass

from gripcourse.course.quantity import Quantity
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.jobs.limits import peak_memory
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.table import visible_sheets
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Reading, Rejected, Submission
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook
from gripcourse.text.words import LANGUAGES, Words


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a file came to.

    Attributes:
        raw: as a student's workbook.
        submission: what its answers were understood as; None for a refused file.
        said: the reason in each language, for a refused file.
        peak: megabytes of memory that the process has had at most.
        printed: what came to a terminal.
    """

    raw: RawWorkbook | Rejected
    submission: Submission | None
    said: tuple[str, ...]
    peak: float
    printed: str


def as_student(data: bytes, quantities: tuple[Quantity, ...]) -> Outcome:
    """Read a file that a student hands in."""
    terminal = io.StringIO()
    with redirect_stdout(terminal), redirect_stderr(terminal):
        raw = read_workbook(NamedBytes("answers.xlsx", data))
        refused = isinstance(raw, Rejected)
        submission = None if isinstance(raw, Rejected) else interpret(raw, quantities)
    said = tuple(Words(one).say(raw.reason) for one in LANGUAGES) if refused else ()
    return Outcome(raw, submission, said, peak_memory() / 1024**2, terminal.getvalue())


def as_table(data: bytes, _: object) -> WhyRefused | int:
    """Read a file that an instructor gives as a table."""
    sheets = visible_sheets(data)
    return sheets if isinstance(sheets, WhyRefused) else len(sheets)


def faults_of(read: Outcome) -> list[str]:
    """Tell what is wrong with an outcome, whatever the file is."""
    if read.printed:
        return [f"printed: {read.printed}"]
    if isinstance(read.raw, Rejected):
        whole = len(set(read.said)) == len(LANGUAGES) and all(read.said)
        is_known = read.raw.code in set(WhyRefused) and len(read.raw.digest) == 64
        return [] if whole and is_known else [f"refused without a reason: {read.raw}"]
    assert read.submission is not None
    return [
        f"{name}: a value without an answer"
        for name, one in read.submission.answers.items()
        if (one.value is None) == (one.reading is Reading.READ)
    ]
