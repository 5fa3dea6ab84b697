"""One job apart from this process, in a worker that waits for the next one.

Starting a process takes longer than reading a file. The worker is kept, and another one takes its
place where it hung, died or grew. Unlike the workers of `run_each` it never runs the program that
asks again: a script of somebody who has not heard of that may read a table.
"""

import atexit
import pickle
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, Final, TypeVar

from gripcourse.machine.jobs.child import DIED, GROWN, NOT_ANSWERED, ask, end, start
from gripcourse.machine.jobs.limits import Limits, limits_of_system
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.work import Task

if TYPE_CHECKING:
    import subprocess

Item = TypeVar("Item")
Shared = TypeVar("Shared")
Result = TypeVar("Result")

# All workers are started by one thread that lives as long as this process: Linux ends a worker
# with the thread that started it, and the threads of a server come and go.
_KEEPER: Final = ThreadPoolExecutor(1, "keeper of warm workers")
_TO_GET_READY: Final = 10.0  # seconds
# What is kept between two calls: one worker for each set of limits, with what the system allowed
# this process when it was started; only the keeper touches it.
_WARM: Final[dict[Limits, tuple["subprocess.Popen[bytes]", Mapping[int, int]]]] = {}


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
    return begin_apart(work, item, shared, limits=limits, seconds=seconds)()


def begin_apart(
    work: Callable[[Item, Shared], Result],
    item: Item,
    shared: Shared,
    *,
    limits: Limits,
    seconds: float,
) -> Callable[[], Result | Lost]:
    """Begin a job as `do_apart` does it; return what waits for its end."""
    packed = pickle.dumps((Task(work, shared, seconds, limits), item))
    return _KEEPER.submit(_done, packed, limits, seconds + limits.grace).result


def start_early(work: Callable[[None, None], object], limits: Limits) -> None:
    """Start the worker that `do_apart` will ask, while this process does something else.

    Args:
        work: makes it ready: what it has imported, jobs need not wait for.
        limits: of the worker.
    """
    packed = pickle.dumps((Task(work, None, _TO_GET_READY, limits), None))
    _KEEPER.submit(_done, packed, limits, _TO_GET_READY + limits.grace)


def _done(packed: bytes, limits: Limits, seconds: float) -> Any | Lost:  # noqa: ANN401 (whatever it returns)
    """Do a job; once more where the worker had died of something else before."""
    allowed = limits_of_system()
    if limits in _WARM and _WARM[limits][1] != allowed:
        _dismiss(limits)
    tries = 2 if limits in _WARM else 1
    for _ in range(tries):
        worker, *_ = _WARM.get(limits) or _WARM.setdefault(limits, (start(limits), allowed))
        try:
            outcome, grown = ask(worker, packed, seconds)
        except NOT_ANSWERED:
            _dismiss(limits)
        else:
            if grown > GROWN:
                _dismiss(limits)
            return outcome
    return Lost(DIED)


def _dismiss(limits: Limits) -> None:
    worker, _ = _WARM.pop(limits)
    end(worker)


@atexit.register
def _dismiss_all() -> None:
    for limits in tuple(_WARM):
        _dismiss(limits)
