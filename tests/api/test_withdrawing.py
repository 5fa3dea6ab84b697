"""A program notes who left, and who has two ids, as a person does."""

import shutil
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import gripcourse as gc
from gripcourse.cli.demo.students import correct
from gripcourse.machine.database.home import home_of

if TYPE_CHECKING:
    from support.classroom import Classroom

DRAWING = "general_view_drawing"


@pytest.fixture
def own(issued: "Classroom", tmp_path: Path) -> gc.Course:
    return gc.Course.load(shutil.copytree(issued.course.root, tmp_path / "course"), "en")


def test_who_left_is_back_when_it_is_taken_back(own: gc.Course) -> None:
    left = gc.withdraw(own, "s03", by="Петров", why="Приказ 12")
    assert left.notes[0].startswith("s03 has left the course")
    back = gc.withdraw(own, "s03", by="Петров", why="Приказ 40", undo=True)
    assert back.notes == ("s03 is in the course again.",)


def test_a_reason_is_asked_for(own: gc.Course) -> None:
    with pytest.raises(gc.GripcourseError) as refused:
        gc.withdraw(own, "s03", by="Петров", why=" ")
    (problem,) = refused.value.problems
    assert problem.parameter == "why"


def test_marks_under_two_ids_are_told_wherever_a_course_is_named(
    own: gc.Course, issued: "Classroom", tmp_path: Path
) -> None:
    place = home_of(own.root)
    works = [issued.hand_in(one, correct, tmp_path / f"{one}.xlsx") for one in ("s01", "s03")]
    own.grade(works, gradebook=place)
    for student, share in (("s01", 0.5), ("s03", 1.0)):
        lines = dict.fromkeys(("sizes", "assembly", "standards"), share)
        gc.enter_mark(own, gc.Draft(student, DRAWING, lines), place, "Петров")
    done = gc.withdraw(own, "s03", by="Петров", why="Один человек", same_as="s01")
    assert done.disputed == (DRAWING,)
    waits = gc.what_waits(place, course=own)
    assert {one.student for one in waits} == {"s01"}
    assert [one.again for one in waits if one.quantity == DRAWING] == [True]
    told = [str(one.what) for one in gc.history(place, "s01", course=own)]
    assert any("(Given to s03.)" in one for one in told)
    published = gc.publish(place, by="Петров", course=own)
    assert [one.student for one in published] == ["s01", "s01"]
