"""A program corrects what was issued as a person does."""

from typing import TYPE_CHECKING

import pytest

import gripcourse as gc
from support.classroom import ROSTER

if TYPE_CHECKING:
    from support.classroom import Classroom


def test_a_program_issues_a_new_version_and_learns_what_changed(
    classroom: "Classroom", monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "gripcourse.usecases.issuing.handout.assignment_sheet", lambda *_: b"%PDF-1.7\n"
    )
    classroom.issue(roster=gc.NamedBytes("roster.csv", ROSTER.partition("s02,")[0].encode()))
    course = gc.Course.load(classroom.course.root, "en")
    out, table = classroom.order.out.with_name("corrected"), classroom.order.table
    done = gc.reissue(course, ["s01"], out, by="Петров", why="опечатка", variant="5", table=table)
    (handout,) = done.handouts
    assert len(handout.files) == 2
    assert not handout.faults
    (note,) = done.notes
    assert "version 2 is variant 005" in note
    with pytest.raises(gc.GripcourseError):
        gc.reissue(course, ["s01"], out, by="Петров", why="", table=table)
