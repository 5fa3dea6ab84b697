"""A deadline is that of the student, else of the group, else of everybody, in the course's zone."""

from dataclasses import replace
from datetime import UTC, date, datetime
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest

from gripcourse.errors import TableError
from gripcourse.gradebook.deadlines import (
    Deadline,
    course_deadlines,
    deadline_of,
    doubt_about,
    moment_of,
    read_deadlines,
)
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.resources import deadlines_path
from gripcourse.policy.time_rules import LateRule
from gripcourse.variants.model import Issued, Student, Variant

KYIV = ZoneInfo("Europe/Kyiv")
TABLE = """\
group,student,deadline
,,2026-12-01
РТК-41,,2026-12-08 18:00
,s02,2026-12-20T9:30
"""


def table(text: str) -> tuple[Deadline, ...]:
    return read_deadlines(NamedBytes("deadlines.csv", text.encode()), KYIV)


def issued(student: str, group: str, day: date | None = date(2026, 11, 1)) -> Issued:
    return Issued(
        student=Student(student, student, group, "", "ru", ""),
        variant=Variant("001", "rack", {}, {}),
        issued_on=date(2026, 9, 1),
        deadline=day,
        signature="",
    )


@pytest.mark.parametrize(
    ("written", "at"),
    [
        ("2026-10-25 03:30+03:00", datetime(2026, 10, 25, 0, 30, tzinfo=UTC)),
        ("2026-10-25 03:30 +02:00", datetime(2026, 10, 25, 1, 30, tzinfo=UTC)),
        ("25.10.2026 03:30+0200", datetime(2026, 10, 25, 1, 30, tzinfo=UTC)),
        ("2026-10-25 02:59", datetime(2026, 10, 24, 23, 59, tzinfo=UTC)),
        ("2026-10-25 04:00", datetime(2026, 10, 25, 2, 0, tzinfo=UTC)),
        ("2026-03-29 02:59", datetime(2026, 3, 29, 0, 59, tzinfo=UTC)),
        ("2026-03-29 04:00", datetime(2026, 3, 29, 1, 0, tzinfo=UTC)),
        ("2026-10-25", datetime(2026, 10, 25, 21, 59, 59, tzinfo=UTC)),
    ],
)
def test_a_deadline_is_a_moment_by_the_clocks_of_the_course(written: str, at: datetime) -> None:
    (row,) = table(f"group,student,deadline\n,,{written}\n")
    assert row.at.timestamp() == at.timestamp()


@pytest.mark.parametrize(
    ("written", "what", "remedy"),
    [
        (
            "2026-10-25 03:30",
            "Clocks show 2026-10-25 03:30 twice",
            "Write 2026-10-25 03:30+03:00 or 2026-10-25 03:30+02:00.",
        ),
        (
            "29.03.2026 03:30",
            "Clocks never show 2026-03-29 03:30",
            "Write 2026-03-29 02:30 or 2026-03-29 04:30.",
        ),
    ],
)
def test_a_deadline_in_the_hour_of_a_change_of_clocks_is_asked_about(
    written: str, what: str, remedy: str
) -> None:
    with pytest.raises(TableError) as caught:
        table(f"group,student,deadline\n,,{written}\n")
    (problem,) = caught.value.problems
    assert what in str(problem.what)
    assert str(problem.remedy) == remedy
    assert doubt_about(written, KYIV) == (problem.what, problem.remedy)
    for answer in remedy.removeprefix("Write ").removesuffix(".").split(" or "):
        assert table(f"group,student,deadline\n,,{answer}\n")


@pytest.mark.parametrize("written", ["2026-10-25 03:30+99:00", "2026-10-25 +02:00", "03:30"])
def test_what_is_no_moment_is_none(written: str) -> None:
    assert moment_of(written, KYIV) is None


def test_the_last_second_of_a_day_that_ends_twice_counts() -> None:
    santiago = ZoneInfo("America/Santiago")  # set back from midnight to 23:00
    last = deadline_of(issued("s01", "A", date(2026, 4, 4)), (), santiago)
    assert last is not None
    assert last.timestamp() == datetime(2026, 4, 5, 3, 59, 59, tzinfo=UTC).timestamp()


def test_the_nearest_row_counts_in_the_time_zone_of_the_course() -> None:
    rows = table(TABLE)
    assert deadline_of(issued("s02", "РТК-41"), rows, KYIV) == datetime(
        2026, 12, 20, 7, 30, tzinfo=UTC
    )
    assert deadline_of(issued("s01", "РТК-41"), rows, KYIV) == datetime(2026, 12, 8, 16, tzinfo=UTC)
    everybody = deadline_of(issued("s03", "РТК-42"), rows, KYIV)
    assert everybody == datetime(2026, 12, 1, 21, 59, 59, tzinfo=UTC)


def test_without_a_row_it_is_the_day_that_was_issued_with() -> None:
    assert deadline_of(issued("s01", ""), (), KYIV) == datetime(2026, 11, 1, 21, 59, 59, tzinfo=UTC)
    assert deadline_of(issued("s01", "", None), (), KYIV) is None


def test_a_day_may_be_written_as_an_office_does() -> None:
    for office, iso in (("1.12.2026", "2026-12-01"), ("01.12.2026 18:00", "2026-12-01 18:00")):
        assert moment_of(office, KYIV) == moment_of(iso, KYIV) is not None
    assert moment_of("31.02.2026", KYIV) is None


def test_headings_may_be_of_any_language() -> None:
    russian = table(TABLE.replace("group,student,deadline", "Группа,Студент,Срок сдачи"))
    ukrainian = table(TABLE.replace("group,student,deadline", "Група,Студент,Кінцевий строк"))
    assert russian == ukrainian == table(TABLE)


def test_a_row_for_nobody_is_named_where_it_is_known_who_there_is() -> None:
    people = [issued(id_, "РТК-41").student for id_ in ("s01", "s02")]
    text = "Группа;Студент;Срок\nРТК-14;;1.12.2026\n;s20;1.12.2026\nРТК-42;s02;1.12.2026\n"
    source = NamedBytes("deadlines.csv", text.encode())
    assert len(read_deadlines(source, KYIV)) == 3
    with pytest.raises(TableError) as caught:
        read_deadlines(source, KYIV, people)
    assert [(str(one.key), str(one.what)) for one in caught.value.problems] == [
        ("row 2, column Группа", "Nobody is in group 'РТК-14'."),
        ("row 3, column Студент", "The register has no student 's20'."),
        ("row 4, column Группа", "s02 is not in group 'РТК-42'."),
    ]


@pytest.mark.parametrize("written", ["РТК 41", "ртк41", "PTK-41"])
def test_a_group_is_the_same_however_it_is_written(written: str) -> None:
    """As on lists: the second is in lower case, the third in Latin letters."""
    people = [issued("s01", "РТК-41").student, issued("s02", "").student]
    source = NamedBytes("d.csv", f"group,student,deadline\n{written},,2026-12-08\n".encode())
    rows = read_deadlines(source, KYIV, people)
    assert deadline_of(issued("s01", "РТК-41"), rows, KYIV) == rows[0].at
    assert deadline_of(issued("s02", "", None), rows, KYIV) is None
    twice = f"group,student,deadline\n{written},,2026-12-08\nРТК-41,,2026-12-09\n"
    with pytest.raises(TableError, match="a second deadline for the same people"):
        table(twice)


def test_a_dash_for_a_group_is_not_everybody() -> None:
    people = [issued("s01", "РТК-41").student, issued("s02", "").student]
    source = NamedBytes("deadlines.csv", "group,student,deadline\n—,,2026-12-08\n".encode())
    assert deadline_of(issued("s02", "", None), read_deadlines(source, KYIV), KYIV) is None
    with pytest.raises(TableError, match="Nobody is in group"):
        read_deadlines(source, KYIV, people)


def test_summer_time_is_kept() -> None:
    summer, winter = (moment_of(day, KYIV) for day in ("2026-07-01 12:00", "2026-12-01 12:00"))
    assert summer is not None
    assert winter is not None
    assert [one.astimezone(UTC).hour for one in (summer, winter)] == [9, 10]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("group,student,deadline\n,,12/1/2026\n", ["'12/1/2026' is no day."]),
        ("group,student,deadline\n,,2026-02-30\n", ["'2026-02-30' is no day."]),
        ("group,student\nРТК-41,s01\n", ["The column 'deadline' is missing."]),
        (
            "group,studnet,deadline\n,,2026-12-01\n",
            ["There is no column 'studnet' in a table of deadlines."],
        ),
        (
            "group,student,deadline\n,s01,2026-12-01\n,s01,2026-12-02\n",
            ["There is a second deadline for the same people."],
        ),
    ],
)
def test_what_is_wrong_is_named_by_row_and_column(text: str, said: list[str]) -> None:
    with pytest.raises(TableError) as caught:
        table(text)
    assert [str(one.what) for one in caught.value.problems] == said


@pytest.mark.parametrize("rule", [None, LateRule(0.1, 0.5, 0, "Europe/Kyiv")])
def test_a_course_whose_table_cannot_be_used_is_told_so_whatever_lateness_costs(
    tmp_path: Path, rule: LateRule | None
) -> None:
    path = deadlines_path(tmp_path)
    path.parent.mkdir()
    path.write_text("student,deadline\ns01,some day\n", encoding="utf-8")
    with pytest.raises(TableError, match="'some day' is no day"):
        course_deadlines(tmp_path, rule)
    path.write_text("student,deadline\ns01,2026-12-08\n", encoding="utf-8")
    assert len(course_deadlines(tmp_path, rule)) == (0 if rule is None else 1)


def test_who_is_listed_under_two_ids_has_the_latest_of_their_deadlines() -> None:
    rows = table("group,student,deadline\nG1,,2026-12-01\nG2,,2026-12-05\n,s03,2026-11-20\n")
    twice = replace(issued("s01", "G1"), joined=(issued("s02", "G2").student,))
    assert deadline_of(twice, rows, KYIV) == deadline_of(issued("s02", "G2"), rows, KYIV)
    # An earlier day for the second id takes nothing from the first.
    other = replace(issued("s01", "G1"), joined=(issued("s03", "G2").student,))
    assert deadline_of(other, rows, KYIV) == deadline_of(issued("s01", "G1"), rows, KYIV)


def test_a_row_for_the_second_id_is_a_deadline_where_nothing_else_says_one() -> None:
    rows = table("student,deadline\ns02,2026-12-05\n")
    twice = replace(issued("s01", "G1", None), joined=(issued("s02", "G1").student,))
    assert deadline_of(twice, rows, KYIV) == rows[0].at
