"""Who waits for whom: the people of one learning platform never for another platform.

And how much one student sends at once: a file is in the memory as a whole while it is kept.
"""

from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

from anyio import CapacityLimiter

_AT_ONCE: Final = 5  # of the forty threads that answer requests
MOST_UPLOADS: Final = 4
"""Files of one student on their way at once; two clicks, each on two devices, are no more."""


class Queues:
    """A few threads for each platform; whoever comes meanwhile waits without one."""

    def __init__(self) -> None:
        self._limiters: dict[str, CapacityLimiter] = {}

    def of(self, platform: str) -> CapacityLimiter:
        """Return what bounds how many of a platform are let in at the same time."""
        return self._limiters.setdefault(platform, CapacityLimiter(_AT_ONCE))


class Uploads:
    """Files that students are sending; each of them a few at once. It is of one loop."""

    def __init__(self) -> None:
        self._on_their_way: Counter[str] = Counter()

    @contextmanager
    def one_more(self, student: str) -> Iterator[bool]:
        """Count a file as long as it is sent and kept; False, and nothing counted, for too many."""
        if self._on_their_way[student] >= MOST_UPLOADS:
            yield False
            return
        self._on_their_way[student] += 1
        try:
            yield True
        finally:
            self._on_their_way[student] -= 1
            self._on_their_way += Counter()  # keeps nothing of who sends nothing
