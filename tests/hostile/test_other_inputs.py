"""Rosters, declarations, tables of platforms and archives from strangers: read or refused."""

import io
import random
import zipfile
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Final

import pytest

from gripcourse.course.toml_faults import toml_values
from gripcourse.errors import GripcourseError, Problem
from gripcourse.exports.platforms.canvas import fill_gradebook
from gripcourse.exports.platforms.moodle_worksheet import fill_worksheet, read_worksheet
from gripcourse.issuing.roster import read_roster
from gripcourse.machine.archive import (
    UnreadableMemberError,
    is_bundle,
    members_of,
    read_member,
)
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


def worksheet(data: bytes, _folder: Path) -> object:
    return fill_worksheet(read_worksheet(NamedBytes("work.csv", data)), (), lambda _: "").content


def gradebook(data: bytes, _folder: Path) -> object:
    return fill_gradebook(NamedBytes("grades.csv", data), (), "").content


def works(data: bytes, folder: Path) -> object:
    """Read every member that may be read; no two of them have one name."""
    path = folder / "works.zip"
    path.write_bytes(data)
    is_bundle(path)
    members = [one for one in members_of(path) if one.unusable is None]
    assert len({one.name for one in members}) == len(members)
    for one in members:
        with suppress(UnreadableMemberError):
            read_member(path, one.place)
    return path


def declared(name: str) -> bytes:
    return (ROOT / "variants" / name).read_bytes()


def packed() -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in ("s01/a.xlsx", "s01/b.xlsx", "Ольга_12_file/ответ.xlsx", "c/"):
            archive.writestr(zipfile.ZipInfo(name), bytes(range(256)) * 4, zipfile.ZIP_DEFLATED)
    return stream.getvalue()


WORKSHEET: Final = """\
Identifier,"Full name",Status,Grade,"Maximum grade","Grade can be changed",\
"Last modified (grade)","Feedback comments"
"Participant 12","Ольга Иванова","Submitted",,100.00,Yes,-,
"Participant 3","Іван Ковальчук","Submitted",,100.00,Yes,"Saturday, 21 November 2026","<p>a,
b</p>"
"""
GRADEBOOK: Final = """\
Student,ID,SIS User ID,SIS Login ID,Section,РГР 1 (9876),Current Score
    Points Possible,,,,,"50.00",(read only)
"Иванова, Ольга",501,u1,ivanova@uni.ua,РТ-41,,70
"""


@pytest.mark.parametrize(
    ("sound", "read"),
    [
        (declared("roster.csv"), roster),
        (declared("course.toml"), declarations),
        (WORKSHEET.encode(), worksheet),
        (WORKSHEET.encode("utf-16"), worksheet),
        (GRADEBOOK.encode("utf-8-sig"), gradebook),
        (packed(), works),
    ],
    ids=["roster", "declarations", "worksheet", "worksheet in UTF-16", "gradebook", "archive"],
)
def test_what_is_spoiled_is_read_or_refused(
    sound: bytes, read: Callable[[bytes, Path], object], tmp_path: Path
) -> None:
    assert read(sound, tmp_path)
    for data in spoiled(sound):
        with suppress(GripcourseError):  # it says what is wrong
            assert read(data, tmp_path)
