"""How large a table may be that a person made: a roster, variants, deadlines, a platform's list.

Rows that are blank from end to end do not count, up to those that a spreadsheet program has: one
may have kept the looks of a million of them.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import Final, TypeVar

from gripcourse.machine.content import Readable, content_of, is_larger
from gripcourse.text.words import Message, message

MOST_ROWS: Final = 200_000
MOST_COLUMNS: Final = 2_000
# Of all rows, each as far as its last one: a hundred thousand people with a dozen columns each.
MOST_CELLS: Final = 1_250_000
MOST_OF_WORKBOOK: Final = 200_000  # cells of its visible sheets; each takes five times as long
LARGEST_TABLE: Final = 16_000_000  # bytes of a file
ROWS_OF_A_SPREADSHEET: Final = 1 << 20
_ENOUGH: Final = 1 << 18  # bytes from which an encoding is guessed

Row = TypeVar("Row", bound=Sequence[object])


class TooLargeTableError(ValueError):
    """A table that is larger than any that is read."""


class RoomForCells:
    """How much more is read of a workbook; it changes, because a parser calls back.

    Blank cells between others count, those behind the last one of a row do not. A text that many
    cells share counts in each of them: all of them have as many letters as a file of text may have.
    """

    def __init__(self) -> None:
        self._rows = MOST_ROWS
        self._cells = MOST_OF_WORKBOOK
        self._letters = LARGEST_TABLE

    def take_row(self) -> None:
        """Take a row.

        Raises:
            TooLargeTableError: there is none left.
        """
        self._rows -= 1
        if self._rows < 0:
            raise TooLargeTableError

    def put(self, text: str, column: int, row: list[str]) -> None:
        """Put a text into a row that is as long as its last text.

        Args:
            text: not empty.
            column: from 1.
            row: gets it.

        Raises:
            TooLargeTableError: there is no room left, or the column lies too far to the right.
        """
        self._letters -= len(text)
        missing = column - len(row)
        if missing > 0:
            self._cells -= missing
            if self._cells < 0 or column > MOST_COLUMNS:
                raise TooLargeTableError
            row.extend([""] * missing)
        if self._letters < 0:
            raise TooLargeTableError
        row[column - 1] = text


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
    """Return what is wrong with a table of text that is too large, and what to do."""
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
            "Delete what lies far to the right or below of what you need, or split the table into"
            " several files."
        ),
    )


def said_of_too_large_workbook() -> tuple[Message, Message]:
    """Return what is wrong with a spreadsheet that is too large, and what to do."""
    return (
        message(
            "The table is too large: of a spreadsheet at most {rows} rows, {columns} columns and"
            " {cells} cells are read, in a file of {size} MB.",
            rows=MOST_ROWS,
            columns=MOST_COLUMNS,
            cells=MOST_OF_WORKBOOK,
            size=LARGEST_TABLE // 1_000_000,
        ),
        message(
            "Delete what lies far to the right or below of what you need. If it really is so large,"
            " save it as “CSV UTF-8”, of which {cells} cells are read, or split it into several"
            " files.",
            cells=MOST_CELLS,
        ),
    )
