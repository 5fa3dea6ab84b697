"""The tables of a whole batch: grades and all files that were found, as CSV and JSON."""

import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import chain, repeat
from pathlib import Path

from gripcourse.batch.one_file import GradingContext
from gripcourse.exports.files import Fate, FileAccount, files_text, graded_account
from gripcourse.exports.grades import Called, grades_text
from gripcourse.exports.make_report_result import around_reports, grades_result
from gripcourse.exports.report_json import report_json
from gripcourse.exports.report_result import GradesResult
from gripcourse.grading.folded import digest_of_report
from gripcourse.grading.model import Report
from gripcourse.machine.files import write_together
from gripcourse.policy.scales import Scale
from gripcourse.text.words import Words
from gripcourse.usecases.grading.collect import REASONS, PassedOver
from gripcourse.usecases.grading.lines_before import LinesBefore, Piece, TableLine, all_made
from gripcourse.usecases.grading.unchanged import PrintedBefore
from gripcourse.usecases.grading.versions import digest_of_texts
from gripcourse.variants.model import Student

GRADES_JSON = "grades.json"
GRADES_CSV = "grades.csv"
FILES_CSV = "files.csv"
_NO_REPORTS = '"reports": []'


def renew_tables(
    reports: Sequence[Report],
    context: GradingContext,
    out: Path,
    passed_over: Sequence[PassedOver],
    printed: PrintedBefore | None,
) -> None:
    """Write the tables of a batch, unless an earlier run wrote them from the very same."""
    tables = [out / name for name in (GRADES_CSV, FILES_CSV, GRADES_JSON)]
    if printed is None:
        write_tables(reports, context, out, passed_over)
        return
    students = (repr(issued.student) for issued in context.register.values())
    digests = [digest_of_report(one) for one in reports]
    made_from = digest_of_texts(chain(digests, [repr(passed_over)], students))
    if all(printed.stands(one, made_from) for one in tables):
        return
    lines = printed.lines_of(out / GRADES_JSON)
    write_tables(reports, context, out, passed_over, TakenLines(lines, digests))
    for one in tables:
        printed.note(one, made_from)


@dataclass(frozen=True, slots=True)
class TakenLines:
    """What need not be put into words again.

    Attributes:
        before: lines of the table of before.
        digests: of the reports, in their order.
    """

    before: LinesBefore
    digests: Sequence[str]


def write_tables(
    reports: Sequence[Report],
    context: GradingContext,
    out: Path,
    passed_over: Sequence[PassedOver] = (),
    taken: TakenLines | None = None,
) -> None:
    """Write what concerns the whole batch: grades and all files, as CSV and JSON.

    All of them or none: on a full disk none is newer than the others.

    Args:
        reports: of the batch.
        context: the course, its policy and the register.
        out: folder to write to.
        passed_over: files that were found and not looked at.
        taken: what an earlier run wrote; None for nothing.

    Raises:
        OSError: one of them cannot be written; those of an earlier run are untouched.
    """
    students = {name: issued.student for name, issued in context.register.items()}
    words = Words(context.course.language)
    called = Called(context.policy.scales, words)

    def accounts() -> Iterator[FileAccount]:
        yield from map(graded_account, reports)
        yield from map(passed_over_account, passed_over)

    digests = repeat("") if taken is None else taken.digests
    pieces = _json_pieces(reports, digests, called, passed_over, missing(reports, context))
    of_before = out / GRADES_JSON
    write_together(
        {
            out / GRADES_CSV: _for_excel(lambda: grades_text(reports, students, called)),
            out / FILES_CSV: _for_excel(lambda: files_text(accounts(), words)),
            of_before: (
                all_made(pieces) if taken is None else taken.before.taken_over(of_before, pieces)
            ),
        }
    )


def _for_excel(text: Callable[[], str]) -> Iterator[str]:
    # The byte order mark is what tells Excel that the Cyrillic is UTF-8.
    yield "\ufeff"
    yield text()


def missing(reports: Sequence[Report], context: GradingContext) -> tuple[Student, ...]:
    """Return the students of the register of whom the batch has nothing, by id."""
    handed_in = {report.student for report in reports}
    return tuple(
        issued.student for name, issued in sorted(context.register.items()) if name not in handed_in
    )


def json_text(
    reports: Sequence[Report],
    words: Words,
    passed_over: Sequence[PassedOver] = (),
    scales: Sequence[Scale] = (),
    missing: Sequence[Student] = (),
) -> str:
    """Return the reports as JSON, each in a line; see `exports.report_result.GradesResult`."""
    called = Called(tuple(scales), words)
    return "".join(all_made(_json_pieces(reports, repeat(""), called, passed_over, missing)))


def _json_pieces(
    reports: Sequence[Report],
    digests: Iterable[str],
    called: Called,
    passed_over: Sequence[PassedOver],
    missing: Sequence[Student],
) -> Iterator[Piece]:
    words, scales = called.words, called.scales
    others = tuple(map(passed_over_account, passed_over))
    plain = around_reports(reports, words, (), others, missing).to_dict()
    around = json.dumps(plain, ensure_ascii=False, indent=1, allow_nan=False)
    before, after = around.split(_NO_REPORTS, 1)
    yield before + _NO_REPORTS.removesuffix("]")
    for number, (report, digest) in enumerate(zip(reports, digests, strict=False)):
        yield ",\n" if number else "\n"
        yield TableLine(digest, partial(report_json, report, words, scales))
    yield ("\n ]" if reports else "]") + after


def batch_result(
    reports: Sequence[Report],
    words: Words,
    context: GradingContext,
    passed_over: Sequence[PassedOver] = (),
    incidents: Sequence[str] = (),
) -> GradesResult:
    """Put a batch into words for another program: every file found, and who handed in nothing."""
    others = tuple(map(passed_over_account, passed_over))
    lacking = missing(reports, context)
    return grades_result(reports, words, incidents, others, context.policy.scales, lacking)


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
