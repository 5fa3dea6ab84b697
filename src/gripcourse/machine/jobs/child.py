"""A process that does one job after the other for this one: started, asked, ended.

It never runs the program that started it again, and it ends with it. Linux ends it with the very
thread that started it, so that one which lives as long as this process has to.
"""

import os
import pickle
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any, Final

from gripcourse.machine.jobs.limits import Limits

GROWN: Final = 256 * 1024**2
"""Bytes that a child has had at most, where it is kept for the next job."""
DIED: Final = "The worker that did this died, or did not end in time.\n"
"""What is said of a job whose worker is gone."""
NOT_ANSWERED: Final = (OSError, EOFError, pickle.UnpicklingError)
"""What `ask` raises where the child is gone."""

_TO_START: Final = 60.0  # seconds, on a machine that is busy
_BEGIN: Final = (
    "import pickle, sys; sys.path[:] = pickle.load(sys.stdin.buffer);"
    "from gripcourse.machine.jobs.servant import serve; serve()"
)


def start(limits: Limits, scratch: Path | None = None) -> "subprocess.Popen[bytes]":
    """Start a child.

    Args:
        limits: of the child.
        scratch: folder for its temporary files; None for the system's.
    """
    place = {} if scratch is None else {"TMPDIR": str(scratch)}
    child = subprocess.Popen(  # noqa: S603 (this very program)
        # A file of the current folder may be called as a module, and be a stranger's.
        [sys.executable, "-P", "-c", _BEGIN],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env={**os.environ, **place},
    )
    _send(child, pickle.dumps(sys.path) + pickle.dumps(limits))
    return child


def ask(child: "subprocess.Popen[bytes]", packed: bytes, seconds: float) -> tuple[Any, int]:
    """Send a job and wait; the child ends itself in time, and where it cannot, it is ended.

    Args:
        child: that waits for a job.
        packed: the pickled task and its item.
        seconds: that the job may take by the clock.

    Returns:
        What the job came to, and how many bytes of memory the child has had at most.

    Raises:
        OSError, EOFError, UnpicklingError: the child is gone; see `NOT_ANSWERED`.
    """
    stop = threading.Timer(_TO_START + seconds, child.kill)
    stop.daemon = True
    stop.start()
    try:
        _send(child, packed)
        if child.stdout is None:  # pragma: no cover (for the types)
            raise EOFError
        outcome, grown = pickle.load(child.stdout)  # noqa: S301 (our own program)
    finally:
        stop.cancel()
    return outcome, grown


def end(child: "subprocess.Popen[bytes]") -> None:
    """End a child, whatever it is doing."""
    child.kill()
    child.wait()
    for pipe in (child.stdin, child.stdout):
        if pipe is not None:
            try:
                pipe.close()
            except OSError:  # what it never read
                continue


def _send(child: "subprocess.Popen[bytes]", packed: bytes) -> None:
    if child.stdin is not None:
        child.stdin.write(packed)
        child.stdin.flush()
