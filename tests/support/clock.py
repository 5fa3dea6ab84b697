"""A clock that a test may move, and the moment at which it begins."""

from dataclasses import dataclass
from datetime import UTC, datetime

BEGAN = datetime(2026, 10, 1, 9, 30, tzinfo=UTC)


@dataclass(slots=True)
class Clock:
    """A clock that a test may move."""

    now: datetime = BEGAN

    def __call__(self) -> datetime:
        return self.now
