"""The zip of feedback files that Moodle hands out to its participants.

Moodle ignores without a word what is not named as it wants: the participant's number must stand
between the first two low lines, and the plug-in after it. Where teams hand in, the number must be
that of a team, and all of it get the file: a report of one student is not put there.
"""

import io
import re
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

from gripcourse.exports.platforms.matching import is_of_team
from gripcourse.exports.platforms.moodle_worksheet import FilledWorksheet
from gripcourse.exports.platforms.works import GradedWork, PlatformRow
from gripcourse.text.words import Message, Words, message

# What Moodle takes out of names.
_DROPPED: Final = re.compile(r"[\x00-\x1f\x7f&<>\"`|':\\/]")
_REPORT: Final = message("report")
_EPOCH: Final = (1980, 1, 1, 0, 0, 0)
_READABLE: Final = 0o644


def feedback_zip(
    filled: FilledWorksheet, report_of: Callable[[GradedWork], Path | None], words: Words
) -> tuple[bytes, tuple[Message, ...]]:
    """Return the zip, the same bytes for the same reports, and notes on works without a report.

    Args:
        filled: the worksheet with its grades.
        report_of: tells where a work's report lies; None where there is none that fits the grades.
        words: the language of the names of files.
    """
    stream, notes = io.BytesIO(), []
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for row, work in _of_works(filled):
            if is_of_team(work, row):
                notes.append(_left_out(work))
                continue
            report = report_of(work)
            if report is None:
                notes.append(no_report(work))
                continue
            if not row.number:
                notes.append(_no_number(work))
                continue
            info = zipfile.ZipInfo(feedback_name(row, work, words), _EPOCH)
            info.external_attr = _READABLE << 16
            archive.writestr(info, report.read_bytes(), zipfile.ZIP_DEFLATED)
    return stream.getvalue(), tuple(notes)


def no_report(work: GradedWork) -> Message:
    """Say that a work has no report, or one of an earlier grading, and what to do."""
    return message(
        "No report of {student} tells the points of these grades: grade again and let reports be"
        " written.",
        student=work.said,
    )


def _no_number(work: GradedWork) -> Message:
    return message(
        "The report of {student} is not in the zip: the worksheet has no number of this row, by"
        " which Moodle would find whose it is.",
        student=work.said,
    )


def feedback_name(row: PlatformRow, work: GradedWork, words: Words) -> str:
    """Return the name of a report in the zip, with its folder."""
    full_name = row.name or (work.part.name if work.part else "")
    file = f"{words.say(_REPORT)}_{work.report.variant}.pdf"
    return f"{_clean(full_name)}_{row.number}_assignfeedback_file/{_DROPPED.sub('', file)}"


def _clean(name: str) -> str:
    return _DROPPED.sub("", name.replace("_", " ")).strip(" .~")


def _left_out(work: GradedWork) -> Message:
    return message(
        "{student} handed in with a team, and Moodle would show the report to all of it: it was"
        " left out of the zip.",
        student=work.said,
    )


def _of_works(filled: FilledWorksheet) -> Iterator[tuple[PlatformRow, GradedWork]]:
    for _, _, row in filled.worksheet.rows():
        work = filled.matching.works.get(row.line)
        if work is not None:
            yield row, work
