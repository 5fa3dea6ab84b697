"""The sheet of one section: a row per quantity, its answer cell, and a cell that checks the kind.

A check cell says what is wrong with the kind of an answer, never with its value.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.formula.prose import without_looks
from gripcourse.text.words import Words, message
from gripcourse.variants.model import Issued
from gripcourse.workbook import names
from gripcourse.workbook.cover import LOCKED, WIDTHS, headings, line_height, write_line
from gripcourse.workbook.guidance import DECIMAL_SIGN
from gripcourse.workbook.layout import SECTION_HEADER, SectionSheet, SheetColumn, SheetLine
from gripcourse.workbook.style import Styles, pages_tall, row_height, set_page, write_symbols

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

_BY_INSTRUCTOR: Final = message("marked by the instructor")
_TITLE_ROW: Final = 0
_TASK_ROW: Final = 1
_HINT_ROW: Final = 2
_TITLE_HEIGHT: Final = 26
_HEAD_HEIGHT: Final = 22
_LONGEST_PROMPT_TITLE: Final = 32
_LONGEST_PROMPT: Final = 255
_WIDEST: Final = 1e15  # bound of an answer that declares none


def write_section(
    book: "Workbook",
    section: SectionSheet,
    issued: Issued,
    course: Course,
    words: Words,
    styles: Styles,
) -> None:
    """Write the sheet of a section.

    Args:
        book: that it is added to.
        section: where everything stands.
        issued: the student, for the header of the page.
        course: its title, likewise.
        words: the student's language.
        styles: of `book`.
    """
    sheet = book.add_worksheet(section.name)
    for column, width in WIDTHS.items():
        sheet.set_column(column, column, width)
    _write_top(sheet, section, words, styles)
    for line in section.answered:
        write_line(sheet, line, styles)
        _write_answer(sheet, line, words, styles)
        name = names.cell_name(names.ANSWER, line.quantity.id)
        book.define_name(name, f"={line.place.reference}")
    for line in section.manual:
        write_line(sheet, line, styles)
        said = words.say(_BY_INSTRUCTOR)
        sheet.set_row(line.place.row, _manual_height(line, said))
        sheet.write_string(line.place.row, line.place.column, said, styles.manual)
    sheet.freeze_panes(SECTION_HEADER + 1, 0)
    sheet.repeat_rows(SECTION_HEADER)
    heights = _heights(section, words)
    title = course.title.of(words.language)
    set_page(sheet, title, issued.student.name, tall=pages_tall(heights, sum(WIDTHS.values())))
    sheet.protect("", LOCKED)


def _heights(section: SectionSheet, words: Words) -> Iterator[float]:
    """Yield the heights of all rows of a sheet."""
    top = (section.task, words.say(DECIMAL_SIGN))
    yield from (row_height([(text, sum(WIDTHS.values()))]) for text in top)
    yield _TITLE_HEIGHT + 2 * _HEAD_HEIGHT
    yield from map(line_height, section.answered)
    said = words.say(_BY_INSTRUCTOR)
    yield from (_manual_height(line, said) for line in section.manual)


def _manual_height(line: SheetLine, said: str) -> float:
    """Return the height of the row of what a person marks, which is said in its answer's cell."""
    return max(line_height(line), row_height([(said, WIDTHS[SheetColumn.VALUE])]))


def _write_top(sheet: "Worksheet", section: SectionSheet, words: Words, styles: Styles) -> None:
    """Write title, task and headings; merged cells do not grow by themselves: heights are set."""
    title = f"{section.number}. {section.section.title.of(words.language)}"
    sheet.set_row(_TITLE_ROW, _TITLE_HEIGHT)
    sheet.write_string(_TITLE_ROW, 0, title, styles.title)
    for row, text, style in (
        (_TASK_ROW, section.task, styles.paragraph),
        (_HINT_ROW, words.say(DECIMAL_SIGN), styles.hint),
    ):
        sheet.merge_range(row, 0, row, SheetColumn.CHECK, "", style)
        write_symbols(sheet, row, 0, text, style, styles)
        sheet.set_row(row, row_height([(text, sum(WIDTHS.values()))]))
    sheet.set_row(SECTION_HEADER, _HEAD_HEIGHT)
    for column, heading in enumerate(headings(words)):
        sheet.write_string(SECTION_HEADER, column, heading, styles.head)


def _write_answer(sheet: "Worksheet", line: SheetLine, words: Words, styles: Styles) -> None:
    """Write an empty answer cell with its rule, and the cell that checks its kind."""
    row, column = line.place.row, line.place.column
    sheet.write_blank(row, column, None, styles.answer)
    verdict = line.quantity.kind is Kind.VERDICT
    rule = _yes_or_no(line, words) if verdict else _decimal(line, words)
    sheet.data_validation(row, column, row, column, rule)
    check = _verdict_check(line, words) if verdict else _number_check(line, words)
    sheet.write_formula(row, SheetColumn.CHECK, check, styles.check, value="")


def _decimal(line: SheetLine, words: Words) -> dict[str, object]:
    """Return the rule that a cell holds a number between the quantity's bounds."""
    low, high = _bounds(line)
    told = message("A number from {low} to {high} {unit}", low=low, high=high, unit=line.unit)
    stop = message(
        "One number from {low} to {high} is needed here, without a unit. {decimal_sign}",
        low=low,
        high=high,
        decimal_sign=DECIMAL_SIGN,
    )
    return {
        "validate": "decimal",
        "criteria": "between",
        "minimum": low,
        "maximum": high,
        **_prompt(line, words.say(told).strip()),
        "error_title": _cut(words.say(message("A number is needed")), _LONGEST_PROMPT_TITLE),
        "error_message": _cut(words.say(stop), _LONGEST_PROMPT),
        "error_type": "stop",
    }


def _yes_or_no(line: SheetLine, words: Words) -> dict[str, object]:
    needed = words.say(message("Choose yes or no."))
    return {
        "validate": "list",
        "source": list(_answers(words)),
        **_prompt(line, needed),
        "error_title": _cut(words.say(message("Yes or no is needed")), _LONGEST_PROMPT_TITLE),
        "error_message": _cut(needed, _LONGEST_PROMPT),
        "error_type": "stop",
    }


def _prompt(line: SheetLine, text: str) -> dict[str, object]:
    """Return the note that a spreadsheet program shows beside the chosen cell."""
    return {
        "input_title": _cut(
            without_looks(f"{line.number}  {line.symbol}").strip(), _LONGEST_PROMPT_TITLE
        ),
        "input_message": _cut(_said(line, text), _LONGEST_PROMPT),
    }


def _said(line: SheetLine, text: str) -> str:
    """Join what there is to say; the title, which stands in the row too, goes first if it must."""
    whole = without_looks(". ".join(filter(None, (line.title, line.decides, text))))
    if len(whole) <= _LONGEST_PROMPT:
        return whole
    return without_looks(". ".join(filter(None, (line.decides, text))))


def _answers(words: Words) -> tuple[str, str]:
    return words.say(message("yes")), words.say(message("no"))


def _number_check(line: SheetLine, words: Words) -> str:
    cell = line.place.address
    low, high = _bounds(line)
    needed = _literal(words.say(message("a number is needed")))
    beyond = _literal(words.say(message("beyond {low} … {high}", low=low, high=high)))
    inside = f"AND({cell}>={low:.15g},{cell}<={high:.15g})"
    return f'=IF(ISBLANK({cell}),"",IF(ISNUMBER({cell}),IF({inside},"",{beyond}),{needed}))'


def _verdict_check(line: SheetLine, words: Words) -> str:
    cell = line.place.address
    yes, no = map(_literal, _answers(words))
    needed = _literal(words.say(message("yes or no is needed")))
    return f'=IF(ISBLANK({cell}),"",IF(OR({cell}={yes},{cell}={no}),"",{needed}))'


def _bounds(line: SheetLine) -> tuple[float, float]:
    low, high = line.quantity.bounds
    return max(float(low), -_WIDEST), min(float(high), _WIDEST)


def _literal(text: str) -> str:
    """Write text as a formula does."""
    return '"' + text.replace('"', '""') + '"'


def _cut(text: str, longest: int) -> str:
    return text if len(text) <= longest else f"{text[: longest - 1]}…"
