"""Settings of the whole process that are changed for a moment, and put back.

What a thread changes, all threads see. So what is put back at the end must be what stood there
before anybody changed it, never another's change. How often garbage is collected is the same for
all who want it rarely: they may be inside together, for as long as they like, and the last one to
leave puts it back. Warnings are another's to hear: who silences them waits for who does already,
and should not take long.
"""

import gc
import logging
import os
import re
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from threading import Lock, RLock
from typing import Final

_COLLECTOR_THRESHOLD: Final = 100_000
_SILENCING: Final = RLock()
DATE_VARIABLE: Final = "SOURCE_DATE_EPOCH"
_MOMENT: Final = re.compile("[0-9]{1,11}")  # seconds from 1970 on, some thousand years


@dataclass(slots=True)
class _Rarely:
    """How many want few collections at the moment, and what stood there before the first of them.

    The lock is held only while this changes, so that nobody ever waits for another's work. A
    process that is forked meanwhile collects rarely for good: that costs memory, no time.
    """

    users: int = 0
    before: tuple[int, int, int] = (0, 0, 0)
    lock: Lock = field(default_factory=Lock)

    def enter(self) -> None:
        """Collect rarely from now on."""
        with self.lock:
            if self.users == 0:
                self.before = gc.get_threshold()
                gc.set_threshold(_COLLECTOR_THRESHOLD, *self.before[1:])
            self.users += 1

    def leave(self) -> None:
        """Collect as before, unless somebody else still wants it rarely."""
        with self.lock:
            self.users -= 1
            if self.users == 0:
                gc.set_threshold(*self.before)


_RARELY: Final = _Rarely()


@contextmanager
def few_collections() -> Iterator[None]:
    """Collect garbage rarely, where many objects are made that live: 15 % of the time otherwise."""
    _RARELY.enter()
    try:
        yield
    finally:
        _RARELY.leave()


def calculate_in_one_thread() -> None:
    """Let numpy start no threads of its own, here and in what this process starts; before numpy.

    Our matrices are small, and each of our workers would start one more for each processor: a third
    of the time that importing numpy takes. Who has set a number has it.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def import_nothing_from_here() -> None:
    """Let what this process starts import no module from the folder that somebody works in.

    An interpreter that is started with a line of code looks there first, and a file that lies there
    may be a stranger's work: `pickle.py` among what was handed in would be run by whoever grades.
    """
    os.environ["PYTHONSAFEPATH"] = "1"


@contextmanager
def importing_nothing_from_here() -> Iterator[None]:
    """Do so for what is started meanwhile."""
    before = os.environ.get("PYTHONSAFEPATH")
    import_nothing_from_here()
    try:
        yield
    finally:
        if before is None:
            os.environ.pop("PYTHONSAFEPATH", None)
        else:
            os.environ["PYTHONSAFEPATH"] = before


def collect_rarely() -> None:
    """Collect garbage rarely from now on, in a process that runs one command or a worker's jobs."""
    gc.set_threshold(_COLLECTOR_THRESHOLD, *gc.get_threshold()[1:])


def leave_to_the_end() -> None:
    """Look for no more garbage in what lives now: the process ends, and all of it with it.

    Looking through a course once more takes a quarter of what a short command takes.
    """
    gc.freeze()


def _found_nowhere(name: str) -> str | None:  # noqa: ARG001 (as the system's function)
    return None


@contextmanager
def libraries_by_full_name() -> Iterator[None]:
    """Find libraries of the system by the full names that are asked for, and by no others.

    WeasyPrint asks for each of its libraries by several names, `libpango-1.0.so.0` among them. For
    the others a compiler is started, where there is one: a dozen times, 0.3 s.
    """
    if sys.platform != "linux":
        yield
        return
    with _SILENCING:
        from ctypes import util  # noqa: PLC0415 (not for --help)

        find, util.find_library = util.find_library, _found_nowhere
        try:
            yield
        finally:
            util.find_library = find


def strange_date() -> str | None:
    """Return the setting of the date which programs are told to write, where it is no date.

    Whoever wants the same bytes each time sets it: https://reproducible-builds.org.
    """
    written = os.environ.get(DATE_VARIABLE)
    return None if written is None or _MOMENT.fullmatch(written) else written


@contextmanager
def without_strange_date() -> Iterator[None]:
    """Take such a date away meanwhile: libraries fail at it when a document is as good as made."""
    if strange_date() is None:
        yield
        return
    with _SILENCING:
        strange = os.environ.pop(DATE_VARIABLE, None)
        try:
            yield
        finally:
            if strange is not None:
                os.environ[DATE_VARIABLE] = strange


@contextmanager
def without_advice(library: str) -> Iterator[None]:
    """Let a library log nothing but errors: where it keeps what it makes is not a user's matter.

    Where the home may not be written, matplotlib recommends a variable to whoever grades, once in
    each worker.
    """
    log = logging.getLogger(library)
    with _SILENCING:
        before = log.level
        log.setLevel(logging.ERROR)
        try:
            yield
        finally:
            log.setLevel(before)


@contextmanager
def without_warnings() -> Iterator[None]:
    """Let a library keep its warnings to itself."""
    with _SILENCING, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield
