"""A file to be read: one on the disk, one inside a zip, or bytes sent under a name."""

import errno
import hashlib
import os
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import BinaryIO, Final, TypeAlias

_LARGEST_DIGESTED: Final = 256_000_000  # bytes; a quarter of a second, four times any workbook
_END: Final = 1_000_000  # bytes


@dataclass(frozen=True, slots=True)
class NamedBytes:
    """The content of a file that need not be on any disk.

    Attributes:
        name: as its owner calls it, with folders or without; problems and reports name it so.
        data: its whole content.
    """

    name: str
    data: bytes


@dataclass(frozen=True, slots=True)
class PackedFile:
    """A file inside a zip; its content is read only when it is wanted.

    Attributes:
        archive: the zip.
        place: number of the member in it; see `machine.archive`.
        name: of the member, with its folders.
    """

    archive: Path
    place: int
    name: str


Readable: TypeAlias = Path | NamedBytes | PackedFile
"""What a reader takes."""


def shown_name(source: Readable) -> str:
    """Return what a file is called in a sentence: its path, or the name it came under."""
    if isinstance(source, PackedFile):
        return f"{source.archive}/{source.name}"
    return source.name if isinstance(source, NamedBytes) else str(source)


def pure_path(source: Readable) -> PurePath:
    """Return a file's name for a look at its last part or its suffix; nothing is on the disk."""
    return source if isinstance(source, Path) else PurePath(source.name)


def is_there(source: Readable) -> bool:
    """Tell whether there is such a file; bytes always are."""
    if isinstance(source, PackedFile):
        return source.archive.is_file()
    return isinstance(source, NamedBytes) or source.is_file()


def content_of(source: Readable) -> bytes:
    """Return the whole content.

    Raises:
        OSError: there is no such file, it may not be read, or it is damaged inside its zip.
    """
    if isinstance(source, PackedFile):
        from gripcourse.machine.archive import read_member  # noqa: PLC0415 (few files are packed)

        return read_member(source.archive, source.place)
    return source.data if isinstance(source, NamedBytes) else source.read_bytes()


def in_memory(source: Readable, most: int) -> NamedBytes:
    """Return a file with its content, for who does not see this disk.

    Args:
        source: the file.
        most: bytes; larger ones are not read.

    Raises:
        OSError: there is no such file, it may not be read, is damaged inside its zip, or too large.
    """
    name = shown_name(source)
    if is_larger(source, most):
        raise OSError(errno.EFBIG, os.strerror(errno.EFBIG), name)
    return NamedBytes(name, content_of(source))


def is_larger(source: Readable, most: int) -> bool:
    """Tell whether a file on the disk has more bytes, without reading it.

    Raises:
        OSError: there is no such file.
    """
    return isinstance(source, Path) and source.stat().st_size > most


def digest_of_content(source: Readable) -> str:
    """Return the SHA-256 of the content, hexadecimal; empty for a file that cannot be read.

    A file on the disk is read piece by piece. Of one that is larger than any that is ever looked
    at, the size and both ends are digested: a file of no content can claim a hundred gigabytes.
    """
    try:
        if isinstance(source, Path):
            with source.open("rb") as stream:
                size = stream.seek(0, os.SEEK_END)
                stream.seek(0)
                if size > _LARGEST_DIGESTED:
                    return _digest_of_ends(stream, size)
                return hashlib.file_digest(stream, "sha256").hexdigest()
        return hashlib.sha256(content_of(source)).hexdigest()
    except OSError:
        return ""


def _digest_of_ends(stream: BinaryIO, size: int) -> str:
    digest = hashlib.sha256(str(size).encode())
    digest.update(stream.read(_END))
    stream.seek(-_END, os.SEEK_END)
    digest.update(stream.read(_END))
    return digest.hexdigest()
