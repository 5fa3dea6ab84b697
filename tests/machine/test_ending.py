"""Whoever asks this program to end finds nothing that it left behind."""

import signal
import subprocess
import sys

import pytest

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="signals of Unix")

_HOLDS_A_SEMAPHORE = """
import multiprocessing, os, signal
from gripcourse.machine.ending import end_in_order
signal.signal(signal.SIGHUP, signal.SIG_IGN)
end_in_order()
held = multiprocessing.get_context("spawn").Lock()
os.kill(os.getpid(), signal.SIGHUP)
try:
    os.kill(os.getpid(), signal.SIGTERM)
finally:
    print("in order")
"""


def test_a_program_that_is_asked_to_end_unwinds_and_is_seen_to_end_by_the_signal() -> None:
    command = [sys.executable, "-c", _HOLDS_A_SEMAPHORE]
    run = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603 (ours)
    assert (run.returncode, run.stdout, run.stderr) == (-signal.SIGTERM, "in order\n", "")


_HEARS_IT_WHERE_NOTHING_CAN_BE_RAISED = """
import os, signal, sys, time
from gripcourse.machine.ending import end_in_order
end_in_order()
number = int(sys.argv[1])
class Held:
    def __del__(self):
        os.kill(os.getpid(), number)
held = Held()
try:
    del held
    time.sleep(60)
except KeyboardInterrupt:
    sys.exit("interrupted")
finally:
    print("in order")
"""


@pytest.mark.parametrize(
    ("number", "ended"),
    [
        (signal.SIGTERM, (-signal.SIGTERM, "in order\n", "")),
        (signal.SIGINT, (1, "in order\n", "interrupted\n")),
    ],
)
def test_so_it_is_where_it_is_asked_while_something_is_forgotten(
    number: int, ended: tuple[int, str, str]
) -> None:
    """The language lets no exception out of there, and says it on the error stream."""
    command = [sys.executable, "-c", _HEARS_IT_WHERE_NOTHING_CAN_BE_RAISED, str(int(number))]
    run = subprocess.run(  # noqa: S603 (ours)
        command,
        capture_output=True,
        text=True,
        check=False,
        timeout=50,
        # A shell may have started the tests deaf to Ctrl-C.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )
    assert (run.returncode, run.stdout, run.stderr) == ended
