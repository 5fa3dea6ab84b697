"""Reports of a batch: each laid out in a worker that may die, each written as it comes."""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import date
from pathlib import Path
from typing import TypeAlias

from gripcourse.course.model import Course
from gripcourse.documents.look import Look, look_of, with_look
from gripcourse.documents.report.totals import is_counting, peers_text
from gripcourse.grading.known_by import KnownBy
from gripcourse.grading.model import Report
from gripcourse.machine.alone import writing_into
from gripcourse.machine.enclosed import file_below
from gripcourse.machine.files import discard_all_unfinished, make_private_folder, write_bytes
from gripcourse.machine.jobs.pools import PROCESSES, Pool
from gripcourse.machine.jobs.workers import Lost, run_each
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Words
from gripcourse.usecases.grading.points_told import points_told
from gripcourse.usecases.grading.unchanged import PrintedBefore, told_of

# A report takes about a second, a hundred times as much is no report any more.
SECONDS_PER_REPORT = 120.0


@dataclass(frozen=True, slots=True)
class Printing:
    """What all reports of a batch are laid out with.

    Attributes:
        course, policy: printed in the reports.
        graded_on: the day that is printed.
        seconds: that one report may take.
        peers: shares of the points that the judged works of the batch earned.
        look: of the course, for workers that share no disk with it; None for the course's folder.
        declared: by fingerprint, other declarations that works were judged by.
    """

    course: Course
    policy: Policy
    graded_on: date
    seconds: float = SECONDS_PER_REPORT
    peers: tuple[float, ...] = ()
    look: Look | None = None
    declared: Mapping[str, Course] = field(default_factory=dict)


LayOut: TypeAlias = Callable[[Report, Printing], bytes]
"""Lays out one student's report; it must be found by its name in another process."""


@dataclass(frozen=True, slots=True)
class AsItWas:
    """A report that an earlier run wrote and that would come out the same."""

    path: Path


Written: TypeAlias = Path | AsItWas | Lost | None
"""What became of a report: written, left as it was, failed on our side, or for nobody."""


def student_pdf(report: Report, printing: Printing) -> bytes:
    """Lay out one student's report, in the student's language."""
    from gripcourse.documents.report.student import student_report  # noqa: PLC0415 (WeasyPrint, 450 ms)

    course = printing.declared.get(report.declarations, printing.course)
    words = Words(report.language or course.language)
    plan = plan_of(course, report.composition)
    policy, day, peers = printing.policy, printing.graded_on, printing.peers
    return student_report(report, plan, policy, course, words, day, peers=peers)


def cohort_pdf(reports: Sequence[Report], printing: Printing) -> bytes:
    """Lay out the report on a whole batch, in the language of the course."""
    from gripcourse.documents.report.cohort import cohort_report  # noqa: PLC0415 (matplotlib, 400 ms)

    course = printing.course
    words = Words(course.language)
    return cohort_report(reports, printing.policy, course, words, printing.graded_on)


def write_reports(  # noqa: PLR0913 (the last ones are what everybody leaves as they are)
    reports: Sequence[Report],
    printing: Printing,
    folder: Path,
    workers: int,
    on_done: Callable[[Path], None],
    lay_out: LayOut = student_pdf,
    *,
    printed: PrintedBefore | None = None,
    pool: Pool = PROCESSES,
) -> list[Written]:
    """Write the report of every file whose student is known.

    Each file appears whole or not at all. Where a report cannot be laid out, what an earlier run
    wrote for the same student is taken away: it would say something else than the grades.

    Args:
        reports: of the batch.
        printing: what they are laid out with.
        folder: to write to.
        workers: how many processes.
        on_done: called with each graded file.
        lay_out: lays out one report.
        printed: what earlier runs wrote, to leave those reports as they are that would come out the
            same; None to write all.
        pool: kind of workers.

    Returns:
        For each report the file that was written or left as it was, what failed on our side, or
        None where there is nobody to write to.

    Raises:
        OSError: the folder cannot be written.
    """
    make_private_folder(folder)
    with writing_into(folder) as alone:
        if alone:
            discard_all_unfinished(folder)
        paths = _paths(reports, folder)
        made_from = [_made_from(one, printing) if printed else "" for one in reports]
        outcomes: list[Written] = [
            AsItWas(path) if printed and path and printed.stands(path, told) else None
            for path, told in zip(paths, made_from, strict=True)
        ]
        to_do = [number for number, path in enumerate(paths) if path and outcomes[number] is None]
        for number in sorted(set(range(len(reports))) - set(to_do)):
            on_done(Path(reports[number].file))
        travels = printing if pool.shares_disk else replace(printing, look=look_of(printing.course))
        shared, items = (lay_out, travels), [reports[number] for number in to_do]
        jobs = run_each(
            _lay_out, items, shared, workers=workers, seconds=printing.seconds, pool=pool
        )
        for place, pdf in jobs:
            number = to_do[place]
            outcomes[number] = _keep(pdf, paths[number])
            if printed and isinstance(pdf, bytes) and (path := paths[number]):
                printed.note(path, made_from[number], _points(reports[number], printing))
            on_done(Path(reports[number].file))
        return outcomes


def _made_from(report: Report, printing: Printing) -> str:
    """Tell what of this batch a report is made from; `PrintedBefore` knows the rest."""
    words = Words(report.language or printing.course.language)
    return told_of((report, peers_text(report, printing.policy, words, printing.peers)))


def _points(report: Report, printing: Printing) -> str:
    return points_told(report, Words(report.language or printing.course.language))


def _lay_out(report: Report, shared: tuple[LayOut, Printing]) -> bytes:
    lay_out, printing = shared
    if printing.look is not None:
        look = printing.look
        declared = {name: with_look(one, look) for name, one in printing.declared.items()}
        course = with_look(printing.course, look)
        printing = replace(printing, course=course, declared=declared)
    return lay_out(report, printing)


def _keep(pdf: bytes | Lost, path: Path | None) -> Path | Lost | None:
    if path is None:
        return None
    if isinstance(pdf, Lost):
        path.unlink(missing_ok=True)
        return pdf
    write_bytes(path, pdf, private=True)
    return path


def _paths(reports: Sequence[Report], folder: Path) -> list[Path | None]:
    """Name each report after its student; a second file of a student gets a number.

    The work that counts comes first, then the surest file of a student: nobody's file takes the
    name of another's report.
    """
    paths: list[Path | None] = [None] * len(reports)
    named: Counter[str] = Counter()
    for number in sorted(range(len(reports)), key=lambda one: _certainty(reports[one])):
        report = reports[number]
        if report.scheme:
            named[report.student] += 1
            suffix = f"-{named[report.student]}" if named[report.student] > 1 else ""
            paths[number] = file_below(folder, f"{report.student}{suffix}.pdf")
    return paths


def _certainty(report: Report) -> tuple[bool, bool, int]:
    return not is_counting(report), not report.judged, tuple(KnownBy).index(report.known_by)
