"""The tables of a whole batch: grades and all files that were found, as CSV and JSON."""

import json
from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import chain, repeat
from pathlib import Path

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded, reports_of
from gripcourse.exports.files import Fate, FileAccount, files_lines, graded_account
from gripcourse.exports.grades import Called, grades_lines
from gripcourse.exports.make_report_result import file_result, grades_result, missing_result
from gripcourse.exports.plain import to_plain
from gripcourse.exports.report_json import report_json
from gripcourse.exports.report_result import FileResult, GradesResult, MissingResult
from gripcourse.grading.model import Report
from gripcourse.machine.files import write_together
from gripcourse.machine.shelf import Shelved, Viewed, ViewedMapping
from gripcourse.policy.scales import Scale
from gripcourse.text.words import Words
from gripcourse.usecases.grading.collect import REASONS, PassedOver
from gripcourse.usecases.grading.lines_before import LinesBefore, Piece, TableLine, all_made
from gripcourse.usecases.grading.unchanged import PrintedBefore
from gripcourse.usecases.grading.versions import digest_of_texts
from gripcourse.variants.model import Issued, Student

GRADES_JSON = "grades.json"
GRADES_CSV = "grades.csv"
FILES_CSV = "files.csv"


def renew_tables(
    graded: Sequence[Graded],
    context: GradingContext,
    out: Path,
    passed_over: Sequence[PassedOver],
    printed: PrintedBefore | None,
    absent: Sequence[Student],
) -> None:
    """Write the tables of a batch, unless an earlier run wrote them from the very same.

    Args:
        graded: the batch.
        context: the course, its policy and the register.
        out: folder to write to.
        passed_over: files that were found and not looked at.
        printed: what earlier runs wrote; None to write all.
        absent: students of whom there is nothing.
    """
    tables = [out / name for name in (GRADES_CSV, FILES_CSV, GRADES_JSON)]
    reports, arounds = reports_of(graded), Viewed(graded, _around)
    if printed is None:
        write_tables(reports, context, out, passed_over, WorkedOut(arounds, absent=absent))
        return
    students = (repr((one.student, one.left)) for one in context.register.values())
    digests = Shelved(one.digest for one in graded)
    made_from = digest_of_texts(chain(digests, [repr(passed_over)], students))
    if all(printed.stands(one, made_from) for one in tables):
        return
    lines = printed.lines_of(out / GRADES_JSON)
    write_tables(reports, context, out, passed_over, WorkedOut(arounds, lines, digests, absent))
    for one in tables:
        printed.note(one, made_from)


def _around(graded: Graded) -> str:
    return "" if graded.stated is None else graded.stated.line


@dataclass(frozen=True, slots=True)
class WorkedOut:
    """What need not be worked out again, of reports in their order.

    Attributes:
        arounds: what `json_around` says of each; empty where nobody knows it.
        before: lines of the table of before; None for none.
        digests: of the reports; none where there is no table of before.
        absent: students of whom there is nothing; None where nobody has looked.
    """

    arounds: Iterable[str]
    before: LinesBefore | None = None
    digests: Sequence[str] = ()
    absent: Sequence[Student] | None = None


def write_tables(
    reports: Sequence[Report],
    context: GradingContext,
    out: Path,
    passed_over: Sequence[PassedOver] = (),
    known: WorkedOut | None = None,
) -> None:
    """Write what concerns the whole batch: grades and all files, as CSV and JSON.

    All of them or none: on a full disk none is newer than the others.

    Args:
        reports: of the batch.
        context: the course, its policy and the register.
        out: folder to write to.
        passed_over: files that were found and not looked at.
        known: what an earlier run wrote, or who made the reports; None for nothing.

    Raises:
        OSError: one of them cannot be written; those of an earlier run are untouched.
    """
    students = ViewedMapping(context.register, _student)
    left = frozenset(id_ for id_, one in context.register.items() if one.left)
    words = Words(context.course.language)
    called = Called(context.policy.scales, words)

    def accounts() -> Iterator[FileAccount]:
        yield from map(graded_account, reports)
        yield from map(passed_over_account, passed_over)

    known = known or WorkedOut(repeat(""))
    lines = zip(reports, known.digests or repeat(""), known.arounds, strict=False)
    absent = missing(reports, context) if known.absent is None else known.absent
    pieces = _json_pieces(reports, lines, called, passed_over, absent)
    of_before = out / GRADES_JSON
    write_together(
        {
            out / GRADES_CSV: _for_excel(lambda: grades_lines(reports, students, called, left)),
            out / FILES_CSV: _for_excel(lambda: files_lines(accounts(), words)),
            of_before: (
                all_made(pieces)
                if known.before is None
                else known.before.taken_over(of_before, pieces)
            ),
        }
    )


def _for_excel(lines: Callable[[], Iterator[str]]) -> Iterator[str]:
    # The byte order mark is what tells Excel that the Cyrillic is UTF-8.
    yield "\ufeff"
    yield from lines()


def _student(issued: Issued) -> Student:
    return issued.student


def missing(reports: Sequence[Report], context: GradingContext) -> tuple[Student, ...]:
    """Return the students of the course of whom the batch has nothing, by id."""
    return lacking({report.student for report in reports}, context)


def lacking(handed_in: Container[str], context: GradingContext) -> tuple[Student, ...]:
    """Return the students of the course but for those who handed in, by id."""
    names = sorted(name for name in context.register if name not in handed_in)
    entries = (context.register[name] for name in names)
    return tuple(one.student for one in entries if not one.left)


def json_text(
    reports: Sequence[Report],
    words: Words,
    passed_over: Sequence[PassedOver] = (),
    scales: Sequence[Scale] = (),
    missing: Sequence[Student] = (),
) -> str:
    """Return the reports as JSON, each in a line; see `exports.report_result.GradesResult`."""
    called = Called(tuple(scales), words)
    lines = ((one, "", "") for one in reports)
    return "".join(all_made(_json_pieces(reports, lines, called, passed_over, missing)))


def _json_pieces(
    reports: Sequence[Report],
    lines_of: Iterable[tuple[Report, str, str]],
    called: Called,
    passed_over: Sequence[PassedOver],
    missing: Sequence[Student],
) -> Iterator[Piece]:
    """Yield the pieces of a table that may be of any length: of each list one line at a time.

    Args:
        reports: of the batch.
        lines_of: each of them with its digest and what `json_around` says, as far as they are
            known.
        called: words and scales.
        passed_over: files that were found and not looked at.
        missing: students of whom there is nothing.
    """
    words, scales = called.words, called.scales

    def accounts() -> Iterator[FileAccount]:
        yield from map(graded_account, reports)
        yield from map(passed_over_account, passed_over)

    flagged = any(one.needs_person for one in accounts())
    left = _as_json(GradesResult((), flagged).to_dict())
    lists: tuple[tuple[str, Iterable[Piece]], ...] = (
        ("reports", (TableLine(digest, partial(report_json, report, words, scales, around))
                     for report, digest, around in lines_of)),
        ("files", (_item(file_result(one, words)) for one in accounts())),
        ("missing", (_item(missing_result(one)) for one in missing)),
    )  # fmt: skip
    for name, lines in lists:
        empty = f'"{name}": []'
        before, left = left.split(empty, 1)
        yield before + empty.removesuffix("]")
        number = -1
        for number, line in enumerate(lines):
            yield ",\n" if number else "\n"
            yield line
        yield "\n ]" if number >= 0 else "]"
    yield left


def _item(result: FileResult | MissingResult) -> str:
    """Write a list's item as it stands in a whole that is written at once."""
    # A text may have other ends of lines in it: JSON escapes no more than this one.
    return "  " + _as_json(to_plain(result)).replace("\n", "\n  ")


def _as_json(plain: object) -> str:
    return json.dumps(plain, ensure_ascii=False, indent=1, allow_nan=False)


def batch_result(
    reports: Sequence[Report],
    words: Words,
    context: GradingContext,
    passed_over: Sequence[PassedOver] = (),
    incidents: Sequence[str] = (),
) -> GradesResult:
    """Put a batch into words for another program: every file found, and who handed in nothing."""
    others = tuple(map(passed_over_account, passed_over))
    absent = missing(reports, context)
    return grades_result(reports, words, incidents, others, context.policy.scales, absent)


def passed_over_account(one: PassedOver) -> FileAccount:
    """Account for a file that was not looked at; only what may be work waits for a person."""
    return FileAccount(
        file=one.file,
        fate=Fate.NOT_LOOKED_AT,
        student="",
        why=one.why,
        message=REASONS[one.why],
        needs_person=one.needs_person,
    )
