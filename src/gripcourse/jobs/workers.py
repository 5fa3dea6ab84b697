"""Jobs in processes of their own, bounded in time and memory: one that fails takes none along.

A library below us can hang, swallow memory or abort its process. Each job has a worker with a
memory limit and an alarm; when a worker dies, the few jobs that were on their way to a worker are
done again one by one, and only the one that kills its worker again is lost.
"""

import faulthandler
import os
import re
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
from types import FrameType
from typing import Any, TypeAlias, TypeVar

from gripcourse.jobs.packed import pack, unpack

# Everything that we do with a file or a page takes a tenth of it.
MEMORY_PER_WORKER = 3 * 1024**3

# Jobs handed to the workers at a time: enough to keep them busy, few enough that a worker that
# dies takes few along.
_AHEAD = 2
# An alarm is heard between two steps of Python; who is deep inside a library ends so much later.
_DEAF_SECONDS = 5.0

# Our own errors are whole sentences; the others mean nothing without their names.
_OWN_ERROR = re.compile(r"^gripcourse\.errors\.\w+: ")

Item = TypeVar("Item")
Shared = TypeVar("Shared")
Result = TypeVar("Result")


@dataclass(frozen=True, slots=True)
class Lost:
    """A job that came to nothing on our side; `trace` says why."""

    trace: str

    @property
    def reason(self) -> str:
        """The last line of the trace: what happened, without where."""
        return _OWN_ERROR.sub("", self.trace.strip().rpartition("\n")[2])


_Waiting: TypeAlias = deque[tuple[int, Any]]
_Outcome: TypeAlias = Any | Lost


class _TookTooLongError(BaseException):
    """A job was not done within its time.

    Not an `Exception`: reading a workbook takes every one of these for a fault of the file.
    """


def run_each(
    work: Callable[[Item, Shared], Result],
    items: Sequence[Item],
    shared: Shared,
    *,
    workers: int,
    seconds: float,
) -> Iterator[tuple[int, Result | Lost]]:
    """Do a job with every item, in parallel.

    Args:
        work: does one job; it must be found by its name in another process.
        items: one for each job.
        shared: what every job needs.
        workers: how many processes at most. 0 does it all in this one, where nothing bounds a job's
            time and memory: for callers that may not start processes, and files that are trusted.
        seconds: that one job may take.

    Yields:
        The place of an item in `items` and what it came to, in the order in which jobs are done.
    """
    if workers == 0:
        yield from _in_this_process(work, items, shared)
        return
    packed = pack((work, shared, seconds))
    waiting: _Waiting = deque(enumerate(items))
    while waiting:
        taken_along = []
        for number, outcome in _until_worker_dies(waiting, packed, min(workers, len(waiting))):
            if outcome is None:
                taken_along.append(number)
            else:
                yield number, outcome[0]
        for number in taken_along:
            yield number, _alone(items[number], packed)


def _in_this_process(
    work: Callable[[Item, Shared], Result], items: Sequence[Item], shared: Shared
) -> Iterator[tuple[int, Result | Lost]]:
    for number, item in enumerate(items):
        try:
            done: Result | Lost = work(item, shared)
        except Exception:  # noqa: BLE001 (as in a worker)
            done = Lost(traceback.format_exc())
        yield number, done


def _until_worker_dies(
    waiting: _Waiting, packed: bytes, workers: int
) -> Iterator[tuple[int, tuple[_Outcome] | None]]:
    """Do jobs from the left of `waiting`, until none is left or a worker dies.

    Yields:
        The number of each job that was taken, with what it came to; None for jobs that a worker
        took along.
    """
    with _pool(workers) as pool:
        running: dict[Future[_Outcome], int] = {}
        is_whole = True
        while running or (waiting and is_whole):
            while waiting and is_whole and len(running) < workers * _AHEAD:
                number, item = waiting.popleft()
                try:
                    running[pool.submit(_guarded, item, packed)] = number
                except BrokenProcessPool:
                    is_whole = False
                    yield number, None
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                outcome = _outcome(future)
                is_whole = is_whole and outcome is not None
                yield running.pop(future), outcome


def _guarded(item: object, packed: bytes) -> _Outcome:
    """Do a job in a worker; a failure on our side comes back as its trace."""
    work, shared, seconds = unpack(packed)
    try:
        with _alarm(seconds):
            return work(item, shared)
    except (Exception, _TookTooLongError):  # noqa: BLE001 (ours: one job's, never the batch's)
        return Lost(traceback.format_exc())


def _alone(item: object, packed: bytes) -> _Outcome:
    with _pool(1) as pool:
        outcome = _outcome(pool.submit(_guarded, item, packed))
    return Lost("The process that did this died.\n") if outcome is None else outcome[0]


def _outcome(future: Future[_Outcome]) -> tuple[_Outcome] | None:
    try:
        return (future.result(),)
    except BrokenProcessPool:
        return None


def _pool(workers: int) -> ProcessPoolExecutor:
    # Fresh interpreters: a fork would copy the threads of a progress bar in an unknown state.
    return ProcessPoolExecutor(workers, get_context("spawn"), initializer=_limit_memory)


def _limit_memory() -> None:
    if sys.platform == "linux":
        import resource  # noqa: PLC0415 (exists on Unix only)

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_PER_WORKER, MEMORY_PER_WORKER))


@contextmanager
def _alarm(seconds: float) -> Iterator[None]:
    """Raise in the main thread of this process when the time is over; end it if that is in vain."""

    def ring(_signal: int, _frame: FrameType | None) -> None:
        raise _TookTooLongError(seconds)

    before = signal.signal(signal.SIGALRM, ring)
    with open(os.devnull, "w", encoding="ascii") as nowhere:  # noqa: PTH123 (no Path in os.devnull)
        faulthandler.dump_traceback_later(seconds + _DEAF_SECONDS, exit=True, file=nowhere)
        signal.setitimer(signal.ITIMER_REAL, seconds)
        try:
            yield
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            faulthandler.cancel_dump_traceback_later()
            signal.signal(signal.SIGALRM, before)
