"""Archives whose lists of members are read once, however many of them are asked for.

A platform's zip of three thousand works has a list that takes 30 ms to read: three thousand times
that is more than reading the works. No file stays open between two questions, and an archive that
changed meanwhile is another one.
"""

import os
import zipfile
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from threading import Lock
from typing import BinaryIO, Final, TypeVar

_KEPT: Final = 2  # archives; the list of one of a hundred thousand members takes 60 megabytes

Found = TypeVar("Found")
_Version = tuple[int, int, int, int]
"""Of a file: its disk, its number there, its size, and when it was written."""


def ask_archive(archive: Path, ask: Callable[[zipfile.ZipFile], Found]) -> Found:
    """Ask an archive something; nobody else asks the same one meanwhile.

    Args:
        archive: a zip.
        ask: looks into it; it must be done with all streams when it returns.

    Raises:
        OSError: it cannot be read.
        Exception: what `zipfile` raises of an archive that is none, and what `ask` raises.
    """
    with archive.open("rb") as stream:
        found = os.fstat(stream.fileno())
        version = (found.st_dev, found.st_ino, found.st_size, found.st_mtime_ns)
        return _listed(str(archive), version).ask(stream, ask)


class _Borrowed:
    """A file that is open only while somebody asks; `zipfile` wants one for its whole life."""

    def __init__(self) -> None:
        self.stream: BinaryIO | None = None

    def seekable(self) -> bool:
        """Tell `zipfile` that it need not count what it reads."""
        return True

    def seek(self, place: int, whence: int = os.SEEK_SET) -> int:
        """Go to a place."""
        return self._open().seek(place, whence)

    def tell(self) -> int:
        """Tell the place."""
        return self._open().tell()

    def read(self, count: int = -1) -> bytes:
        """Read on from there."""
        return self._open().read(count)

    def _open(self) -> BinaryIO:
        if self.stream is None:
            raise ValueError("nobody asks this archive")
        return self.stream


@dataclass(slots=True, eq=False)
class _Listed:
    """One version of an archive; what it lists is read when it is asked for the first time."""

    borrowed: _Borrowed = field(default_factory=_Borrowed)
    opened: zipfile.ZipFile | None = None
    lock: Lock = field(default_factory=Lock)

    def ask(self, stream: BinaryIO, ask: Callable[[zipfile.ZipFile], Found]) -> Found:
        with self.lock:
            self.borrowed.stream = stream
            try:
                if self.opened is None:
                    self.opened = zipfile.ZipFile(self.borrowed)
                return ask(self.opened)
            finally:
                self.borrowed.stream = None


@lru_cache(maxsize=_KEPT)
def _listed(_path: str, _version: _Version) -> _Listed:
    return _Listed()
