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
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from threading import Lock
from typing import IO, Any, Final, Generic, TypeAlias, TypeVar, overload

_Value = TypeVar("_Value")
_Of = TypeVar("_Of")

_READS_AT_ONCE: Final = hasattr(os, "pread")  # at a place, whoever writes meanwhile: not on Windows
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

    def put(self, data: bytes) -> "ShelfPlace | None":
        """Put bytes here; None where there is no room."""
        if self.file is None:
            return None
        try:
            with self.lock:
                start = self.file.seek(0, os.SEEK_END)
                written = self.file.write(data)
        except OSError:
            return None
        return ShelfPlace(self, start, len(data)) if written == len(data) else None

    def read(self, start: int, size: int) -> bytes:
        """Return what lies at a place.

        Raises:
            OSError: it cannot be read.
        """
        if self.file is None:
            return b""
        if _READS_AT_ONCE:
            return os.pread(self.file.fileno(), size, start)
        with self.lock:
            self.file.seek(start)
            return self.file.read(size)


@dataclass(frozen=True, slots=True, eq=False)
class ShelfPlace:
    """Where bytes lie on a shelf."""

    shelf: Shelf
    start: int
    size: int


def fetched(held: bytes | ShelfPlace) -> bytes:
    """Return bytes, wherever they are."""
    return held if isinstance(held, bytes) else held.shelf.read(held.start, held.size)


@dataclass(frozen=True, slots=True, eq=False)
class Lying:
    """Where values lie on a shelf.

    Attributes:
        shelf: that shelf.
        starts, sizes: of each.
        held: bytes of those that stayed in memory.
    """

    shelf: Shelf
    starts: "array[int]"
    sizes: "array[int]"
    held: dict[int, bytes]

    @classmethod
    def of(cls, shelf: Shelf, count: int) -> "Lying":
        """Make room for so many values."""
        return cls(shelf, array("q", [_HERE]) * count, array("q", [0]) * count, {})

    def copied(self) -> "Lying":
        """Return the same, to be changed."""
        return Lying(self.shelf, self.starts[:], self.sizes[:], dict(self.held))

    def put(self, number: int, data: bytes) -> None:
        """Put the bytes of a value on the shelf."""
        place = self.shelf.put(data)
        if place is None:
            self.starts[number], self.held[number] = _HERE, data
        else:
            self.starts[number], self.sizes[number] = place.start, place.size

    def get(self, number: int) -> bytes:
        """Return the bytes of a value."""
        start = self.starts[number]
        return self.held[number] if start == _HERE else self.shelf.read(start, self.sizes[number])

    def __reduce__(
        self,
    ) -> "tuple[Callable[[array[int], bytes], Lying], tuple[array[int], bytes]]":
        # Another process has no part in the shelf: the bytes travel, and get one there.
        every = [self.get(number) for number in range(len(self.starts))]
        return _lying_there, (array("q", map(len, every)), b"".join(every))


def _lying_there(sizes: "array[int]", whole: bytes) -> Lying:
    found, start = Lying.of(Shelf(), len(sizes)), 0
    for number, size in enumerate(sizes):
        found.put(number, whole[start : start + size])
        start += size
    return found


Places: TypeAlias = tuple["array[int]", "array[int]", dict[int, bytes]]
"""Where values lie on a shelf: starts and sizes, and the bytes of those that stayed in memory."""


class Shelved(Sequence[_Value], Generic[_Value]):
    """Values on a shelf: each is loaded anew whenever somebody asks for it.

    So what is asked for twice is two objects, equal but not the same; and who changes one changes
    nothing here. All that is held of a value is where it lies.

    Some that were asked for first may stay in memory: a small batch is looked through twenty times.
    """

    __slots__ = ("_dump", "_load", "_loaded", "_lying", "_stay")

    def __init__(
        self,
        values: Iterable[_Value] = (),
        *,
        dump: Callable[[_Value], bytes] = pickle.dumps,
        load: Callable[[bytes], Any] = pickle.loads,
        lying: Lying | None = None,
        stay: int = 0,
        loaded: dict[int, _Value] | None = None,
    ) -> None:
        """Put values on a shelf.

        Args:
            values: each is asked for once and let go.
            dump: makes bytes of a value.
            load: makes the value of its bytes.
            lying: values that are there already, before these; None for none.
            stay: how many stay in memory once they were asked for; only of such as nobody changes.
            loaded: those that stayed already, by their starts on the shelf; None for none.
        """
        self._stay, self._loaded = stay, {} if loaded is None else loaded
        self._lying = Lying.of(Shelf(), 0) if lying is None else lying
        self._dump, self._load = dump, load
        for number, value in enumerate(values, start=len(self)):
            self._lying.starts.append(_HERE)
            self._lying.sizes.append(0)
            self._lying.put(number, dump(value))

    def filled(self, count: int, pairs: Iterable[tuple[int, _Value]]) -> "Shelved[_Value]":
        """Return so many values, kept as these are, that come in any order with their places."""
        return self._with(Lying.of(self._lying.shelf, count), pairs)

    def with_changes(self, pairs: Iterable[tuple[int, _Value]]) -> "Shelved[_Value]":
        """Return the same values but for some, which come with their places."""
        return self._with(self._lying.copied(), pairs)

    def _with(self, lying: Lying, pairs: Iterable[tuple[int, _Value]]) -> "Shelved[_Value]":
        for number, value in pairs:
            lying.put(number, self._dump(value))
        return Shelved(
            dump=self._dump, load=self._load, lying=lying, stay=self._stay, loaded=self._loaded
        )

    @property
    def places(self) -> "Places":
        """Where the values lie on their shelf, for another process that has a part in it."""
        return self._lying.starts, self._lying.sizes, self._lying.held

    def at(self, places: "Places") -> "Shelved[_Value]":
        """Return what lies at places of the same shelf."""
        return self._with(Lying(self._lying.shelf, *places), ())

    def __len__(self) -> int:
        return len(self._lying.starts)

    @overload
    def __getitem__(self, place: int) -> _Value: ...

    @overload
    def __getitem__(self, place: slice) -> Sequence[_Value]: ...

    def __getitem__(self, place: int | slice) -> _Value | Sequence[_Value]:
        if isinstance(place, slice):
            return tuple(self[number] for number in range(*place.indices(len(self))))
        number = range(len(self))[place]
        start = self._lying.starts[number]
        if start in self._loaded:
            return self._loaded[start]
        value: _Value = self._load(self._lying.get(number))
        if start != _HERE and len(self._loaded) < self._stay:
            self._loaded[start] = value
        return value

    def __iter__(self) -> Iterator[_Value]:
        return (self[number] for number in range(len(self)))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and tuple(self) == tuple(other)

    __hash__ = None  # type: ignore[assignment] # as of any sequence whose values may have none

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self)} values)"


class Viewed(Sequence[_Value], Generic[_Value]):
    """What follows from each value of a long series, made anew whenever somebody asks for it."""

    __slots__ = ("_made", "_values")

    def __init__(self, values: Sequence[_Of], made: Callable[[_Of], _Value]) -> None:
        """Look at values through a function of each."""
        self._values, self._made = values, made

    def __len__(self) -> int:
        return len(self._values)

    @overload
    def __getitem__(self, place: int) -> _Value: ...

    @overload
    def __getitem__(self, place: slice) -> Sequence[_Value]: ...

    def __getitem__(self, place: int | slice) -> _Value | Sequence[_Value]:
        if isinstance(place, slice):
            return tuple(map(self._made, self._values[place]))
        return self._made(self._values[place])

    def __iter__(self) -> Iterator[_Value]:
        return map(self._made, self._values)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and tuple(self) == tuple(other)

    __hash__ = None  # type: ignore[assignment] # as of any sequence whose values may have none


class ViewedMapping(Mapping[str, _Value], Generic[_Value]):
    """What follows from each value of a large mapping, made anew whenever somebody asks for it."""

    __slots__ = ("_made", "_values")

    def __init__(self, values: Mapping[str, _Of], made: Callable[[_Of], _Value]) -> None:
        """Look at values through a function of each."""
        self._values, self._made = values, made

    def __len__(self) -> int:
        return len(self._values)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __contains__(self, name: object) -> bool:
        return name in self._values

    def __getitem__(self, name: str) -> _Value:
        return self._made(self._values[name])
