"""Workers that stay between jobs, for who has to answer at once.

A batch opens its workers and lets them go; a server would let every visitor wait for a new process
that first unpacks the course.
"""

import threading
import uuid
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.pools import NOT_STARTED, PROCESSES, Executing, Pool
from gripcourse.machine.jobs.work import Task, do, install, perform
from gripcourse.machine.jobs.workers import run_each


class StandingWorkers:
    """Workers for one task, bounded like those of a batch; they may be asked from any thread.

    Attributes:
        task: what is done with each item.
        workers: how many processes.
        pool: whose memory is apart; None for none: each job in the thread that asks, unbounded.
    """

    def __init__(
        self,
        work: Callable[[Any, Any], Any],
        shared: object,
        *,
        workers: int,
        seconds: float,
        pool: Pool | None = PROCESSES,
    ) -> None:
        limits = None if pool is None else pool.limits
        self.task = Task(work, shared, seconds, limits)
        self.workers = workers
        self.pool = pool
        self._name = uuid.uuid4().hex
        self._lock = threading.Lock()
        self._opened: Executing | None = None
        # A worker ends with the thread that started it, and threads that answer requests come and
        # go: one that stays starts them all.
        self._keeper = ThreadPoolExecutor(1, "keeper")
        self._alone = threading.BoundedSemaphore(max(1, workers))

    def do(self, item: object) -> Any | Lost:  # noqa: ANN401 (whatever the work returns)
        """Do a job and wait for it; what fails on our side is `Lost`."""
        if self.pool is None:
            return do(self.task, item)
        executor = self._executor(self.pool)
        try:
            return self._keeper.submit(executor.submit, perform, self._name, item).result().result()
        except (*NOT_STARTED, RuntimeError):
            # A worker died, of this job or of a neighbour's, and all that were opened with it are
            # of no use. Alone it is found out whose job it was.
            self._discard(executor)
        # All that waited for it come here at once: no more processes than there are workers.
        with self._alone:
            jobs = run_each(
                self.task.work,
                [item],
                self.task.shared,
                workers=1,
                seconds=self.task.seconds,
                pool=self.pool,
            )
            ((_, outcome),) = jobs
        return outcome

    def renew(self, shared: object) -> None:
        """Let the jobs that are asked for from now on share something else.

        What is being done is done to its end, by what it began with.
        """
        with self._lock:
            self.task = replace(self.task, shared=shared)
            opened, self._opened = self._opened, None
        if opened is not None:
            opened.shutdown(wait=False)

    def close(self) -> None:
        """Let the workers go."""
        with self._lock:
            opened, self._opened = self._opened, None
        if opened is not None:
            opened.shutdown(cancel_futures=True)
        self._keeper.shutdown()

    def _executor(self, pool: Pool) -> Executing:
        with self._lock:
            if self._opened is None:
                first = (self._name, pool.packed(self.task), pool.limits)
                self._opened = pool.open(self.workers, install, first)
            return self._opened

    def _discard(self, executor: Executing) -> None:
        with self._lock:
            if self._opened is executor:
                self._opened = None
        executor.shutdown(wait=False, cancel_futures=True)
