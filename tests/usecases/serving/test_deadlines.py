"""The desk calls late what grading calls late: by the course's zone and its table of deadlines."""

from dataclasses import replace
from datetime import UTC, date, datetime
from typing import TYPE_CHECKING
from zoneinfo import ZoneInfo

import pytest

from gripcourse.access.desk.store import open_desk
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.database.home import home_of
from gripcourse.machine.resources import deadlines_path
from gripcourse.policy.time_rules import LateRule
from gripcourse.usecases.serving.deadlines import DeskDeadlines
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import hand_in, is_late
from gripcourse.variants.model import Issued, Student, Variant
from support.classroom import KEY

if TYPE_CHECKING:
    from pathlib import Path

    from support.classroom import Classroom

RULE = LateRule(0.1, 0.5, 0, "Europe/Kyiv")
ANNA = Student("s01", "Anna", "A-1", "", "en", "")
ISSUED = Issued(ANNA, Variant("1", "x", {}, {}), date(2026, 9, 7), date(2026, 12, 1), "")
"""Whose last day is the first of December."""


def write_table(root: "Path", *rows: str) -> None:
    path = deadlines_path(root)
    path.parent.mkdir(exist_ok=True)
    path.write_text("\n".join(("group,student,deadline", *rows)) + "\n", encoding="utf-8")


def test_a_day_ends_in_the_zone_of_the_course(tmp_path: "Path") -> None:
    last = DeskDeadlines(tmp_path, RULE).of(ISSUED)
    assert last == datetime(2026, 12, 1, 23, 59, 59, tzinfo=ZoneInfo("Europe/Kyiv"))


def test_the_table_says_otherwise_for_a_student_and_is_read_again_when_it_changes(
    tmp_path: "Path",
) -> None:
    found = DeskDeadlines(tmp_path, RULE)
    write_table(tmp_path, ",s01,2026-12-08 18:00")
    assert found.of(ISSUED) == datetime(2026, 12, 8, 18, tzinfo=ZoneInfo("Europe/Kyiv"))
    write_table(tmp_path, ",s01,2026-12-20")
    later = found.of(ISSUED)
    assert later is not None
    assert later.date() == date(2026, 12, 20)
    deadlines_path(tmp_path).unlink()
    assert found.of(ISSUED) == datetime(2026, 12, 1, 21, 59, 59, tzinfo=UTC)


def test_a_table_that_cannot_be_used_leaves_what_it_said_before_and_is_logged_once(
    tmp_path: "Path", caplog: pytest.LogCaptureFixture
) -> None:
    found = DeskDeadlines(tmp_path, RULE)
    write_table(tmp_path, ",s01,2026-12-08")
    before = found.of(ISSUED)
    write_table(tmp_path, ",s01,some day")
    assert [found.of(ISSUED), found.of(ISSUED)] == [before, before]
    assert [one.getMessage() for one in caplog.records] == ["'some day' is no day."]


def test_where_lateness_costs_nothing_the_table_is_not_read(tmp_path: "Path") -> None:
    write_table(tmp_path, ",s01,2026-12-08")
    last = DeskDeadlines(tmp_path, None).of(ISSUED)
    assert last is not None
    assert (last.date(), last.time().hour) == (date(2026, 12, 1), 23)
    assert DeskDeadlines(tmp_path, None).of(replace(ISSUED, deadline=None)) is None


@pytest.mark.parametrize(
    ("at", "late"),
    [
        (datetime(2026, 12, 1, 21, 59, 59, 999_999, tzinfo=UTC), False),
        (datetime(2026, 12, 1, 22, 0, 0, tzinfo=UTC), True),  # past midnight in Kyiv
    ],
)
def test_a_receipt_is_late_from_the_second_on_from_which_grading_counts(
    classroom: "Classroom", at: datetime, *, late: bool
) -> None:
    course = classroom.course
    desk = open_desk(home_of(course.root), course.id)
    context = DeskContext(course, replace(classroom.policy, late=RULE), KEY, desk)
    assert hand_in(context, ISSUED, NamedBytes("s01.xlsx", b"PK"), at).late == late
    assert is_late(context, ISSUED, at) == late
