"""Grading a whole batch: each file in a worker that may die; none is lost, none a zero."""

import hashlib
import logging
from array import array
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

from gripcourse.batch.comparing import Comparing
from gripcourse.batch.context import GradingContext, handed_in_by, likely_composition
from gripcourse.batch.doubts import in_doubt
from gripcourse.batch.duplicates import doubles
from gripcourse.batch.graded import Graded, Stated, reports_of, with_reports
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.batch.read_ahead import WorkRead, WorksAhead
from gripcourse.batch.second_look import made_by_office, needs_second_look
from gripcourse.course.composition import Composition
from gripcourse.grading.folded import Derivation, digest_of_report, folded
from gripcourse.grading.model import Report
from gripcourse.grading.recalculated import not_recalculated_flag
from gripcourse.grading.unjudged import incident_report
from gripcourse.machine.content import NamedBytes, Readable, in_memory, shown_name
from gripcourse.machine.jobs.pools import PROCESSES, Pool
from gripcourse.machine.jobs.workers import Lost, in_order, run_each
from gripcourse.machine.shelf import Viewed
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

LineOf: TypeAlias = Callable[[Report], str]
"""Puts a report but for its findings into one line; found by its name in another process."""

GradeOne: TypeAlias = Callable[[Readable, GradingContext], Report]
"""Grades one file; it must be found by its name in another process."""


def _grade_file(source: Readable, context: GradingContext, made: bytes | None = None) -> Report:
    """Grade one file as `one_file.grade_file` does: only who judges imports all that judges."""
    from gripcourse.batch.one_file import grade_file  # noqa: PLC0415 (an eighth of a second)

    return grade_file(source, context, made)


@dataclass(frozen=True, slots=True)
class _Job:
    """What is done with every file; see `grade_files`."""

    context: GradingContext
    grade_one: GradeOne
    wanted: tuple[Derivation[Any], ...]
    line_of: LineOf | None


def grade_files(  # noqa: PLR0913 (the last ones are what everybody leaves as they are)
    files: Sequence[Readable],
    context: GradingContext,
    workers: int,
    on_done: Callable[[Readable], None] = lambda _: None,
    *,
    grade_one: GradeOne = _grade_file,
    seconds: float = SECONDS_PER_FILE,
    kept: KeptReports | None = None,
    pool: Pool = PROCESSES,
    wanted: Sequence[Derivation[Any]] = (),
    line_of: LineOf | None = None,
    ahead: WorksAhead | None = None,
    comparing: Comparing | None = None,
) -> Sequence[Graded]:
    """Grade files in parallel; the result is in the order of the files.

    Files are compared with each other each time anew, whatever is known of each. Of a batch of any
    size few reports are in memory at a time.

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
        line_of: puts each report into a line where it is made; None for nobody.
        ahead: what was read of these files before; None for nothing.
        comparing: begins to compare the files when they are graded, for who does something with
            them meanwhile and enters then what it comes to; None to enter it here.
    """
    job = _Job(context, grade_one, tuple(wanted), line_of)
    here = Comparing(context, kept) if comparing is None else comparing
    grading = _Grading(files, job, workers, seconds, pool, kept, on_done, here, ahead)
    alone = here.batch.filled(len(files), grading.each())
    apart = set_apart(alone.with_changes(grading.again(alone)))
    here.begin(apart)
    return apart if comparing is not None else here.entered(apart)


@dataclass(frozen=True, slots=True)
class _Grading:
    """Grading single files of a batch, each for itself; see `grade_files`.

    Attributes:
        comparing: gets ready to compare the files while workers judge them.
        ahead: what was read of the files before; None for nothing.
        open: places of the files that LibreOffice could make more of.
    """

    files: Sequence[Readable]
    job: _Job
    workers: int
    seconds: float
    pool: Pool
    kept: KeptReports | None
    on_done: Callable[[Readable], None]
    comparing: Comparing
    ahead: WorksAhead | None = None
    open: "array[int]" = field(default_factory=lambda: array("q"))

    def each(self) -> Iterator[tuple[int, Graded]]:
        """Yield what each file comes to, in any order: first what an earlier run found out."""
        is_known = bytearray(len(self.files))
        known = () if self.kept is None else self.kept.of(self.files)
        for number, before in known:
            is_known[number] = True
            yield number, self._graded(number, before, taken_over=True)
            self.on_done(self.files[number])
        left = array("q", (number for number, one in enumerate(is_known) if not one))
        meanwhile = self.comparing.prepared(len(left), self.workers)
        jobs = run_each(
            _grade, Viewed(left, self._work), self.job, workers=self.workers,
            seconds=self.seconds, pool=self.pool, send=_travelling, together=_TOGETHER,
            kind_of=self._kind,
        )  # fmt: skip
        for done, (place, outcome) in enumerate(jobs, start=1):
            number = left[place]
            report, stated = (outcome, None) if isinstance(outcome, Lost) else outcome
            if isinstance(report, Report) and self._can_look_again(report):
                self.open.append(number)
            yield number, self._found(number, report, stated)
            _log.info("graded %s", shown(shown_name(self.files[number])))
            self.on_done(self.files[number])
            if done < len(left):
                next(meanwhile, None)

    def _work(self, number: int) -> Readable | WorkRead:
        return self.files[number] if self.ahead is None else self.ahead.work(number)

    def _kind(self, work: Readable | WorkRead) -> Composition | None:
        file = work.name if isinstance(work, WorkRead) else shown_name(work)
        return likely_composition(file, self.job.context)

    def again(self, alone: Sequence[Graded]) -> Iterator[tuple[int, Graded]]:
        """Grade those files again of which LibreOffice could make more."""
        context, numbers = self.job.context, sorted(self.open)
        for start in range(0, len(numbers), _OF_OFFICE):
            portion = {number: self.files[number] for number in numbers[start : start + _OF_OFFICE]}
            first = {number: alone[number].report for number in portion}
            made = made_by_office(portion, first, context.office or "", context.course.language)
            pairs = [(portion[number], data) for number, data in made.workbooks.items()]
            jobs = run_each(
                _grade_again,
                pairs,
                context,
                workers=min(self.workers, len(pairs)),
                seconds=self.seconds,
                pool=self.pool,
                send=_pair_in_memory,
            )
            found = dict(zip(made.workbooks, in_order(jobs), strict=True))
            for number, before in first.items():
                second = _second(before, found.get(number), unopened=number in made.unopened)
                if second is not before:
                    yield number, self._found(number, second)

    def _can_look_again(self, report: Report) -> bool:
        """Tell whether LibreOffice could make more of a file; nothing can without workers."""
        context = self.job.context
        asked = context.office is not None and self.workers > 0
        return asked and needs_second_look(report, recalculate=context.recalculate)

    def _found(self, number: int, report: Report | Lost, stated: Stated | None = None) -> Graded:
        """Keep what was found out of a file; what failed or needs a second look is tried again."""
        if (
            self.kept is not None
            and isinstance(report, Report)
            and is_found_out(report, self.job.context, self.workers)
        ):
            self.kept.keep(self.files[number], report)
        found = self._graded(number, report, taken_over=False)
        return replace(found, stated=stated) if found.report is report else found

    def _graded(self, number: int, report: Report | Lost, *, taken_over: bool) -> Graded:
        return _graded(self.files[number], report, self.job.context, taken_over=taken_over)


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


def _travelling(work: Readable | WorkRead) -> NamedBytes | WorkRead:
    return work if isinstance(work, WorkRead) else in_memory(work, LARGEST_FILE)


def _pair_in_memory(pair: tuple[Readable, bytes]) -> tuple[Readable, bytes]:
    return in_memory(pair[0], LARGEST_FILE), pair[1]


def _second(first: Report, again: Report | Lost | None, *, unopened: bool) -> Report:
    """Choose the second report of a file, if it has one; note where LibreOffice gave it up.

    What LibreOffice made may be more than a worker can read: that is no fault of the first reading,
    but somebody may have wanted it so.
    """
    if isinstance(again, Report):
        return again
    if unopened:
        first = replace(first, unopened=True)
    if first.unverified:
        return replace(first, flags=(*first.flags, not_recalculated_flag()))
    return first


def compared(
    graded: Sequence[Graded], context: GradingContext, kept: KeptReports | None = None
) -> Sequence[Graded]:
    """Flag the files of a batch that belong together or hold another student's numbers.

    Before that, whoever only took a student's name beside the student's own work is nobody.

    What fails on our side while they are compared stands with the first file.
    """
    comparing, apart = Comparing(context, kept), set_apart(graded)
    comparing.begin(apart)
    return comparing.entered(apart)


def set_apart(graded: Sequence[Graded]) -> Sequence[Graded]:
    """Flag the files of a batch that belong together.

    Before that, whoever only took a student's name beside the student's own work is nobody.
    """
    graded = with_reports(graded, in_doubt(reports_of(graded)))
    return with_reports(graded, doubles(reports_of(graded)))


def incident_number(trace: str) -> str:
    """Return the number under which a failure is looked up in the log of incidents."""
    return hashlib.sha256(shown(trace).encode()).hexdigest()[:8]


def _grade(work: Readable | WorkRead, job: _Job) -> tuple[Report, Stated | None]:
    # Folded where it was made: it travels as bytes, and who waits for all has less to do.
    report = folded(_graded_alone(work, job), job.wanted)
    if job.line_of is None:
        return report, None
    return report, Stated(digest_of_report(report), job.line_of(report))


def _graded_alone(work: Readable | WorkRead, job: _Job) -> Report:
    if not isinstance(work, WorkRead):
        return job.grade_one(work, job.context)
    from gripcourse.batch.one_file import grade_read  # noqa: PLC0415 (as `_grade_file`)

    return grade_read(work.workbook(), work.name, job.context)


def _grade_again(pair: tuple[Readable, bytes], context: GradingContext) -> Report:
    file, made = pair
    return folded(_grade_file(file, context, made))


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
