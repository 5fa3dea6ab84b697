"""A worker's side: what all jobs need comes once, each job then brings only its own item."""

import pickle
import signal
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType
from typing import Any, TypeAlias

from gripcourse.machine.jobs.limits import Limits, TookTooLongError, bind_worker, time_limit
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.parcel import Packed
from gripcourse.machine.process_wide import collect_rarely


@dataclass(frozen=True, slots=True)
class Task:
    """What is done with every item.

    Attributes:
        work: does one job; found by its name in another process.
        shared: what every job needs.
        seconds: that one job may take.
        limits: of the worker; None where it cannot be bounded.
    """

    work: Callable[[Any, Any], Any]
    shared: Any
    seconds: float
    limits: Limits | None


_Known: TypeAlias = dict[str, Task | Lost]

# The one thing that a worker remembers between jobs: an executor hands a job nothing but its own
# arguments, and a course takes longer to send and unpack than a workbook to read.
_KNOWN: _Known = {}


def install(name: str, packed: Packed, limits: Limits | None) -> None:
    """Make a worker ready: bound it and unpack the task; what fails is said by each job."""
    try:
        # What jobs share and what is made of it once live as long as the worker.
        collect_rarely()
        if limits is not None:
            bind_worker(limits)
        _KNOWN[name] = packed.unpacked()
    except (Exception, SystemExit):  # noqa: BLE001 (a worker that cannot start comes again and again)
        _KNOWN[name] = Lost(traceback.format_exc())


@contextmanager
def known(name: str, task: Task) -> Iterator[None]:
    """Let jobs of this process know a task while they are done."""
    _KNOWN[name] = task
    try:
        yield
    finally:
        del _KNOWN[name]


def perform(name: str, item: object) -> Any | Lost:  # noqa: ANN401 (whatever the work returns)
    """Do a job of a task that is known here."""
    task = _KNOWN[name]
    return task if isinstance(task, Lost) else do(task, item)


def perform_all(name: str, packed: tuple[bytes, ...]) -> tuple[Any | Lost, ...]:
    """Do several jobs of a task, each with its own bounds; their items come packed."""
    return tuple(perform(name, pickle.loads(one)) for one in packed)  # noqa: S301 (packed by the program that started this)


def hear_in_job(number: int, frame: FrameType | None) -> None:
    """Let Ctrl-C end the job in hand; between jobs there is nothing to end.

    It comes to all processes of a terminal. The one that was called answers for it, and lets its
    workers go; a worker that was interrupted while it waits would only write where from.
    """
    while frame is not None:
        if frame.f_code is do.__code__:
            signal.default_int_handler(number, frame)
        frame = frame.f_back


def do(task: Task, item: object) -> Any | Lost:  # noqa: ANN401 (as above)
    """Do a job; a failure on our side comes back as its trace."""
    try:
        if task.limits is None:
            return task.work(item, task.shared)
        with time_limit(task.seconds, task.limits.grace, task.limits.processor):
            return task.work(item, task.shared)
    except (Exception, SystemExit, TookTooLongError):  # noqa: BLE001 (one job's, never the batch's)
        return Lost(traceback.format_exc())
