"""A platform knows people by first name and surname; a row by name alone is nobody's by guess."""

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.exports.platforms.matching import Matching, match
from gripcourse.exports.platforms.works import PlatformRow, works_of
from gripcourse.variants.model import Student

if TYPE_CHECKING:
    from gripcourse.exports.report_result import GradesResult

Graded = Callable[..., "GradesResult"]
OLGA = "Иванова Ольга Сергеевна"
STUDENTS = {"s17": Student("s17", "Иванова Ольга", "", "ivanova@uni.ua", "", "")}


def matched(graded: Graded, called: str, rows: list[str], **others: str) -> Matching:
    """Match the work of somebody by name; others are in the register and handed in nothing."""
    found = graded({"a.xlsx": "s17"})
    (report,) = found.reports
    works, _ = works_of(replace(found, reports=(replace(report, name=called),)), {})
    table = [PlatformRow(line, "", (), name) for line, name in enumerate(rows, start=2)]
    return match(works, table, "table.csv", {"s17": called, **others})


@pytest.mark.parametrize("row", ["Иванова, Ольга", "Ольга Иванова"])
def test_a_row_without_a_patronymic_is_filled_in_and_named(graded: Graded, row: str) -> None:
    found = matched(graded, OLGA, ["Петрова, Ольга", row])
    assert set(found.works) == {3}
    assert f"3 {row} = s17 {OLGA}" in "\n".join(map(str, found.notes))
    assert matched(graded, OLGA, [OLGA]).notes == ()


@pytest.mark.parametrize("other", ["Иванова Ольга Петровна", "Иванова Ольга"])
def test_who_handed_in_nothing_may_be_meant_too(graded: Graded, other: str) -> None:
    found = matched(graded, OLGA, ["Иванова, Ольга"], s18=other)
    assert found.works == {}
    assert "may be that of s17" in str(found.notes[0])
    assert "s18" in str(found.notes[0])


def test_a_namesake_who_handed_in_nothing_gets_nobody_elses_grade(graded: Graded) -> None:
    assert matched(graded, "Бондарь Олег", ["Бондарь, Олег"], s18="Олег Бондарь").works == {}


def test_two_rows_of_one_name_are_named(graded: Graded) -> None:
    found = matched(graded, OLGA, ["Иванова, Ольга", "Иванова, Ольга"])
    assert found.works == {}
    assert "Rows 2, 3 have the name of s17" in str(found.notes[0])


@pytest.mark.parametrize("row", ["Ольга", "Иванова", "Иванова Ольга Петровна", "Иванова Анна"])
def test_another_name_and_a_single_word_are_nobodys(graded: Graded, row: str) -> None:
    found = matched(graded, OLGA, [row])
    assert found.works == {}
    assert "is not in the platform's table" in str(found.notes[0])


@pytest.mark.parametrize(
    ("row", "address", "is_named"),
    [
        ("Чужой Человек", "", True),
        ("Иванова О.", "", False),
        ("", "", False),
        ("Чужой Человек", "ivanova@uni.ua", False),
    ],
)
def test_a_row_of_another_name_that_the_number_alone_tells_is_named(
    graded: Graded, row: str, address: str, *, is_named: bool
) -> None:
    file = f"РГР.zip/{row or 'Участник'}_55_assignsubmission_file/a.xlsx"
    works, _ = works_of(graded({file: "s17"}), {"s17": STUDENTS["s17"]})
    found = match(works, [PlatformRow(2, "55", (address,), row)], "table.csv")
    assert set(found.works) == {2}
    assert [str(one).count("bear other names") for one in found.notes] == [1] * is_named
