"""Values that come one by one, kept in few files: one file for each process that keeps any.

As with `kept`, what cannot be read, was damaged or belongs to somebody else counts as not kept. A
process that is killed in the middle leaves the beginning of its last value, which nobody takes for
a whole one.
"""

import errno
import hashlib
import os
import pickle
import struct
import weakref
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any, Final, TypeAlias
from uuid import uuid4

from gripcourse.machine.kept import is_mine

_HEAD: Final = struct.Struct(">Q32s32s")  # bytes of the value; its key; digest of the value
_SUFFIX: Final = ".records.kept"

Find: TypeAlias = Callable[[bytes], Any]
"""Returns what is kept under a key; None where nothing is."""


@dataclass(frozen=True, slots=True, eq=False, weakref_slot=True)
class RecordsFile:
    """A file of this process that grows at its end."""

    path: Path
    stream: IO[bytes]

    def __post_init__(self) -> None:
        weakref.finalize(self, self.stream.close)

    def add(self, key: bytes, value: object) -> None:
        """Keep a value under a key of 32 bytes.

        Raises:
            OSError: it cannot be written; what was kept before stays readable.
        """
        packed = pickle.dumps(value)
        record = _HEAD.pack(len(packed), key, hashlib.sha256(packed).digest()) + packed
        start = self.stream.seek(0, os.SEEK_END)
        try:
            # What a machine loses with its power counts as not kept.
            is_whole = self.stream.write(record) == len(record)
        except OSError as fault:
            self._forget(start)
            fault.filename = str(self.path)
            raise
        if not is_whole:
            self._forget(start)
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(self.path))

    def _forget(self, start: int) -> None:
        with suppress(OSError):
            self.stream.truncate(start)


def new_records(folder: Path) -> RecordsFile:
    """Make a file in a folder that only this user may open.

    Raises:
        OSError: it cannot be made.
    """
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    path = folder / f"{uuid4().hex}{_SUFFIX}"
    handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o600)
    # Without a buffer: what a full disk does not take must not come back later.
    return RecordsFile(path, os.fdopen(handle, "r+b", buffering=0))


@contextmanager
def kept_records(folder: Path) -> Iterator[Find]:
    """Open all files of records in a folder; of several values of one key any may be found."""
    with ExitStack() as stack:
        places: dict[bytes, tuple[IO[bytes], int, int, bytes]] = {}
        for path in sorted(folder.glob(f"*{_SUFFIX}")):
            with suppress(OSError):
                if _is_ours(path):
                    stream = stack.enter_context(path.open("rb"))
                    places.update(_places(stream))
        yield lambda key: _value(*places[key]) if key in places else None


def _places(stream: IO[bytes]) -> Iterator[tuple[bytes, tuple[IO[bytes], int, int, bytes]]]:
    """Yield where each value lies, by its key."""
    whole, start = os.fstat(stream.fileno()).st_size, 0
    while start + _HEAD.size <= whole:
        stream.seek(start)
        size, key, digest = _HEAD.unpack(stream.read(_HEAD.size))
        start += _HEAD.size
        if start + size > whole:  # its process was killed
            return
        yield key, (stream, start, size, digest)
        start += size


def _value(stream: IO[bytes], start: int, size: int, digest: bytes) -> Any:  # noqa: ANN401 (whatever was kept)
    try:
        stream.seek(start)
        packed = stream.read(size)
        if hashlib.sha256(packed).digest() != digest:
            return None
        return pickle.loads(packed)  # noqa: S301 (written by this user's own process)
    except Exception:  # noqa: BLE001 (a damaged file fails in any way; the value is made again)
        return None


def _is_ours(path: Path) -> bool:
    return hasattr(os, "getuid") and is_mine(path)
