"""What callers name as a file: a path, bytes, or bytes with a name."""

from collections.abc import Iterable
from os import PathLike, fspath
from pathlib import Path
from typing import BinaryIO, Final, TypeAlias, cast

from gripcourse.api.choices import brief
from gripcourse.errors import Problem, UsageError
from gripcourse.machine.content import NamedBytes, Readable
from gripcourse.text.shown import shown
from gripcourse.text.words import message
from gripcourse.usecases.grading.collect import PassedOver, collect

Content: TypeAlias = bytes | bytearray | memoryview
FileLike: TypeAlias = (
    str | PathLike[str] | Content | BinaryIO | tuple[str, Content | BinaryIO] | NamedBytes
)
"""A path, a content, a file that is open for reading bytes, or one of the last two with a name.

A text is a path, never a content.
"""

_PAIR: Final = 2
_SPREADSHEET: Final = b"PK"  # how every .xlsx begins


def path_of(given: str | PathLike[str]) -> Path:
    """Return a path that the system can be asked for.

    Raises:
        UsageError: no system has such a path.
    """
    text = fspath(given) if isinstance(given, str | PathLike) else None
    if not isinstance(text, str) or not text or "\0" in text:
        named = brief(given) if text is None else shown(str(text))
        what = message("The path '{path}' is none.", path=named)
        raise UsageError([Problem("", "", what, message("Check the path."))])
    return Path(text)


def place_of(gradebook: str | PathLike[str]) -> str:
    """Return a gradebook's path, or its database URL as it is.

    Raises:
        UsageError: no system has such a path.
    """
    url = isinstance(gradebook, str) and "://" in gradebook
    return str(gradebook) if url else str(path_of(gradebook))


def readable(given: FileLike, stem: str) -> Path | NamedBytes:
    """Return what the readers take.

    Args:
        given: by the caller.
        stem: what bytes without a name are called.

    Raises:
        UsageError: it is no file, or no system has a path as it was given.
    """
    match given:
        case NamedBytes(str(name), bytes()) if name:
            return given
        case (str(name), content) if name:
            return NamedBytes(name, _content(content, stem))
        case str() | PathLike():
            return path_of(given)
        case _:
            content = _content(given, stem)
            suffix = ".xlsx" if content.startswith(_SPREADSHEET) else ".csv"
            return NamedBytes(_name_of(given) or f"{stem}{suffix}", content)


def _content(given: object, parameter: str) -> bytes:
    """Return the bytes that somebody gave, or that an open file holds from where it stands.

    Raises:
        UsageError: there are none.
    """
    if isinstance(given, bytes | bytearray | memoryview):
        return bytes(given)
    reading = getattr(given, "read", None)
    content = reading() if callable(reading) else None
    if isinstance(content, bytes):
        return content
    what = message("{value} is no file.", value=brief(given))
    remedy = message("Give a path, bytes, a pair of name and bytes, or a file open for bytes.")
    raise UsageError([Problem("", "", what, remedy, parameter=parameter)])


def _name_of(given: object) -> str:
    """Return what an open file is called; nothing where it has a number only, or no name."""
    name = getattr(given, "name", "")
    return name if isinstance(name, str) else ""


def read(given: FileLike, stem: str) -> NamedBytes:
    """Return the content of a file, with its name.

    Raises:
        OSError: it cannot be read.
    """
    source = readable(given, stem)
    if isinstance(source, NamedBytes):
        return source
    return NamedBytes(str(source), source.read_bytes())


def workbooks(given: FileLike | Iterable[FileLike]) -> tuple[list[Readable], list[PassedOver]]:
    """Return the workbooks to grade: bytes as they are, those of a folder sorted.

    Returns:
        The workbooks, and what else was found in folders.

    Raises:
        UsageError: a path does not exist, a folder holds no workbook, or there is no file.
    """
    files = [given] if _is_one(given) else given
    found: list[Readable] = []
    others: list[PassedOver] = []
    for number, one in enumerate(cast("Iterable[FileLike]", files), start=1):
        source = readable(one, f"workbook-{number}")
        if isinstance(source, NamedBytes):
            found.append(source)
            continue
        collected = collect([source])
        found += collected.files
        others += collected.passed_over
    return list(dict.fromkeys(found)), list(dict.fromkeys(others))


def _is_one(given: object) -> bool:
    """Tell whether this is one file, not several: a text is a path, a pair begins with a name."""
    if isinstance(given, tuple):
        return len(given) == _PAIR and isinstance(given[0], str) and _holds_bytes(given[1])
    return not isinstance(given, Iterable) or isinstance(given, str) or _holds_bytes(given)


def _holds_bytes(given: object) -> bool:
    return isinstance(given, bytes | bytearray | memoryview) or hasattr(given, "read")
