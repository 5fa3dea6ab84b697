"""The files inside a zip: named as their owners named them, read one by one, never unpacked.

Nothing of an archive is ever written to the disk, so that no name in it can lead anywhere. A member
is read only as far as it may be large, whatever size the archive declares.
"""

import errno
import stat
import unicodedata
import zipfile
import zlib
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.machine.listed_archive import ask_archive
from gripcourse.text.words import message

LARGEST_MEMBER: Final = 64_000_000  # bytes; more than any workbook that is looked at
MOST_MEMBERS: Final = 100_000
_OF_A_DOCUMENT: Final = frozenset({"[Content_Types].xml", "mimetype"})
_UTF8: Final = 1 << 11
_ENCRYPTED: Final = 1
# Of bzip2 a few bytes are gigabytes, and the library unpacks all that it has read at once. No
# learning platform packs so.
_METHODS: Final = frozenset({zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED})
_DAMAGE: Final = (
    *(zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError),
    *(RuntimeError, ValueError),  # a password; a name that is no text, a place before the file
)


class Unusable(StrEnum):
    """Why a member is not read; the value stands in JSON and in tables."""

    UNSAFE_PATH = "unsafe_path"
    ENCRYPTED = "encrypted"
    METHOD = "method"
    TOO_LARGE = "too_large"
    NO_FILE = "no_file"


class UnreadableMemberError(OSError):
    """A member that is damaged, larger than it said, or packed in a way that is not read."""


@dataclass(frozen=True, slots=True)
class PackedMember:
    """One file of an archive.

    Attributes:
        place: its number in the archive, from 0.
        name: with folders, as its owner wrote it; no two that can be read are the same.
        unusable: why it is not to be read; None where it is.
    """

    place: int
    name: str
    unusable: Unusable | None


def is_bundle(path: Path) -> bool:
    """Tell whether a file is a zip of other files, not a document that is a zip by itself."""
    if path.suffix.lower() != ".zip" or not zipfile.is_zipfile(path):
        return False
    with _opened(path) as opened:
        return _OF_A_DOCUMENT.isdisjoint(opened.namelist())


def members_of(archive: Path) -> tuple[PackedMember, ...]:
    """List the files of a zip, sorted by name.

    Raises:
        UsageError: it is damaged, no zip at all, or has too many members.
        OSError: it cannot be read.
    """
    with _opened(archive) as opened:
        found = opened.infolist()
    if len(found) > MOST_MEMBERS:
        what = message(
            "It has {count} members; at most {most} are looked at.",
            count=len(found),
            most=MOST_MEMBERS,
        )
        remedy = message("Unpack it, and name the folder with what was handed in.")
        raise UsageError([Problem(str(archive), "", what, remedy)])
    taken: Counter[str] = Counter()
    members = []
    for place, info in enumerate(found):
        if not info.filename.endswith("/"):
            name = _name(info)
            unusable = _unusable(info, name)
            if unusable is not Unusable.UNSAFE_PATH:  # that need not have a last part
                name = _free(name, taken)
            members.append(PackedMember(place, name, unusable))
    return tuple(sorted(members, key=lambda one: one.name))


def read_member(archive: Path, place: int) -> bytes:
    """Return the content of a member.

    Args:
        archive: a zip.
        place: of the member; see `PackedMember`.

    Raises:
        UnreadableMemberError: it is damaged, larger than any file that is looked at, or packed
            in a way that is not read.
        OSError: the archive cannot be read.
    """
    data = beginning_of_member(archive, place, LARGEST_MEMBER + 1)
    if len(data) > LARGEST_MEMBER:
        raise UnreadableMemberError(str(len(data)))
    return data


def beginning_of_member(archive: Path, place: int, count: int) -> bytes:
    """Return the first bytes of a member; the rest stays packed. Errors: see `read_member`."""

    def first_bytes(opened: zipfile.ZipFile) -> bytes:
        info = opened.infolist()[place]
        if info.compress_type not in _METHODS:
            raise NotImplementedError(info.compress_type)
        with opened.open(info) as stream:
            return stream.read(count)

    try:
        return ask_archive(archive, first_bytes)
    except (*_DAMAGE, OSError) as fault:
        if _is_of_the_disk(fault):
            raise
        raise UnreadableMemberError(str(fault)) from fault


def damaged_zip(archive: Path) -> Problem:
    """Say that a file that is called a zip is none that can be read."""
    what = message("This is no zip that can be read: it is damaged or something else.")
    remedy = message("Download it again, or unpack it and name the folder.")
    return Problem(str(archive), "", what, remedy)


@contextmanager
def _opened(archive: Path) -> Iterator[zipfile.ZipFile]:
    try:
        with zipfile.ZipFile(archive) as opened:
            _refuse_begun_before(opened)
            yield opened
    except (*_DAMAGE, OSError) as fault:
        if _is_of_the_disk(fault):
            raise
        raise UsageError([damaged_zip(archive)]) from fault


def _refuse_begun_before(opened: zipfile.ZipFile) -> None:
    """Refuse an archive in whose file something stands before it.

    Of a download that broke off, the last list of members is that of a workbook inside: one work
    would pass for all of them.
    """
    if min((one.header_offset for one in opened.infolist()), default=0) > 0:
        raise zipfile.BadZipFile


def _is_of_the_disk(fault: Exception) -> bool:
    """Tell a fault of the disk from one of the archive, which may point before its own begin."""
    return isinstance(fault, OSError) and fault.errno != errno.EINVAL


def _name(info: zipfile.ZipInfo) -> str:
    """Return the name of a member as its owner wrote it, with one sign for each letter."""
    name = info.filename
    if not info.flag_bits & _UTF8:
        # Without the flag a name is in whatever code page the packer had: macOS writes UTF-8,
        # Windows in Russia and Ukraine cp866. The library reads it as cp437.
        raw = name.encode("cp437", errors="replace")
        try:
            name = raw.decode()
        except UnicodeDecodeError:
            name = raw.decode("cp866", errors="replace")
    return unicodedata.normalize("NFC", name.replace("\\", "/"))


def _free(name: str, taken: Counter[str]) -> str:
    """Return a name that no member before has: archives may hold one name twice."""
    taken[name] += 1
    while taken[name] > 1:
        path = PurePosixPath(name)
        name = str(path.with_name(f"{path.stem} ({taken[name]}){path.suffix}"))
        taken[name] += 1
    return name


def _unusable(info: zipfile.ZipInfo, name: str) -> Unusable | None:
    path = PurePosixPath(name)
    if path.is_absolute() or ".." in path.parts or PureWindowsPath(name).drive or not path.name:
        return Unusable.UNSAFE_PATH
    mode = info.external_attr >> 16
    if mode and not stat.S_ISREG(mode) and stat.S_IFMT(mode):
        return Unusable.NO_FILE
    if info.flag_bits & _ENCRYPTED:
        return Unusable.ENCRYPTED
    if info.compress_type not in _METHODS:
        return Unusable.METHOD
    return Unusable.TOO_LARGE if info.file_size > LARGEST_MEMBER else None
