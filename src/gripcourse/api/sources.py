"""What callers name as a file: a path, bytes, or bytes with a name."""

from collections.abc import Iterable
from pathlib import Path
from typing import TypeAlias

from gripcourse.machine.content import NamedBytes, Readable
from gripcourse.usecases.grading.collect import PassedOver, collect

FileLike: TypeAlias = str | Path | bytes | tuple[str, bytes] | NamedBytes
"""A text is a path, never a content."""

_SPREADSHEET = b"PK"  # how every .xlsx begins


def readable(given: FileLike, stem: str) -> Path | NamedBytes:
    """Return what the readers take.

    Args:
        given: by the caller.
        stem: what bytes without a name are called.
    """
    if isinstance(given, bytes):
        suffix = ".xlsx" if given.startswith(_SPREADSHEET) else ".csv"
        return NamedBytes(f"{stem}{suffix}", given)
    if isinstance(given, tuple):
        return NamedBytes(*given)
    return Path(given) if isinstance(given, str) else given


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
