"""Taking somebody out of the register, as a program asks for it."""

from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.api.course import Course
from gripcourse.api.refusals import refusals_said
from gripcourse.api.sources import place_of

if TYPE_CHECKING:
    from gripcourse.issuing.withdrawal import Join

# Every call imports what it needs itself, as in `api.course`.
# ruff: noqa: PLC0415


@dataclass(frozen=True, slots=True)
class WithdrawResult:
    """What a withdrawal, or taking one back, comes to.

    Attributes:
        notes: what it comes to, and what is left to do, in the language of the course.
        disputed: quantities that were marked by hand, otherwise, under both ids: somebody should
            mark them again.
        told_twice: whether results were published under both ids that differ: somebody should look
            which of the works counts.
    """

    notes: tuple[str, ...]
    disputed: tuple[str, ...]
    told_twice: bool = False


@refusals_said
def withdraw(  # noqa: PLR0913 (the last ones are for those who need them)
    course: Course,
    student: str,
    *,
    by: str,
    why: str,
    same_as: str = "",
    undo: bool = False,
    gradebook: str | Path | None = None,
) -> WithdrawResult:
    """Take somebody out of the course, or join two entries of one person; nothing is removed.

    Args:
        course: that issued to them.
        student: whose entry of the register.
        by: who does it.
        why: the reason, kept for good.
        same_as: the entry that the person keeps; empty for who left the course.
        undo: whether the last withdrawal of the student is taken back instead.
        gradebook: path or database URL; None for the course's own.

    Raises:
        GripcourseError: with everything that is wrong with it; nothing was kept.
    """
    from gripcourse.issuing.withdrawal import Withdrawal
    from gripcourse.machine.database.home import home_of
    from gripcourse.usecases.marks.withdraw import withdraw as enter

    place = home_of(course.root) if gradebook is None else place_of(gradebook)
    done = enter(Withdrawal(student, same_as, undo, why, by, datetime.now(UTC)), course.root, place)
    said = tuple(map(course.words.say, done.notes))
    return WithdrawResult(said, done.disputed, done.told_twice)


def joins_said_by(course: Course | None) -> "tuple[Join, ...]":
    """Return which ids of a course stand for one person; none where no course is named.

    Raises:
        GripcourseError: the register cannot be used.
    """
    from gripcourse.usecases.marks.opening import register_of

    return () if course is None else register_of(course.root).joins
