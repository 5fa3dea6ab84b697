"""What a worker process may take: memory, time, and no longer a life than who started it.

Memory is bounded where the system can (Linux, other Unix systems by their own limits); where it
cannot, `memory_notice` says so. Time is bounded everywhere: an alarm that Python hears, and behind
it a watchdog outside of Python that ends the process.
"""

import faulthandler
import math
import multiprocessing
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing.process import BaseProcess
from pathlib import Path
from types import FrameType

from gripcourse.machine.jobs.room import start_if_there_is_room
from gripcourse.text.words import Message, message

_MEBIBYTE = 1024**2
_SET_PARENT_DEATH_SIGNAL = 1  # PR_SET_PDEATHSIG of Linux
_ABANDONED = 1  # exit code of a worker whose parent is gone


@dataclass(frozen=True, slots=True)
class Limits:
    """What one worker may take.

    Attributes:
        memory: bytes of address space; what we do with a file or a page takes a tenth of it.
        grace: seconds after the time of a job until its process is ended. An alarm is heard between
            two steps of Python; who is deep inside a library does not hear it.
        processor: seconds of processor time that a job may take, whatever else the machine does
            meanwhile; None for no other bound than that by the clock.
        writes: whether it may write files.
    """

    memory: int = 3 * 1024**3
    grace: float = 5.0
    processor: float | None = None
    writes: bool = True


class TookTooLongError(BaseException):
    """A job was not done within its time.

    Not an `Exception`: reading a workbook takes every one of these for a fault of the file.
    """


def bind_worker(limits: Limits) -> None:
    """Bound the memory of this worker process, and its life by that of its parent."""
    _die_with_parent()
    if sys.platform != "win32":
        import resource  # noqa: PLC0415 (exists on Unix only)

        if not limits.writes:
            # Python ignores the signal that comes with it: writing a file is a plain error.
            _lower(resource.RLIMIT_FSIZE, 0)
        _, hard = resource.getrlimit(resource.RLIMIT_AS)
        wanted = min(limits.memory, system_memory_limit() or limits.memory)
        try:
            resource.setrlimit(resource.RLIMIT_AS, (wanted, hard))
        except (OSError, ValueError):
            # macOS knows the limit and does not keep it; `memory_notice` has said so.
            return


def limits_of_system() -> Mapping[int, int]:
    """Return how far the system lets this process go now, by the numbers of limits that are set.

    A process that was started earlier, by which workers are started, may be allowed more.
    """
    if sys.platform == "win32":
        return {}
    import resource  # noqa: PLC0415 (exists on Unix only)

    kinds = (resource.RLIMIT_AS, resource.RLIMIT_DATA, resource.RLIMIT_FSIZE, resource.RLIMIT_CPU)
    found = {kind: resource.getrlimit(kind)[0] for kind in kinds}
    return {kind: soft for kind, soft in found.items() if soft != resource.RLIM_INFINITY}


def keep_within(found: Mapping[int, int]) -> None:
    """Let this process go no further than another one may."""
    for kind, soft in found.items():
        _lower(kind, soft)


def system_memory_limit() -> int | None:
    """Return how many bytes of address space the system gives a process; None for no limit."""
    if sys.platform == "win32":
        return None
    import resource  # noqa: PLC0415 (exists on Unix only)

    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    set_ones = [one for one in (soft, hard) if one != resource.RLIM_INFINITY]
    return min(set_ones, default=None)


def memory_notice(limits: Limits, platform: str = sys.platform) -> Message | None:
    """Say what a person should know of the memory of workers; None where all is as it should be.

    Args:
        limits: that workers get.
        platform: as `sys.platform` names it.
    """
    if platform != "linux":
        return message(
            "This system does not bound the memory of a worker: a file that takes too much of it"
            " can slow down the whole machine."
        )
    found = system_memory_limit()
    if found is None or found >= limits.memory:
        return None
    return message(
        "The system gives a process {found} MB of memory, fewer than the {wanted} MB of a worker:"
        " its limit counts, and large files may fail.",
        found=found // _MEBIBYTE,
        wanted=limits.memory // _MEBIBYTE,
    )


def peak_memory(process: int | None = None) -> int:
    """Return how many bytes of memory a process has had at most; 0 where nobody counts.

    On Linux `getrusage` counts what the process that started it had, too.

    Args:
        process: number of one that runs; None for this one.
    """
    if sys.platform == "linux":
        with suppress(OSError, StopIteration):
            status = Path(f"/proc/{process or 'self'}/status")
            lines = status.read_text(encoding="ascii", errors="replace")
            peak = next(line for line in lines.splitlines() if line.startswith("VmHWM:"))
            return int(peak.split()[1]) * 1024
    return 0


def _lower(kind: int, wanted: int) -> None:
    """Lower a soft limit of this process; what the system bounds more stays."""
    import resource  # noqa: PLC0415 (exists on Unix only)

    soft, hard = resource.getrlimit(kind)
    bounds = [one for one in (soft, hard) if one != resource.RLIM_INFINITY]
    resource.setrlimit(kind, (min([wanted, *bounds]), hard))


@contextmanager
def time_limit(seconds: float, grace: float, processor: float | None = None) -> Iterator[None]:
    """Bound what happens inside, in the main thread of a worker process.

    Where the system has an alarm, it raises when the time is over and the worker goes on with other
    jobs; a worker that does not hear it, or a system without one, ends with the process.

    Raises:
        TookTooLongError: the time is over.
    """
    with open(os.devnull, "w", encoding="ascii") as nowhere:  # noqa: PTH123 (no Path in os.devnull)
        # A thread that needs nothing of Python, on every system.
        faulthandler.dump_traceback_later(seconds + grace, exit=True, file=nowhere)
        try:
            with _alarm(seconds), _processor_limit(processor, grace):
                yield
        finally:
            faulthandler.cancel_dump_traceback_later()


@contextmanager
def _alarm(seconds: float) -> Iterator[None]:
    if sys.platform == "win32":
        yield
        return

    def ring(_signal: int, _frame: FrameType | None) -> None:
        raise TookTooLongError(seconds)

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


@contextmanager
def _processor_limit(seconds: float | None, grace: float) -> Iterator[None]:
    """Bound processor time: a signal that Python hears, behind it the system that ends us."""
    if seconds is None or sys.platform == "win32":
        yield
        return
    import resource  # noqa: PLC0415 (exists on Unix only)

    def ring(_signal: int, _frame: FrameType | None) -> None:
        raise TookTooLongError(seconds)

    soft, hard = resource.getrlimit(resource.RLIMIT_CPU)
    before = signal.signal(signal.SIGPROF, ring)
    _lower(resource.RLIMIT_CPU, math.ceil(time.process_time() + seconds + grace))
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
        resource.setrlimit(resource.RLIMIT_CPU, (soft, hard))


def _die_with_parent() -> None:
    """End this process as soon as the one that started it is gone, however that ended.

    A thread waits for the parent's end of a pipe to close, on every system. It cannot run while a
    library holds Python's lock, so that on Linux the kernel is asked as well.
    """
    parent = multiprocessing.parent_process()
    if parent is not None:
        start_if_there_is_room(threading.Thread(target=_end_after, args=(parent,), daemon=True))
    if sys.platform == "linux":
        import ctypes  # noqa: PLC0415 (for this alone)

        ctypes.CDLL(None).prctl(_SET_PARENT_DEATH_SIGNAL, signal.SIGKILL)


def _end_after(parent: BaseProcess) -> None:
    parent.join()
    os._exit(_ABANDONED)
