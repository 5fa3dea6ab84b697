"""Workers that stay: one that dies takes nobody else's job along."""

import os
import threading
import time
from collections.abc import Iterator

import pytest

from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.standing import StandingWorkers


def work(item: str, shared: str) -> str:
    if item == "die":
        os._exit(7)
    if item == "wait":
        time.sleep(1)
    if item == "fail":
        raise ValueError(item)
    return f"{shared} {item} {os.getpid()}"


@pytest.fixture(scope="module")
def workers() -> Iterator[StandingWorkers]:
    opened = StandingWorkers(work, "did", workers=1, seconds=20)
    yield opened
    opened.close()


def test_a_worker_stays_until_it_dies_and_another_takes_its_place(
    workers: StandingWorkers,
) -> None:
    first = workers.do("one")
    assert isinstance(first, str)
    assert first.split()[-1] != str(os.getpid())
    assert workers.do("two") == first.replace("one", "two")
    assert isinstance(workers.do("fail"), Lost)
    assert isinstance(workers.do("die"), Lost)
    after = workers.do("three")
    assert after.startswith("did three ")
    assert after.split()[-1] != first.split()[-1]


def test_a_worker_outlives_the_thread_that_asked_first() -> None:
    opened, found = StandingWorkers(work, "did", workers=1, seconds=20), []
    asking = threading.Thread(target=lambda: found.append(opened.do("one")))
    asking.start()
    asking.join()
    time.sleep(0.2)  # for the system to end what belongs to a thread that is gone
    assert opened.do("one") == found[0]
    opened.close()


def test_without_workers_it_is_done_here() -> None:
    here = StandingWorkers(work, "did", workers=0, seconds=20, pool=None)
    assert here.do("one") == f"did one {os.getpid()}"
    assert isinstance(here.do("fail"), Lost)
    here.close()


def test_what_workers_share_is_renewed_and_a_job_in_hand_is_done_to_its_end() -> None:
    opened = StandingWorkers(work, "did", workers=1, seconds=20)
    first, found = opened.do("one"), list[object]()
    asking = threading.Thread(target=lambda: found.append(opened.do("wait")))
    asking.start()
    time.sleep(0.2)  # for the job to begin
    opened.renew("does")
    after = opened.do("two")
    asking.join()
    assert isinstance(after, str)
    assert after.startswith("does two ")
    assert after.split()[-1] != first.split()[-1]
    assert found == [first.replace("one", "wait")]
    opened.close()
