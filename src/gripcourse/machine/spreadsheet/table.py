"""All cells of the first sheet of a spreadsheet: a table that a person made."""

from dataclasses import dataclass

from gripcourse.machine.spreadsheet.cell_value import (
    GENERAL,
    CellValue,
    UnreadableContentError,
    counts_from_1904,
    formats_of,
    shown_value,
)
from gripcourse.machine.spreadsheet.package import Package
from gripcourse.machine.spreadsheet.preflight import TABLE, read_checked
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.sheet_cells import StoredCell, all_cells, shared_texts

MOST_COLUMNS = 2_000


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


def first_sheet(data: bytes) -> tuple[TableRow, ...] | WhyRefused:
    """Read the first sheet of a spreadsheet of any content.

    Returns:
        Its rows without blank ones, or why it cannot be read; nothing is raised.
    """
    try:
        return read_checked("", data, _rows, TABLE)
    except MemoryError:
        return WhyRefused.TOO_LARGE
    except Exception:  # noqa: BLE001 (whatever the bytes make a library raise)
        return WhyRefused.UNREADABLE_CONTENT


def _rows(package: Package) -> tuple[TableRow, ...]:
    workbook = package.workbook_part()
    part = next(iter(package.sheets(workbook).values()))
    parts = {one.kind: one.part for one in package.related(workbook)}
    has_texts = "sharedStrings" in parts
    texts = shared_texts(package.elements(parts["sharedStrings"])) if has_texts else {}
    formats = formats_of(package, parts["styles"]) if "styles" in parts else ()
    from_1904 = counts_from_1904(package, workbook)

    def value_of(cell: StoredCell) -> CellValue:
        number_format = formats[cell.style] if formats else GENERAL
        shown = shown_value(cell, number_format, texts, from_1904=from_1904)
        return cell.formula or None if shown.value is None else shown.value

    rows: list[TableRow] = []
    for number, cells in sorted(all_cells(package.elements(part)).items()):
        values = {column: value_of(cell) for column, cell in cells.items()}
        rows.append(TableRow(number, _in_a_row(values)))
    return tuple(row for row in rows if row.cells)


def _in_a_row(values: dict[int, CellValue]) -> tuple[CellValue, ...]:
    last = max((column for column, value in values.items() if value is not None), default=0)
    if last > MOST_COLUMNS:
        raise UnreadableContentError
    return tuple(values.get(column) for column in range(1, last + 1))
