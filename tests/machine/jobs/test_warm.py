"""A worker that waits: bounded, kept from job to job, and replaced when it must be."""

import os
import signal
import subprocess
import sys
import threading
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import ModuleType

import pytest

from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.warm import do_apart, start_early
from support.processes import is_running, wait_for

LIMITS = Limits(memory=1024**3, grace=0.5, processor=0.3, writes=False)


def test_one_worker_does_one_job_after_the_other(errands: ModuleType) -> None:
    one, two = (do_apart(errands.who, n, None, limits=LIMITS, seconds=60) for n in (1, 2))
    assert one == two != os.getpid()


def test_a_worker_that_was_started_early_is_asked(errands: ModuleType, tmp_path: Path) -> None:
    limits = replace(LIMITS, processor=None, writes=True, grace=0.4)
    start_early(partial(errands.leave_note, str(tmp_path / "note")), limits)
    asked = do_apart(errands.who, 0, None, limits=limits, seconds=60)
    assert (tmp_path / "note").read_text(encoding="ascii") == str(asked)


def test_a_worker_outlives_the_thread_that_asked_first(errands: ModuleType) -> None:
    found: list[object] = []

    def ask() -> None:
        found.append(do_apart(errands.who, 0, None, limits=LIMITS, seconds=60))

    for _ in range(2):
        thread = threading.Thread(target=ask)
        thread.start()
        thread.join()
    assert found[0] == found[1]


@pytest.mark.skipif(sys.platform != "linux", reason="other systems count otherwise")
def test_processor_time_is_bounded_and_sleep_costs_none(errands: ModuleType) -> None:
    spun = do_apart(errands.spin, 60, None, limits=LIMITS, seconds=30)
    assert isinstance(spun, Lost)
    assert "TookTooLong" in spun.reason
    assert do_apart(errands.nap, 0.4, None, limits=LIMITS, seconds=60) == 0.4


@pytest.mark.skipif(sys.platform == "win32", reason="this system bounds no files")
def test_who_only_reads_writes_no_file(errands: ModuleType, tmp_path: Path) -> None:
    path = tmp_path / "written"
    written = do_apart(errands.write, path, None, limits=LIMITS, seconds=60)
    assert isinstance(written, Lost)
    assert path.read_bytes() == b""


@pytest.mark.skipif(sys.platform != "linux", reason="other systems count otherwise")
def test_who_grew_is_replaced(errands: ModuleType) -> None:
    before = do_apart(errands.grow, 300 * 1024**2, None, limits=LIMITS, seconds=60)
    assert do_apart(errands.who, 0, None, limits=LIMITS, seconds=60) != before


def test_who_died_is_replaced(errands: ModuleType) -> None:
    assert isinstance(do_apart(errands.vanish, 0, None, limits=LIMITS, seconds=60), Lost)
    assert isinstance(do_apart(errands.who, 0, None, limits=LIMITS, seconds=60), int)


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
@pytest.mark.parametrize("ending", [signal.SIGKILL, signal.SIGTERM])
def test_it_dies_with_the_program_that_keeps_it(
    errands: ModuleType, tmp_path: Path, ending: signal.Signals
) -> None:
    script = [sys.executable, str(errands.__file__), str(tmp_path), "warm"]
    with subprocess.Popen(script) as program:  # noqa: S603 (ours)
        wait_for(lambda: len(list(tmp_path.iterdir())) == 1)
        program.send_signal(ending)
    (worker,) = (int(one.name) for one in tmp_path.iterdir())
    wait_for(lambda: not is_running(worker))
