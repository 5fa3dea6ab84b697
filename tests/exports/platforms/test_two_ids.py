"""Who was listed twice is found in a platform's table by either id, and gets one grade."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from gripcourse.exports.platforms.matching import match
from gripcourse.exports.platforms.works import PlatformRow, works_of
from gripcourse.variants.model import Student

if TYPE_CHECKING:
    from gripcourse.exports.report_result import GradesResult

Graded = Callable[..., "GradesResult"]
NOW = {"s17": Student("s17", "Иванова Ольга", "РТ-41", "ivanova@uni.ua", "", "")}
TWICE = {"s17": (Student("s18", "Ковальчук Ольга", "РТ-41", "kovalchuk@uni.ua", "", ""),)}


def row(line: int, key: str) -> PlatformRow:
    return PlatformRow(line, "", (key,), "")


def test_the_row_of_the_second_id_or_its_address_is_the_persons(graded: Graded) -> None:
    works, notes = works_of(graded({"a.xlsx": "s17"}), NOW, TWICE)
    assert notes == ()
    for key in ("s18", "kovalchuk@uni.ua"):
        found = match(works, [row(2, key), row(3, "s19")], "table.csv")
        assert {line: one.report.student for line, one in found.works.items()} == {2: "s17"}
        assert found.notes == ()


def test_of_two_rows_the_one_of_the_id_that_is_kept_gets_the_grade(graded: Graded) -> None:
    works, _ = works_of(graded({"a.xlsx": "s17"}), NOW, TWICE)
    found = match(works, [row(2, "s18"), row(3, "s17")], "table.csv")
    assert set(found.works) == {3}


def test_works_that_were_graded_under_both_ids_are_of_one_person(graded: Graded) -> None:
    works, _ = works_of(graded({"a.xlsx": "s17", "b.xlsx": "s18"}), NOW, TWICE)
    assert len(works) == 1
