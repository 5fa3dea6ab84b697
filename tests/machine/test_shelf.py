"""Long series lie on disk and are the same as in memory, on a full disk and in another process."""

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import IO

import pytest

from gripcourse.machine.shelf import Shelf, Shelved, Viewed, ViewedMapping, fetched

VALUES = ("one", 2.0, {"three": (3,)}, None, b"five")


def test_values_are_as_they_were_put_and_loaded_anew_each_time() -> None:
    held = Shelved(VALUES)
    assert tuple(held) == VALUES
    assert held == VALUES
    assert (len(held), held[2], held[-1], held[1:3]) == (5, VALUES[2], b"five", VALUES[1:3])
    assert held[2] is not held[2]
    with pytest.raises(IndexError):
        held[5]


def test_each_value_is_asked_for_once_and_let_go() -> None:
    made = (f"value {number}" for number in range(1000))
    held = Shelved(made)
    assert next(made, None) is None
    assert held[999] == "value 999"


def test_some_stand_in_the_place_of_others_and_those_before_stay() -> None:
    before = Shelved(VALUES)
    after = before.with_changes([(0, "changed"), (4, "too")])
    assert tuple(after) == ("changed", *VALUES[1:4], "too")
    assert tuple(before) == VALUES


def test_so_many_as_are_wanted_stay_in_memory_and_what_stands_in_their_place_does_not() -> None:
    before = Shelved(VALUES, stay=3)
    assert before[2] is before[2]
    after = before.with_changes([(2, "changed")])
    assert (after[2], before[2]) == ("changed", VALUES[2])
    assert after[4] is before[4]
    assert before[1] == VALUES[1]
    assert before[1] is not before[1]


def test_they_come_in_any_order() -> None:
    found = Shelved[object]().filled(len(VALUES), reversed(list(enumerate(VALUES))))
    assert tuple(found) == VALUES


def test_another_process_gets_the_same() -> None:
    held = Shelved(VALUES).with_changes([(1, "changed")])
    assert tuple(pickle.loads(pickle.dumps(held))) == tuple(held)  # noqa: S301 (ours)


def no_file(**_: object) -> IO[bytes]:
    """A machine without room for temporary files."""
    raise OSError


def full_file(**_: object) -> IO[bytes]:
    """A disk that takes nothing more."""
    return Path("/dev/full").open("r+b", buffering=0)


@pytest.mark.parametrize("made", [no_file, full_file])
def test_what_finds_no_room_stays_in_memory(
    made: Callable[..., IO[bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert fetched(b"more") == b"more"
    place = Shelf().put(b"more")
    assert place is not None
    assert fetched(place) == b"more"
    monkeypatch.setattr("tempfile.TemporaryFile", made)
    assert Shelf().put(b"more") is None
    held = Shelved(VALUES)
    assert tuple(held.with_changes([(1, "changed")])) == ("one", "changed", *VALUES[2:])
    assert tuple(pickle.loads(pickle.dumps(held))) == VALUES  # noqa: S301 (ours)


def test_a_view_makes_each_value_when_it_is_asked_for() -> None:
    asked: list[int] = []

    def doubled(number: int) -> int:
        asked.append(number)
        return 2 * number

    seen = Viewed([1, 2, 3], doubled)
    assert asked == []
    assert (seen[1], seen[1:], len(seen), list(seen)) == (4, (4, 6), 3, [2, 4, 6])
    assert seen == (2, 4, 6)
    by_name = ViewedMapping({"a": 1, "b": 2}, doubled)
    assert dict(by_name) == {"a": 2, "b": 4}
    assert ("a" in by_name, "c" in by_name, len(by_name)) == (True, False, 2)
