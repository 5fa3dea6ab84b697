"""Reports of files that could not be judged: never a zero mark, always a flag that says why."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from gripcourse.grading.model import Flag, FlagCode, Report
from gripcourse.submission.model import Answer, Reading, Rejected, Submission
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued

UNREADABLE_SHARE = 0.1  # of the answers; beyond it nothing is judged
_OF_THE_FILLED = 0.5  # of the answers that are not blank, likewise
_NAMED = 3  # cells that the flag names, and reasons that are told
_TOLD = 12  # cells of a reason


def rejected_report(rejected: Rejected, issued: Issued | None) -> Report:
    """Report a file that is no workbook that we can read."""
    report = unjudged(
        rejected.file, Flag(FlagCode.REJECTED, rejected.reason), issued, rejected.digest
    )
    # The student can mend this, so the student is told; other flags are the instructor's.
    return replace(report, remarks=(rejected.reason,), refusal=rejected.code)


def is_unreadable(submission: Submission) -> bool:
    """Tell whether so many answers cannot be read that a mark would say nothing of the work.

    One cell with a word in it is a mistake of the student's. A program that stored no results of
    formulas, or a column of pictures, is none: whoever handed that in has to be asked. So has to
    be who filled in little, most of which cannot be read.
    """
    unread = sum(one.reading is Reading.UNREADABLE for one in submission.answers.values())
    filled = sum(one.reading is not Reading.BLANK for one in submission.answers.values())
    most = unread > _OF_THE_FILLED * filled
    return most or unread > UNREADABLE_SHARE * len(submission.answers)


def unreadable_report(submission: Submission, issued: Issued) -> Report:
    """Report a workbook whose answers cannot be read; the student can mend it and is told so."""
    unread = [one for one in submission.answers.values() if one.reading is Reading.UNREADABLE]
    said = message(
        "{count} of {asked} answers cannot be read, so the work was not judged: for example "
        "{cells}. Open it, write numbers into the answer cells, save it as .xlsx and hand it in "
        "again.",
        count=len(unread),
        asked=len(submission.answers),
        cells=", ".join(one.cell for one in unread[:_NAMED]),
    )
    flag = Flag(FlagCode.UNREADABLE, said)
    report = unjudged(submission.file, flag, issued, submission.digest)
    return replace(report, remarks=(said, *_reasons(unread)))


def _reasons(unread: Sequence[Answer]) -> Iterator[Message]:
    """Yield the first reasons why cells cannot be read, each behind the cells that have it."""
    found: dict[str, list[Answer]] = {}
    for one in unread:
        for remark in one.remarks[:1]:
            found.setdefault(str(remark), []).append(one)
    for those in list(found.values())[:_NAMED]:
        yield message("{cells}: {reason}", cells=_cells(those), reason=those[0].remarks[0])


def _cells(answers: Sequence[Answer]) -> str:
    """Name cells, the sheet before those that stand on it: `1. Scheme!E6, E8; 2. Drive!E7`."""
    sheets: dict[str, list[str]] = {}
    for sheet, _, cell in sorted(map(_place, answers))[:_TOLD]:
        sheets.setdefault(sheet, []).append(cell)
    named = "; ".join(f"{sheet}!{', '.join(cells)}" for sheet, cells in sheets.items())
    return named + (", …" if len(answers) > _TOLD else "")


def _place(answer: Answer) -> tuple[str, int, str]:
    """Return the sheet and the cell of an answer, with what sets `E9` before `E10`."""
    sheet, _, cell = answer.cell.rpartition("!")
    return sheet, len(cell), cell


def unknown_student_report(file: str, student: str, digest: str) -> Report:
    """Report a workbook of somebody who is not in the register."""
    said = (
        message("The register has no student '{student}'.", student=student)
        if student
        else message("Neither the file's name nor the workbook says whose it is.")
    )
    return unjudged(file, Flag(FlagCode.UNKNOWN_STUDENT, said), None, digest)


def disputed_report(file: str, doubt: Message, digest: str) -> Report:
    """Report a file of which a person must say who handed it in; it is nobody's until then."""
    return unjudged(file, Flag(FlagCode.WHO_HANDED_IN, doubt), None, digest)


def incident_report(file: str, number: str, issued: Issued | None) -> Report:
    """Report a file whose grading failed on our side."""
    said = message(
        "Grading failed on our side (incident {number}); the file waits for the instructor.",
        number=number,
    )
    return unjudged(file, Flag(FlagCode.INCIDENT, said), issued, "")


def unjudged(file: str, flag: Flag, issued: Issued | None, digest: str) -> Report:
    """Make the report of a file without a judgement."""
    return Report(
        file=file,
        student=issued.student.id if issued else "",
        name=issued.student.name if issued else "",
        variant=issued.variant.id if issued else "",
        scheme=issued.variant.scheme if issued else "",
        options=issued.variant.options if issued else {},
        language=issued.student.language if issued else "",
        score=0.0,
        max_score=0.0,
        open_points=0.0,
        flags=(flag,),
        findings=(),
        remarks=(),
        judged=False,
        digest=digest,
    )
