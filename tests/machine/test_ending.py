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
