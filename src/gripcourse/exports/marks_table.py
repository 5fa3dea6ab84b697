"""A table of marks to fill in: what waits for a person, a column for each line of the rubrics."""

import csv
import io
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

from gripcourse.exports.csv_text import text_cell
from gripcourse.machine.files import write_bytes
from gripcourse.machine.spreadsheet.table_page import set_no_moment, set_table_page
from gripcourse.policy.rubric import MOST_TOGETHER, Rubric, RubricLine, column_heading, lines_of
from gripcourse.text.conventions import is_english
from gripcourse.text.shown import shown
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

_WIDE, _NARROW = 30, 14  # of columns, in digits
_GREY: Final = "#D9D9D9"


@dataclass(frozen=True, slots=True)
class RowToMark:
    """A row of the table.

    Attributes:
        student, quantity: ids.
        name, group: of the student.
        title: of the item.
        possible: points of the item.
        rubric: by which it is marked; None where points are written.
    """

    student: str
    quantity: str
    name: str
    group: str
    title: str
    possible: float
    rubric: Rubric | None


@dataclass(frozen=True, slots=True)
class _MarksColumn:
    """A column: its heading, its cells, and which of them wait for a number."""

    heading: str
    cells: tuple[str | float, ...]
    lines: tuple[RubricLine | None, ...] | None = None


def write_marks_table(path: Path, items: Sequence[RowToMark], words: Words) -> None:
    """Write the table, a workbook where the path ends in `.xlsx`, else CSV.

    Args:
        path: file to write, whole or not at all; only its owner may read it.
        items: a row each.
        words: the language of the headings.

    Raises:
        OSError: the file cannot be written.
    """
    columns = tuple(_columns(items, words))
    is_workbook = path.suffix.lower() == ".xlsx"
    data = _workbook(columns, len(items)) if is_workbook else _csv(columns, words)
    write_bytes(path, data, private=True)


def _columns(items: Sequence[RowToMark], words: Words) -> Iterator[_MarksColumn]:
    def texts(heading: str, name: str) -> _MarksColumn:
        return _MarksColumn(heading, tuple(getattr(one, name) for one in items))

    yield texts(words.say(message("Student")), "student")
    yield texts(words.say(message("Full name")), "name")
    yield texts(words.say(message("Group")), "group")
    yield texts(words.say(message("Item")), "quantity")
    yield texts(words.say(message("What is marked")), "title")
    yield texts(words.say(message("Possible points")), "possible")
    blank = tuple("" for _ in items)
    used = {one.rubric.id: one.rubric for one in items if one.rubric}
    for id_, heading in _headings(tuple(used.values()), words).items():
        lines = tuple(one.rubric.by_id.get(id_) if one.rubric else None for one in items)
        yield _MarksColumn(heading, blank, lines)
    yield _MarksColumn(words.say(message("Points")), blank)
    yield _MarksColumn(words.say(message("Comment")), blank)


def _headings(rubrics: Sequence[Rubric], words: Words) -> dict[str, str]:
    """Return what each line is called: its text in each rubric where no other is called so."""
    texts = {
        id_: {one.of(words.language) for one in found} for id_, found in lines_of(rubrics).items()
    }
    headings = {id_: column_heading(found) for id_, found in texts.items()}
    every = list(headings.values())
    return {
        id_: heading if every.count(heading) == 1 and len(texts[id_]) <= MOST_TOGETHER else id_
        for id_, heading in headings.items()
    }


def _csv(columns: Sequence[_MarksColumn], words: Words) -> bytes:
    stream = io.StringIO(newline="")
    # A spreadsheet program splits at semicolons where the comma is the decimal one.
    table = csv.writer(
        stream, delimiter="," if is_english(words.language) else ";", lineterminator="\r\n"
    )
    table.writerow([one.heading for one in columns])
    for row in zip(*(one.cells for one in columns), strict=True):
        table.writerow([text_cell(cell) if isinstance(cell, str) else f"{cell:g}" for cell in row])
    return stream.getvalue().encode("utf-8-sig")


def _workbook(columns: Sequence[_MarksColumn], count: int) -> bytes:
    import xlsxwriter  # noqa: PLC0415 (not for CSV)

    stream = io.BytesIO()
    plain = {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False}
    with xlsxwriter.Workbook(stream, plain) as book:
        sheet = book.add_worksheet()
        set_no_moment(book)
        bold = book.add_format({"bold": True, "text_wrap": True, "valign": "top", "border": 1})
        for place, column in enumerate(columns):
            sheet.write_string(0, place, column.heading, bold)
            longest = max((len(str(cell)) for cell in column.cells), default=0)
            sheet.set_column(place, place, min(_WIDE, max(_NARROW, longest)))
            for row, cell in enumerate(column.cells, start=1):
                if isinstance(cell, str):
                    sheet.write_string(row, place, shown(cell))
                else:
                    sheet.write_number(row, place, cell)
            if column.lines is not None:
                _ask(book, sheet, place, column.lines)
        sheet.freeze_panes(1, 2)
        set_table_page(sheet)
        sheet.autofilter(0, 0, count, len(columns) - 1)
    return stream.getvalue()


def _ask(
    book: "Workbook", sheet: "Worksheet", place: int, lines: Sequence[RubricLine | None]
) -> None:
    """Take a share from 0 to 1 where the item is marked by the line; grey out the other cells."""
    share = {"validate": "decimal", "criteria": "between", "minimum": 0, "maximum": 1}
    grey = book.add_format({"bg_color": _GREY})
    for row, line in enumerate(lines, start=1):
        if line is None:
            sheet.write_blank(row, place, None, grey)
        else:
            sheet.data_validation(row, place, row, place, share)
