"""Telling whether a folder is written into by this process alone.

What a killed process left unfinished looks as what another one is writing just now.
"""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path


@contextmanager
def writing_into(folder: Path) -> Iterator[bool]:
    """Be known to others of this program as who writes into a folder.

    The system forgets it when the process ends, however it ends. On a disk that knows no locks
    nobody is known, and everybody seems to be alone.

    Args:
        folder: of which nothing is changed; where it is not there, nobody else writes into it.

    Yields:
        Whether nobody else was writing into it when this one began: what is unfinished there was
        left by the dead.
    """
    held = _opened(folder)
    if held is None:
        yield True
        return
    try:
        yield _is_alone(held)
    finally:
        os.close(held)


def _opened(folder: Path) -> int | None:
    """Open a folder; None where that cannot be done, as on Windows."""
    with suppress(OSError):
        return os.open(folder, os.O_RDONLY)
    return None


def _is_alone(held: int) -> bool:
    """Lock a folder beside others who do so, unless it can be locked against all of them."""
    try:
        import fcntl  # noqa: PLC0415 (not everywhere)
    except ModuleNotFoundError:
        return True
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        alone = False
    except OSError:
        return True
    else:
        alone = True
    with suppress(OSError):
        fcntl.flock(held, fcntl.LOCK_SH)
    return alone
