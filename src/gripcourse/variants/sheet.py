"""Reading a table that a person made: CSV of either kind, or a spreadsheet.

Nothing is understood here: cells come out as text, rows keep the number that a spreadsheet shows.
"""

import csv
import io
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import date, time

from gripcourse.errors import Problem, TableError
from gripcourse.machine.content import Readable, content_of, is_there, pure_path, shown_name
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.table import first_sheet
from gripcourse.text.words import Message, message

_DELIMITERS = ("\t", ";", ",")
"""In the order in which they are believed: a heading like `mass, kg` may hold a comma."""


@dataclass(frozen=True, slots=True)
class SheetRow:
    """A row as it stands in the file.

    Attributes:
        number: as a spreadsheet shows it; the heading is row 1.
        cells: text without surrounding blanks, as many as there are headings.
    """

    number: int
    cells: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Sheet:
    """A table as text.

    Attributes:
        file: the path, as the user would type it.
        header: the headings; an empty one where a column has cells but no heading.
        rows: without those that are blank from end to end.
        decimal_comma: whether a comma in a number can only be a decimal one; in a file whose cells
            are separated by commas it could group thousands.
    """

    file: str
    header: tuple[str, ...]
    rows: tuple[SheetRow, ...]
    decimal_comma: bool


def read_sheet(source: Readable) -> Sheet:
    """Read a `.csv` or `.xlsx` file; of a spreadsheet the first sheet.

    Args:
        source: the file, or its bytes; its name tells what kind of table it is.

    Returns:
        Its cells as text. A number of a spreadsheet is written with all its digits, a formula
        without a stored result as the formula.

    Raises:
        TableError: the file is missing, not a table, empty, or not in UTF-8.
    """
    if not is_there(source):
        raise _failure(source, message("There is no such file."), message("Check the path."))
    suffix = pure_path(source).suffix.lower()
    if suffix == ".xlsx":
        return _sheet(source, _spreadsheet_rows(source), decimal_comma=True)
    if suffix in {".csv", ".txt", ".tsv"}:
        text = _text(source)
        delimiter = _delimiter(text)
        return _sheet(source, _csv_rows(source, text, delimiter), decimal_comma=delimiter != ",")
    raise _failure(
        source,
        message("A table of this kind cannot be read."),
        message("Save it as .csv (CSV UTF-8) or as .xlsx."),
    )


def cell_place(row: int, column: str) -> Message:
    """Name a cell as a person finds it."""
    return message("row {row}, column {column}", row=row, column=column)


def column_name(position: int, header: tuple[str, ...]) -> str:
    """Return what a person calls a column: its heading, or its letter where it has none.

    Args:
        position: from 0.
        header: the headings.
    """
    if header[position]:
        return header[position]
    letters = ""
    rest = position + 1
    while rest:
        rest, letter = divmod(rest - 1, 26)
        letters = chr(ord("A") + letter) + letters
    return letters


def _sheet(source: Readable, found: list[SheetRow], *, decimal_comma: bool) -> Sheet:
    """Cut blank rows and columns off."""
    rows = [row for row in found if any(row.cells)]
    if not rows or rows[0].number != 1:
        raise _failure(
            source,
            message("The first row is blank; it must hold the headings."),
            message("Put the headings into the first row of the first sheet."),
        )
    width = max(_width(row.cells) for row in rows)
    padded = [SheetRow(row.number, (row.cells + ("",) * width)[:width]) for row in rows]
    return Sheet(shown_name(source), padded[0].cells, tuple(padded[1:]), decimal_comma)


def _width(cells: tuple[str, ...]) -> int:
    return max((position for position, cell in enumerate(cells, start=1) if cell), default=0)


def _text(source: Readable) -> str:
    try:
        return content_of(source).decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        raise _failure(
            source,
            message("The file is not in UTF-8: line {line} cannot be read.",
                    line=fault.object[: fault.start].count(b"\n") + 1),
            message("Save it again as “CSV UTF-8”: Excel has it in its list of file types."),
        ) from fault  # fmt: skip


def _delimiter(text: str) -> str:
    """Return what separates the cells, judged by the headings outside quotation marks."""
    heading = text.partition("\n")[0]
    plain = "".join(heading.split('"')[::2])
    return next((sign for sign in _DELIMITERS if sign in plain), ",")


def _csv_rows(source: Readable, text: str, delimiter: str) -> list[SheetRow]:
    """Read every record, whatever its length; a quoted line break does not end a row."""
    if not text.strip():
        return []
    try:
        rows = list(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True))
    except csv.Error as fault:
        raise _failure(
            source,
            message("The rows cannot be told apart: {fault}.", fault=fault),
            message("Look for a quotation mark that is opened and never closed."),
        ) from fault
    return [SheetRow(number, _stripped(row)) for number, row in enumerate(rows, start=1)]


def _spreadsheet_rows(source: Readable) -> list[SheetRow]:
    """Read the first sheet: stored results, and the formula where no result is stored."""
    rows = first_sheet(content_of(source))
    if rows is WhyRefused.TOO_LARGE:
        raise _failure(
            source,
            message("The spreadsheet holds far more than a table of this kind does."),
            message("Copy the table into a new spreadsheet, or save it as .csv (CSV UTF-8)."),
        )
    if isinstance(rows, WhyRefused):
        raise _failure(
            source,
            message("The file is damaged, protected by a password, or no spreadsheet."),
            message("Open it in a spreadsheet program and save it again as .xlsx."),
        )
    return [SheetRow(row.number, _stripped(map(_cell_text, row.cells))) for row in rows]


def _cell_text(cell: object) -> str:
    if cell is None:
        return ""
    if isinstance(cell, float) and cell.is_integer():
        return str(int(cell))
    if isinstance(cell, date | time):
        return cell.isoformat()
    return str(cell)


def _stripped(cells: Iterable[str]) -> tuple[str, ...]:
    return tuple(cell.strip() for cell in cells)


def _failure(source: Readable, what: Message, remedy: Message) -> TableError:
    return TableError([Problem(shown_name(source), "", what, remedy)])
