"""Rosters, courses, tables of platforms, archives, answers, JSON of strangers: read or refused."""

import random
from collections.abc import Iterator
from contextlib import suppress
from typing import Final

import pytest

from gripcourse.errors import GripcourseError
from hostile.changes import LARGEST, change_of
from hostile.readers import FAILED, READERS

RUNS: Final = 60
SLOW: Final = {"course": 4, "drawing": 20, "workbook": 10}
"""Readers that take a tenth of a second, and a fiftieth."""
PIECES: Final = (
    *(b"\0", b'"', b'"' * 7, b";", b",", b"\r", b"\xff\xfe", b"\x1b[2J", b"=1+1", b"../../x"),
    *(b"9" * 5000, b"nan", b"1e999", b"a" * 100_000, b"x\n" * 5000, b"," * 20_000, b"[" * 5000),
    *(b'",\n' * 3000, "с\u202e½１２".encode(), b"\xd1", b"con", b"{}", b"[[", b"]]\n= 1"),
)


def spoiled(sound: bytes, runs: int) -> Iterator[bytes]:
    """Yield copies with one to four random changes of bytes each."""
    for seed in range(runs):
        draw, data = random.Random(seed), sound  # noqa: S311 (nothing secret)
        for _ in range(draw.choice((1, 1, 2, 4))):
            data = with_a_piece(draw, data)
        yield data


def with_a_piece(draw: random.Random, data: bytes) -> bytes:
    place, length = draw.randrange(len(data) + 1), draw.choice((0, 0, 1, 3, 50))
    return data[:place] + draw.choice(PIECES) + data[place + length :]


@pytest.mark.parametrize("name", READERS)
def test_what_is_spoiled_is_read_or_refused(name: str) -> None:
    reader = READERS[name]
    runs = max(1, RUNS // SLOW.get(name, 1) // len(reader.sound))
    for sound in reader.sound:
        assert reader.read(sound)
        for data in spoiled(sound, runs):
            with suppress(GripcourseError):  # it says what is wrong
                assert reader.read(data)


@pytest.mark.parametrize("name", READERS)
def test_what_is_changed_by_its_form_is_read_or_refused(name: str) -> None:
    reader = READERS[name]
    change = change_of(reader.form, reader.sound, lambda data, _: data[1:])
    for seed in range(RUNS // SLOW.get(name, 1) if change else 0):
        data = reader.sound[seed % len(reader.sound)]
        with suppress(GripcourseError):
            assert reader.read(change(data, LARGEST, seed) if change else data)


def test_what_once_failed_is_read_or_refused() -> None:
    for path in FAILED.glob("*/*"):
        with suppress(GripcourseError):
            assert READERS[path.parent.name].read(path.read_bytes()), path


def test_who_changes_files_by_their_form_makes_others_and_the_same_again() -> None:
    for reader in READERS.values():
        change = change_of(reader.form, reader.sound, lambda data, _: data[1:])
        if change is not None:
            made = [change(reader.sound[0], LARGEST, seed) for seed in range(20)]
            assert made == [change(reader.sound[0], LARGEST, seed) for seed in range(20)]
            assert len(set(made)) > len(made) / 4
