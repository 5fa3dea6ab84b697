"""What jobs need comes to workers as it was, and a shelf goes along as the file that it is."""

import os
import pickle
import sys
from array import array
from types import ModuleType
from typing import IO, Any

import pytest

from gripcourse.machine.jobs.parcel import PackedBytes, packed_for_workers
from gripcourse.machine.jobs.workers import in_order, run_each
from gripcourse.machine.shelf import Shelved

NUMBERS = tuple(range(1000))
ON_LINUX = pytest.mark.skipif(sys.platform != "linux", reason="files travel on Linux only")


def test_workers_read_a_shelf_and_put_nothing_on_it(errands: ModuleType) -> None:
    here = Shelved(NUMBERS)
    jobs = run_each(errands.put_more, [-1, -2, -3], here, workers=2, seconds=60)
    assert in_order(jobs) == tuple((added, *NUMBERS[1:]) for added in (-1, -2, -3))
    assert tuple(here.with_changes([(1, "more")])) == (0, "more", *NUMBERS[2:])
    assert tuple(here) == NUMBERS


@ON_LINUX
def test_what_lies_on_a_shelf_is_not_packed() -> None:
    held = Shelved([bytes(1_000_000)])
    packed: Any = packed_for_workers(("twice the same", held, held))
    assert len(packed.shelves) == 1
    assert packed.file.seek(0, 2) < 1000
    assert len(PackedBytes.of(held).data) > 1_000_000
    name, *twice = packed.unpacked()
    assert (name, [one[0] for one in twice]) == ("twice the same", [bytes(1_000_000)] * 2)


@ON_LINUX
def test_what_had_no_room_on_a_shelf_travels_too(monkeypatch: pytest.MonkeyPatch) -> None:
    def no_file(**_: object) -> IO[bytes]:
        raise OSError

    monkeypatch.setattr("tempfile.TemporaryFile", no_file)
    assert tuple(packed_for_workers(Shelved(NUMBERS)).unpacked()) == NUMBERS


@ON_LINUX
def test_files_go_to_who_is_being_started_and_to_nobody_else() -> None:
    with pytest.raises(pickle.PicklingError):
        pickle.dumps(packed_for_workers(NUMBERS))


def test_where_files_do_not_travel_all_of_it_lies_in_shared_memory(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("gripcourse.machine.jobs.parcel._FILES_TRAVEL", False)
    packed = packed_for_workers((array("q", NUMBERS), Shelved(NUMBERS)))
    name = packed.name  # type: ignore[attr-defined]
    arrived = pickle.loads(pickle.dumps(packed))  # noqa: S301 (ours)
    numbers, shelved = arrived.unpacked()
    assert (tuple(numbers), tuple(shelved)) == (NUMBERS, NUMBERS)
    del packed
    with pytest.raises(FileNotFoundError, match=name):
        arrived.unpacked()


@ON_LINUX
def test_what_the_system_does_not_let_us_write_is_no_parcel(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("os.memfd_create", lambda _: os.open("/dev/full", os.O_RDWR))
    with pytest.raises(OSError, match="space"):
        packed_for_workers(bytes(100_000))
