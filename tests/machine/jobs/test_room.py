"""What an executor needs is tried before it is begun: half begun, it would wait for ever."""

import mmap
import threading

import pytest

from gripcourse.machine.jobs.room import demand_room
from gripcourse.machine.jobs.workers import in_order, run_each


def double(item: int, _: object) -> int:
    return 2 * item


def no_thread_after(monkeypatch: pytest.MonkeyPatch, most: int) -> list[threading.Thread]:
    """Let the system give so many threads and no more; return those that it gave."""
    given: list[threading.Thread] = []
    start = threading.Thread.start

    def start_some(thread: threading.Thread) -> None:
        if len(given) == most:
            raise RuntimeError("can't start new thread")
        given.append(thread)
        start(thread)

    monkeypatch.setattr(threading.Thread, "start", start_some)
    return given


def test_what_is_tried_is_given_back() -> None:
    before = threading.active_count()
    demand_room()
    assert threading.active_count() == before


@pytest.mark.parametrize("most", [0, 1, 3])
def test_too_few_threads_are_too_little_memory(monkeypatch: pytest.MonkeyPatch, most: int) -> None:
    given = no_thread_after(monkeypatch, most)
    with pytest.raises(MemoryError):
        in_order(run_each(double, [1, 2], None, workers=1, seconds=9))
    assert len(given) == most
    assert not any(one.is_alive() for one in given)


def test_so_are_too_few_addresses(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise OSError(12, "Cannot allocate memory")

    monkeypatch.setattr(mmap, "mmap", refuse)
    with pytest.raises(MemoryError):
        demand_room()
