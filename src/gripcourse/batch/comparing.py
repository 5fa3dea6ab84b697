"""Comparing the works of a batch by a process of its own, while this one does something with them.

A cohort is compared when its last work is judged, and then one processor would be busy with that
and the others with nothing. A process that has got ready meanwhile looks at the works where they
lie, on the shelf of this one; what it comes to is entered when it is wanted. Where there is no such
process, or it dies, all is compared here: what comes out is the same.
"""

from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import Final

from gripcourse.batch.context import GradingContext
from gripcourse.batch.copies import Alike, like_others, solve_ahead, with_alike
from gripcourse.batch.graded import Graded, on_a_shelf, reports_of
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.pools import FORKED, NOT_STARTED
from gripcourse.machine.jobs.standing import StandingWorkers
from gripcourse.machine.shelf import Places, Shelved

# From so many works on a process is worth its start.
_WORTH: Final = 200
_SECONDS: Final = 30.0
# Many times what it takes: what hangs is compared here.
_SECONDS_PER_WORK: Final = 0.01


@dataclass(slots=True)
class Comparing:
    """A batch that is compared, or will be.

    Attributes:
        context: the course, its policy, the register.
        kept: what an earlier run found out; None for nothing.
        batch: nothing yet, on the shelf where the works will lie.
        apart: whether another process may compare them.
        compared: the works; None while they are judged.
    """

    context: GradingContext
    kept: KeptReports | None = None
    apart: bool = False
    batch: Shelved[Graded] = field(default_factory=on_a_shelf)
    compared: Sequence[Graded] | None = None
    _other: "_Other | None" = None

    def prepared(self, works: int, workers: int) -> Iterator[None]:
        """Get ready while works are judged.

        Args:
            works: how many there are.
            workers: how many processes judge them; where one has all to do, none is beside it.

        Yields:
            After each part of what this process has to do for it.
        """
        if self.apart and FORKED and workers > 1 and works >= _WORTH:
            seconds = _SECONDS + works * _SECONDS_PER_WORK
            # What is kept of single works stays with who keeps it.
            kept = None if self.kept is None else replace(self.kept, written=[])
            self._other = _Other.of(_Task(self.context, kept, self.batch), seconds)
        elif self.kept is not None:
            yield from solve_ahead(self.context, self.kept)

    def begin(self, graded: Sequence[Graded]) -> None:
        """Begin to compare works that lie on the shelf of this batch."""
        self.compared = graded
        if self._other is not None and isinstance(graded, Shelved):
            self._other.begin(graded.places)

    def entered(self, graded: Sequence[Graded]) -> Sequence[Graded]:
        """Return the batch, as it is now, with what comparing it came to."""
        works = graded if self.compared is None else self.compared
        alike = None if self._other is None else self._other.found()
        if alike is None:
            alike = like_others(works, self.context, self.kept)
        return with_alike(graded, alike, reports_of(works))

    def close(self) -> None:
        """Let the other process go."""
        if self._other is not None:
            self._other.close()


@contextmanager
def comparing_apart(context: GradingContext, kept: KeptReports | None) -> Iterator[Comparing]:
    """Let another process compare a batch, where that is worth it; see `Comparing`."""
    comparing = Comparing(context, kept, apart=True)
    try:
        yield comparing
    finally:
        comparing.close()


@dataclass(frozen=True, slots=True)
class _Task:
    """What the other process knows from its start on."""

    context: GradingContext
    kept: KeptReports | None
    batch: Shelved[Graded]


@dataclass(slots=True)
class _Other:
    """The other process, and a thread that waits for it."""

    process: StandingWorkers
    thread: ThreadPoolExecutor
    answer: "Future[Alike | Lost | None] | None" = None

    @classmethod
    def of(cls, task: _Task, seconds: float) -> "_Other | None":
        """Start it; None where there is no room for it."""
        process = StandingWorkers(_compared, task, workers=1, seconds=seconds)
        found = cls(process, ThreadPoolExecutor(1, "comparing"))
        try:
            found.thread.submit(process.do, None)
        except RuntimeError:  # no room for a thread
            found.close()
            return None
        return found

    def begin(self, places: Places) -> None:
        """Let it compare what lies at these places, and then go."""
        self.answer = self.thread.submit(self.process.do, places)
        self.thread.submit(self.process.close)

    def found(self) -> Alike | None:
        """Wait for what it found; None where it found nothing out."""
        try:
            alike = None if self.answer is None else self.answer.result()
        except (*NOT_STARTED, MemoryError):  # the system has no room for it
            return None
        return None if isinstance(alike, Lost) else alike

    def close(self) -> None:
        """Let it go."""
        self.thread.shutdown(cancel_futures=True)
        self.process.close()


def _compared(places: Places | None, task: _Task) -> Alike | None:
    """Compare works; without any get ready for that."""
    if places is None:
        if task.kept is not None:
            deque(solve_ahead(task.context, task.kept), maxlen=0)
        return None
    return like_others(task.batch.at(places), task.context, task.kept)
