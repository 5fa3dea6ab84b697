"""What callers name as a file: a path, bytes, or bytes with a name."""

from collections.abc import Iterable
from pathlib import Path
from typing import TypeAlias

from gripcourse.errors import Problem, UsageError
from gripcourse.machine.content import NamedBytes, Readable
from gripcourse.text.shown import shown
from gripcourse.text.words import message
from gripcourse.usecases.grading.collect import PassedOver, collect

FileLike: TypeAlias = str | Path | bytes | tuple[str, bytes] | NamedBytes
"""A text is a path, never a content."""

_SPREADSHEET = b"PK"  # how every .xlsx begins


def path_of(given: str | Path) -> Path:
    """Return a path that the system can be asked for.

    Raises:
        UsageError: no system has such a path.
    """
    text = str(given)
    if not text or "\0" in text:
        what = message("The path '{path}' is none.", path=shown(text))
        raise UsageError([Problem("", "", what, message("Check the path."))])
    return Path(given)


def place_of(gradebook: str | Path) -> str:
    """Return a gradebook's path, or its database URL as it is.

    Raises:
        UsageError: no system has such a path.
    """
    return str(gradebook) if "://" in str(gradebook) else str(path_of(gradebook))


def readable(given: FileLike, stem: str) -> Path | NamedBytes:
    """Return what the readers take.

    Args:
        given: by the caller.
        stem: what bytes without a name are called.

    Raises:
        UsageError: no system has a path as it was given.
    """
    if isinstance(given, bytes):
        suffix = ".xlsx" if given.startswith(_SPREADSHEET) else ".csv"
        return NamedBytes(f"{stem}{suffix}", given)
    if isinstance(given, tuple):
        return NamedBytes(*given)
    if isinstance(given, str | Path):
        return path_of(given)
    return given


def read(given: FileLike, stem: str) -> NamedBytes:
    """Return the content of a file, with its name.

    Raises:
        OSError: it cannot be read.
    """
    source = readable(given, stem)
    if isinstance(source, NamedBytes):
        return source
    return NamedBytes(str(source), source.read_bytes())


def workbooks(given: Iterable[FileLike]) -> tuple[list[Readable], list[PassedOver]]:
    """Return the workbooks to grade: bytes as they are, those of a folder sorted.

    Returns:
        The workbooks, and what else was found in folders.

    Raises:
        UsageError: a path does not exist, or a folder holds no workbook.
    """
    found: list[Readable] = []
    others: list[PassedOver] = []
    for number, one in enumerate(given, start=1):
        source = readable(one, f"workbook-{number}")
        if isinstance(source, NamedBytes):
            found.append(source)
            continue
        collected = collect([source])
        found += collected.files
        others += collected.passed_over
    return list(dict.fromkeys(found)), list(dict.fromkeys(others))
