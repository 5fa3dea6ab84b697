"""Deadlines as grading counts them, for who asks all the time."""

import logging
from datetime import datetime
from pathlib import Path

from gripcourse.errors import GripcourseError
from gripcourse.gradebook.deadlines import (
    END_OF_DAY,
    Deadline,
    course_deadlines,
    deadline_of,
)
from gripcourse.machine.resources import deadlines_path
from gripcourse.policy.time_rules import LateRule
from gripcourse.variants.model import Issued

_log = logging.getLogger(__name__)


class DeskDeadlines:
    """The deadlines of a course; its table is read again only where it is another."""

    def __init__(self, root: Path, rule: LateRule | None) -> None:
        self._root, self._rule = root, rule
        self._last: tuple[tuple[int, int, int] | None, tuple[Deadline, ...]] = (None, ())

    def of(self, issued: Issued) -> datetime | None:
        """Return the last moment at which a student is not late; None where there is none.

        Where lateness costs nothing no zone is declared: the day ends by the clock of this place.
        """
        if self._rule is not None:
            return deadline_of(issued, self._rows(), self._rule.time_zone)
        if issued.deadline is None:
            return None
        end = datetime.combine(issued.deadline, END_OF_DAY)
        # A day that ends twice does so the second time, here as elsewhere.
        return max(end.replace(fold=one).astimezone() for one in (0, 1))

    def _rows(self) -> tuple[Deadline, ...]:
        state = _state_of(deadlines_path(self._root))
        before, rows = self._last
        if state != before:
            try:
                rows = course_deadlines(self._root, self._rule)
            except GripcourseError as error:
                # Somebody is writing the table: until it can be used, what it said before counts.
                _log.error("%s", error.problems[0].what)
            self._last = state, rows
        return rows


def _state_of(path: Path) -> tuple[int, int, int] | None:
    try:
        found = path.stat()
    except FileNotFoundError:
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino
