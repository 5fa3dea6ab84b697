"""What all pages of a server are made from."""

from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Final

from anyio import CapacityLimiter

from gripcourse.machine.jobs.standing import StandingWorkers
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.living import LivingCourse
from gripcourse.web.batch import BatchReader, OwnBatch
from gripcourse.web.checking import shared_with_checkers
from gripcourse.web.queues import Uploads
from gripcourse.web.rates import Counter

_MOST_WAITING: Final = 10  # of the forty threads that answer requests


@dataclass(frozen=True, slots=True, eq=False)
class Site:
    """A server for one course.

    Attributes:
        living: the course and its desk, as its files say now.
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

    living: LivingCourse
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

    @property
    def context(self) -> DeskContext:
        """The course and its desk; another one as soon as somebody saw its files change."""
        return self.living.context

    def look(self) -> None:
        """See whether the files of the course are others, and go on with what they say."""
        self.living.look(lambda now: self.checkers.renew(shared_with_checkers(now)))
