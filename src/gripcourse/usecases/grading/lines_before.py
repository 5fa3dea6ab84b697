"""Lines of a long table that an earlier run wrote, taken over as bytes where they say the same.

What a line says hangs on its report and on what every document is made with. Under a digest of both
stands where the line lies in the table of before, with a digest of its bytes: where that table was
changed or is gone, its lines are made again.
"""

import hashlib
import os
from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from struct import Struct
from typing import IO, Final, TypeAlias

from gripcourse.machine.kept import read_value, write_value

# Digest of what it says; where it begins; how long it is; digest of its bytes. Ten thousand of them
# lie in one run of bytes, ordered: an object for each would take five times the room.
_PLACE: Final = Struct(">32sQQ32s")
_KEY: Final = 32


@dataclass(frozen=True, slots=True)
class TableLine:
    """A line that need not be made.

    Attributes:
        about: digest of what it says, but for what all lines are made with.
        make: makes it.
    """

    about: str
    make: Callable[[], str]


Piece: TypeAlias = str | TableLine
"""A piece of a table."""


def all_made(pieces: Iterable[Piece]) -> Iterator[str]:
    """Yield the pieces of a table, each line made."""
    for piece in pieces:
        yield piece.make() if isinstance(piece, TableLine) else piece


@dataclass(frozen=True, slots=True)
class LinesBefore:
    """Lines of the table that this run replaces.

    Attributes:
        note: file that tells where they lie.
        made_with: digest of what all lines are made with.
    """

    note: Path
    made_with: str

    def taken_over(self, table: Path, pieces: Iterable[Piece]) -> Iterator[bytes]:
        """Yield the pieces of a table as UTF-8, and at the end note where its lines lie.

        Args:
            table: of before; it must stay until the last piece was asked for.
            pieces: of the new one.
        """
        places, at = list[bytes](), 0
        with _known_lines(table, read_value(self.note)) as known:
            for piece in pieces:
                if isinstance(piece, TableLine):
                    key = hashlib.sha256(f"{self.made_with}\n{piece.about}".encode()).digest()
                    written = known(key) or piece.make().encode()
                    digest = hashlib.sha256(written).digest()
                    places.append(_PLACE.pack(key, at, len(written), digest))
                else:
                    written = piece.encode()
                at += len(written)
                yield written
        # Who cannot note it makes all lines again.
        with suppress(OSError):
            write_value(self.note, b"".join(sorted(places)))


@contextmanager
def _known_lines(table: Path, noted: object) -> Iterator[Callable[[bytes], bytes]]:
    """Open a table; yield what returns the line of a key, empty where none lies there any more."""
    if not isinstance(noted, bytes) or len(noted) % _PLACE.size or not table.is_file():
        yield lambda _: b""
        return
    with table.open("rb") as stream:
        yield partial(_line, noted, stream)


def _line(noted: bytes, stream: IO[bytes], key: bytes) -> bytes:
    number = bisect_left(range(len(noted) // _PLACE.size), key, key=partial(_key_at, noted))
    place = noted[number * _PLACE.size : (number + 1) * _PLACE.size]
    if not place.startswith(key):
        return b""
    _, start, size, digest = _PLACE.unpack(place)
    if start + size > os.fstat(stream.fileno()).st_size:
        return b""
    stream.seek(start)
    found = stream.read(size)
    return found if hashlib.sha256(found).digest() == digest else b""


def _key_at(noted: bytes, number: int) -> bytes:
    return noted[number * _PLACE.size : number * _PLACE.size + _KEY]
