"""All cells of the sheets of a spreadsheet: tables that a person made."""

import re
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date, time
from itertools import accumulate
from typing import Final, TypeAlias

from gripcourse.machine.process_wide import few_collections
from gripcourse.machine.spreadsheet.cell_value import (
    CellValue,
    NumberFormats,
    UnreadableContentError,
    counts_from_1904,
    formats_of,
    shown_value,
    text_index,
)
from gripcourse.machine.spreadsheet.long_parts import (
    LongSheet,
    ShownText,
    read_long_sheet,
    read_long_texts,
)
from gripcourse.machine.spreadsheet.package import Package
from gripcourse.machine.spreadsheet.preflight import TABLE, DecidedError, read_checked
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.sheet_cells import (
    StoredCell,
    unescaped,
    without_crossed_out,
)
from gripcourse.machine.spreadsheet.xml_scan import RefusedError
from gripcourse.machine.table_bounds import RoomForCells, TooLargeTableError, within_bounds

# Digits of a number that are kept by whatever holds it.
_SIMPLE: Final = re.compile(r"-?\d{1,15}(?:\.\d{1,20})?(?:[eE][+-]?\d{1,2})?", re.ASCII)
_NOUGHTS: Final = re.compile("0+")


TableRow: TypeAlias = tuple[int, tuple[str, ...]]
"""A row that holds anything: its number, as a spreadsheet shows it, and its cells as text.

They are those from the first column to the last that holds something: a number with all its digits,
of a formula its stored result, or the formula where none is stored.
"""


@dataclass(frozen=True, slots=True)
class TableSheet:
    """A sheet that holds anything.

    Attributes:
        title: of the sheet.
        rows: without blank ones.
        hidden: numbers of those that no program shows, as a filter leaves them out.
        hidden_columns: places, from 0, of the columns that no program shows and that hold anything.
    """

    title: str
    rows: tuple[TableRow, ...]
    hidden: tuple[int, ...] = ()
    hidden_columns: tuple[int, ...] = ()


def visible_sheets(data: bytes) -> tuple[TableSheet, ...] | WhyRefused:
    """Read the sheets of a spreadsheet of any content, as they are shown.

    A cell of a merged range shows down to its end what its first row has.

    Returns:
        Those that are not hidden and not blank (where all are hidden, the first), in their order;
        or why the file cannot be read; nothing is raised.
    """
    try:
        with few_collections():  # three quarters of the time otherwise, of a hundred thousand rows
            return read_checked("", data, _sheets_or_reason, TABLE)
    except MemoryError:
        return WhyRefused.TOO_LARGE
    except Exception:  # noqa: BLE001 (whatever the bytes make a library raise)
        return WhyRefused.UNREADABLE_CONTENT


def _sheets_or_reason(package: Package) -> tuple[TableSheet, ...]:
    try:
        return _sheets(package)
    except TooLargeTableError:
        reason = WhyRefused.TOO_LARGE
    except UnreadableContentError:
        reason = WhyRefused.UNREADABLE_CONTENT
    except RefusedError as refused:
        reason = refused.reason
    raise DecidedError(reason)


def _sheets(package: Package) -> tuple[TableSheet, ...]:
    workbook = package.workbook_part()
    sheets, hidden = package.sheets(workbook), package.hidden_sheets(workbook)
    titles = [title for title in sheets if title not in hidden] or list(sheets)[:1]
    parts = {one.kind: one.part for one in package.related(workbook)}
    has_texts = package.has(parts.get("sharedStrings", ""))
    texts = package.long_part(parts["sharedStrings"], read_long_texts) if has_texts else []
    formats = formats_of(package, parts.get("styles"))
    shown = _shown_by(texts, formats, from_1904=counts_from_1904(package, workbook))
    room = RoomForCells()
    # Two titles may lead to one part, which is read once.
    once = {sheets[title]: title for title in reversed(titles)}
    read = [
        (title, _long_sheet(package, part, shown, room)) for part, title in reversed(once.items())
    ]
    found = [_table_sheet(title, sheet, room) for title, sheet in read]
    if not found:
        raise UnreadableContentError
    return tuple(one for one in found if one.rows) or (found[0],)


def _long_sheet(package: Package, part: str, shown: ShownText, room: RoomForCells) -> LongSheet:
    return package.long_part(
        part, lambda content, scan: read_long_sheet(content, scan, shown, room)
    )


def _shown_by(texts: Sequence[str], formats: NumberFormats, *, from_1904: bool) -> ShownText:
    """Return what tells the text that a cell shows."""
    plain = {style for style in range(len(formats.of_styles)) if formats.is_plain(style)} or {0}
    # Once: a long one may stand in every cell.
    texts = [without_crossed_out(text).strip() for text in texts]
    by_number = dict(enumerate(texts))

    def shown(kind: str, text: str | None, style: int, formula: str) -> str:
        if text is None:
            return formula
        if kind == "s":
            index = text_index(text)
            if index is None or index >= len(texts):  # nobody may be left out
                raise UnreadableContentError
            return texts[index] or formula
        if kind in {"inlineStr", "str"}:
            return without_crossed_out(text if kind == "inlineStr" else unescaped(text)) or formula
        if kind == "n" and style in plain and _SIMPLE.fullmatch(text):
            number = float(text)
            if number:  # one that is too small to be held is no zero
                return str(int(number)) if number.is_integer() else str(number)
        return shown_in_full(StoredCell(kind, text, style, formula)) or formula

    def shown_in_full(cell: StoredCell) -> str:
        if cell.kind == "n" and formats.is_lost(cell):
            raise UnreadableContentError  # half a point may have been half of all of them
        number_format = formats.of(cell)
        value = shown_value(cell, number_format, by_number, from_1904=from_1904).value
        return _as_shown(value, number_format)

    return shown


def _as_shown(value: CellValue, number_format: str) -> str:
    """Return the text of a value; an id may owe its first noughts to a format such as `00000`."""
    if isinstance(value, str):
        return _cell_text(without_crossed_out(value))
    is_id = isinstance(value, int) and value >= 0 and _NOUGHTS.fullmatch(number_format)
    return _cell_text(value).zfill(len(number_format)) if is_id else _cell_text(value)


def _table_sheet(title: str, sheet: LongSheet, room: RoomForCells) -> TableSheet:
    rows = _rows(sheet, room)
    width = max((len(cells) for _, cells in rows), default=0)
    places = _hidden_places(sheet, width)
    held = (one for one in places if any(len(cells) > one and cells[one] for _, cells in rows))
    return TableSheet(title, rows, sheet.hidden, tuple(held))


def _hidden_places(sheet: LongSheet, width: int) -> list[int]:
    """Return the places, from 0, of hidden columns; of a strange file, runs may overlap."""
    steps = [0] * (width + 1)
    for first, last in sheet.hidden_columns:
        if 0 < first <= last:
            steps[min(first - 1, width)] += 1
            steps[min(last, width)] -= 1
    return [place for place, runs in enumerate(accumulate(steps[:width])) if runs]


def _rows(sheet: LongSheet, room: RoomForCells) -> tuple[TableRow, ...]:
    values = {number: sheet.rows[number] for number in sorted(sheet.rows)}
    _fill_down(values, sheet, room)
    shown = within_bounds(tuple(row or ()) for row in values.values())
    return tuple(row for row in zip(values, shown, strict=True) if row[1])


def _fill_down(values: dict[int, list[str] | None], sheet: LongSheet, room: RoomForCells) -> None:
    """Write what a merged range shows into its rows; a row without cells gets none."""
    numbers = list(values)
    for (first, column), (last, _) in sheet.merged:
        above = values.get(first) or []
        value = above[column - 1] if column <= len(above) else ""
        if not value:
            continue
        for number in numbers[bisect_right(numbers, first) : bisect_right(numbers, last)]:
            row = values[number] = values[number] or []
            room.put(value, column, row)


def _cell_text(value: CellValue) -> str:
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    if isinstance(value, date | time):
        return value.isoformat()
    return str(value)
