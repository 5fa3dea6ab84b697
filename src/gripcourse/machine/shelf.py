"""Long series on disk: a batch may be of any size, and holds no more than it looks into at a time.

They lie in temporary files without a name, which go with the last that needs them, whatever ends
the program. Where the machine has no room for one, or none any more, what is put there stays in
memory.
"""

import os
import pickle
import tempfile
import weakref
from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import accumulate
from threading import Lock
from typing import IO, Any, Final, Generic, TypeVar, overload

_Value = TypeVar("_Value")

_HERE: Final = -1  # of a start: what has it stayed in memory


def _new_file() -> IO[bytes] | None:
    try:
        # Without a buffer: what a full disk does not take must not come back at the next reading.
        return tempfile.TemporaryFile(buffering=0)
    except OSError:
        return None


@dataclass(frozen=True, slots=True, eq=False, weakref_slot=True)
class Shelf:
    """A temporary file without a name.

    Attributes:
        file: grows at its end; None where the machine has no room for one.
        lock: for who reads and writes between threads.
    """

    file: IO[bytes] | None = field(default_factory=_new_file)
    lock: Lock = field(default_factory=Lock)

    def __post_init__(self) -> None:
        if self.file is not None:
            weakref.finalize(self, self.file.close)

    def put(self, data: bytes) -> "Place | None":
        """Put bytes here; None where there is no room."""
        if self.file is None:
            return None
        try:
            with self.lock:
                start = self.file.seek(0, os.SEEK_END)
                written = self.file.write(data)
        except OSError:
            return None
        return Place(self, start, len(data)) if written == len(data) else None

    def read(self, start: int, size: int) -> bytes:
        """Return what lies at a place.

        Raises:
            OSError: it cannot be read.
        """
        if self.file is None:
            return b""
        with self.lock:
            self.file.seek(start)
            return self.file.read(size)


@dataclass(frozen=True, slots=True, eq=False)
class Place:
    """Where bytes lie on a shelf."""

    shelf: Shelf
    start: int
    size: int


def fetched(held: bytes | Place) -> bytes:
    """Return bytes, wherever they are."""
    return held if isinstance(held, bytes) else held.shelf.read(held.start, held.size)


class Shelved(Sequence[_Value], Generic[_Value]):
    """Values on a shelf: each is loaded anew whenever somebody asks for it.

    So what is asked for twice is two objects, equal but not the same; and who changes one changes
    nothing here. All that is held of a value is where it lies.
    """

    __slots__ = ("_held", "_load", "_shelf", "_sizes", "_starts")

    def __init__(
        self,
        values: Iterable[_Value] = (),
        *,
        shelf: Shelf | None = None,
        dump: Callable[[_Value], bytes] = pickle.dumps,
        load: Callable[[bytes], Any] = pickle.loads,
    ) -> None:
        """Put values on a shelf.

        Args:
            values: each is asked for once and let go.
            shelf: where they lie; None for one of their own.
            dump: makes bytes of a value.
            load: makes the value of its bytes.
        """
        self._shelf = Shelf() if shelf is None else shelf
        self._starts, self._sizes = array("q"), array("q")
        self._held: dict[int, bytes] = {}
        self._load = load
        for number, value in enumerate(values):
            self._put(number, dump(value))

    def _put(self, number: int, data: bytes) -> None:
        place = self._shelf.put(data)
        if place is None:
            self._held[number] = data
        self._starts.append(_HERE if place is None else place.start)
        self._sizes.append(len(data))

    def __len__(self) -> int:
        return len(self._starts)

    @overload
    def __getitem__(self, place: int) -> _Value: ...

    @overload
    def __getitem__(self, place: slice) -> Sequence[_Value]: ...

    def __getitem__(self, place: int | slice) -> _Value | Sequence[_Value]:
        if isinstance(place, slice):
            return tuple(self[number] for number in range(*place.indices(len(self))))
        value: _Value = self._load(self._bytes(range(len(self))[place]))
        return value

    def _bytes(self, number: int) -> bytes:
        start, size = self._starts[number], self._sizes[number]
        return self._held[number] if start == _HERE else self._shelf.read(start, size)

    def __iter__(self) -> Iterator[_Value]:
        return (self[number] for number in range(len(self)))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and tuple(self) == tuple(other)

    __hash__ = None  # type: ignore[assignment] # as of any sequence whose values may have none

    def __reduce__(self) -> tuple[object, ...]:
        # Another process has no part in the shelf: the bytes travel, and get one there.
        whole = b"".join(map(self._bytes, range(len(self))))
        return _lying_again, (self._load, self._sizes.tobytes(), whole)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self)} values)"


def _lying_again(load: Callable[[bytes], Any], sizes: bytes, whole: bytes) -> Shelved[Any]:
    found = array("q")
    found.frombytes(sizes)
    ends = accumulate(found)
    parts = (whole[end - size : end] for size, end in zip(found, ends, strict=True))
    return Shelved(parts, dump=bytes, load=load)
