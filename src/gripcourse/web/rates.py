"""How often somebody may do something, counted in the memory of one server."""

import threading
from collections import deque
from typing import Final

from gripcourse.desk.model import Allowance

_MOST_KEPT: Final = 10_000  # whoever tries with ever new names cannot fill the memory


CHECKS: Final = Allowance(30, 600)
HAND_INS: Final = Allowance(20, 600)
REQUESTS: Final = Allowance(20, 600)
REFUSED_LINKS: Final = Allowance(60, 600)
SIGN_INS: Final = Allowance(20, 600)
LAUNCHES: Final = Allowance(2000, 600)  # a whole year may sit behind one address


class Counter:
    """Counts what was done by whom; safe between threads."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._done: dict[tuple[Allowance, str], deque[float]] = {}

    def allows(self, rate: Allowance, who: str, now: float) -> bool:
        """Count one more; False, and nothing counted, where it would be too many.

        Args:
            rate: what is counted.
            who: by whom.
            now: seconds of a clock that never goes back.
        """
        with self._lock:
            if len(self._done) > _MOST_KEPT:
                self._done.clear()
            times = self._done.setdefault((rate, who), deque())
            while times and now - times[0] >= rate.seconds:
                times.popleft()
            if len(times) >= rate.times:
                return False
            times.append(now)
            return True
