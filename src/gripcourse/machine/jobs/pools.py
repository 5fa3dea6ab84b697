"""Kinds of workers that jobs can be given to: the port between our jobs and who does them.

A pool is opened as the executors of `concurrent.futures` are: so many workers, and what each of
them does first. Another kind of workers, on other machines for example, is another `Pool`; nobody
who has jobs to do has to know.
"""

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import (
    BrokenExecutor,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
)
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.context import BaseContext
from typing import Any, Final, Protocol, TypeAlias

from gripcourse.machine.jobs.limits import Limits, keep_within, limits_of_system
from gripcourse.machine.jobs.parcel import Packed, PackedBytes, packed_for_workers
from gripcourse.machine.jobs.room import demand_room
from gripcourse.machine.jobs.work import hear_in_job
from gripcourse.machine.process_wide import import_nothing_from_here, importing_nothing_from_here

Initializer: TypeAlias = Callable[..., None]


class Executing(Protocol):
    """What we need of an executor."""

    def submit(self, call: Callable[..., Any], /, *arguments: Any) -> Future[Any]:  # noqa: ANN401 (of any job)
        """Give a job to a worker."""

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:  # noqa: FBT001, FBT002 (as in `Executor`)
        """Let the workers go."""


OpenExecutor: TypeAlias = Callable[[int, Initializer, tuple[Any, ...]], Executing]
"""Opens an executor: number of workers, what each does first, the arguments of that."""

NOT_STARTED: Final = (BrokenExecutor, OSError, EOFError)
"""What giving a job to a worker raises where workers have died, or what they are forks of has."""

FORKED: Final = sys.platform == "linux"
"""Whether workers of this machine are forks, which begin at once."""

_MOST_ON_WINDOWS = 61  # handles that it can wait for at a time


@dataclass(frozen=True, slots=True)
class Pool:
    """A kind of workers.

    Attributes:
        open: opens an executor.
        apart: whether workers have a memory of their own, so that what jobs need must be sent.
        limits: of each worker; None where a worker cannot be bounded, as a thread.
        shares_disk: whether workers see the files that this process sees.
        addressed: whether each worker can be opened for itself, so that a job is given to a certain
            one.
    """

    open: OpenExecutor
    apart: bool
    limits: Limits | None
    shares_disk: bool = True
    addressed: bool = False

    def packed(self, value: object) -> Packed:
        """Pack what all jobs need, as it travels to these workers.

        Raises:
            OSError: the system has no room for it.
        """
        return packed_for_workers(value) if self.shares_disk else PackedBytes.of(value)


def _processes(workers: int, first: Initializer, arguments: tuple[Any, ...]) -> Executor:
    demand_room()
    most = _MOST_ON_WINDOWS if sys.platform == "win32" else workers
    is_deaf = signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    packed = packed_for_workers((dict(os.environ), limits_of_system(), is_deaf))
    return ProcessPoolExecutor(min(workers, most), _context(), _begin, (packed, first, arguments))


def foresee_processes(*modules: str) -> None:
    """Let what workers will be forks of begin while this process is still getting ready.

    It takes half a second of another processor; where workers are no forks nothing happens.

    Args:
        modules: of this program, by their full names, that workers will need; with these come all
            that they import.
    """
    _context(*modules)


def _context(*modules: str) -> BaseContext:
    """Return how workers are started: as fresh interpreters, or from one on Linux.

    A fork of this process would copy the threads of a progress bar in an unknown state. On Linux
    workers are forks of a fresh interpreter that has no threads, and has imported some modules and
    what this process has by then: half a second less for each worker.
    """
    if not FORKED:
        return _spawning()
    from multiprocessing.forkserver import ensure_running  # noqa: PLC0415 (exists on Unix only)

    context = get_context("forkserver")
    ours = __name__.partition(".")[0]
    imported = [one for one in sys.modules if one.partition(".")[0] == ours]
    context.set_forkserver_preload([*modules, *imported])
    try:
        with _deaf_to_interrupts(), importing_nothing_from_here():
            ensure_running()
    except OSError:  # it needs a place for temporary files, whose path is not too long
        return _spawning()
    return context


def _spawning() -> BaseContext:
    # Each worker is started whenever a job needs one: there is no moment to put it back.
    import_nothing_from_here()
    return get_context("spawn")


@contextmanager
def _deaf_to_interrupts() -> Iterator[None]:
    """Let what is started meanwhile ignore Ctrl-C: this process hears it, and ends the other."""
    before = signal.getsignal(signal.SIGINT)
    if before is None or threading.current_thread() is not threading.main_thread():
        yield
        return
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _begin(packed: Packed, first: Initializer, arguments: tuple[Any, ...]) -> None:
    """Take over what this process has, in the worker, and do what it does first."""
    environment, allowed, is_deaf = packed.unpacked()
    # What it is a fork of may have been started in another one, with other limits, and is deaf.
    signal.signal(signal.SIGINT, signal.SIG_IGN if is_deaf else hear_in_job)
    keep_within(allowed)
    os.environ.clear()
    os.environ.update(environment)
    first(*arguments)


def _threads(workers: int, first: Initializer, arguments: tuple[Any, ...]) -> Executor:
    return ThreadPoolExecutor(workers, "job", first, arguments)


PROCESSES: Final = Pool(_processes, apart=True, limits=Limits(), addressed=True)
"""A process for each worker: a job can take down only its own."""

THREADS: Final = Pool(_threads, apart=False, limits=None)
"""Threads of this process: nothing is bounded; for work that is trusted, and for tests."""

INLINE: Final = None
"""No workers: one job after the other, here; nothing is bounded and a debugger sees all."""


def pool_for(workers: int) -> Pool | None:
    """Return where to do trusted work: one worker needs no process of its own."""
    return INLINE if workers == 1 else PROCESSES
