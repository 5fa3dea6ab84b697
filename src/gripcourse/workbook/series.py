"""The sheet of an answer workbook with the series and tables that its answers are taken from."""

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Final

from gripcourse.formula.prose import without_looks
from gripcourse.solver.needed_tables import NeededTable, needed_tables
from gripcourse.solver.plan import Plan
from gripcourse.text.units import unit_text
from gripcourse.text.words import Words, message
from gripcourse.workbook.cover import LOCKED
from gripcourse.workbook.layout import WorkbookLayout
from gripcourse.workbook.style import Styles, row_height, set_page
from gripcourse.workbook.wrapping import lines_taken

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

_COLUMNS: Final = 10  # of sizes in a row, as many as a page has room for
_WIDTH: Final = 10.8  # of a column, in characters
_FIRST: Final = 3  # row of the first series
_LINE: Final = 12.75  # points of a row
_HEADING_LINE, _HEADING_EDGES = 10.5, 4.0  # points: of a line of a heading, and round them
_HEADING_LETTERS: Final = 0.86  # of headings beside usual ones: bold, and smaller
_PAGE: Final = 850.0  # points of rows on a page where the columns are as wide as it
_DRAWN_TOGETHER: Final = 1.15  # of a page: so much is printed smaller, on one


def write_series(
    book: "Workbook", placed: WorkbookLayout, plan: Plan, right: str, words: Words, styles: Styles
) -> None:
    """Write the sheet; none for an assignment whose answers are taken from no table.

    Args:
        book: that it is added to.
        placed: its name, and the numbers of the answers.
        plan: whose tables are shown, exactly as they are declared.
        right: what stands above the page at the right.
        words: the student's language.
        styles: of `book`.
    """
    tables = needed_tables(plan)
    if not tables:
        return
    sheet = book.add_worksheet(placed.series)
    sheet.set_default_row(_LINE)
    sheet.set_column(0, _COLUMNS - 1, _WIDTH)
    title = words.say(message("Series and tables"))
    sheet.set_row(0, 26)
    sheet.write_string(0, 0, title, styles.title)
    said = message("Behind the title of each stand the numbers of the answers taken from it.")
    sheet.write_string(1, 0, words.say(said), styles.hint_line)
    row, heights = _FIRST, [(0, _LINE * _FIRST)]
    for table in tables:
        first = row
        heading = " ".join((_title(table, words), *_takers(table, placed)))
        sheet.merge_range(row, 0, row, _COLUMNS - 1, "", styles.heading_line)
        sheet.write_string(row, 0, heading, styles.heading_line)
        sheet.set_row(row, row_height([(heading, _WIDTH * _COLUMNS)]))
        row = 1 + _write_table(sheet, row + 1, table, words, styles)
        beyond = sum(_heading_height(table, names, words) - _LINE for names in _parts(table))
        heights.append((first, _LINE * (row - first) + beyond))
    together = sum(height for _, height in heights) <= _DRAWN_TOGETHER * _PAGE
    set_page(sheet, title, right, tall=1 if together else 0)
    if not together:
        sheet.set_h_pagebreaks(page_breaks(heights, _PAGE))
    sheet.protect("", LOCKED)


def page_breaks(heights: Sequence[tuple[int, float]], page: float) -> list[int]:
    """Return the rows that pages begin with, so that no table is torn that a page has room for.

    Args:
        heights: the first row of everything that stays together, and its height.
        page: height of a page, in the same unit.
    """
    breaks: list[int] = []
    used = 0.0
    for row, height in heights:
        if used and used + height > page:
            breaks.append(row)
            used = 0.0
        used += height
    return breaks


def _parts(table: NeededTable) -> Iterator[tuple[str, ...]]:
    """Yield the columns of each part of a table: a wide one goes on below, its sizes in front."""
    if not table.is_series:
        first, *others = table.columns
        for at in range(0, len(others), _COLUMNS - 1):
            yield first, *others[at : at + _COLUMNS - 1]


def _heading_height(table: NeededTable, names: Iterable[str], words: Words) -> float:
    room = _WIDTH / _HEADING_LETTERS
    lines = max(lines_taken(_heading(table, name, words), room) for name in names)
    return _HEADING_LINE * lines + _HEADING_EDGES


def _title(table: NeededTable, words: Words) -> str:
    catalogue = table.catalogue
    title = catalogue.source if catalogue.title is None else catalogue.title
    unit = unit_text(catalogue.units[table.columns[0]], words.language) if table.is_series else ""
    return f"{table.number}. {without_looks(title.of(words.language))}{f', {unit}' if unit else ''}"


def _takers(table: NeededTable, placed: WorkbookLayout) -> Iterator[str]:
    numbers = {line.quantity.id: line.number for one in placed.sheets for line in one.answered}
    taken = [numbers[one.id] for one in table.takers if one.id in numbers]
    if taken:
        yield f"→ {', '.join(taken)}"


def _write_table(
    sheet: "Worksheet", row: int, table: NeededTable, words: Words, styles: Styles
) -> int:
    """Write the numbers from a row on; return the row after the last one."""
    if table.is_series:
        sizes = [size for (size,) in table.rows]
        lines = [sizes[at : at + _COLUMNS] for at in range(0, len(sizes), _COLUMNS)]
        return _write_lines(sheet, row, lines, styles)
    for names in _parts(table):
        shown = [table.columns.index(name) for name in names]
        for column, name in enumerate(names):
            sheet.write_string(row, column, _heading(table, name, words), styles.small_head)
        sheet.set_row(row, _heading_height(table, names, words))
        row = _write_lines(
            sheet, row + 1, [[line[index] for index in shown] for line in table.rows], styles
        )
    return row


def _heading(table: NeededTable, name: str, words: Words) -> str:
    catalogue = table.catalogue
    heading = catalogue.headings[name].of(words.language) if name in catalogue.headings else ""
    return ", ".join(
        part
        for part in (without_looks(heading), unit_text(catalogue.units[name], words.language))
        if part
    )


def _write_lines(
    sheet: "Worksheet", row: int, lines: Sequence[Sequence[float]], styles: Styles
) -> int:
    for offset, line in enumerate(lines):
        # LibreOffice takes no height from the sheet: it would press these rows together.
        sheet.set_row(row + offset, _LINE)
        for column, size in enumerate(line):
            sheet.write_number(row + offset, column, size, styles.size)
    return row + len(lines)
