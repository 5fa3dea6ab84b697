"""Jobs in workers, bounded in time and memory: one that fails takes none along.

A library below us can hang, swallow memory or abort its process. When a worker dies, its executor
is of no use any more: the few jobs that were on their way to a worker are done again one by one,
and only the one that ends its worker again is lost. Where no worker can even start, all are lost.
"""

import pickle
import uuid
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from dataclasses import dataclass, replace
from typing import Any, TypeAlias, TypeVar

from gripcourse.machine.jobs.child import DIED
from gripcourse.machine.jobs.lanes import JobsLeft, KindOf
from gripcourse.machine.jobs.lost import JobLostError, Lost
from gripcourse.machine.jobs.parcel import Packed
from gripcourse.machine.jobs.pools import NOT_STARTED, PROCESSES, Executing, Pool
from gripcourse.machine.jobs.work import Task, do, install, known, perform, perform_all

__all__ = ["Lost", "all_done", "in_order", "run_each"]

# Jobs handed to the workers at a time: enough to keep them busy, few enough that a worker that
# dies takes few along.
_AHEAD = 2
# Bytes that travel in one message, where it brings several jobs: what waits takes room.
_MESSAGE = 1024**2

Item = TypeVar("Item")
Shared = TypeVar("Shared")
Result = TypeVar("Result")

_Done: TypeAlias = Iterator[tuple[int, Any]]


@dataclass(frozen=True, slots=True)
class _Crew:
    """Workers that can be opened again and again for one task, which they know by its name.

    Attributes:
        pool: kind of workers.
        name, packed: the task; None where workers know what this process knows.
        send: returns what travels of an item.
        together: how many jobs one message may bring.
        kind_of: jobs of a kind are for the same worker; None for all alike.
    """

    pool: Pool
    name: str
    packed: Packed | None
    send: Callable[[Any], Any]
    together: int
    kind_of: KindOf | None = None

    def lanes(self, workers: int) -> int:
        """Return how many of so many workers are given jobs by name: each of them, or none."""
        return max(1, workers) if self.pool.addressed and self.kind_of is not None else 1

    def open(self, workers: int) -> Executing:
        """Open an executor whose workers know the task."""
        first = (self.name, self.packed, self.pool.limits)
        return self.pool.open(workers, install if self.pool.apart else _nothing, first)


def _as_it_is(item: Item) -> Item:
    return item


def run_each(  # noqa: PLR0913 (the last ones are what nearly everybody leaves as they are)
    work: Callable[[Item, Shared], Result],
    items: Sequence[Item],
    shared: Shared,
    *,
    workers: int,
    seconds: float,
    pool: Pool | None = PROCESSES,
    send: Callable[[Item], Item] = _as_it_is,
    together: int = 1,
    kind_of: KindOf | None = None,
) -> Generator[tuple[int, Result | Lost], None, None]:
    """Do a job with every item, in parallel.

    Args:
        work: does one job; with workers apart it must be found by its name in another process.
        items: one for each job; asked for when its turn comes, and again where a worker dies.
        shared: what every job needs; it is sent to each worker once.
        workers: how many at most; 0 for none: here, one after the other, nothing bounded, for who
            may not start processes and trusts what it has.
        seconds: that one job may take, where workers are bounded.
        pool: kind of workers; None for none.
        send: makes of an item what a worker can use that shares no disk with this process; where it
            raises `OSError`, the job is done by a process of this machine at the end.
        together: how many jobs one message to a worker may bring, while many are left; for jobs so
            short that messages count. Each job has its own bounds all the same.
        kind_of: tells jobs of which kind a worker makes something once, for the same worker to do
            them one after the other; None where they are all alike. Not asked without workers.

    Yields:
        The place of an item in `items` and what it came to, in the order in which jobs are done;
        `in_order` sorts them.
    """
    if pool is None or workers == 0:
        task = Task(work, shared, seconds, None)
        yield from ((number, do(task, item)) for number, item in enumerate(items))
        return
    task = Task(work, shared, seconds, pool.limits)
    name = uuid.uuid4().hex
    if not pool.apart:
        with known(name, task):
            yield from _each(items, _Crew(pool, name, None, _as_it_is, 1), workers, [])
        return
    stay: list[int] = []
    travels = _as_it_is if pool.shares_disk else send
    crew = _Crew(pool, name, pool.packed(task), travels, together, kind_of)
    yield from _each(items, crew, workers, stay)
    if stay:
        here = run_each(work, [items[one] for one in stay], shared, workers=1, seconds=seconds)
        yield from ((stay[place], outcome) for place, outcome in here)


def in_order(
    jobs: Iterable[tuple[int, Result]], on_done: Callable[[int], None] = lambda _: None
) -> tuple[Result, ...]:
    """Return what jobs came to, in the order of their items.

    Args:
        jobs: as `run_each` yields them.
        on_done: called with the place of each item as its job is done.
    """
    done: dict[int, Result] = {}
    for number, outcome in jobs:
        done[number] = outcome
        on_done(number)
    return tuple(done[number] for number in sorted(done))


def all_done(jobs: Iterable[tuple[int, Result | Lost]]) -> Iterator[tuple[int, Result]]:
    """Yield what jobs came to, where nothing is worth having without all of them.

    Raises:
        JobLostError: a job came to nothing; its text is the trace.
    """
    for number, outcome in jobs:
        if isinstance(outcome, Lost):
            raise JobLostError(outcome.trace)
        yield number, outcome


def _each(items: Sequence[Any], crew: _Crew, workers: int, stay: list[int]) -> _Done:
    """Do all jobs but those whose items cannot travel: their numbers are added to `stay`."""
    count = min(workers, len(items))
    waiting = JobsLeft.of(items, range(len(items)), crew.kind_of, crew.lanes(count))
    while waiting:
        # Who was taken along when a worker died may be the one that it died of.
        suspects, has_started = yield from _until_worker_dies(
            waiting, crew, count, count * _AHEAD, stay
        )
        if suspects and not has_started and not _can_start(crew):
            lost = Lost("No worker could start; what it wrote to its error output says why.\n")
            left = sorted((*suspects, *waiting.left()))
            yield from ((number, lost) for number in left)
            return
        alone = JobsLeft.of(items, sorted(suspects))
        while alone:
            single = replace(crew, together=1, kind_of=None)
            lost_alone, _ = yield from _until_worker_dies(alone, single, 1, 1, stay)
            yield from ((number, Lost(DIED)) for number in lost_alone)


def _until_worker_dies(
    waiting: JobsLeft, crew: _Crew, workers: int, ahead: int, stay: list[int]
) -> Generator[tuple[int, Any], None, tuple[list[int], bool]]:
    """Do jobs that wait, until none is left or a worker dies.

    Yields:
        The number of each job that was done, with what it came to.

    Returns:
        The numbers of the jobs that a worker took along, and whether a worker did any job.
    """
    lanes = len(waiting.lanes)
    executors = [crew.open(workers // lanes) for _ in range(lanes)]
    taken_along: list[int] = []
    has_started = False
    running: dict[Future[Any], _Message] = {}
    try:
        while running or (waiting and not taken_along):
            for lane, executor in enumerate(executors):
                busy = sum(message.lane == lane for message in running.values())
                while waiting and not taken_along and busy < ahead // lanes:
                    message = _next_message(waiting, crew, lane, ahead, stay)
                    if not message.numbers:
                        continue
                    try:
                        running[executor.submit(*message.call)] = message
                    except NOT_STARTED:
                        taken_along += message.numbers
                    busy += 1
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                message = running.pop(future)
                try:
                    outcomes = message.outcomes(future.result())
                except BrokenExecutor:
                    taken_along += message.numbers
                else:
                    has_started = True
                    yield from zip(message.numbers, outcomes, strict=True)
    finally:
        for executor in executors:
            executor.shutdown(cancel_futures=True)
    return taken_along, has_started


@dataclass(frozen=True, slots=True)
class _Message:
    """What is sent to a worker at a time.

    Attributes:
        numbers: of the jobs; none where no item could travel.
        lane: whose jobs they were.
        call: what the worker does, with its arguments.
        several: whether it answers with a tuple, one outcome for each job.
    """

    numbers: tuple[int, ...]
    lane: int
    call: tuple[Any, ...]
    several: bool

    def outcomes(self, answer: Any) -> tuple[Any, ...]:  # noqa: ANN401 (whatever the jobs came to)
        """Return what each job came to."""
        return answer if self.several else (answer,)


def _next_message(
    waiting: JobsLeft, crew: _Crew, lane: int, ahead: int, stay: list[int]
) -> _Message:
    """Take jobs that wait: the fewer are left, the fewer go together.

    So no worker has much to do when the others have nothing any more.
    """
    most = min(crew.together, max(1, len(waiting) // (2 * ahead)))
    found: dict[int, Any] = {}
    size = 0
    while waiting and len(found) < most and size < _MESSAGE:
        number, item = waiting.take(lane)
        try:
            sent = crew.send(item)
        except OSError:
            stay.append(number)
            continue
        found[number] = sent if most == 1 else pickle.dumps(sent)
        size += 0 if most == 1 else len(found[number])
    numbers = tuple(found)
    if most == 1:
        return _Message(numbers, lane, (perform, crew.name, *found.values()), several=False)
    call = perform_all, crew.name, tuple(found.values())
    return _Message(numbers, lane, call, several=True)


def _can_start(crew: _Crew) -> bool:
    """Tell whether a worker that is given nothing to do lives."""
    executor = crew.open(1)
    try:
        executor.submit(_nothing).result()
    except NOT_STARTED:
        return False
    finally:
        executor.shutdown(cancel_futures=True)
    return True


def _nothing(*_: object) -> None:
    """Begin without anything: a thread knows what this process knows."""
