"""Reading a workbook in a process of its own, bounded in time and memory."""

import hashlib
from collections.abc import Callable
from dataclasses import replace
from typing import Final, TypeAlias

from gripcourse.jobs.limits import Limits
from gripcourse.jobs.pools import PROCESSES, Pool
from gripcourse.jobs.workers import Lost, run_each
from gripcourse.machine.content import NamedBytes, Readable, content_of, shown_name
from gripcourse.submission.model import Rejected, WhyRefused
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook

Read: TypeAlias = Callable[[Readable], RawWorkbook | Rejected]
"""Reads a workbook of any content."""

# An answer workbook takes 0.03 s; what preflight lets through takes 2 s.
_SECONDS: Final = 10.0
READERS: Final[Pool] = replace(PROCESSES, limits=Limits(memory=1024**3, grace=2.0))
"""Processes that only read: less memory than for a report."""


def read_apart(
    source: Readable, *, read: Read = read_workbook, seconds: float = _SECONDS
) -> RawWorkbook | Rejected:
    """Read a workbook where it can take nothing else along; see `read_workbook`.

    Args:
        source: a file of any content, or its bytes.
        read: reads it; it must be found by its name in another process.
        seconds: that it may take.

    Raises:
        OSError: there is no such file, or it may not be read.
    """
    named = NamedBytes(shown_name(source), content_of(source))
    jobs = run_each(_read, [named], read, workers=1, seconds=seconds, pool=READERS)
    ((_, outcome),) = jobs
    if isinstance(outcome, Lost):
        digest = hashlib.sha256(named.data).hexdigest()
        return Rejected.because(named.name, digest, WhyRefused.TOO_COSTLY)
    return outcome


def _read(source: NamedBytes, read: Read) -> RawWorkbook | Rejected:
    return read(source)
