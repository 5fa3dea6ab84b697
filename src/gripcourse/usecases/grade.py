"""Grading a batch: files in; reports, grades and what a person must look at out."""

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path

from gripcourse.batch.one_file import GradingContext
from gripcourse.batch.run import Graded, grade_files, incident_number
from gripcourse.errors import Problem, UsageError
from gripcourse.exports.grades import grades_csv
from gripcourse.exports.report_result import grades_result
from gripcourse.grading.model import Flag, FlagCode, Report
from gripcourse.jobs.workers import Lost, run_each
from gripcourse.machine.content import Readable
from gripcourse.machine.files import write_bytes, write_text
from gripcourse.text.words import Message, Words, message
from gripcourse.usecases.student_reports import (
    LayOut,
    Printing,
    cohort_pdf,
    student_pdf,
    write_reports,
)

# What people hand in as a workbook; a drawing or a note beside it is not ours to judge.
WORKBOOKS = {".xlsx", ".xlsm", ".xls", ".xlsb", ".ods", ".csv", ".numbers"}
GRADES_JSON = "grades.json"
GRADES_CSV = "grades.csv"
COHORT_PDF = "cohort.pdf"
INCIDENTS = "incidents.log"
REPORTS = "reports"


@dataclass(frozen=True, slots=True)
class GradingOutcome:
    """What a batch came to.

    Attributes:
        reports: one per file, in order.
        written: the student reports, by file.
        cohort: the cohort report, None where it could not be laid out.
        needs_person: whether something waits for a person.
    """

    reports: tuple[Report, ...]
    written: Mapping[str, Path]
    cohort: Path | None
    needs_person: bool


def find_files(paths: Iterable[Path]) -> list[Path]:
    """Return the workbooks under the given files and folders, sorted inside a folder.

    Raises:
        UsageError: for a path that does not exist, or a batch without any workbook.
    """
    files: list[Path] = []
    problems: list[Problem] = []
    for path in paths:
        if path.is_dir():
            files += [one for one in sorted(path.rglob("*")) if _is_workbook(one)]
        elif path.is_file():
            files.append(path)
        else:
            problems.append(_problem(path, message("There is no such file or folder.")))
    if not files and not problems:
        problems = [_problem(path, message("There is no workbook in it.")) for path in paths]
    if problems:
        raise UsageError(problems)
    return list(dict.fromkeys(files))


def grade(
    files: Sequence[Readable],
    context: GradingContext,
    workers: int,
    on_done: Callable[[Readable], None],
) -> tuple[Graded, ...]:
    """Grade files; see `batch.run.grade_files`."""
    return grade_files(files, context, min(workers, len(files)), on_done)


def write_results(  # noqa: PLR0913 (the last is what everybody leaves as it is)
    graded: Sequence[Graded],
    context: GradingContext,
    out: Path,
    graded_on: date,
    workers: int,
    on_done: Callable[[Path], None],
    *,
    lay_out: LayOut = student_pdf,
) -> GradingOutcome:
    """Write student reports, the cohort report, grades as CSV and JSON, and the incidents.

    A report that cannot be laid out is an incident of that student; the others are written. So it
    is with the cohort report: grades are never lost for it.
    """
    printing = Printing(context.course, context.policy, graded_on)
    plain = [one.report for one in graded]
    outcomes = write_reports(plain, printing, out / REPORTS, workers, on_done, lay_out)
    reports = [_with_incident(*pair) for pair in zip(plain, outcomes, strict=True)]
    written = {
        report.file: path
        for report, path in zip(reports, outcomes, strict=True)
        if isinstance(path, Path)
    }
    incidents = [one.incident for one in graded if one.incident]
    incidents += [
        _told(one, f"report of {report.file}")
        for report, one in zip(reports, outcomes, strict=True)
        if isinstance(one, Lost)
    ]
    failed = write_grades(reports, context, out, graded_on, workers)
    if failed is not None:
        incidents.append(_told(failed, COHORT_PDF))
    if incidents:
        write_text(out / INCIDENTS, "\n".join(incidents))
    else:
        # Those of an earlier run into the same folder have been mended.
        (out / INCIDENTS).unlink(missing_ok=True)
    cohort = None if failed is not None else out / COHORT_PDF
    needs_person = cohort is None or any(one.flags for one in reports)
    return GradingOutcome(tuple(reports), written, cohort, needs_person)


def write_grades(
    reports: Sequence[Report],
    context: GradingContext,
    out: Path,
    graded_on: date,
    workers: int = 1,
) -> Lost | None:
    """Write what concerns the whole batch: grades as CSV and JSON, and the cohort report.

    Returns:
        Why the cohort report could not be laid out, None where it was.
    """
    groups = {name: issued.student.group for name, issued in context.register.items()}
    grades_csv(reports, out / GRADES_CSV, groups)
    write_text(out / GRADES_JSON, json_text(reports, Words(context.course.language)))
    printing = Printing(context.course, context.policy, graded_on)
    ((_, pdf),) = run_each(
        cohort_pdf, [tuple(reports)], printing, workers=min(workers, 1), seconds=printing.seconds
    )
    if isinstance(pdf, Lost):
        # An earlier one would say something else than the grades.
        (out / COHORT_PDF).unlink(missing_ok=True)
        return pdf
    write_bytes(out / COHORT_PDF, pdf)
    return None


def json_text(reports: Sequence[Report], words: Words) -> str:
    """Return the reports as JSON; see `exports.report_result.GradesResult`."""
    plain = grades_result(reports, words).to_dict()
    return json.dumps(plain, ensure_ascii=False, indent=1, allow_nan=False)


def _told(lost: Lost, of: str) -> str:
    return f"incident {incident_number(lost.trace)}: {of}\n{lost.trace}"


def _with_incident(report: Report, outcome: Path | Lost | None) -> Report:
    if not isinstance(outcome, Lost):
        return report
    said = message(
        "The report could not be laid out (incident {number}): {reason}",
        number=incident_number(outcome.trace),
        reason=outcome.reason,
    )
    return replace(report, flags=(*report.flags, Flag(FlagCode.REPORT_INCIDENT, said)))


def _is_workbook(path: Path) -> bool:
    hidden = path.name.startswith((".", "~$"))
    return path.is_file() and not hidden and path.suffix.lower() in WORKBOOKS


def _problem(path: Path, what: Message) -> Problem:
    return Problem(str(path), "", what, message("Name a workbook or a folder with workbooks."))
