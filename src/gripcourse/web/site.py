"""What all pages of a server are made from."""

from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Final

from anyio import CapacityLimiter

from gripcourse.machine.jobs.standing import StandingWorkers
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.web.batch import BatchReader, OwnBatch
from gripcourse.web.queues import Uploads
from gripcourse.web.rates import Counter

_MOST_WAITING: Final = 10  # of the forty threads that answer requests


@dataclass(frozen=True, slots=True, eq=False)
class Site:
    """A server for one course.

    Attributes:
        context: the course and its desk.
        checkers: workers that read what students upload.
        clock: the time with its zone.
        assignments: the folder that issuing wrote; None where sheets are handed out otherwise.
        graded: the folder that grading writes, which may be published; None for none.
        secure: whether browsers reach it by https alone.
        counter: of what is done how often.
        batches: what was graded last, read when it changed.
        own_batch: what this server itself began to grade.
        waiting: how many may wait for a worker at once; who hands in never stands behind them.
        uploads: files that are on their way.
    """

    context: DeskContext
    checkers: StandingWorkers
    clock: Callable[[], datetime]
    assignments: Path | None = None
    graded: Path | None = None
    secure: bool = False
    counter: Counter = field(default_factory=Counter)
    batches: BatchReader = field(default_factory=BatchReader)
    own_batch: OwnBatch = field(default_factory=OwnBatch)
    waiting: CapacityLimiter = field(default_factory=lambda: CapacityLimiter(_MOST_WAITING))
    uploads: Uploads = field(default_factory=Uploads)
