"""All cells of the sheets of a spreadsheet: tables that a person made."""

from bisect import bisect_right
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Final
from xml.etree.ElementTree import Element

from gripcourse.machine.process_wide import few_collections
from gripcourse.machine.spreadsheet.cell_value import (
    CellValue,
    UnreadableContentError,
    counts_from_1904,
    formats_of,
    shown_value,
)
from gripcourse.machine.spreadsheet.package import Package
from gripcourse.machine.spreadsheet.preflight import TABLE, read_checked
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.sheet_cells import (
    Merged,
    StoredCell,
    all_cells,
    shared_texts,
    without_crossed_out,
)
from gripcourse.machine.table_bounds import MOST_COLUMNS, TooLargeTableError, within_bounds

_MOST_FILLED: Final = 1_000_000  # cells of merged ranges


@dataclass(frozen=True, slots=True)
class TableRow:
    """A row that holds anything.

    Attributes:
        number: as a spreadsheet shows it, from 1.
        cells: from the first column to the last that holds something; of a formula its stored
            result, or the formula where none is stored.
    """

    number: int
    cells: tuple[CellValue, ...]


@dataclass(frozen=True, slots=True)
class TableSheet:
    """A sheet that holds anything.

    Attributes:
        title: of the sheet.
        rows: without blank ones.
    """

    title: str
    rows: tuple[TableRow, ...]


def visible_sheets(data: bytes) -> tuple[TableSheet, ...] | WhyRefused:
    """Read the sheets of a spreadsheet of any content, as they are shown.

    A cell of a merged range shows down to its end what its first row has.

    Returns:
        Those that are not hidden and not blank (where all are hidden, the first), in their order;
        or why the file cannot be read; nothing is raised.
    """
    try:
        with few_collections():  # three quarters of the time otherwise, of a hundred thousand rows
            return read_checked("", data, _sheets_within_bounds, TABLE)
    except MemoryError:
        return WhyRefused.TOO_LARGE
    except Exception:  # noqa: BLE001 (whatever the bytes make a library raise)
        return WhyRefused.UNREADABLE_CONTENT


def _sheets_within_bounds(package: Package) -> tuple[TableSheet, ...] | WhyRefused:
    try:
        return _sheets(package)
    except TooLargeTableError:  # known: no second look at all of it is worth its time
        return WhyRefused.TOO_LARGE


def _sheets(package: Package) -> tuple[TableSheet, ...]:
    workbook = package.workbook_part()
    sheets, hidden = package.sheets(workbook), package.hidden_sheets(workbook)
    titles = [title for title in sheets if title not in hidden] or list(sheets)[:1]
    parts = {one.kind: one.part for one in package.related(workbook)}
    has_texts = package.has(parts.get("sharedStrings", ""))
    texts = shared_texts(package.elements(parts["sharedStrings"])) if has_texts else {}
    formats = formats_of(package, parts.get("styles"))
    from_1904 = counts_from_1904(package, workbook)

    def value_of(cell: StoredCell) -> CellValue:
        if cell.kind == "n" and cell.text is not None and formats.is_lost(cell):
            raise UnreadableContentError  # half a point may have been half of all of them
        shown = shown_value(cell, formats.of(cell), texts, from_1904=from_1904)
        if shown.error and shown.value is None:  # a text that is not there: nobody may be left out
            raise UnreadableContentError
        value = without_crossed_out(shown.value) if isinstance(shown.value, str) else shown.value
        return cell.formula or None if value is None else value

    # Two titles may lead to one part, which is read once.
    once = {sheets[title]: title for title in reversed(titles)}
    found = [
        TableSheet(title, _rows(package.elements(part), value_of))
        for part, title in reversed(once.items())
    ]
    if not found:
        raise UnreadableContentError
    return tuple(one for one in found if one.rows) or (found[0],)


def _rows(
    elements: Iterable[Element], value_of: Callable[[StoredCell], CellValue]
) -> tuple[TableRow, ...]:
    merged: list[Merged] = []
    cells = all_cells(elements, merged)
    values = {
        number: {column: value_of(cell) for column, cell in of_row.items()}
        for number, of_row in sorted(cells.items())
    }
    _fill_down(values, merged)
    shown = within_bounds(map(_in_a_row, values.values()))
    rows = (TableRow(number, one) for number, one in zip(values, shown, strict=True))
    return tuple(row for row in rows if row.cells)


def _fill_down(values: dict[int, dict[int, CellValue]], merged: Iterable[Merged]) -> None:
    """Write what a merged range shows into its rows; a row without cells gets none."""
    numbers = list(values)
    left = _MOST_FILLED
    for (first, column), (last, _) in merged:
        value = values.get(first, {}).get(column)
        if value is None:
            continue
        rows = numbers[bisect_right(numbers, first) : bisect_right(numbers, last)]
        left -= len(rows)
        if left < 0:  # ranges of a spreadsheet program do not overlap
            raise UnreadableContentError
        for number in rows:
            values[number][column] = value


def _in_a_row(values: dict[int, CellValue]) -> tuple[CellValue, ...]:
    last = max((column for column, value in values.items() if value is not None), default=0)
    if last > MOST_COLUMNS:
        raise TooLargeTableError
    return tuple(values.get(column) for column in range(1, last + 1))
