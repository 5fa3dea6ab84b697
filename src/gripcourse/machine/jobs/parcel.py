"""What all jobs of a task need, packed once; each worker unpacks it once.

What is packed for workers of this machine lies outside of the memory of this process, and what
lies on a shelf already is not even read: workers get the shelf's own file.
"""

import copyreg
import mmap
import os
import pickle
import sys
import weakref
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.context import get_spawning_popen
from multiprocessing.reduction import DupFd
from multiprocessing.shared_memory import SharedMemory
from typing import IO, Any, Final, Protocol, TypeAlias

from gripcourse.machine.file_limits import demand_file_of
from gripcourse.machine.shelf import Lying, Shelf

_FILES_TRAVEL: Final = sys.platform == "linux"  # without names, to a process as it is started

_Reduced: TypeAlias = tuple[Callable[..., Any], tuple[Any, ...]]


class Packed(Protocol):
    """What was packed for another process."""

    def unpacked(self) -> Any:  # noqa: ANN401 (whatever was packed)
        """Return a copy of it, once, in that process."""


@dataclass(frozen=True, slots=True)
class PackedBytes:
    """What was packed for any machine."""

    data: bytes

    @classmethod
    def of(cls, value: object) -> "PackedBytes":
        """Pack something."""
        return cls(pickle.dumps(value))

    def unpacked(self) -> Any:  # noqa: ANN401 (see `Packed`)
        """Return a copy of it; see `Packed`."""
        return pickle.loads(self.data)  # noqa: S301 (packed by the program that started this)


def packed_for_workers(value: object) -> Packed:
    """Pack something for processes that this one starts.

    Args:
        value: is packed now: it may change later, but for what is put on its shelves.

    Raises:
        OSError: the system has no room for it.
    """
    if not _FILES_TRAVEL:
        return _PackedInMemory.of(pickle.dumps(value))
    file = os.fdopen(os.memfd_create("packed"), "w+b")
    packer = _Packer(file)
    try:
        packer.dump(value)
        file.flush()
    except OSError:
        with suppress(OSError):  # what it still holds cannot be written either
            file.close()
        raise
    packed = _PackedInFile(file, tuple(packer.files))
    weakref.finalize(packed, file.close)
    return packed


@dataclass(frozen=True, slots=True, weakref_slot=True)
class _PackedInFile:
    """What was packed into a file without a name.

    Attributes:
        file: it.
        shelves: files of the shelves that go along, by their numbers in it.
    """

    file: IO[bytes]
    shelves: tuple[IO[bytes], ...]

    def unpacked(self) -> Any:  # noqa: ANN401 (see `Packed`)
        """Return a copy of it; see `Packed`."""
        # Not read: all workers have one place in the file in common.
        with self.file, mmap.mmap(self.file.fileno(), 0, access=mmap.ACCESS_READ) as content:
            return _Unpacker(content, self.shelves).load()

    def __reduce__(self) -> _Reduced:
        if get_spawning_popen() is None:
            raise pickle.PicklingError(type(self).__name__)  # files go to who is being started
        return _arrived, tuple(DupFd(one.fileno()) for one in (self.file, *self.shelves))


def _arrived(*numbers: Any) -> _PackedInFile:  # noqa: ANN401 (what `DupFd` makes of them)
    # For reading alone: what a worker puts on a shelf of ours would lie among what we put there.
    file, *shelves = (os.fdopen(one.detach(), "rb", buffering=0) for one in numbers)
    return _PackedInFile(file, tuple(shelves))


class _Packer(pickle.Pickler):
    """Packs a value; of shelves it only notes the files."""

    def __init__(self, target: IO[bytes]) -> None:
        super().__init__(target)
        self.files: list[IO[bytes]] = []
        # Asked of two classes alone: to ask of every object takes twice as long as packing it.
        self.dispatch_table = {**copyreg.dispatch_table, Lying: _lying, Shelf: self._noted}

    def _noted(self, shelf: Shelf) -> _Reduced:
        """Return how to find a shelf's file there; one for which there was no room has none."""
        if shelf.file is None:
            return Shelf, (None,)
        if shelf.file not in self.files:
            self.files.append(shelf.file)
        return _shelf, (self.files.index(shelf.file),)


def _lying(value: Lying) -> _Reduced:
    return Lying, (value.shelf, value.starts, value.sizes, value.held)


def _shelf(number: int) -> Shelf:
    """Stand for a shelf by the number of its file: only `_Unpacker` knows the files."""
    raise pickle.UnpicklingError(number)


class _Unpacker(pickle.Unpickler):
    """Unpacks what `_Packer` packed."""

    def __init__(self, source: mmap.mmap, files: tuple[IO[bytes], ...]) -> None:
        super().__init__(source)
        self._shelves = tuple(Shelf(one) for one in files)

    def find_class(self, module: str, name: str, /) -> Any:  # noqa: ANN401 (as `pickle` has it)
        """Return what a name means: that of a shelf's place the shelf."""
        is_shelf = (module, name) == (_shelf.__module__, _shelf.__name__)
        return self._shelves.__getitem__ if is_shelf else super().find_class(module, name)


@dataclass(frozen=True, slots=True, weakref_slot=True)
class _PackedInMemory:
    """What was packed into memory that processes share, where files do not travel.

    Not with what else a worker is started with: that goes through a pipe that nobody empties if it
    ends too early, and more than fits in there would be waited for in vain.

    Attributes:
        name: of the memory.
        size: of what is in it; memory comes in whole pages.
    """

    name: str
    size: int

    @classmethod
    def of(cls, data: bytes) -> "_PackedInMemory":
        """Put bytes there, until nobody in this process needs them any more."""
        demand_file_of(len(data))
        memory = SharedMemory(create=True, size=len(data))
        _content(memory)[: len(data)] = data
        packed = cls(memory.name, len(data))
        weakref.finalize(packed, _give_back, memory)
        return packed

    def unpacked(self) -> Any:  # noqa: ANN401 (see `Packed`)
        """Return a copy of it; see `Packed`."""
        memory = SharedMemory(self.name)
        data = bytes(_content(memory)[: self.size])
        memory.close()
        return pickle.loads(data)  # noqa: S301 (packed by the program that started this)


def _content(memory: SharedMemory) -> memoryview:
    content = memory.buf
    if content is None:
        raise ValueError(memory.name)  # it was closed
    return content


def _give_back(memory: SharedMemory) -> None:
    memory.close()
    memory.unlink()
