"""Reading a table that a person made: CSV of either kind, or a spreadsheet.

Nothing is understood here: cells come out as text, rows keep the number that a spreadsheet shows.
Only where the headings are is asked from whoever knows them: an office writes a title above them.
"""

import csv
import io
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path
from typing import TypeAlias

from gripcourse.errors import Problem, TableError
from gripcourse.machine.content import Readable, is_there, pure_path, shown_name
from gripcourse.machine.spreadsheet.by_content import is_workbook
from gripcourse.machine.spreadsheet.table import TableSheet
from gripcourse.machine.table_bounds import (
    MOST_CELLS,
    TooLargeTableError,
    content_of_table,
    said_of_too_large,
    within_bounds,
)
from gripcourse.text.words import Message, message
from gripcourse.variants.decoded import TextOfFile, decoded
from gripcourse.variants.spreadsheet import (
    UnreadableSpreadsheetError,
    read_spreadsheet,
    said_of_hidden,
    said_of_hidden_columns,
)

_DELIMITERS = ("\t", ";", "|", ",")
"""In the order in which they are believed: a heading like `mass, kg` may hold a comma."""

_BEGINNING = 1 << 20  # characters in which the first lines are looked for
_SPREADSHEETS = frozenset({".xlsx", ".xlsm", ".xlsb", ".xls", ".ods", ".numbers"})
_LAST_HEADING = 20  # row: whatever stands above headings is a title, not a page
_FEWEST_KNOWN = 2  # headings in a row of headings; a title may be called as one by chance
_WHOLE_SHARE = 0.3  # of a row's cells that are headings, where it is that row and no title

IsHeading: TypeAlias = Callable[[str], bool]
"""Tells whether a text is the heading of a column."""


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
        rows: those below the headings, without those that are blank from end to end.
        decimal_comma: whether a comma in a number can only be a decimal one; in a file whose cells
            are separated by commas it could group thousands.
        notes: how the file was read where it could have been read in another way.
        heading_row: in which row the headings are, as a spreadsheet shows it.
        titles: what stands in the rows above the headings.
        title: of its sheet, where several of a workbook are read; empty for the only one.
    """

    file: str
    header: tuple[str, ...]
    rows: tuple[SheetRow, ...]
    decimal_comma: bool
    notes: tuple[Message, ...] = ()
    heading_row: int = 1
    titles: tuple[str, ...] = ()
    title: str = ""

    def row_name(self, number: int) -> str:
        """Return what a person calls a row: its number, and its sheet where there are several."""
        return f"{number} [{self.title}]" if self.title else str(number)


@dataclass(frozen=True, slots=True)
class SheetsOfFile:
    """All tables of a file.

    Attributes:
        sheets: those that have headings; else the first one.
        others: titles of the others, where anything stands in them.
    """

    sheets: tuple[Sheet, ...]
    others: tuple[str, ...] = ()


def read_sheet(source: Readable, is_heading: IsHeading = lambda _: False) -> Sheet:
    """Read a `.csv`, `.xlsx`, `.ods` or `.xls` file; of a spreadsheet the first sheet.

    Args:
        source: the file, or its bytes; its name tells what kind of table it is, but a workbook
            is one whatever it is called.
        is_heading: knows what columns may be called, so that titles above the headings are passed
            over; where no row has known headings, the first one that is not blank holds them.

    Returns:
        Its cells as text. A number of a spreadsheet is written with all its digits, a formula
        without a stored result as the formula.

    Raises:
        TableError: the file is missing, not a table, empty, or in no known encoding.
    """
    if not is_there(source):
        if isinstance(source, Path) and source.is_dir():
            what = message("This is a folder, not a file.")
            raise _failure(source, what, message("Name a file."))
        raise _failure(source, message("There is no such file."), message("Check the path."))
    if _is_spreadsheet(source):
        return _spreadsheet(source, is_heading)
    if pure_path(source).suffix.lower() in {".csv", ".txt", ".tsv"}:
        return _csv_sheet(source, is_heading)
    raise _failure(
        source,
        message("A table of this kind cannot be read."),
        message("Save it as .csv (CSV UTF-8) or as .xlsx."),
    )


def read_sheets(source: Readable, is_heading: IsHeading) -> SheetsOfFile:
    """Read all tables of a file; see `read_sheet`."""
    if not (is_there(source) and _is_spreadsheet(source)):
        return SheetsOfFile((read_sheet(source, is_heading),))
    found = _sheets_of(source)
    chosen = [one for one in found if _has_headings(_rows_of(one), is_heading)] or found[:1]
    return SheetsOfFile(
        tuple(replace(_sheet_of(source, one, is_heading), title=one.title) for one in chosen),
        tuple(one.title for one in found if one not in chosen and one.rows),
    )


def cell_place(row: int | str, column: str) -> Message:
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


def _is_spreadsheet(source: Readable) -> bool:
    return pure_path(source).suffix.lower() in _SPREADSHEETS or is_workbook(source)


def _spreadsheet(source: Readable, is_heading: IsHeading) -> Sheet:
    """Read the first sheet that has headings, else the first one; the others are named."""
    sheets = _sheets_of(source)
    rows = list(map(_rows_of, sheets))
    chosen = next((at for at, one in enumerate(rows) if _has_headings(one, is_heading)), 0)
    sheet = _sheet_of(source, sheets[chosen], is_heading)
    others = [one.title for at, one in enumerate(sheets) if at != chosen and one.rows]
    if not others:
        return sheet
    note = message(
        "{file}: only the sheet '{sheet}' was read; there is also: {others}.",
        file=sheet.file,
        sheet=sheets[chosen].title,
        others=", ".join(others),
    )
    return replace(sheet, notes=(*sheet.notes, note))


def _sheet_of(source: Readable, one: TableSheet, is_heading: IsHeading) -> Sheet:
    """Find the headings of a sheet; notes name what is hidden, which counts as all else does."""
    sheet = _sheet(source, _rows_of(one), is_heading)
    rows = [number for number in one.hidden if number > sheet.heading_row]
    places = [place for place in one.hidden_columns if place < len(sheet.header)]
    columns = [column_name(place, sheet.header) for place in places]
    notes = [said_of_hidden(sheet.file, one.title, rows)] if rows else []
    notes += [said_of_hidden_columns(sheet.file, one.title, columns)] if columns else []
    return replace(sheet, notes=(*sheet.notes, *notes))


def _rows_of(sheet: TableSheet) -> list[SheetRow]:
    return [SheetRow(number, _stripped(cells)) for number, cells in sheet.rows]


def _sheets_of(source: Readable) -> Sequence[TableSheet]:
    try:
        return read_spreadsheet(source)
    except UnreadableSpreadsheetError as fault:
        raise _failure(source, fault.what, fault.remedy) from fault


def _has_headings(rows: Sequence[SheetRow], is_heading: IsHeading) -> bool:
    known = (sum(map(is_heading, row.cells)) for row in rows if row.number <= _LAST_HEADING)
    return max(known, default=0) > 0


def _csv_sheet(source: Readable, is_heading: IsHeading) -> Sheet:
    try:
        content = content_of_table(source)
    except TooLargeTableError as fault:
        raise _failure(source, *said_of_too_large()) from fault
    text = decoded(source, content)
    with text.opened() as stream:
        beginning = stream.read(_BEGINNING)
    # A title above may hold any sign; what separates the cells gives most headings.
    likely = sorted(
        _delimiters(beginning), key=lambda one: -_known_headings(beginning, one, is_heading)
    )
    faults: list[TableError] = []
    for delimiter in likely:
        try:
            one = _sheet(source, _csv_rows(source, text, delimiter), is_heading)
        except TableError as fault:
            faults.append(fault)
        else:
            return replace(one, decimal_comma=delimiter != ",", notes=text.notes)
    raise faults[0]


def _known_headings(beginning: str, delimiter: str, is_heading: IsHeading) -> int:
    """Return how many headings are known of a table that is separated so."""
    records = csv.reader(io.StringIO(beginning, newline=""), delimiter=delimiter)
    try:
        first = [_stripped(cells) for cells in islice(records, _LAST_HEADING)]
    except csv.Error:
        return 0
    rows = [SheetRow(number, cells) for number, cells in enumerate(first, start=1) if any(cells)]
    return sum(map(is_heading, rows[_heading_row(rows, is_heading)].cells)) if rows else 0


def _sheet(source: Readable, found: Iterable[SheetRow], is_heading: IsHeading) -> Sheet:
    """Find the headings; cut blank rows and columns off."""
    rows = [row for row in found if any(row.cells)]
    if not rows:
        raise _failure(
            source,
            message("The table is blank."),
            message("Put the headings into the first row of the first sheet."),
        )
    heading = _heading_row(rows, is_heading)
    above, rows = rows[:heading], rows[heading:]
    width = max(_width(row.cells) for row in rows)
    if width * len(rows) > MOST_CELLS:  # one far cell makes every row as wide
        raise _failure(
            source,
            message(
                "The table is {width} columns wide and has {count} rows.",
                width=width,
                count=len(rows),
            ),
            message("Delete the cells that lie far to the right or below of what you need."),
        )
    for place, row in enumerate(rows):
        if len(row.cells) != width:  # in its place: two of a large table are too much
            rows[place] = SheetRow(row.number, (row.cells + ("",) * width)[:width])
    head = rows.pop(0)
    return Sheet(
        file=shown_name(source),
        header=head.cells,
        rows=tuple(rows),
        decimal_comma=True,
        heading_row=head.number,
        titles=tuple(cell for row in above for cell in row.cells if cell),
    )


def _heading_row(rows: Sequence[SheetRow], is_heading: IsHeading) -> int:
    """Return which row holds the headings: the one with most that are known, else the first."""
    known = [sum(map(is_heading, row.cells)) for row in rows if row.number <= _LAST_HEADING] or [0]
    best = known.index(max(known))
    cells = sum(map(bool, rows[best].cells))
    is_one = known[best] >= min(_FEWEST_KNOWN, cells) and known[best] >= _WHOLE_SHARE * cells
    return best if is_one or known[best] > _FEWEST_KNOWN else 0


def _width(cells: tuple[str, ...]) -> int:
    width = len(cells)
    while width and not cells[width - 1]:
        width -= 1
    return width


def _delimiters(text: str) -> tuple[str, ...]:
    """Return what may separate the cells, the likeliest first; the comma where nothing does.

    Judged by the first lines that are not blank, outside quotation marks.
    """
    beginning = text.lstrip("\r\n")[:_BEGINNING]
    lines = [line for line in beginning.splitlines() if line.strip()][:_LAST_HEADING]
    plain = ["".join(line.split('"')[::2]) for line in lines]
    first = [sign for sign in _DELIMITERS if plain and sign in plain[0]]
    later = [sign for sign in _DELIMITERS if any(sign in line for line in plain)]
    return tuple(dict.fromkeys([*first, *later])) or (",",)


def _csv_rows(source: Readable, text: TextOfFile, delimiter: str) -> Iterator[SheetRow]:
    """Yield every record, whatever its length; a quoted line break does not end a row."""
    try:
        rows = csv.reader(text.opened(), delimiter=delimiter, strict=True)
        for number, cells in enumerate(within_bounds(map(_to_the_last, rows)), start=1):
            if cells:
                yield SheetRow(number, cells)
    except TooLargeTableError as fault:
        raise _failure(source, *said_of_too_large()) from fault
    except csv.Error as fault:
        raise _failure(
            source,
            message("The rows cannot be told apart: {fault}.", fault=fault),
            message("Look for a quotation mark that is opened and never closed."),
        ) from fault


def _to_the_last(cells: Sequence[str]) -> tuple[str, ...]:
    """Return the cells of a row without the blank ones behind its last."""
    stripped = _stripped(cells)
    return stripped[: _width(stripped)]


def _stripped(cells: Iterable[str]) -> tuple[str, ...]:
    return tuple(map(str.strip, cells))


def _failure(source: Readable, what: Message, remedy: Message) -> TableError:
    return TableError([Problem(shown_name(source), "", what, remedy)])
