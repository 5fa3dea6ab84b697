"""The end of this program where another one asks for it: the system, `kill`, a closed terminal."""

import atexit
import os
import signal
import sys
import threading
from contextlib import suppress
from time import sleep
from types import FrameType
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from sys import UnraisableHookArgs

_SAID_BY_A_SHELL: Final = 128  # and the number of the signal
_ASKED_BY: Final = ("SIGTERM", "SIGHUP")  # the second is not everywhere
_SOON: Final = 0.02  # seconds


def end_in_order() -> None:
    """Let a signal that asks this program to end unwind it, as Ctrl-C does.

    So workers and LibreOffice are ended, and temporary files and semaphores removed. What ended it
    is seen from outside all the same. A second signal ends it at once; one that is ignored, as by
    `nohup`, stays so. Call it in the main thread.

    A signal, Ctrl-C too, may come while the collector of garbage runs somebody's callback: there
    no exception goes further, and it is sent again.
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

    say_unheard = sys.unraisablehook

    def hear_again(unheard: "UnraisableHookArgs") -> None:
        if issubclass(unheard.exc_type, KeyboardInterrupt):
            _send_soon(signal.SIGINT)
        elif issubclass(unheard.exc_type, SystemExit) and asked:
            number = asked.pop()
            signal.signal(number, stop)
            _send_soon(number)
        else:
            say_unheard(unheard)

    atexit.register(end_by_signal)  # the first that is registered is the last that is done
    sys.unraisablehook = hear_again
    for name in _ASKED_BY:
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, stop)


def _send_soon(number: int) -> None:
    """Send this process a signal once more, when the callback will have come to its end."""

    def send() -> None:
        sleep(_SOON)
        os.kill(os.getpid(), number)

    with suppress(RuntimeError):  # no room for a thread: whoever asked asks again
        threading.Thread(target=send, daemon=True).start()
