"""Results as letters to send: a folder for each student, and a list of addresses."""

import csv
import io
from pathlib import Path

from gripcourse.exports.csv_text import text_cell
from gripcourse.exports.platforms.comment import comment_lines
from gripcourse.exports.platforms.moodle_feedback import no_report
from gripcourse.exports.platforms.works import GradedWork
from gripcourse.machine.files import write_bytes, write_text
from gripcourse.text.words import Message, message
from gripcourse.usecases.publishing.exporting import Results

_REPORT = "report.pdf"
_TEXT = "message.txt"
_LIST = "outbox.csv"


def outbox_folders(results: Results, out: Path) -> tuple[tuple[Path, ...], tuple[Message, ...]]:
    """Write a folder for each student: a text to send, the report, and a list of addresses.

    Returns:
        The folders, and notes on works without a report. Nothing is sent.
    """
    stream = io.StringIO(newline="")
    table = csv.writer(stream)
    table.writerow(("student", "name", "email", "folder"))
    folders, notes = [], []
    for work in results.works:
        folder = out / work.report.student
        report = results.report_of(work)
        text = _letter(results, work, has_report=report is not None)
        write_text(folder / _TEXT, text, private=True)
        if report is None:
            # Of an earlier time it would say something else than the text.
            (folder / _REPORT).unlink(missing_ok=True)
            notes.append(no_report(work))
        else:
            write_bytes(folder / _REPORT, report.read_bytes(), private=True)
        told = (work.report.student, work.report.name, work.email, folder.name)
        table.writerow([text_cell(one) for one in told])
        folders.append(folder)
    write_bytes(out / _LIST, stream.getvalue().encode("utf-8-sig"), private=True)
    return tuple(folders), tuple(notes)


def _letter(results: Results, work: GradedWork, *, has_report: bool) -> str:
    """Return the text for a student, in the student's language."""
    words = results.words_of(work.report.student)
    course = results.course.title.of(words.language)
    lines = [
        words.say(message("To: {address}", address=work.email or "—")),
        words.say(message("Subject: {course}: your result", course=course)),
        "",
        words.say(message("Dear {name},", name=work.report.name)),
        "",
        words.say(message("your work was graded (variant {id}):", id=work.report.variant)),
        *comment_lines(work, results.course, words),
    ]
    if has_report:
        lines += ["", words.say(message("The attached report says what was found, and why."))]
    return "\n".join(lines) + "\n"
