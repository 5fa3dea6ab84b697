"""A file to be read: one on the disk, or bytes that somebody sent under a name."""

from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import TypeAlias


@dataclass(frozen=True, slots=True)
class NamedBytes:
    """The content of a file that need not be on any disk.

    Attributes:
        name: as its owner calls it, with folders or without; problems and reports name it so.
        data: its whole content.
    """

    name: str
    data: bytes


Readable: TypeAlias = Path | NamedBytes
"""What a reader takes."""


def shown_name(source: Readable) -> str:
    """Return what a file is called in a sentence: its path, or the name it came under."""
    return source.name if isinstance(source, NamedBytes) else str(source)


def pure_path(source: Readable) -> PurePath:
    """Return a file's name for a look at its last part or its suffix; nothing is on the disk."""
    return PurePath(source.name) if isinstance(source, NamedBytes) else source


def is_there(source: Readable) -> bool:
    """Tell whether there is such a file; bytes always are."""
    return isinstance(source, NamedBytes) or source.is_file()


def content_of(source: Readable) -> bytes:
    """Return the whole content.

    Raises:
        OSError: there is no such file, or it may not be read.
    """
    return source.data if isinstance(source, NamedBytes) else source.read_bytes()
