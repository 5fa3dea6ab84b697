"""A command and all that it starts, looked at while it runs, and hardly disturbed by that.

Finding a program's processes among all of a machine takes a share of a processor: two workers that
want both would be measured slower than they are.
"""

import os
import select
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import psutil

from gripcourse.machine.jobs.limits import peak_memory

_TICKS = os.sysconf("SC_CLK_TCK")
_USER_TIME = 11  # of the fields behind a program's name, the first of four


@dataclass(frozen=True, slots=True)
class Seen:
    """What a look at a program and all that it started found.

    Attributes:
        busy: seconds of the processor, with those of workers that have ended.
        own: bytes that the program has had at most.
        of_workers: bytes that the largest of the others has had at most; 0 for none.
    """

    busy: float
    own: int
    of_workers: int


def seen(process: int) -> Seen:
    """Look at a program that runs, and at all that it started.

    Args:
        process: its number.
    """
    started = descendants(process)
    return Seen(
        busy=sum(map(busy_seconds, (process, *started))),
        own=peak_memory(process),
        of_workers=max(map(peak_memory, started), default=0),
    )


def descendants(process: int) -> list[int]:
    """Return the numbers of all processes that one started, and that these started."""
    try:
        threads = list(Path(f"/proc/{process}/task").iterdir())
        children = [
            int(one)
            for thread in threads
            for one in (thread / "children").read_text(encoding="ascii").split()
        ]
    except FileNotFoundError:  # it has ended, or the system keeps no such list
        with suppress(psutil.Error):
            return [one.pid for one in psutil.Process(process).children(recursive=True)]
        return []
    except OSError:
        return []
    return [*children, *(one for child in children for one in descendants(child))]


def busy_seconds(process: int) -> float:
    """Return seconds of the processor, of a process and of its children that have ended."""
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace")
    except OSError:  # it has ended: who started it knows
        return 0.0
    fields = text.rpartition(")")[2].split()
    return sum(map(int, fields[_USER_TIME : _USER_TIME + 4])) / _TICKS


def wait_for_end(process: int, seconds: float) -> None:
    """Wait until a process ends, and no longer than so many seconds."""
    handle = os.pidfd_open(process)
    try:
        select.select([handle], [], [], seconds)
    finally:
        os.close(handle)
