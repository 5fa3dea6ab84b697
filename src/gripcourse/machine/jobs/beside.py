"""One long job in a process of its own, beside what this process does, which may let it go.

Workers of a batch finish the job in hand before they go. Where one takes minutes, whoever asks the
program to end would wait for it.
"""

import pickle
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, TypeVar

from gripcourse.machine.jobs.child import DIED, NOT_ANSWERED, ask, end, start
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.work import Task

if TYPE_CHECKING:
    from subprocess import Popen

Item = TypeVar("Item")
Shared = TypeVar("Shared")
Result = TypeVar("Result")


@contextmanager
def done_beside(
    work: Callable[[Item, Shared], Result],
    item: Item,
    shared: Shared,
    *,
    limits: Limits,
    seconds: float,
) -> Iterator[Callable[[], Result | Lost]]:
    """Do a job while something else is done; leaving ends it, however far it has come.

    Args:
        work: does the job; found by its name in another process.
        item: what it is done with.
        shared: what else it needs.
        limits: of the process.
        seconds: that the job may take.

    Yields:
        What waits for the job and returns what it came to; what fails on our side is `Lost`.

    Raises:
        OSError: the system has no room for another process.
    """
    packed = pickle.dumps((Task(work, shared, seconds, limits), item))
    child = start(limits)
    thread = ThreadPoolExecutor(1, "beside")
    try:
        yield thread.submit(_answer, child, packed, seconds + limits.grace).result
    finally:
        # Without it the thread gets no answer and ends too.
        end(child)
        thread.shutdown()


def _answer(child: "Popen[bytes]", packed: bytes, seconds: float) -> Any | Lost:  # noqa: ANN401 (whatever the job came to)
    try:
        outcome, _ = ask(child, packed, seconds)
    except NOT_ANSWERED:
        return Lost(DIED)
    return outcome
