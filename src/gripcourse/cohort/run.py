"""Grading a whole batch: in processes of their own, bounded in time and memory, none lost.

A spreadsheet can make a parser hang, swallow memory or abort its process. Each file is graded in a
worker with a memory limit and an alarm; when a worker dies, the few files that were on their way to
a worker are graded again one by one, and only the one that kills its worker again is set aside for
a person.
"""

import hashlib
import signal
import sys
import traceback
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from types import FrameType
from typing import TypeAlias

from gripcourse.cohort.alike import mark_likeness
from gripcourse.cohort.doubles import mark_doubles
from gripcourse.cohort.one import Desk, grade_file
from gripcourse.cohort.packed import pack, unpack
from gripcourse.grading.identify import submitter
from gripcourse.grading.model import Report
from gripcourse.grading.unjudged import incident_report

# A real answer workbook takes 0.02 s and 60 MB; these are for files that are none.
SECONDS_PER_FILE = 30.0
MEMORY_PER_WORKER = 3 * 1024**3

# Files handed to the workers at a time: enough to keep them busy, few enough that a worker that
# dies takes few along.
_AHEAD = 2

GradeOne: TypeAlias = Callable[[Path, Desk], Report]
"""Grades one file; it must be found by its name in another process."""


@dataclass(frozen=True, slots=True)
class Graded:
    """A report, and the trace of what failed on our side (empty for nothing)."""

    report: Report
    incident: str


@dataclass(frozen=True, slots=True)
class _Job:
    """What is done with every file."""

    desk: Desk
    grade_one: GradeOne
    seconds: float


class _TookTooLongError(BaseException):
    """A file was not graded within its time.

    Not an `Exception`: reading a workbook takes every one of these for a fault of the file.
    """


def grade_files(
    files: Sequence[Path],
    desk: Desk,
    workers: int,
    on_done: Callable[[Path], None] = lambda _: None,
    *,
    grade_one: GradeOne = grade_file,
    seconds: float = SECONDS_PER_FILE,
) -> tuple[Graded, ...]:
    """Grade files in parallel; the result is in the order of the files.

    Args:
        files: to grade.
        desk: the course, its policy, the register.
        workers: how many processes.
        on_done: called with each file when it is done.
        grade_one: grades one file.
        seconds: that one file may take.
    """
    job = _Job(desk, grade_one, seconds)
    done: dict[Path, Graded] = {}
    waiting = deque(files)
    packed = pack(job)
    while waiting:
        lost = []
        for file, graded in _until_worker_dies(waiting, packed, workers):
            if graded is None:
                lost.append(file)
                continue
            done[file] = graded
            on_done(file)
        for file in lost:
            done[file] = _grade_alone(file, job)
            on_done(file)
    reports, trace = mark_likeness(mark_doubles([done[file].report for file in files]), desk)
    incidents = [done[file].incident for file in files]
    incidents[:1] = [one + trace for one in incidents[:1]]
    return tuple(map(Graded, reports, incidents))


def _until_worker_dies(
    waiting: deque[Path], packed: bytes, workers: int
) -> Iterator[tuple[Path, Graded | None]]:
    """Grade files from the left of `waiting`, until none is left or a worker dies.

    Yields:
        Each file that was taken, with what it came to; None for files that a worker took along.
    """
    with _pool(workers) as pool:
        running: dict[Future[Graded], Path] = {}
        is_whole = True
        while running or (waiting and is_whole):
            while waiting and is_whole and len(running) < workers * _AHEAD:
                file = waiting.popleft()
                try:
                    running[pool.submit(_grade_guarded, file, packed)] = file
                except BrokenProcessPool:
                    is_whole = False
                    yield file, None
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                graded = _result(future)
                is_whole = is_whole and graded is not None
                yield running.pop(future), graded


def _grade_guarded(file: Path, packed: bytes) -> Graded:
    """Grade a file; a failure on our side becomes an incident with its trace."""
    job: _Job = unpack(packed)
    try:
        with _alarm(job.seconds):
            return Graded(job.grade_one(file, job.desk), "")
    except (Exception, _TookTooLongError):  # noqa: BLE001 (ours: never counted against the student)
        return _incident(file, job.desk, traceback.format_exc())


def _grade_alone(file: Path, job: _Job) -> Graded:
    with _pool(1) as pool:
        graded = _result(pool.submit(_grade_guarded, file, pack(job)))
    return graded or _incident(file, job.desk, f"{file}: the process that graded the file died\n")


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
def _alarm(seconds: float) -> Iterator[None]:
    """Raise in the main thread of this process when the time is over."""

    def ring(_signal: int, _frame: FrameType | None) -> None:
        raise _TookTooLongError(seconds)

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
