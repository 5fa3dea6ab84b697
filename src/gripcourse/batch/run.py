"""Grading a whole batch: each file in a worker that may die; none is lost, none a zero."""

import hashlib
import logging
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

from gripcourse.batch.copies import mark_likeness
from gripcourse.batch.doubts import put_in_doubt
from gripcourse.batch.duplicates import mark_doubles
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.batch.one_file import GradingContext, grade_file, handed_in_by
from gripcourse.batch.second_look import made_by_office, needing, needs_second_look
from gripcourse.grading.folded import Derivation, Shelf, folded
from gripcourse.grading.model import Report
from gripcourse.grading.recalculated import not_recalculated_flag
from gripcourse.grading.unjudged import incident_report
from gripcourse.machine.content import NamedBytes, Readable, in_memory, shown_name
from gripcourse.machine.jobs.pools import PROCESSES, Pool
from gripcourse.machine.jobs.workers import Lost, in_order, run_each
from gripcourse.machine.spreadsheet.preflight import LARGEST_FILE
from gripcourse.machine.spreadsheet.refusals import OF_THE_MACHINE
from gripcourse.text.shown import shown

_log = logging.getLogger(__name__)

# A real answer workbook takes 0.02 s and 60 MB; this is for files that are none.
SECONDS_PER_FILE = 30.0
# Files that LibreOffice opens in one call: a start for each hundred costs little, and what it makes
# of ten thousand never lies in memory together.
_OF_OFFICE = 100
# Works that travel in one message: what is done for a message costs a hundredth of judging one.
_TOGETHER = 8

GradeOne: TypeAlias = Callable[[Readable, GradingContext], Report]
"""Grades one file; it must be found by its name in another process."""


@dataclass(frozen=True, slots=True)
class Graded:
    """What a file came to.

    Attributes:
        report: of the file.
        incident: the trace of what failed on our side; empty for nothing.
        taken_over: whether the report was found out by an earlier run.
    """

    report: Report
    incident: str
    taken_over: bool = False


@dataclass(frozen=True, slots=True)
class _Job:
    """What is done with every file; see `grade_files`."""

    context: GradingContext
    grade_one: GradeOne
    wanted: tuple[Derivation[Any], ...]


def grade_files(  # noqa: PLR0913 (the last ones are what everybody leaves as they are)
    files: Sequence[Readable],
    context: GradingContext,
    workers: int,
    on_done: Callable[[Readable], None] = lambda _: None,
    *,
    grade_one: GradeOne = grade_file,
    seconds: float = SECONDS_PER_FILE,
    kept: KeptReports | None = None,
    pool: Pool = PROCESSES,
    wanted: Sequence[Derivation[Any]] = (),
) -> tuple[Graded, ...]:
    """Grade files in parallel; the result is in the order of the files.

    Files are compared with each other each time anew, whatever is known of each.

    Args:
        files: to grade; bytes with their names are files too.
        context: the course, its policy, the register.
        workers: how many processes; 0 for none but this one, see `run_each`.
        on_done: called with each file when it is done.
        grade_one: grades one file.
        seconds: that one file may take.
        kept: what is known of single files from an earlier run, where every new report is kept as
            it comes; None for neither.
        pool: kind of workers.
        wanted: what will be asked of the findings of each, derived where they are made.
    """
    shelf = Shelf(register=context.register)
    known = {} if kept is None else kept.of(files, shelf)
    for number in known:
        on_done(files[number])
    left = [number for number in range(len(files)) if number not in known]
    job = _Job(context, grade_one, tuple(wanted))
    new = _alone([files[number] for number in left], job, workers, on_done,
                 seconds, kept, pool, shelf)  # fmt: skip
    reports = {**known, **dict(zip(left, new, strict=True))}
    graded = (
        _graded(file, reports[number], context, taken_over=number in known)
        for number, file in enumerate(files)
    )
    return compared(tuple(graded), context, kept)


def _alone(  # noqa: PLR0913, PLR0917 (called once)
    files: Sequence[Readable],
    job: _Job,
    workers: int,
    on_done: Callable[[Readable], None],
    seconds: float,
    kept: KeptReports | None,
    pool: Pool,
    shelf: Shelf,
) -> Sequence[Report | Lost]:
    """Grade files, each for itself, and keep each report as soon as nothing is left to find out."""

    def done(number: int) -> None:
        _log.info("graded %s", shown(shown_name(files[number])))
        on_done(files[number])

    jobs = run_each(
        _grade, files, job, workers=workers, seconds=seconds, pool=pool, send=_in_memory,
        together=_TOGETHER,
    )  # fmt: skip
    keeping = _Remembering(job.context, workers, kept, shelf)
    alone = in_order(_kept(jobs, files, keeping), done)
    reports = _looked_at_again(files, alone, job.context, workers, seconds, pool)
    pairs = enumerate(reports)
    again = ((number, report) for number, report in pairs if report is not alone[number])
    held = dict(_kept(again, files, keeping))
    return [held.get(number, report) for number, report in enumerate(reports)]


@dataclass(frozen=True, slots=True)
class _Remembering:
    """What decides over what is kept of a report, and where; see `grade_files`."""

    context: GradingContext
    workers: int
    kept: KeptReports | None
    shelf: Shelf


def _kept(
    jobs: Iterable[tuple[int, Report | Lost]], files: Sequence[Readable], keeping: _Remembering
) -> Iterator[tuple[int, Report | Lost]]:
    """Keep what was found out of files; what failed or needs a second look is tried again."""
    for number, report in jobs:
        if isinstance(report, Lost):
            yield number, report
            continue
        if keeping.kept is not None and is_found_out(report, keeping.context, keeping.workers):
            keeping.kept.keep(files[number], report)
        yield number, keeping.shelf.put(report)


def is_found_out(report: Report, context: GradingContext, workers: int) -> bool:
    """Tell whether all is known of a file: the same bytes need not be looked at again.

    What is refused for its content stays refused; what LibreOffice gave up stays so until there is
    another one. Where the machine may be to blame, the file is looked at again each time.

    Args:
        report: of the file.
        context: that it was graded with.
        workers: how many processes grade; without any no other program is asked.
    """
    if not report.digest or report.refusal in OF_THE_MACHINE:
        return False
    asked = context.office is not None and workers > 0
    return not (asked and needs_second_look(report, recalculate=context.recalculate))


def _in_memory(file: Readable) -> NamedBytes:
    return in_memory(file, LARGEST_FILE)


def _pair_in_memory(pair: tuple[Readable, bytes]) -> tuple[Readable, bytes]:
    return _in_memory(pair[0]), pair[1]


def _looked_at_again(
    files: Sequence[Readable],
    reports: Sequence[Report | Lost],
    context: GradingContext,
    workers: int,
    seconds: float,
    pool: Pool,
) -> Sequence[Report | Lost]:
    """Grade those files again of which LibreOffice could make more; none without workers."""
    if context.office is None or not workers:
        return reports
    numbers = needing(reports, recalculate=context.recalculate)
    again: dict[int, Report | Lost] = {}
    unopened: set[int] = set()
    for start in range(0, len(numbers), _OF_OFFICE):
        portion = {number: files[number] for number in numbers[start : start + _OF_OFFICE]}
        made = made_by_office(portion, reports, context.office, context.course.language)
        unopened |= made.unopened
        pairs = [(portion[number], data) for number, data in made.workbooks.items()]
        jobs = run_each(
            _grade_again,
            pairs,
            context,
            workers=min(workers, len(pairs)),
            seconds=seconds,
            pool=pool,
            send=_pair_in_memory,
        )
        again |= zip(made.workbooks, in_order(jobs), strict=True)
    needed = set(numbers)
    return [
        _second(report, again.get(number), unopened=number in unopened)
        if number in needed
        else report
        for number, report in enumerate(reports)
    ]


def _second(first: Report | Lost, again: Report | Lost | None, *, unopened: bool) -> Report | Lost:
    """Choose the second report of a file, if it has one; note where LibreOffice gave it up.

    What LibreOffice made may be more than a worker can read: that is no fault of the first reading,
    but somebody may have wanted it so.
    """
    if isinstance(again, Report) or not isinstance(first, Report):
        return first if again is None else again
    if unopened:
        first = replace(first, unopened=True)
    if first.unverified:
        return replace(first, flags=(*first.flags, not_recalculated_flag()))
    return first


def compared(
    graded: Sequence[Graded], context: GradingContext, kept: KeptReports | None = None
) -> tuple[Graded, ...]:
    """Flag the files of a batch that belong together or hold another student's numbers.

    Before that, whoever only took a student's name beside the student's own work is nobody.

    What fails on our side while they are compared stands with the first file.
    """
    reports, trace = mark_likeness(
        mark_doubles(put_in_doubt([one.report for one in graded])), context, kept
    )
    incidents = [one.incident for one in graded]
    incidents[:1] = [one + trace for one in incidents[:1]]
    return tuple(
        one
        if one.report is report and one.incident == incident
        else replace(one, report=report, incident=incident)
        for one, report, incident in zip(graded, reports, incidents, strict=True)
    )


def incident_number(trace: str) -> str:
    """Return the number under which a failure is looked up in the log of incidents."""
    return hashlib.sha256(shown(trace).encode()).hexdigest()[:8]


def _grade(file: Readable, job: _Job) -> Report:
    # Folded where it was made: it travels as bytes, and who waits for all has less to do.
    return folded(job.grade_one(file, job.context), job.wanted)


def _grade_again(pair: tuple[Readable, bytes], context: GradingContext) -> Report:
    file, made = pair
    return folded(grade_file(file, context, made))


def _graded(
    file: Readable, report: Report | Lost, context: GradingContext, *, taken_over: bool
) -> Graded:
    if isinstance(report, Lost):
        return _incident(file, context, report.trace)
    # A name need not be text for every system; from here on it is only read by people.
    name = shown(report.file)
    return Graded(report if name == report.file else replace(report, file=name), "", taken_over)


def _incident(source: Readable, context: GradingContext, trace: str) -> Graded:
    number, file = incident_number(trace), shown_name(source)
    handed_in = handed_in_by(file, None, context)
    told = shown(f"incident {number}: {trace}\n{file}\n")
    report = incident_report(shown(file), number, handed_in.issued)
    return Graded(replace(report, known_by=handed_in.known_by), told)
