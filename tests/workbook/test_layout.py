from collections import Counter

import pytest

from gripcourse.solver.plan import Plan
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.workbook.layout import LONGEST_SHEET_NAME, CellPlace, layout


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_answered_given_and_manual_quantity_has_one_row(plan: Plan, language: str) -> None:
    placed = layout(plan, Words(language))
    assert set(placed.answers) == {quantity.id for quantity in plan.answered}
    assert set(placed.givens) == {quantity.id for quantity in plan.givens}
    manual = {line.quantity.id for sheet in placed.sheets for line in sheet.manual}
    assert manual == {quantity.id for quantity in plan.manual}


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_two_quantities_share_a_cell(plan: Plan, language: str) -> None:
    placed = layout(plan, Words(language))
    lines = [
        *placed.cover.givens,
        *placed.cover.constants,
        *(line for sheet in placed.sheets for line in (*sheet.answered, *sheet.manual)),
    ]
    uses = Counter(line.place for line in lines)
    assert uses.total() == len(lines)
    assert set(uses.values()) == {1}


def test_sections_follow_the_order_of_the_course(plan: Plan) -> None:
    placed = layout(plan, Words("ru"))
    assert [sheet.section for sheet in placed.sheets] == list(plan.course.sections)
    assert [sheet.number for sheet in placed.sheets] == [1, 2, 3, 4, 5]


@pytest.mark.parametrize("language", LANGUAGES)
def test_names_of_sheets_are_short_and_unlike_each_other(plan: Plan, language: str) -> None:
    placed = layout(plan, Words(language))
    names = [placed.cover.name, *(sheet.name for sheet in placed.sheets)]
    assert len({name.casefold() for name in names}) == len(names)
    assert all(0 < len(name) <= LONGEST_SHEET_NAME for name in names)


def test_a_sheet_is_named_by_the_short_title_of_its_section(plan: Plan) -> None:
    assert layout(plan, Words("ru")).sheets[0].name == "1. Схема"


def test_a_place_is_written_as_spreadsheets_write_it() -> None:
    assert CellPlace("Об'єкт", 4, 4).reference == "'Об''єкт'!$E$5"
    assert CellPlace("x", 0, 27).address == "AB1"
