"""Marks by hand of a person who had two ids: they count once, and go back where they came from."""

from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.cli.demo.students import correct
from gripcourse.gradebook.journal import Signed
from gripcourse.gradebook.timing import Waiver
from gripcourse.grading.model import FlagCode
from gripcourse.usecases.marks.mark import existing_gradebook, item_of
from gripcourse.usecases.marks.opening import open_grading, register_of
from gripcourse.usecases.marks.regrade import publish, regrade
from gripcourse.usecases.marks.waive import waive
from support.office import DRAWING, NOW, Office

if TYPE_CHECKING:
    from support.classroom import Classroom


@pytest.fixture(scope="module")
def works(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("inbox")
    return {
        one: issued.hand_in(one, correct, folder / f"{one}.xlsx") for one in ("s01", "s02", "s03")
    }


def test_the_mark_of_the_second_id_counts_for_the_person_and_goes_back(
    office: Office, works: dict[str, Path]
) -> None:
    (alone,) = office.grade(works["s03"])
    assert office.mark("s03", 0.5) == 1
    done = office.join()
    assert done.disputed == ()
    assert str(done.notes[-1]) == (
        f"1 mark by hand that was given to s03 is that of s01 now: {DRAWING}."
    )
    (report,) = office.grade(works["s03"])
    item = next(one for one in report.findings if one.quantity == DRAWING)
    assert (report.student, item.points, report.flags) == ("s01", item.max_points / 2, ())
    assert report.score == pytest.approx((alone.score or 0) + item.points)
    assert office.waits() == set()
    assert any(f"{DRAWING}: points" in one and "s03" in one for one in office.told("s01"))
    given_back = office.join(undo=True)
    assert str(given_back.notes[-1]) == f"1 mark by hand is that of s03 again: {DRAWING}."
    assert item_of(office.place, "s01", DRAWING) is None
    assert office.credit("s03") == 0.5
    assert not any(f"{DRAWING}: points" in one for one in office.told("s01"))


def test_rows_of_marks_stay_as_they_were_kept(office: Office, works: dict[str, Path]) -> None:
    office.grade(works["s03"])
    office.mark("s03", 0.5)
    before = existing_gradebook(office.place).entries()
    office.join()
    assert existing_gradebook(office.place).entries() == before


def test_the_mark_of_the_id_that_is_kept_counts_where_the_other_has_none(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s01"])
    office.mark("s01", 1.0)
    assert office.join().notes[1:] == ()
    assert office.credit("s01") == 1.0


def test_of_two_that_say_the_same_one_counts(office: Office, works: dict[str, Path]) -> None:
    office.grade(works["s01"], works["s03"])
    office.mark("s01", 0.5)
    office.mark("s03", 0.5)
    assert (office.join().disputed, office.credit("s01")) == ((), 0.5)
    assert office.waits() == set()


def test_a_person_decides_between_two_that_differ(office: Office, works: dict[str, Path]) -> None:
    office.grade(works["s01"], works["s03"])
    office.mark("s01", 0.5)
    office.mark("s03", 1.0)
    done = office.join()
    assert done.disputed == (DRAWING,)
    both = "s01 50\N{NO-BREAK SPACE}%, s03 100\N{NO-BREAK SPACE}%"
    assert both in str(done.notes[-1])
    # Until then the one of the id that is kept counts, and whoever looks is told.
    assert office.credit("s01") == 0.5
    assert office.waits() == {("s01", True)}
    (report,) = office.grade(works["s01"])
    (flag,) = (one for one in report.flags if one.code is FlagCode.MARK_OUTDATED)
    assert both in str(flag.message)
    # The very same mark once more is a decision, too.
    assert office.mark("s01", 0.5) == 1
    assert office.waits() == set()
    assert office.grade(works["s01"])[0].flags == ()
    assert office.mark("s01", 0.5) == 0
    office.join(undo=True)
    assert (office.credit("s01"), office.credit("s03")) == (0.5, 1.0)


def test_what_is_marked_under_either_id_after_that_is_of_the_person(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s01"], works["s03"])
    office.mark("s03", 1.0)
    office.join()
    office.mark("s03", 0.5)
    assert office.credit("s01") == 0.5
    office.mark("s01", None, "Ошибка")
    assert office.credit("s01") is None
    office.join(undo=True)
    assert (office.credit("s01"), office.credit("s03")) == (None, 1.0)


def test_a_mark_that_was_withdrawn_before_is_none(office: Office, works: dict[str, Path]) -> None:
    office.grade(works["s01"], works["s03"])
    office.mark("s01", 0.5)
    office.mark("s01", None, "Не тот чертёж")
    office.mark("s03", 1.0)
    assert office.join().disputed == ()
    assert office.credit("s01") == 1.0


def test_a_clock_that_was_set_back_decides_nothing(office: Office, works: dict[str, Path]) -> None:
    office.grade(works["s01"], works["s03"])
    office.mark("s01", 0.5)
    office.mark("s03", 1.0)
    office.now = NOW - timedelta(days=3)
    assert office.join().disputed == (DRAWING,)
    office.mark("s01", 1.0)
    assert (office.credit("s01"), office.waits()) == (1.0, set())


def test_three_ids_of_one_person_are_followed(office: Office, works: dict[str, Path]) -> None:
    office.grade(works["s01"], works["s03"])
    office.mark("s03", 1.0)
    office.join("s03", "s02")
    office.join("s02", "s01")
    assert office.credit("s01") == 1.0
    assert any("(Given to s03.)" in one for one in office.told("s01"))
    office.join("s02", undo=True)
    assert office.credit("s01") is None


def test_the_marks_are_in_what_is_published_and_regraded(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s03"])
    office.mark("s03", 1.0)
    office.join()
    (report,) = office.grade(works["s03"])
    joins = register_of(office.root).joins
    (told,) = publish(office.place, ["s03"], Signed("Петров", office.later()), joins)
    assert (told.student, told.points) == ("s01", report.score)
    (change,) = regrade(
        [works["s03"]], open_grading(office.root), office.place, 0, office.later()
    ).changes
    assert change.before.score == change.after.score == report.score


def test_a_waiver_of_either_id_is_the_persons_and_the_more_generous_counts(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s01"], works["s03"])
    joins = register_of(office.root).joins
    one = Waiver("s03", 0, None, withdrawn=False, person="Петров", done_at=NOW, why="Больница")
    until = replace(one, student="s01", until=NOW, why="Олимпиада")
    waive(one, office.place, {"s01", "s03"}, joins)
    waive(until, office.place, {"s01", "s03"}, joins)
    office.join()
    assert any(
        one.startswith("Lateness is not counted. (Given to s03") for one in office.told("s01")
    )
