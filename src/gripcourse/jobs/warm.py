"""One job apart from this process, in a worker that waits for the next one.

Starting a process takes longer than reading a file. The worker is kept, and another one takes its
place where it hung, died or grew. Unlike the workers of `run_each` it never runs the program that
asks again: a script of somebody who has not heard of that may read a table.
"""

import atexit
import pickle
import subprocess
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Final, TypeVar

from gripcourse.jobs.limits import Limits
from gripcourse.jobs.lost import Lost
from gripcourse.jobs.work import Task

Item = TypeVar("Item")
Shared = TypeVar("Shared")
Result = TypeVar("Result")

_GROWN: Final = 256 * 1024**2  # bytes that a worker has had at most, where it is kept
_TO_START: Final = 60.0  # seconds, on a machine that is busy
_BEGIN: Final = (
    "import pickle, sys; sys.path[:] = pickle.load(sys.stdin.buffer);"
    "from gripcourse.jobs.servant import serve; serve()"
)

# All workers are started by one thread that lives as long as this process: Linux ends a worker
# with the thread that started it, and the threads of a server come and go.
_KEEPER: Final = ThreadPoolExecutor(1, "keeper of warm workers")
# What is kept between two calls: one worker for each set of limits; only the keeper touches it.
_WARM: Final[dict[Limits, "subprocess.Popen[bytes]"]] = {}


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
    packed = pickle.dumps((Task(work, shared, seconds, limits), item))
    return _KEEPER.submit(_done, packed, limits, seconds + limits.grace).result()


def _done(packed: bytes, limits: Limits, seconds: float) -> Any | Lost:  # noqa: ANN401 (whatever it returns)
    """Do a job; once more where the worker had died of something else before."""
    tries = 2 if limits in _WARM else 1
    for _ in range(tries):
        worker = _WARM.get(limits) or _WARM.setdefault(limits, _started(limits))
        try:
            outcome, grown = _answered(worker, packed, seconds)
        except (OSError, EOFError, pickle.UnpicklingError):
            _dismiss(limits)
        else:
            if grown > _GROWN:
                _dismiss(limits)
            return outcome
    return Lost("The worker that did this died, or did not end in time.\n")


def _started(limits: Limits) -> "subprocess.Popen[bytes]":
    worker = subprocess.Popen(  # noqa: S603 (this very program)
        [sys.executable, "-c", _BEGIN],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    _send(worker, pickle.dumps(sys.path) + pickle.dumps(limits))
    return worker


def _answered(worker: "subprocess.Popen[bytes]", packed: bytes, seconds: float) -> tuple[Any, int]:
    """Send a job and wait; the worker ends itself in time, and where it cannot, it is ended."""
    end = threading.Timer(_TO_START + seconds, worker.kill)
    end.daemon = True
    end.start()
    try:
        _send(worker, packed)
        if worker.stdout is None:  # pragma: no cover (for the types)
            raise EOFError
        outcome, grown = pickle.load(worker.stdout)  # noqa: S301 (our own program)
    finally:
        end.cancel()
    return outcome, grown


def _send(worker: "subprocess.Popen[bytes]", packed: bytes) -> None:
    if worker.stdin is not None:
        worker.stdin.write(packed)
        worker.stdin.flush()


def _dismiss(limits: Limits) -> None:
    worker = _WARM.pop(limits)
    worker.kill()
    worker.wait()
    for pipe in (worker.stdin, worker.stdout):
        if pipe is not None:
            try:
                pipe.close()
            except OSError:  # what it never read
                continue


@atexit.register
def _dismiss_all() -> None:
    for limits in tuple(_WARM):
        _dismiss(limits)
