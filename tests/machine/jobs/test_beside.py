"""A job beside what a program does: waited for, bounded, and let go in the middle."""

import os
import signal
import sys
from pathlib import Path
from types import ModuleType

import pytest

from gripcourse.machine.jobs.beside import done_beside
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.lost import Lost
from support.processes import is_running, wait_for

LIMITS = Limits(grace=0.5)


def test_a_job_is_done_by_another_process_and_waited_for(errands: ModuleType) -> None:
    with done_beside(errands.who, 0, None, limits=LIMITS, seconds=60) as answer:
        assert answer() != os.getpid()


def test_a_job_that_fails_or_dies_or_takes_too_long_is_lost(errands: ModuleType) -> None:
    for work, item, seconds in (
        (errands.stop_at_odd, 1, 60),
        (errands.vanish, 0, 60),
        (errands.nap, 60, 0.1),
    ):
        with done_beside(work, item, None, limits=LIMITS, seconds=seconds) as answer:
            assert isinstance(answer(), Lost)


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_who_is_asked_to_end_does_not_wait_for_it(errands: ModuleType, tmp_path: Path) -> None:
    def asked_in_the_middle() -> None:
        with done_beside(errands.report_and_sleep, tmp_path, None, limits=LIMITS, seconds=600):
            wait_for(lambda: any(tmp_path.iterdir()))
            raise SystemExit(signal.SIGTERM)

    with pytest.raises(SystemExit):
        asked_in_the_middle()
    (worker,) = (int(one.name) for one in tmp_path.iterdir())
    assert not is_running(worker)
