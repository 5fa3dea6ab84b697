"""Kinds of workers that jobs can be given to: the port between our jobs and who does them.

A pool is opened as the executors of `concurrent.futures` are: so many workers, and what each of
them does first. Another kind of workers, on other machines for example, is another `Pool`; nobody
who has jobs to do has to know.
"""

import os
import pickle
import sys
import weakref
from collections.abc import Callable
from concurrent.futures import (
    BrokenExecutor,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
)
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.context import BaseContext
from multiprocessing.shared_memory import SharedMemory
from typing import Any, Final, Protocol, TypeAlias

from gripcourse.machine.file_limits import demand_file_of
from gripcourse.machine.jobs.limits import Limits, keep_within, limits_of_system
from gripcourse.machine.jobs.room import demand_room

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

_MOST_ON_WINDOWS = 61  # handles that it can wait for at a time


@dataclass(frozen=True, slots=True)
class Pool:
    """A kind of workers.

    Attributes:
        open: opens an executor.
        apart: whether workers have a memory of their own, so that what jobs need must be sent.
        limits: of each worker; None where a worker cannot be bounded, as a thread.
        shares_disk: whether workers see the files that this process sees.
    """

    open: OpenExecutor
    apart: bool
    limits: Limits | None
    shares_disk: bool = True


def _processes(workers: int, first: Initializer, arguments: tuple[Any, ...]) -> Executor:
    demand_room()
    most = _MOST_ON_WINDOWS if sys.platform == "win32" else workers
    # What a worker is started with goes through a pipe that nobody empties if it ends too early:
    # more than fits in there would be waited for in vain.
    packed = pickle.dumps((dict(os.environ), limits_of_system(), first, arguments))
    demand_file_of(len(packed))
    memory = SharedMemory(create=True, size=len(packed))
    _content(memory)[: len(packed)] = packed
    executor = ProcessPoolExecutor(
        min(workers, most), _context(), _begin, (memory.name, len(packed))
    )
    weakref.finalize(executor, _give_back, memory)
    return executor


def _context() -> BaseContext:
    """Return how workers are started: as fresh interpreters, or from one on Linux.

    A fork of this process would copy the threads of a progress bar in an unknown state. On Linux
    workers are forks of a fresh interpreter that has no threads, and has imported what this process
    has by then: half a second less for each worker.
    """
    if sys.platform != "linux":
        return get_context("spawn")
    from multiprocessing.forkserver import ensure_running  # noqa: PLC0415 (exists on Unix only)

    context = get_context("forkserver")
    ours = __name__.partition(".")[0]
    context.set_forkserver_preload([one for one in sys.modules if one.partition(".")[0] == ours])
    try:
        ensure_running()
    except OSError:  # it needs a place for temporary files, whose path is not too long
        return get_context("spawn")
    return context


def _begin(name: str, size: int) -> None:
    """Fetch what a worker does first, in the worker, and do it."""
    memory = SharedMemory(name)
    packed = bytes(_content(memory)[:size])
    memory.close()
    environment, allowed, first, arguments = pickle.loads(packed)  # noqa: S301 (packed by who started this)
    # What it is a fork of may have been started in another one, and with other limits.
    keep_within(allowed)
    os.environ.clear()
    os.environ.update(environment)
    first(*arguments)


def _content(memory: SharedMemory) -> memoryview:
    content = memory.buf
    if content is None:
        raise ValueError(memory.name)  # it was closed
    return content


def _give_back(memory: SharedMemory) -> None:
    memory.close()
    memory.unlink()


def _threads(workers: int, first: Initializer, arguments: tuple[Any, ...]) -> Executor:
    return ThreadPoolExecutor(workers, "job", first, arguments)


PROCESSES: Final = Pool(_processes, apart=True, limits=Limits())
"""A process for each worker: a job can take down only its own."""

THREADS: Final = Pool(_threads, apart=False, limits=None)
"""Threads of this process: nothing is bounded; for work that is trusted, and for tests."""

INLINE: Final = None
"""No workers: one job after the other, here; nothing is bounded and a debugger sees all."""


def pool_for(workers: int) -> Pool | None:
    """Return where to do trusted work: one worker needs no process of its own."""
    return INLINE if workers == 1 else PROCESSES
