"""Reading a workbook in a process of its own, bounded in time and memory."""

import hashlib
from collections.abc import Callable
from typing import Final, TypeAlias

from gripcourse.machine.content import NamedBytes, Readable, content_of, shown_name
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.warm import do_apart, start_early
from gripcourse.submission.model import Rejected, WhyRefused
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook

Read: TypeAlias = Callable[[Readable], RawWorkbook | Rejected]
"""Reads a workbook of any content."""

# An answer workbook takes 0.03 s; what preflight lets through takes 1 s, and another machine more.
_SECONDS: Final = 10.0  # by the clock, beside whatever else the machine does
READERS: Final[Limits] = Limits(memory=1024**3, grace=2.0, processor=5.0, writes=False)
"""Of processes that only read: less memory than for a report, and no file is written."""


def read_apart(
    source: Readable, *, read: Read = read_workbook, seconds: float = _SECONDS
) -> RawWorkbook | Rejected:
    """Read a workbook where it can take nothing else along; see `read_workbook`.

    Args:
        source: a file of any content, or its bytes.
        read: reads it; it must be found by its name in another process.
        seconds: that it may take by the clock.

    Raises:
        OSError: there is no such file, or it may not be read.
    """
    named = NamedBytes(shown_name(source), content_of(source))
    outcome = do_apart(_read, named, read, limits=READERS, seconds=seconds)
    if isinstance(outcome, Lost):
        digest = hashlib.sha256(named.data).hexdigest()
        return Rejected.because(named.name, digest, WhyRefused.TOO_COSTLY)
    return outcome


def start_reader() -> None:
    """Start the process that `read_apart` will ask, while this one does something else."""
    start_early(_import, READERS)


def _import(*_: None) -> None:
    import openpyxl.styles.numbers  # noqa: F401, PLC0415 (100 ms, for formats of dates)


def _read(source: NamedBytes, read: Read) -> RawWorkbook | Rejected:
    return read(source)
