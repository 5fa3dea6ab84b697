"""Packing files into a zip part by part: neither the memory nor the disk holds the whole."""

import re
import stat
import zipfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Final

_PART: Final = 1_000_000  # bytes
_EARLIEST: Final = (1980, 1, 1, 0, 0, 0)  # of the times that a zip can hold
_PRIVATE_FILE: Final = (stat.S_IFREG | 0o600) << 16
_NO_NAME: Final = re.compile(r'[<>:"/\\|?*\x00-\x1f\x7f]')  # on any system


@dataclass(frozen=True, slots=True)
class ToPack:
    """A file that goes into a zip.

    Attributes:
        name: in the zip, folders by slashes; each part as `part_of_name` makes them.
        path: of the file.
        at: the time that it gets, with its zone.
    """

    name: str
    path: Path
    at: datetime


def part_of_name(text: str) -> str:
    """Return a text as it may stand between the slashes of a name on every system."""
    return _NO_NAME.sub("_", text).strip(". ") or "_"


def packed(files: Iterable[ToPack]) -> Iterator[bytes]:
    """Pack files, each read only when its turn comes.

    Yields:
        The parts of the zip. Nothing is compressed: workbooks and PDF files are already.

    Raises:
        OSError: a file cannot be read; what came before is no whole zip then.
    """
    outlet = _Outlet()
    with zipfile.ZipFile(outlet, "w") as archive:
        for one in files:
            with one.path.open("rb") as source, archive.open(_member(one), "w") as target:
                while part := source.read(_PART):
                    target.write(part)
                    yield outlet.taken()
            yield outlet.taken()
    yield outlet.taken()


class _Outlet:
    """What a zip is written to: keeps what came until it is taken."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []

    def write(self, data: bytes, /) -> int:
        self._parts.append(bytes(data))
        return len(data)

    def flush(self) -> None:
        """Do nothing: whoever takes the parts sends them."""

    def close(self) -> None:
        """Do nothing: there is no file."""

    def taken(self) -> bytes:
        parts, self._parts = self._parts, []
        return b"".join(parts)


def _member(one: ToPack) -> zipfile.ZipInfo:
    local = one.at.astimezone()
    info = zipfile.ZipInfo(one.name, max(local.timetuple()[:6], _EARLIEST))
    info.external_attr = _PRIVATE_FILE
    info.file_size = one.path.stat().st_size
    return info
