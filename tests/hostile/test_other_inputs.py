"""Rosters and declarations from strangers: each spoiled one is read or refused."""

import random
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Final

import pytest

from gripcourse.course.toml_faults import toml_values
from gripcourse.errors import GripcourseError, Problem
from gripcourse.issuing.roster import read_roster
from gripcourse.machine.content import NamedBytes

ROOT: Final = Path(__file__).parents[2]
RUNS: Final = 60
PIECES: Final = (
    *(b"\0", b'"', b'"' * 7, b";", b",", b"\r", b"\xff\xfe", b"\x1b[2J", b"=1+1", b"../../x"),
    *(b"9" * 5000, b"nan", b"1e999", b"a" * 100_000, b"x\n" * 5000, b"," * 20_000, b"[" * 5000),
    *(b'",\n' * 3000, "с\u202e½１２".encode(), b"\xd1", b"con", b"{}", b"[[", b"]]\n= 1"),
)


def spoiled(sound: bytes) -> Iterator[bytes]:
    """Yield copies with one to four random changes each."""
    for seed in range(RUNS):
        draw, data = random.Random(seed), sound  # noqa: S311 (nothing secret)
        for _ in range(draw.choice((1, 1, 2, 4))):
            place, length = draw.randrange(len(data) + 1), draw.choice((0, 0, 1, 3, 50))
            data = data[:place] + draw.choice(PIECES) + data[place + length :]
        yield data


def roster(data: bytes, _folder: Path) -> object:
    return read_roster(NamedBytes("roster.csv", data))


def declarations(data: bytes, folder: Path) -> object:
    (folder / "course.toml").write_bytes(data)
    problems: list[Problem] = []
    return toml_values(folder / "course.toml", "course.toml", problems) or problems


@pytest.mark.parametrize(
    ("sound", "read"),
    [("variants/roster.csv", roster), ("variants/course.toml", declarations)],
    ids=["roster", "declarations"],
)
def test_what_is_spoiled_is_read_or_refused(
    sound: str, read: Callable[[bytes, Path], object], tmp_path: Path
) -> None:
    for data in spoiled((ROOT / sound).read_bytes()):
        with suppress(GripcourseError):  # it says what is wrong
            assert read(data, tmp_path)
