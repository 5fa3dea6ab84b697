"""How often somebody may do something, counted in the memory of one server."""

import threading
from collections import OrderedDict, deque
from typing import Final

from gripcourse.access.desk.model import Allowance

# Of each allowance: whoever tries with ever new names cannot fill the memory.
MOST_KEPT: Final = 10_000


CHECKS: Final = Allowance(30, 600)
HAND_INS: Final = Allowance(20, 600)
REQUESTS: Final = Allowance(20, 600)
REFUSED_LINKS: Final = Allowance(60, 600)
REFUSED_SIGN_INS: Final = Allowance(20, 600)


class Counter:
    """Counts what was done by whom; safe between threads."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._done: dict[Allowance, OrderedDict[str, deque[float]]] = {}

    def allows(self, rate: Allowance, who: str, now: float) -> bool:
        """Count one more; False, and nothing counted, where it would be too many.

        Args:
            rate: what is counted.
            who: by whom.
            now: seconds of a clock that never goes back.
        """
        with self._lock:
            done = self._done.setdefault(rate, OrderedDict())
            times = done.setdefault(who, deque())
            done.move_to_end(who)
            if len(done) > MOST_KEPT:  # who has not come for the longest time is forgotten
                done.popitem(last=False)
            while times and now - times[0] >= rate.seconds:
                times.popleft()
            if len(times) >= rate.times:
                return False
            times.append(now)
            return True
