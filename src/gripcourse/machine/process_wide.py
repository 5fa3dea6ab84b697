"""Settings of the whole process that are changed for a moment: one thread at a time, and put back.

What a thread changes, all threads see. So who changes something waits until nobody else has it
changed: what is put back at the end is then what stood there before, never another's change.
"""

import gc
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from threading import RLock
from typing import Final

_CHANGING: Final = RLock()
_COLLECTOR_THRESHOLD: Final = 100_000


@contextmanager
def few_collections() -> Iterator[None]:
    """Collect garbage rarely, where many objects are made that live: 15 % of the time otherwise."""
    with _CHANGING:
        before = gc.get_threshold()
        gc.set_threshold(_COLLECTOR_THRESHOLD, *before[1:])
        try:
            yield
        finally:
            gc.set_threshold(*before)


def collect_rarely() -> None:
    """Collect garbage rarely from now on, in a process that runs one command and ends."""
    gc.set_threshold(_COLLECTOR_THRESHOLD, *gc.get_threshold()[1:])


@contextmanager
def without_warnings() -> Iterator[None]:
    """Let a library keep its warnings to itself."""
    with _CHANGING, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield
