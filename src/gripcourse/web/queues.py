"""Who waits for whom: the people of one learning platform never for another platform."""

from typing import Final

from anyio import CapacityLimiter

_AT_ONCE: Final = 5  # of the forty threads that answer requests


class Queues:
    """A few threads for each platform; whoever comes meanwhile waits without one."""

    def __init__(self) -> None:
        self._limiters: dict[str, CapacityLimiter] = {}

    def of(self, platform: str) -> CapacityLimiter:
        """Return what bounds how many of a platform are let in at the same time."""
        return self._limiters.setdefault(platform, CapacityLimiter(_AT_ONCE))
