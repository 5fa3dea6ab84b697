"""What is done in a worker: what students upload is never opened by the server itself."""

from dataclasses import dataclass
from typing import Final

from gripcourse.api.make_results import check_result, refused_check
from gripcourse.api.results import CheckResult
from gripcourse.course.model import Course
from gripcourse.errors import UsageError
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.jobs.pools import PROCESSES, Pool
from gripcourse.machine.jobs.standing import StandingWorkers
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.grading.check import check_both_ways
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.web.pictures import PaintedPage, picture_of

SECONDS: Final = 20.0
"""A workbook takes a tenth of a second; what preflight lets through takes two."""


@dataclass(frozen=True, slots=True)
class CheckJob:
    """What is checked: the file, the ids of who asks, and the reader's language."""

    file: NamedBytes
    ids: frozenset[str]
    language: str


@dataclass(frozen=True, slots=True)
class CheckedBothWays:
    """What a worker found out; who asked it counts, and shows one of the two.

    Attributes:
        reading: how the answers were read, or why the file is refused.
        told: all that the policy may tell; None where that is no more.
        compares: whether that tells of any numbers that they fit each other, or do not.
    """

    reading: CheckResult
    told: CheckResult | None
    compares: bool


@dataclass(frozen=True, slots=True)
class PaintJob:
    """A drawing of which a page is to be seen."""

    file: NamedBytes
    page: int


def work(job: CheckJob | PaintJob, shared: tuple[Course, Policy]) -> CheckedBothWays | PaintedPage:
    """Do what is asked of a worker of the server."""
    if isinstance(job, PaintJob):
        return picture_of(job.file.data, job.file.name, job.page)
    return check(job, shared)


def check(job: CheckJob, shared: tuple[Course, Policy]) -> CheckedBothWays:
    """Check a workbook; a file that cannot be used is said in the result."""
    course, policy = shared
    words = Words(job.language)
    try:
        reading, told = check_both_ways(job.file, course, policy, job.ids)
    except UsageError as refused:
        return CheckedBothWays(refused_check(refused.problems, words), None, compares=False)
    return CheckedBothWays(
        reading=check_result(reading, words),
        told=None if told is None else check_result(told, words),
        compares=told is not None and told.compares,
    )


def make_checkers(
    context: DeskContext, workers: int, pool: Pool | None = PROCESSES
) -> StandingWorkers:
    """Make the workers of a server; see `StandingWorkers`."""
    shared = shared_with_checkers(context)
    return StandingWorkers(work, shared, workers=workers, seconds=SECONDS, pool=pool)


def shared_with_checkers(context: DeskContext) -> tuple[Course, Policy]:
    """Return what the workers of a server know of its course."""
    return context.course, context.policy
