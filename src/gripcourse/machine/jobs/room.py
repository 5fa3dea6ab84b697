"""Whether this process has room for what an executor needs, before it is half begun.

An executor whose thread cannot start waits for ever for answers that nobody brings.
"""

import mmap
import threading
from contextlib import suppress
from typing import Final

_THREADS: Final = 4  # who sends jobs, who takes answers, who shows how far it is, and one more
_BYTES: Final = 32 * 1024**2
_NO_THREAD: Final = "can't start new thread"
_NOT_LOADED: Final = ("failed to map segment", "cannot allocate memory", "Cannot allocate memory")


def demand_room() -> None:
    """Try what will be needed: the system tells of no other way what it will give.

    Raises:
        MemoryError: it does not give it.
    """
    goes_on = threading.Event()
    begun: list[threading.Thread] = []
    try:
        with mmap.mmap(-1, _BYTES):  # never touched, so it takes addresses and no memory
            for _ in range(_THREADS):
                one = threading.Thread(target=goes_on.wait, daemon=True)
                one.start()
                begun.append(one)
    except (OSError, RuntimeError) as fault:
        raise MemoryError(str(fault)) from fault
    finally:
        goes_on.set()
        for one in begun:
            one.join()


def start_if_there_is_room(thread: threading.Thread) -> None:
    """Start a thread that is a comfort only."""
    with suppress(RuntimeError):
        thread.start()


def is_lack_of_room(fault: Exception) -> bool:
    """Tell whether something failed for want of addresses, though nobody called it that.

    A thread has a stack, and a library that is loaded has a place.
    """
    said = str(fault)
    if isinstance(fault, ImportError):
        return any(one in said for one in _NOT_LOADED)
    return isinstance(fault, RuntimeError) and said == _NO_THREAD
