"""Grading a batch: files in; reports, grades and what a person must look at out."""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import date
from functools import partial
from pathlib import Path

from gripcourse.batch.comparing import Comparing
from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded, reports_of, with_reports
from gripcourse.batch.read_ahead import WorksAhead
from gripcourse.batch.run import grade_files, incident_number, is_found_out
from gripcourse.documents.report.totals import is_counting, shares
from gripcourse.exports.grades import FOUND
from gripcourse.exports.report_json import json_around, said_in
from gripcourse.gradebook.results import RESULTS, RESULTS_DIGEST
from gripcourse.grading.model import Flag, FlagCode, Report
from gripcourse.grading.path_pattern import fits_none
from gripcourse.likeness.works import TYPED
from gripcourse.machine.alone import writing_into
from gripcourse.machine.content import Readable
from gripcourse.machine.files import (
    discard_unfinished,
    write_text,
)
from gripcourse.machine.jobs.pools import PROCESSES, Pool
from gripcourse.machine.jobs.workers import Lost
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.text.words import message
from gripcourse.usecases.grading.batch_tables import (
    FILES_CSV,
    GRADES_CSV,
    GRADES_JSON,
    lacking,
    renew_tables,
)
from gripcourse.usecases.grading.cohort_print import CohortPrint, printing_cohort
from gripcourse.usecases.grading.collect import PassedOver
from gripcourse.usecases.grading.student_reports import (
    AsItWas,
    LayOut,
    Printing,
    Written,
    student_pdf,
    write_reports,
)
from gripcourse.usecases.grading.unchanged import Earlier, PrintedBefore, TakenOver
from gripcourse.variants.model import Student

COHORT_PDF = "cohort.pdf"
INCIDENTS = "incidents.log"
REPORTS = "reports"


@dataclass(frozen=True, slots=True)
class GradingOutcome:
    """What a batch came to.

    Attributes:
        reports: one per file, in order.
        written: the student reports, by file.
        cohort: the cohort report, None where it could not be laid out or nobody wants it.
        needs_person: whether something waits for a person.
        passed_over: files that were found and not looked at.
        left_over: student reports of earlier runs that this one did not renew.
        taken_over: what was neither graded nor printed again.
        grades_only: whether nobody wanted anything printed.
        missing: students to whom something was issued and whose work is not in the batch, by id.
        cohort_fault: why the cohort report could not be laid out.
        undated: students with a judged work who have no deadline, though lateness costs, by id.
        unfitting: the pattern of paths that an instructor gave, where it fits no file; else empty.
    """

    reports: Sequence[Report]
    written: Mapping[str, Path]
    cohort: Path | None
    needs_person: bool
    passed_over: tuple[PassedOver, ...] = ()
    left_over: tuple[Path, ...] = ()
    taken_over: TakenOver = field(default_factory=TakenOver)
    grades_only: bool = False
    missing: tuple[Student, ...] = ()
    cohort_fault: str = ""
    undated: tuple[str, ...] = ()
    unfitting: str = ""


def grade(  # noqa: PLR0913 (the last ones are what nearly everybody leaves as they are)
    files: Sequence[Readable],
    context: GradingContext,
    workers: int,
    on_done: Callable[[Readable], None],
    earlier: Earlier | None = None,
    pool: Pool = PROCESSES,
    *,
    ahead: WorksAhead | None = None,
    comparing: Comparing | None = None,
) -> Sequence[Graded]:
    """Grade files, but for those that an earlier run graded; see `batch.run.grade_files`."""
    kept = None if earlier is None else earlier.reports
    count = min(workers, len(files))
    # What the gradebook, the search for likeness and the tables ask of every work.
    wanted = (RESULTS, RESULTS_DIGEST, TYPED, FOUND, said_in(context.course.language))
    line_of = partial(json_around, language=context.course.language, scales=context.policy.scales)
    return grade_files(
        files, context, count, on_done, kept=kept, pool=pool, wanted=wanted, line_of=line_of,
        ahead=ahead, comparing=comparing,
    )  # fmt: skip


def write_results(  # noqa: PLR0913 (the last is what everybody leaves as it is)
    graded: Sequence[Graded],
    context: GradingContext,
    out: Path,
    graded_on: date,
    workers: int,
    on_done: Callable[[Path], None],
    *,
    passed_over: Sequence[PassedOver] = (),
    lay_out: LayOut | None = student_pdf,
    earlier: Earlier | None = None,
    pool: Pool = PROCESSES,
) -> GradingOutcome:
    """Write student reports, the cohort report, grades as CSV and JSON, and the incidents.

    A report that cannot be laid out is an incident of that student; the others are written. So it
    is with the cohort report: grades are never lost for it.

    What an earlier run printed from the very same is left as it is.

    Args:
        graded: what is written.
        context: the course, its policy and the register.
        out: folder to write to.
        graded_on: the day that is printed.
        workers: how many processes lay out reports.
        on_done: called with each file.
        passed_over: files that were found and not looked at.
        lay_out: lays out a student's report; None to print nothing.
        earlier: what an earlier run left.
        pool: kind of workers.
    """
    printed = None if earlier is None else earlier.printed
    results = _Results(context, out, passed_over, printed)
    with writing_into(out) as alone:
        if alone:
            _discard_unfinished(out)
        plain = reports_of(graded)
        if lay_out is None:
            return results.written(graded, [None] * len(plain), None)
        printing = Printing(
            context.course,
            context.policy,
            graded_on,
            peers=tuple(shares(filter(is_counting, plain))),
            declared=context.declared,
        )
        with printing_cohort(plain, printing, out / COHORT_PDF, workers, printed) as cohort:
            outcomes = write_reports(
                plain,
                printing,
                out / REPORTS,
                workers,
                on_done,
                lay_out,
                printed=printed,
                pool=pool,
            )
            return results.written(graded, outcomes, cohort)


@dataclass(frozen=True, slots=True)
class _Results:
    """Where the results of a batch are written to; see `write_results`."""

    context: GradingContext
    out: Path
    passed_over: Sequence[PassedOver]
    printed: PrintedBefore | None

    def written(
        self, graded: Sequence[Graded], outcomes: Sequence[Written], cohort: CohortPrint | None
    ) -> GradingOutcome:
        """Write what concerns the whole batch.

        Args:
            graded: the batch.
            outcomes: what became of each student's report.
            cohort: the report on the batch; None where nobody wants it.
        """
        before, context, out = reports_of(graded), self.context, self.out
        lost = [(number, one) for number, one in enumerate(outcomes) if isinstance(one, Lost)]
        graded = with_reports(
            graded, ((number, _with_incident(before[number], one)) for number, one in lost)
        )
        reports = reports_of(graded)
        written = {
            reports[number].file: path
            for number, one in enumerate(outcomes)
            if (path := one.path if isinstance(one, AsItWas) else one) and isinstance(path, Path)
        }
        seen = _Seen.of(graded)
        incidents = [*seen.incidents]
        incidents += [_told(one, f"report of {reports[number].file}") for number, one in lost]
        absent = lacking(seen.handed_in, context)
        renew_tables(graded, context, out, self.passed_over, self.printed, absent)
        failed = None if cohort is None else cohort.written(reports, changed=bool(lost))
        if failed is not None:
            incidents.append(_told(failed, COHORT_PDF))
        if incidents:
            write_text(out / INCIDENTS, "\n".join(incidents), private=True)
        else:
            # Those of an earlier run into the same folder have been corrected.
            (out / INCIDENTS).unlink(missing_ok=True)
        path = None if cohort is None or failed is not None else cohort.path
        return GradingOutcome(
            reports=reports,
            written=written,
            cohort=path,
            needs_person=failed is not None
            or seen.is_flagged
            or any(one.needs_person for one in self.passed_over),
            passed_over=tuple(self.passed_over),
            left_over=left_over(out, {*written.values(), *([] if path is None else [path])}),
            taken_over=TakenOver(
                results=seen.taken_over,
                reports=sum(isinstance(one, AsItWas) for one in outcomes),
            ),
            grades_only=cohort is None,
            missing=absent,
            cohort_fault="" if failed is None else failed.reason,
            undated=tuple(sorted(seen.undated)) if context.policy.late is not None else (),
            unfitting=fits_none(context.pattern, (one.file for one in reports)),
        )


@dataclass(slots=True)
class _Seen:
    """What is seen in a batch that is looked through once.

    Attributes:
        incidents: what failed on our side.
        is_flagged: whether anything waits for a person.
        taken_over: how many results an earlier run found out.
        undated: students with a judged work who have no deadline.
        handed_in: students of whom there is a file.
    """

    incidents: list[str] = field(default_factory=list)
    is_flagged: bool = False
    taken_over: int = 0
    undated: set[str] = field(default_factory=set)
    handed_in: set[str] = field(default_factory=set)

    @classmethod
    def of(cls, graded: Iterable[Graded]) -> "_Seen":
        """Look through a batch."""
        seen = cls()
        for one in graded:
            report = one.report
            if one.incident:
                seen.incidents.append(one.incident)
            seen.is_flagged |= bool(report.flags)
            seen.handed_in.add(report.student)
            seen.taken_over += one.taken_over
            if report.judged and report.timing is not None and report.timing.deadline is None:
                seen.undated.add(report.student)
        return seen


def is_settled(graded: Sequence[Graded], context: GradingContext, out: Path, workers: int) -> bool:
    """Tell whether the next run need not look at any file or report again while nothing changes.

    What was gone, and what failed on our side, may be the machine's fault of that day.

    Args:
        graded: the batch.
        context: that it was graded with.
        out: folder of its results, written.
        workers: how many processes graded it.
    """
    whole = all(_is_settled(one.report, context, workers) for one in graded)
    return whole and not (out / INCIDENTS).exists()


def _is_settled(report: Report, context: GradingContext, workers: int) -> bool:
    """Tell whether all is known of a file; one that is damaged inside its zip has no bytes."""
    damaged = not report.digest and report.refusal == WhyRefused.DAMAGED
    return damaged or is_found_out(report, context, workers)


def taken_over_next_time(outcome: GradingOutcome) -> GradingOutcome:
    """Return what the next run comes to while nothing changes."""
    taken_over = TakenOver(results=len(outcome.reports), reports=len(outcome.written))
    return replace(outcome, taken_over=taken_over)


def left_over(out: Path, written: Collection[Path]) -> tuple[Path, ...]:
    """Return the reports among the results that this run did not write.

    They stay: somebody may grade one student after the other into the same folder. But who is no
    longer in the batch still has a report there, and nobody should take it for today's.
    """
    found = {*(out / REPORTS).glob("*.pdf"), *out.glob(COHORT_PDF)}
    return tuple(sorted(found - set(written)))


def _discard_unfinished(out: Path) -> None:
    """Remove what a run that was killed left half-written."""
    for name in (GRADES_JSON, GRADES_CSV, FILES_CSV, COHORT_PDF, INCIDENTS):
        discard_unfinished(out / name)


def _told(lost: Lost, of: str) -> str:
    return f"incident {incident_number(lost.trace)}: {of}\n{lost.trace}"


def _with_incident(report: Report, outcome: Lost) -> Report:
    said = message(
        "The report could not be laid out (incident {number}): {reason}",
        number=incident_number(outcome.trace),
        reason=outcome.reason,
    )
    return replace(report, flags=(*report.flags, Flag(FlagCode.REPORT_INCIDENT, said)))
