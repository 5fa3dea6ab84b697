"""Whoever filled in a copy of a sheet loses nothing, and the sheet that was issued comes first."""

from typing import TYPE_CHECKING

import pytest
from openpyxl.workbook.defined_name import DefinedName

from gripcourse.submission.model import Reading

if TYPE_CHECKING:
    from openpyxl import Workbook
    from openpyxl.worksheet.worksheet import Worksheet

    from conftest import Returned

FORCE = "drive_force"
BORE = "bore_required"


def copied(returned: "Returned", book: "Workbook", *quantities: str) -> "Worksheet":
    """Copy the sheet of some answers as a spreadsheet program does: names and all."""
    source = returned.cell(book, quantities[0]).parent
    made: Worksheet = book.copy_worksheet(source)
    for one in quantities:
        where = f"'{made.title}'!{returned.cell(book, one).coordinate}"
        made.defined_names[f"answer.{one}"] = DefinedName(f"answer.{one}", attr_text=where)
    return made


def fill(
    returned: "Returned", book: "Workbook", sheet: "Worksheet", name: str, value: object
) -> None:
    sheet[returned.cell(book, name).coordinate].value = value


def test_answers_on_a_copy_are_taken_where_the_sheet_is_blank(returned: "Returned") -> None:
    book = returned.book()
    copy = copied(returned, book, FORCE, BORE)
    fill(returned, book, copy, FORCE, 22941.0)
    fill(returned, book, copy, BORE, 60.08)
    read = returned.read(returned.saved(book))
    assert (read.answers[FORCE].value, read.answers[BORE].value) == (22941.0, 60.08)
    (said,) = map(str, read.remarks)
    assert f"'{copy.title}'" in said
    assert "in all: 2" in said


def test_what_stands_on_the_sheet_itself_counts(returned: "Returned") -> None:
    book = returned.book()
    copy = copied(returned, book, FORCE, BORE)
    returned.cell(book, FORCE).value = 1.0
    returned.cell(book, BORE).value = "no idea"
    fill(returned, book, copy, FORCE, 2.0)
    fill(returned, book, copy, BORE, 3.0)
    read = returned.read(returned.saved(book))
    assert read.answers[FORCE].value == 1.0
    assert read.answers[BORE].reading is Reading.UNREADABLE
    assert read.remarks == ()


def test_of_two_copies_none_is_guessed(returned: "Returned") -> None:
    book = returned.book()
    for value in (1.0, 2.0):
        fill(returned, book, copied(returned, book, FORCE), FORCE, value)
    read = returned.read(returned.saved(book))
    assert read.answers[FORCE].reading is Reading.BLANK
    (said,) = map(str, read.remarks)
    assert "several copies" in said


def test_of_two_copies_the_filled_one_counts(returned: "Returned") -> None:
    book = returned.book()
    copied(returned, book, FORCE)
    fill(returned, book, copied(returned, book, FORCE), FORCE, 2.0)
    assert returned.read(returned.saved(book)).answers[FORCE].value == 2.0


@pytest.mark.parametrize("value", [None, ""])
def test_a_blank_copy_changes_nothing(returned: "Returned", value: object) -> None:
    book = returned.book()
    fill(returned, book, copied(returned, book, FORCE), FORCE, value)
    read = returned.read(returned.saved(book))
    assert read.answers[FORCE].reading is Reading.BLANK
    assert read.remarks == ()
