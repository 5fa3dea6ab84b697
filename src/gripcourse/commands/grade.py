"""Grading a batch: files in; reports, grades and what a person must look at out."""

import json
import traceback
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from datetime import date
from multiprocessing import get_context
from pathlib import Path

from gripcourse.cohort.one import Desk
from gripcourse.cohort.packed import pack, unpack
from gripcourse.cohort.run import Graded, grade_files
from gripcourse.course.model import Course
from gripcourse.course.policy import Policy
from gripcourse.errors import Problem, UsageError
from gripcourse.files import write_bytes, write_text
from gripcourse.grading.model import Decision, Flag, Report
from gripcourse.report.grades import grades_csv
from gripcourse.solver.plan import make_plan
from gripcourse.words import Message, Words, message

# What people hand in as a workbook; a drawing or a note beside it is not ours to judge.
WORKBOOKS = {".xlsx", ".xlsm", ".xls", ".xlsb", ".ods", ".csv", ".numbers"}
GRADES_JSON = "grades.json"
GRADES_CSV = "grades.csv"
COHORT_PDF = "cohort.pdf"
INCIDENTS = "incidents.log"
REPORTS = "reports"


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a batch came to.

    Attributes:
        reports: one per file, in order.
        written: the student reports, by file.
        needs_person: whether something waits for a person.
    """

    reports: tuple[Report, ...]
    written: Mapping[str, Path]
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
    files: Sequence[Path], desk: Desk, workers: int, on_done: Callable[[Path], None]
) -> tuple[Graded, ...]:
    """Grade files; see `cohort.run.grade_files`."""
    return grade_files(files, desk, min(workers, len(files)), on_done)


def write_results(
    graded: Sequence[Graded],
    desk: Desk,
    out: Path,
    graded_on: date,
    workers: int,
    on_done: Callable[[Path], None],
) -> Outcome:
    """Write student reports, the cohort report, grades as CSV and JSON, and the incidents.

    A report that cannot be laid out is an incident of that student; the others are written.
    """
    laid_out = _lay_out([one.report for one in graded], desk, graded_on, workers, on_done)
    written: dict[str, Path] = {}
    reports: list[Report] = []
    incidents = [one.incident for one in graded if one.incident]
    for report, pdf in laid_out:
        if isinstance(pdf, str):
            incidents.append(pdf)
            reports.append(_with_incident(report))
            continue
        reports.append(report)
        if pdf is not None:
            written[report.file] = out / REPORTS / _pdf_name(report, written)
            write_bytes(written[report.file], pdf)
    write_grades(reports, desk, out, graded_on)
    if incidents:
        write_text(out / INCIDENTS, "\n".join(incidents))
    else:
        # Those of an earlier run into the same folder have been mended.
        (out / INCIDENTS).unlink(missing_ok=True)
    return Outcome(tuple(reports), written, any(one.flags for one in reports))


def write_grades(reports: Sequence[Report], desk: Desk, out: Path, graded_on: date) -> None:
    """Write what concerns the whole batch: grades as CSV and JSON, and the cohort report."""
    from gripcourse.report.cohort import cohort_report  # noqa: PLC0415 (matplotlib, 400 ms)

    groups = {name: issued.student.group for name, issued in desk.register.items()}
    grades_csv(reports, out / GRADES_CSV, groups)
    words = Words(desk.course.language)
    write_text(out / GRADES_JSON, json_text(reports, words))
    write_bytes(
        out / COHORT_PDF,
        cohort_report(reports, desk.policy, desk.course, words, graded_on),
    )


def json_text(reports: Sequence[Report], words: Words) -> str:
    """Return the reports as JSON, one object per file."""
    return json.dumps([report_json(one, words) for one in reports], ensure_ascii=False, indent=1)


def report_json(report: Report, words: Words) -> dict[str, object]:
    """Return one report as plain values; values are in declared units, None where there is none."""
    return {
        "file": report.file,
        "student": report.student,
        "variant": report.variant,
        "scheme": report.scheme,
        "judged": report.judged,
        "score": report.score if report.judged else None,
        "max_score": report.max_score if report.judged else None,
        "open_points": report.open_points,
        "flags": [flag.code for flag in report.flags],
        "flag_messages": [words.say(flag.message) for flag in report.flags],
        "remarks": [words.say(remark) for remark in report.remarks],
        "findings": [
            {
                "quantity": finding.quantity,
                "section": finding.section,
                "outcome": finding.outcome.value,
                "against": finding.against.value,
                "given": finding.given,
                "typed": finding.typed,
                "cell": finding.cell,
                "reference": finding.reference,
                "expected": finding.expected,
                "band": finding.band,
                "points": finding.points,
                "max_points": finding.max_points,
                "slip": finding.slip,
                "message": words.say(finding.message),
                "remarks": [words.say(remark) for remark in finding.remarks],
                "decision": _decision_json(finding.decision),
            }
            for finding in report.findings
        ],
    }


def _decision_json(decision: Decision | None) -> dict[str, object] | None:
    if decision is None:
        return None
    return {
        "automatic": decision.automatic.value,
        "credit": decision.credit,
        "lines": dict(decision.lines),
        "marker": decision.marker,
        "decided_at": decision.decided_at.isoformat(),
        "comment": decision.comment,
        "outdated": decision.outdated,
    }


def student_pdf(report: Report, course: Course, policy: Policy, graded_on: date) -> bytes | str:
    """Lay out one student's report; the trace of the failure where that is not possible."""
    from gripcourse.report.student import student_report  # noqa: PLC0415 (WeasyPrint, 450 ms)

    words = Words(report.language or course.language)
    try:
        plan = make_plan(course, report.scheme, report.options)
        return student_report(report, plan, policy, course, words, graded_on)
    except Exception:  # noqa: BLE001 (ours: one student's incident, never a lost batch)
        return f"report of {report.file}:\n{traceback.format_exc()}"


def _packed_pdf(report: Report, packed: bytes) -> bytes | str:
    course, policy, graded_on = unpack(packed)
    return student_pdf(report, course, policy, graded_on)


def _lay_out(
    reports: Sequence[Report],
    desk: Desk,
    graded_on: date,
    workers: int,
    on_done: Callable[[Path], None],
) -> list[tuple[Report, bytes | str | None]]:
    laid_out: list[tuple[Report, bytes | str | None]] = []
    context = get_context("spawn")
    packed = pack((desk.course, desk.policy, graded_on))
    with ProcessPoolExecutor(min(workers, max(len(reports), 1)), context) as pool:
        jobs = [
            pool.submit(_packed_pdf, report, packed) if report.scheme else None
            for report in reports
        ]
        for report, job in zip(reports, jobs, strict=True):
            laid_out.append((report, None if job is None else job.result()))
            on_done(Path(report.file))
    return laid_out


def _with_incident(report: Report) -> Report:
    said = message("The report could not be laid out; see the log of incidents.")
    return replace(report, flags=(*report.flags, Flag("report_incident", said)))


def _pdf_name(report: Report, written: Mapping[str, Path]) -> str:
    """Name a report after its student; a second file of a student gets a number."""
    taken = {path.name for path in written.values()}
    names = (f"{report.student}{suffix}.pdf" for suffix in ("", *(f"-{n}" for n in range(2, 1000))))
    return next(name for name in names if name not in taken)


def _is_workbook(path: Path) -> bool:
    hidden = path.name.startswith((".", "~$"))
    return path.is_file() and not hidden and path.suffix.lower() in WORKBOOKS


def _problem(path: Path, what: Message) -> Problem:
    return Problem(str(path), "", what, message("Name a workbook or a folder with workbooks."))
