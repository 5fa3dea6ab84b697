"""One job apart from this process, in a worker that waits for the next one.

Starting a process takes longer than reading a file. The worker is kept, and another one takes its
place where it hung, died or grew.
"""

from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from typing import Any, Final, TypeVar

from gripcourse.jobs.limits import Limits, bind_worker, peak_memory
from gripcourse.jobs.lost import Lost
from gripcourse.jobs.work import Task, do

Item = TypeVar("Item")
Shared = TypeVar("Shared")
Result = TypeVar("Result")

_GROWN: Final = 256 * 1024**2  # bytes that a worker has had at most, where it is kept

# All workers are started by one thread that lives as long as this process: Linux ends a worker
# with the thread that started it, and the threads of a server come and go.
_KEEPER: Final = ThreadPoolExecutor(1, "keeper of warm workers")
# What is kept between two calls: one worker for each set of limits; only the keeper touches it.
_WARM: Final[dict[Limits, Executor]] = {}


def do_apart(
    work: Callable[[Item, Shared], Result],
    item: Item,
    shared: Shared,
    *,
    limits: Limits,
    seconds: float,
) -> Result | Lost:
    """Do one job in a worker that is bounded; nothing that happens there happens here.

    Args:
        work: does the job; found by its name in another process.
        item: what it is done with.
        shared: what else it needs; small, since it is sent each time.
        limits: of the worker; `Limits.processor` bounds its time too.
        seconds: that the job may take by the clock.
    """
    return _KEEPER.submit(_done, Task(work, shared, seconds, limits), item, limits).result()


def _done(task: Task, item: object, limits: Limits) -> Any | Lost:  # noqa: ANN401 (whatever it returns)
    """Do a job; once more where the worker had died of something else before."""
    for fresh in (limits not in _WARM, True):
        worker = _WARM.get(limits) or _WARM.setdefault(limits, _worker(limits))
        try:
            outcome, grown = worker.submit(_measured, task, item).result()
        except BrokenExecutor:
            _dismiss(limits)
            if fresh:
                break
        else:
            if grown > _GROWN:
                _dismiss(limits)
            return outcome
    return Lost("The worker that did this died, or did not end in time.\n")


def _worker(limits: Limits) -> Executor:
    return ProcessPoolExecutor(1, get_context("spawn"), bind_worker, (limits,))


def _dismiss(limits: Limits) -> None:
    _WARM.pop(limits).shutdown(wait=False)


def _measured(task: Task, item: object) -> tuple[Any | Lost, int]:
    outcome = do(task, item)
    return outcome, peak_memory()
