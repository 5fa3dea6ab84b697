"""The end of this program where another one asks for it: the system, `kill`, a closed terminal."""

import atexit
import os
import signal
import sys
from contextlib import suppress
from types import FrameType
from typing import Final

_SAID_BY_A_SHELL: Final = 128  # and the number of the signal
_ASKED_BY: Final = ("SIGTERM", "SIGHUP")  # the second is not everywhere


def end_in_order() -> None:
    """Let a signal that asks this program to end unwind it, as Ctrl-C does.

    So workers and LibreOffice are ended, and temporary files and semaphores removed. What ended it
    is seen from outside all the same. A second signal ends it at once; one that is ignored, as by
    `nohup`, stays so. Call it in the main thread.
    """
    asked: list[int] = []

    def stop(number: int, _frame: FrameType | None) -> None:
        signal.signal(number, signal.SIG_DFL)
        asked.append(number)
        raise SystemExit(_SAID_BY_A_SHELL + number)

    def end_by_signal() -> None:
        if asked:
            for stream in (sys.stdout, sys.stderr):
                with suppress(OSError, ValueError):
                    stream.flush()
            os.kill(os.getpid(), asked[0])

    atexit.register(end_by_signal)  # the first that is registered is the last that is done
    for name in _ASKED_BY:
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, stop)
