"""The first sheet of the answer workbook: who, how to fill in, progress, given data."""

from typing import TYPE_CHECKING, Final

from gripcourse.solver.plan import Plan
from gripcourse.text.amounts import day_text
from gripcourse.text.shown import shown
from gripcourse.text.words import Words, message
from gripcourse.variants.model import Issued
from gripcourse.workbook import names
from gripcourse.workbook.guidance import HOW_TO
from gripcourse.workbook.layout import (
    COVER_TITLE,
    IDENTITY,
    Cover,
    SheetColumn,
    SheetLine,
    WorkbookLayout,
    quoted,
)
from gripcourse.workbook.style import (
    Styles,
    pages_tall,
    row_height,
    set_page,
    write_symbol,
    write_symbols,
)

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

WIDTHS: Final = {
    SheetColumn.NUMBER: 6,
    SheetColumn.SYMBOL: 12,
    SheetColumn.TITLE: 46,
    SheetColumn.UNIT: 9,
    SheetColumn.VALUE: 17,
    SheetColumn.CHECK: 20,
}
"""Of the columns, in characters."""

_ROW: Final = 16.0  # points, on the average
_LAST_COLUMN: Final = SheetColumn.VALUE  # nothing is checked: the narrower, the larger the print
_DRAWN_TOGETHER: Final = 0.25  # of a page; the print is larger than a section's
_TEXT_COLUMN: Final = SheetColumn.TITLE
LOCKED: Final = {"select_locked_cells": True, "format_columns": True, "format_rows": True}
"""What a student may do with locked cells: look, copy, and change widths and heights."""


def write_cover(
    book: "Workbook",
    placed: WorkbookLayout,
    plan: Plan,
    issued: Issued,
    words: Words,
    styles: Styles,
) -> None:
    """Write the first sheet.

    Args:
        book: that it is added to.
        placed: where everything stands.
        plan: titles of the scheme and its options.
        issued: the student and the given values.
        words: the student's language.
        styles: of `book`.
    """
    cover = placed.cover
    sheet = book.add_worksheet(cover.name)
    for column, width in _widths().items():
        sheet.set_column(column, column, width)
    title = plan.course.title.of(words.language)
    sheet.set_row(COVER_TITLE, 26)
    sheet.write_string(COVER_TITLE, 0, title, styles.title)
    _write_particulars(sheet, plan, issued, words, styles)
    _write_guidance(sheet, cover, words, styles)
    _write_progress(sheet, placed, words, styles)
    _write_givens(book, sheet, cover, issued, words, styles)
    tall = pages_tall(_heights(cover), sum(_widths().values()), drawn_together=_DRAWN_TOGETHER)
    sheet.repeat_rows(cover.given_header)
    set_page(sheet, title, issued.student.name, tall=tall)
    sheet.protect("", LOCKED)
    sheet.activate()


def variant_text(issued: Issued, words: Words) -> str:
    """Name a variant as documents do: with its version where it was issued anew."""
    if issued.version == 1:
        return issued.variant.id
    said = message("{variant}, version {version}", variant=issued.variant.id,
                   version=issued.version)  # fmt: skip
    return words.say(said)


def _widths() -> dict[SheetColumn, int]:
    return {column: width for column, width in WIDTHS.items() if column <= _LAST_COLUMN}


def _heights(cover: Cover) -> list[float]:
    """Return the heights of all rows, as they are where nothing is wrapped."""
    return [_ROW] * cover.given_header + list(map(line_height, (*cover.givens, *cover.constants)))


def _write_particulars(
    sheet: "Worksheet", plan: Plan, issued: Issued, words: Words, styles: Styles
) -> None:
    student, language = issued.student, words.language
    options = [
        (option.title.of(language), choice.title.of(language))
        for option in plan.scheme.options
        for choice in option.choices
        if choice.id == plan.options.get(option.id)
    ]
    pairs = [
        (words.say(message("Student")), student.name),
        (words.say(message("Group")), student.group),
        (words.say(message("Variant")), variant_text(issued, words)),
        (words.say(message("Scheme")), plan.scheme.title.of(language)),
        *options,
        (words.say(message("Issued on")), day_text(issued.issued_on, words)),
        (
            words.say(message("Deadline")),
            day_text(issued.deadline, words) if issued.deadline else "—",
        ),
    ]
    width = WIDTHS[SheetColumn.NUMBER] + WIDTHS[SheetColumn.SYMBOL]
    for row, (label, value) in enumerate(pairs, start=IDENTITY):
        said = label[:1].upper() + label[1:]
        sheet.merge_range(row, 0, row, SheetColumn.SYMBOL, said, styles.label_wrapped)
        sheet.set_row(row, row_height([(said, width)]))
        sheet.write_string(row, _TEXT_COLUMN, shown(value) or "—", styles.particular)


def _write_guidance(sheet: "Worksheet", cover: Cover, words: Words, styles: Styles) -> None:
    heading = words.say(message("How to fill in this workbook"))
    sheet.write_string(cover.guidance, 0, heading, styles.heading)
    for number, sentence in enumerate(HOW_TO, start=1):
        row = cover.guidance + number
        sheet.write_string(row, 0, f"{number}.", styles.hint)
        text = words.say(sentence)
        sheet.merge_range(row, SheetColumn.SYMBOL, row, _LAST_COLUMN, "", styles.paragraph)
        sheet.write_string(row, SheetColumn.SYMBOL, text, styles.paragraph)
        width = sum(_widths().values()) - WIDTHS[SheetColumn.NUMBER]
        sheet.set_row(row, row_height([(text, width)]))


def _write_progress(
    sheet: "Worksheet", placed: WorkbookLayout, words: Words, styles: Styles
) -> None:
    """Write how many cells of each section are filled in; spreadsheet programs keep it current."""
    row = placed.cover.progress
    sheet.write_string(row, 0, words.say(message("Filled in")), styles.heading)
    for offset, section in enumerate(placed.sheets, start=1):
        link = f"internal:{quoted(section.name)}!A1"
        title = section.section.title.of(words.language)
        sheet.write_string(row + offset, SheetColumn.NUMBER, f"{section.number}.", styles.label)
        sheet.write_url(row + offset, SheetColumn.SYMBOL, link, styles.label, title)
        if not section.answered:
            continue
        first, last = section.answered[0].place, section.answered[-1].place
        cells = f"{first.reference}:{last.reference.rpartition('!')[2]}"
        total = words.say(message("of {total}", total=len(section.answered)))
        sheet.write_formula(
            row + offset, SheetColumn.UNIT, f"=COUNTA({cells})", styles.particular, value=0
        )
        sheet.write_string(row + offset, SheetColumn.VALUE, total, styles.label)


def _write_givens(
    book: "Workbook",
    sheet: "Worksheet",
    cover: Cover,
    issued: Issued,
    words: Words,
    styles: Styles,
) -> None:
    row = cover.given_header
    sheet.write_string(row - 1, 0, words.say(message("Given data")), styles.heading)
    for column, heading in enumerate(headings(words)[: SheetColumn.CHECK - 1]):
        sheet.write_string(row, column, heading, styles.head)
    sheet.write_string(row, SheetColumn.VALUE, words.say(message("Value")), styles.head)
    for line in cover.givens:
        _write_given(sheet, line, issued.variant.given[line.quantity.id], styles)
        name = names.cell_name(names.GIVEN, line.quantity.id)
        book.define_name(name, f"={line.place.reference}")
    for line in cover.constants:
        given = issued.variant.given.get(line.quantity.id, line.quantity.value)
        if given is not None:
            _write_given(sheet, line, given, styles)


def _write_given(sheet: "Worksheet", line: SheetLine, value: float, styles: Styles) -> None:
    write_line(sheet, line, styles)
    sheet.write_number(line.place.row, line.place.column, value, styles.given)


def headings(words: Words) -> tuple[str, ...]:
    """Return the headings of the columns up to the unit, then of the answer and its check."""
    return (
        words.say(message("No.")),
        words.say(message("Symbol")),
        words.say(message("Quantity")),
        words.say(message("Unit")),
        words.say(message("Answer")),
        words.say(message("Check")),
    )


def write_line(sheet: "Worksheet", line: SheetLine, styles: Styles) -> None:
    """Write what names a quantity: number, symbol, title, unit."""
    row = line.place.row
    sheet.set_row(row, line_height(line))
    sheet.write_string(row, SheetColumn.NUMBER, line.number, styles.number)
    write_symbol(sheet, row, SheetColumn.SYMBOL, line.symbol, styles)
    write_symbols(sheet, row, SheetColumn.TITLE, line.title, styles.text, styles)
    sheet.write_string(row, SheetColumn.UNIT, line.unit, styles.unit)


def line_height(line: SheetLine) -> float:
    """Return the height of a quantity's row, in points; its symbol may be a whole condition."""
    symbol = line.symbol.replace("_", "")
    return row_height(
        [(line.title, WIDTHS[SheetColumn.TITLE]), (symbol, WIDTHS[SheetColumn.SYMBOL])]
    )
