"""How large a table may be that a person made: a roster, variants, deadlines, a platform's list.

Rows that are blank from end to end do not count, up to those that a spreadsheet program has: one
may have kept the looks of a million of them.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import Final, TypeVar

from gripcourse.machine.content import Readable, content_of, is_larger
from gripcourse.text.words import Message, message

MOST_ROWS: Final = 200_000  # twice the largest table of variants that anybody solves
MOST_COLUMNS: Final = 2_000
MOST_CELLS: Final = 6_000_000  # of all rows, each as far as its last one
LARGEST_TABLE: Final = 32_000_000  # bytes of a file
ROWS_OF_A_SPREADSHEET: Final = 1 << 20
_ENOUGH: Final = 1 << 18  # bytes from which an encoding is guessed

Row = TypeVar("Row", bound=Sequence[object])


class TooLargeTableError(ValueError):
    """A table that is larger than any that is read."""


def content_of_table(source: Readable) -> bytes:
    """Return the whole content of a table.

    Raises:
        TooLargeTableError: it is larger than any that is read.
        OSError: it cannot be read.
    """
    if is_larger(source, LARGEST_TABLE):
        raise TooLargeTableError
    content = content_of(source)
    if len(content) > LARGEST_TABLE:
        raise TooLargeTableError
    return content


def within_bounds(rows: Iterable[Row]) -> Iterator[Row]:
    """Pass rows on until they are too many.

    Args:
        rows: blank ones, too.

    Raises:
        TooLargeTableError: there are too many of them, or too many cells.
    """
    filled, cells = 0, 0
    for number, row in enumerate(rows, start=1):
        if any(row):
            filled += 1
            cells += len(row)
        if number > ROWS_OF_A_SPREADSHEET or filled > MOST_ROWS:
            raise TooLargeTableError
        if cells > MOST_CELLS or len(row) > MOST_COLUMNS:
            raise TooLargeTableError
        yield row


def around(content: bytes, place: int) -> bytes:
    """Return as much of a text as tells its encoding, in which each letter is one byte.

    Args:
        content: of a file.
        place: of a letter that must be in it.
    """
    start = max(0, place - _ENOUGH // 2)
    return content[start : start + _ENOUGH]


def said_of_too_large() -> tuple[Message, Message]:
    """Return what is wrong with a table that is too large, and what to do."""
    return (
        message(
            "The table is too large: at most {rows} rows, {columns} columns and {cells} cells are"
            " read, in a file of {size} MB.",
            rows=MOST_ROWS,
            columns=MOST_COLUMNS,
            cells=MOST_CELLS,
            size=LARGEST_TABLE // 1_000_000,
        ),
        message(
            "Delete what lies far to the right or below of what you need, or copy the table into a"
            " new file."
        ),
    )
