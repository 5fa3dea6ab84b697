"""Rows that were sorted or inserted: each answer is read from the row with its title."""

from typing import TYPE_CHECKING

import pytest

from gripcourse.submission.model import Reading
from gripcourse.workbook.layout import SheetColumn

if TYPE_CHECKING:
    from openpyxl import Workbook
    from openpyxl.worksheet.worksheet import Worksheet

    from conftest import Returned

VALUE = SheetColumn.VALUE + 1


def typed(returned: "Returned") -> dict[str, float]:
    """A number of its own for each answer of the second section."""
    section = returned.plan.answered[0].section
    asked = [one.id for one in returned.plan.answered if one.section == section]
    return {name: 1.5 + number for number, name in enumerate(asked)}


def filled(returned: "Returned") -> "tuple[Workbook, Worksheet, dict[str, int]]":
    book = returned.book()
    rows = {}
    for name, value in typed(returned).items():
        cell = returned.cell(book, name)
        cell.value = value
        rows[name] = cell.row
    sheet = returned.cell(book, next(iter(rows))).parent
    return book, sheet, rows


def values(sheet: "Worksheet", row: int) -> list[object]:
    return [sheet.cell(row, column).value for column in range(1, VALUE + 1)]


def write(sheet: "Worksheet", row: int, content: list[object]) -> None:
    for column, value in enumerate(content, start=1):
        sheet.cell(row, column).value = value


@pytest.fixture(params=["sorted", "inserted", "untouched"])
def edited(request: pytest.FixtureRequest, returned: "Returned") -> "tuple[Workbook, bool]":
    """A workbook whose rows moved and whose names did not."""
    book, sheet, rows = filled(returned)
    order = sorted(rows.values())
    contents = [values(sheet, row) for row in order]
    if request.param == "sorted":
        for row, content in zip(order, sorted(contents, key=lambda one: str(one[2])), strict=True):
            write(sheet, row, content)
    if request.param == "inserted":
        for row, content in zip(order[3:], contents[3:], strict=True):
            write(sheet, row + 1, content)
        write(sheet, order[3], [None] * VALUE)
    return book, request.param != "untouched"


def test_each_answer_is_read_from_the_row_with_its_title(
    returned: "Returned", edited: "tuple[Workbook, bool]"
) -> None:
    book, moved = edited
    read = returned.read(returned.saved(book))
    found = {name: read.answers[name].value for name in typed(returned)}
    assert found == typed(returned)
    assert bool(read.moved) == moved
    told = [one for one in read.moved if "title" in str(read.answers[one].remarks)]
    assert told == list(read.moved)


def test_a_title_that_was_rewritten_moves_nothing(returned: "Returned") -> None:
    book, sheet, rows = filled(returned)
    name, row = next(iter(rows.items()))
    sheet.cell(row, SheetColumn.TITLE + 1).value = "my own words"
    read = returned.read(returned.saved(book))
    assert read.answers[name].value == typed(returned)[name]
    assert read.moved == ()


def test_a_row_of_whose_title_there_are_two_is_left_as_it_is(returned: "Returned") -> None:
    book, sheet, rows = filled(returned)
    first, second, *_ = rows.values()
    sheet.cell(first, SheetColumn.TITLE + 1).value = sheet.cell(second, SheetColumn.TITLE + 1).value
    read = returned.read(returned.saved(book))
    assert read.moved == ()
    assert read.answers[next(iter(rows))].reading is Reading.READ


def test_a_sheet_that_only_bears_another_name_keeps_its_answers(returned: "Returned") -> None:
    """Not every program that renames a sheet tells the names so."""
    book, sheet, _ = filled(returned)
    sheet.title = "Sheet of mine"
    book.create_sheet("Notes", 0)
    read = returned.read(returned.saved(book))
    assert {name: read.answers[name].value for name in typed(returned)} == typed(returned)
    assert set(read.moved) == set(typed(returned))
    assert read.remarks == ()


def test_answers_whose_sheet_was_removed_are_blank_and_that_is_said(returned: "Returned") -> None:
    book, sheet, _ = filled(returned)
    book.remove(sheet)
    read = returned.read(returned.saved(book))
    assert {read.answers[name].reading for name in typed(returned)} == {Reading.BLANK}
    assert read.moved == ()
    title, asked = sheet.title, set(typed(returned))
    [said] = map(str, read.remarks)
    assert f"'{title}'" in said
    assert f"in all: {len(asked)}" in said


def test_an_answer_that_was_cut_over_another_one_is_found_in_its_row(returned: "Returned") -> None:
    """The name of the cell that is pasted over is lost; the one that was cut brings its own."""
    book, _, rows = filled(returned)
    first, second, *_ = rows
    names = book.defined_names
    names[f"answer.{second}"].value = names[f"answer.{first}"].value
    names[f"answer.{first}"].value = "#REF!"
    read = returned.read(returned.saved(book))
    assert {name: read.answers[name].value for name in typed(returned)} == typed(returned)
    assert set(read.moved) == {first, second}
