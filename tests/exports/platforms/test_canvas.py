"""Canvas gets the smallest table that it takes, with its own ids."""

import csv
import io
from collections.abc import Callable

import pytest

from gripcourse.errors import UsageError
from gripcourse.exports.platforms.canvas import fill_gradebook
from gripcourse.exports.platforms.works import GradedWork
from gripcourse.machine.content import NamedBytes

Works = Callable[[dict[str, str]], tuple[GradedWork, ...]]
EXPORT = """\
Student,ID,SIS User ID,SIS Login ID,Section,РГР 1 (9876),Lab (11),Current Score
Manual Posting,,,,,,,
    Points Possible,,,,,"50.00",10.00,(read only)
"Иванова, Ольга",501,u1,ivanova@uni.ua,РТ-41,,7.00,70
"Ковальчук, Іван",502,u2,other,РТ-41,N/A,8.00,80
"""
FILES = {"ивановаольга_LATE_501_77_s.xlsx": "s17", "оковальчуківан_502_78_s.xlsx": "s18"}


def table(
    text: str = EXPORT, assignment: str = "РГР 1", **found: tuple[GradedWork, ...]
) -> list[list[str]]:
    source = NamedBytes("grades.csv", text.encode("utf-8-sig"))
    content = fill_gradebook(source, found.get("works", ()), assignment).content
    return list(csv.reader(io.StringIO(content.decode("utf-8-sig"), newline="")))


def test_ids_sections_and_possible_points_are_kept(works: Works) -> None:
    header, possible, first, second = table(works=works(FILES))
    assert header == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "РГР 1 (9876)"]
    assert possible == ["    Points Possible", "", "", "", "", "50.00"]
    assert first[:5] == ["Иванова, Ольга", "501", "u1", "ivanova@uni.ua", "РТ-41"]
    assert 0 < float(first[5]) <= 50
    assert 0 < float(second[5]) <= 50


def test_who_has_no_work_keeps_what_stood_there(works: Works) -> None:
    *_, second = table(works=works({"s17.xlsx": "s17"}))
    assert second[-1] == "N/A"


def notes(text: str, found: tuple[GradedWork, ...]) -> str:
    source = NamedBytes("grades.csv", text.encode("utf-8-sig"))
    return "\n".join(map(str, fill_gradebook(source, found, "РГР 1").notes))


def test_who_is_excused_there_stays_excused_and_is_named(works: Works) -> None:
    text = EXPORT.replace("N/A", "EX")
    assert table(text, works=works(FILES))[-1][-1] == "EX"
    assert "is excused in Canvas" in notes(text, works(FILES))


@pytest.mark.parametrize("points", ["", "0.00"])
def test_an_assignment_without_possible_points_is_named(works: Works, points: str) -> None:
    text = EXPORT.replace("50.00", points)
    assert "no possible points for РГР 1 (9876)" in notes(text, works(FILES))
    assert notes(EXPORT, works(FILES)) == ""


@pytest.mark.parametrize("points", ["nan", "1e999"])
def test_points_that_are_no_number_fill_in_none(works: Works, points: str) -> None:
    first = table(EXPORT.replace("50.00", points), works=works(FILES))[2]
    own = table(EXPORT.replace("50.00", "?"), works=works(FILES))[2]
    assert first == own
    assert 0 < float(first[-1]) < 200


def test_the_assignment_must_be_clear() -> None:
    with pytest.raises(UsageError, match="Lab"):
        table(assignment="")
    assert table(assignment="11")[0][-1] == "Lab (11)"


def test_another_table_is_refused_by_its_headings() -> None:
    with pytest.raises(UsageError, match="No heading is ID, Section"):
        table("Student,Points\nA,1\n")
    with pytest.raises(UsageError, match="No heading is Student, ID, Section"):
        table("Идентификатор,Оценка\nУчастник12,1\n")
    with pytest.raises(UsageError, match="No heading is LastName, Section"):
        table("FirstName,ID\nA,1\n")


def test_a_blank_line_is_nobodys(works: Works) -> None:
    header, *rest = EXPORT.splitlines(keepends=True)
    spaced = "".join((header, "\n", *rest, "\n"))
    assert table(spaced, works=works(FILES)) == table(works=works(FILES))


def test_spaces_around_a_heading_are_nothing(works: Works) -> None:
    spaced = EXPORT.replace("Student,ID,SIS User ID,", "Student , ID,SIS User ID ,", 1)
    assert table(spaced, works=works(FILES))[1:] == table(works=works(FILES))[1:]
