"""Grading a whole batch: in processes of their own, bounded in time and memory, none lost.

A spreadsheet can make a parser hang, swallow memory or abort its process. Each file is graded in a
worker with a memory limit and an alarm; when a worker dies, the files that it took along are graded
again one by one, and only the one that kills its worker again is set aside for a person.
"""

import hashlib
import signal
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass, replace
from multiprocessing import get_context
from pathlib import Path
from types import FrameType

from gripcourse.cohort.one import Desk, grade_file
from gripcourse.grading.identify import submitter
from gripcourse.grading.model import Flag, Report
from gripcourse.grading.unjudged import incident_report
from gripcourse.words import message

# A real answer workbook takes 0.02 s and 60 MB; these are for files that are none.
SECONDS_PER_FILE = 30
MEMORY_PER_WORKER = 3 * 1024**3


@dataclass(frozen=True, slots=True)
class Graded:
    """A report, and the trace of what failed on our side (empty for nothing)."""

    report: Report
    incident: str


class _TookTooLongError(Exception):
    """A file was not graded within its time."""


def grade_files(
    files: Sequence[Path],
    desk: Desk,
    workers: int,
    on_done: Callable[[Path], None] = lambda _: None,
) -> tuple[Graded, ...]:
    """Grade files in parallel; the result is in the order of the files.

    Args:
        files: to grade.
        desk: the course, its policy, the register.
        workers: how many processes.
        on_done: called with each file when it is done.
    """
    done: dict[Path, Graded] = {}
    lost: list[Path] = []
    with _pool(workers) as pool:
        futures = {pool.submit(grade_guarded, file, desk): file for file in files}
        for future in as_completed(futures):
            file = futures[future]
            graded = _result(future)
            if graded is None:
                lost.append(file)
            else:
                done[file] = graded
                on_done(file)
    for file in lost:
        done[file] = _grade_alone(file, desk)
        on_done(file)
    return tuple(_mark_doubles([done[file] for file in files]))


def grade_guarded(file: Path, desk: Desk) -> Graded:
    """Grade a file; a failure on our side becomes an incident with its trace."""
    try:
        with _alarm(SECONDS_PER_FILE):
            return Graded(grade_file(file, desk), "")
    except Exception:  # noqa: BLE001 (ours: recorded, never counted against the student)
        return _incident(file, desk, traceback.format_exc())


def _grade_alone(file: Path, desk: Desk) -> Graded:
    with _pool(1) as pool:
        graded = _result(pool.submit(grade_guarded, file, desk))
    return graded or _incident(file, desk, f"{file}: the process that graded the file died\n")


def _result(future: Future[Graded]) -> Graded | None:
    try:
        return future.result()
    except BrokenProcessPool:
        return None


def _incident(file: Path, desk: Desk, trace: str) -> Graded:
    number = hashlib.sha256(trace.encode()).hexdigest()[:8]
    issued = submitter(str(file), "", desk.register)
    return Graded(incident_report(str(file), number, issued), f"incident {number}: {trace}")


def _pool(workers: int) -> ProcessPoolExecutor:
    # Fresh interpreters: a fork would copy the threads of a progress bar in an unknown state.
    return ProcessPoolExecutor(workers, get_context("spawn"), initializer=_limit_memory)


def _limit_memory() -> None:
    if sys.platform == "linux":
        import resource  # noqa: PLC0415 (exists on Unix only)

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_PER_WORKER, MEMORY_PER_WORKER))


@contextmanager
def _alarm(seconds: int) -> Iterator[None]:
    """Raise in the main thread of this process when the time is over."""

    def ring(_signal: int, _frame: FrameType | None) -> None:
        raise _TookTooLongError(seconds)

    before = signal.signal(signal.SIGALRM, ring)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def _mark_doubles(graded: Sequence[Graded]) -> Iterator[Graded]:
    """Flag several files of one student, and equal bytes from several students."""
    for one in graded:
        others = [other.report for other in graded if other is not one and other.report.student]
        flags = tuple(_double_flags(one.report, others))
        yield replace(one, report=replace(one.report, flags=(*one.report.flags, *flags)))


def _double_flags(report: Report, others: Sequence[Report]) -> Iterator[Flag]:
    same_student = [other.file for other in others if other.student == report.student]
    if report.student and same_student:
        yield Flag(
            "several_files",
            message("The student handed in more files: {files}.", files=", ".join(same_student)),
        )
    same_bytes = [
        other.student
        for other in others
        if report.digest and other.digest == report.digest and other.student != report.student
    ]
    if same_bytes:
        yield Flag(
            "same_bytes",
            message("The same file came from: {students}.", students=", ".join(same_bytes)),
        )
