"""The sheet of series and tables, as it is printed."""

import io
import re
from dataclasses import replace
from typing import Final

import pytest
from openpyxl import load_workbook

from gripcourse.course.model import Course
from gripcourse.solver.plan import make_plan
from gripcourse.text.words import Words
from gripcourse.variants.model import Issued, Variant
from gripcourse.workbook.layout import layout
from gripcourse.workbook.series import page_breaks
from gripcourse.workbook.write import answer_workbook

RUSSIAN: Final = Words("ru")

PAGE = 100.0


@pytest.mark.parametrize(
    ("heights", "breaks"),
    [
        ([(0, 40.0), (3, 60.0)], []),
        ([(0, 40.0), (3, 61.0)], [3]),
        ([(0, 40.0), (3, 50.0), (8, 30.0), (11, 71.0)], [8, 11]),
        ([(0, 10.0), (3, 300.0), (30, 20.0)], [3, 30]),
        ([(0, 300.0)], []),
        ([], []),
    ],
)
def test_a_page_ends_before_a_table_that_it_has_no_room_for(
    heights: list[tuple[int, float]], breaks: list[int]
) -> None:
    assert page_breaks(heights, PAGE) == breaks


def test_pages_of_the_sheet_begin_with_the_title_of_a_table(course: Course, issued: Issued) -> None:
    """A rack with its cylinder takes its sizes from more series than a page has room for."""
    example = course.schemes["rack_parallelogram"].example
    assert example is not None
    plan = make_plan(course, "rack_parallelogram", example.options)
    given = {one.id: sum(one.bounds) / 2 for one in plan.givens}
    entry = replace(issued, variant=Variant("7", plan.scheme.id, dict(plan.options), given))
    book = load_workbook(io.BytesIO(answer_workbook(plan, entry, course, RUSSIAN)))
    sheet = book[layout(plan, RUSSIAN).series]
    begun = [sheet.cell(one.id + 1, 1).value for one in sheet.row_breaks.brk]
    assert begun
    assert all(re.match(r"\d+\. ", str(title)) for title in begun)
