"""Whether a table that is about to be written can be written, and could be read again."""

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from gripcourse.errors import Problem, TableError
from gripcourse.machine.table_bounds import LARGEST_TABLE, MOST_CELLS, MOST_ROWS
from gripcourse.text.words import message

CSV: Final = ".csv"
WORKBOOK: Final = ".xlsx"


@dataclass(frozen=True, slots=True)
class Room:
    """How many cells a table has, and how many are read of one of its kind."""

    cells: int
    most: int


def expect_kind(path: Path) -> str:
    """Return which kind of table a name asks for.

    Raises:
        TableError: none that can be written.
    """
    kind = path.suffix.lower()
    if kind in {CSV, WORKBOOK}:
        return kind
    what = message("A table of this kind cannot be written.")
    remedy = message("Name a file that ends in .csv or .xlsx.")
    raise TableError([Problem(str(path), "", what, remedy)])


def expect_readable(path: Path, rows: int, columns: int, room: Room, size: int = 0) -> None:
    """See that a table can be read again, before it is written.

    Args:
        path: of the file.
        rows: with the headings.
        columns: of the table.
        room: its cells.
        size: of the file, in bytes.

    Raises:
        TableError: it cannot.
    """
    if rows <= MOST_ROWS and room.cells <= room.most and size <= LARGEST_TABLE:
        return
    what = message(
        "The table would have {rows} rows and {columns} columns, more than is read again: {most}"
        " cells at most. Nothing was written.",
        rows=rows,
        columns=columns,
        most=room.most,
    )
    fewer = message("Make a table of its own for each scheme, or one of fewer variants.")
    if room.most < MOST_CELLS:
        fewer = message(
            "Name a file that ends in .csv, of which {cells} cells are read, or make a table of its"
            " own for each scheme, or one of fewer variants.",
            cells=MOST_CELLS,
        )
    raise TableError([Problem(str(path), "", what, fewer)])
