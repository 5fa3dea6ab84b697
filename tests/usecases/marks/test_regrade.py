"""A regrade is seen before it counts, has a reason, and can be taken back; nothing is lost."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from openpyxl import load_workbook
from openpyxl.packaging.core import DocumentProperties
from openpyxl.packaging.custom import CustomPropertyList

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.errors import GradebookError, NextStep, UsageError
from gripcourse.gradebook.enter import Draft
from gripcourse.gradebook.journal import Signed
from gripcourse.gradebook.regrade import Shift
from gripcourse.gradebook.store import open_gradebook
from gripcourse.gradebook.works import works_of
from gripcourse.grading.model import Report
from gripcourse.usecases.marks.batch_wish import BatchWish
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.handed_in import HandingTime
from gripcourse.usecases.marks.history import history
from gripcourse.usecases.marks.mark import enter_mark
from gripcourse.usecases.marks.opening import by_word
from gripcourse.usecases.marks.regrade import (
    Regrading,
    apply_regrade,
    as_decided,
    publish,
    regrade,
    undo_regrade,
)
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

NOW = datetime(2026, 12, 2, 9, tzinfo=UTC)
DRAWING = "general_view_drawing"


class Faculty:
    """Two graded works, and a policy that gives the second of them less."""

    def __init__(self, classroom: "Classroom", files: Sequence[Path], folder: Path) -> None:
        self.files, self.place = files, str(folder / "gradebook.sqlite")
        self.today = classroom.context
        self.stricter = replace(self.today, policy=replace(self.today.policy, carried_credit=0.5))
        self.hours = 0

    def signed(self, why: str = "так решила кафедра") -> Signed:
        self.hours += 1
        return Signed("Петров", NOW + timedelta(hours=self.hours), why)

    def grade(
        self, context: GradingContext, handed_in: datetime | None = None
    ) -> dict[str, Report]:
        """Grade, and say of all files when they were handed in where somebody knows it."""
        graded = [Graded(grade_file(one, context), "") for one in self.files]
        said = [] if handed_in is None else [HandingTime(handed_in, said=True)]
        times = {one.report.file: time for one in graded for time in said}
        kept = keep(graded, context, self.place, NOW, times)
        return {one.report.student: one.report for one in kept}

    def regrade(self, context: GradingContext | None = None) -> Regrading:
        return regrade(self.files, context or self.stricter, self.place, 0, NOW)

    def mark(self, student: str = "s02") -> None:
        draft = Draft(student, DRAWING, {"sizes": 1.0, "assembly": 0.5, "standards": 0.0})
        enter_mark(draft, self.today, self.place, "Петров", self.signed().done_at)


@pytest.fixture(scope="module")
def files(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """A right workbook and one with an early slip."""
    folder = tmp_path_factory.mktemp("inbox")
    return [
        issued.hand_in("s01", correct, folder / "s01.xlsx"),
        issued.hand_in("s02", forget_one_jaw, folder / "s02.xlsx"),
    ]


@pytest.fixture
def faculty(issued: "Classroom", files: list[Path], tmp_path: Path) -> Faculty:
    faculty = Faculty(issued, files, tmp_path)
    faculty.grade(faculty.today)
    return faculty


def test_it_shows_old_and_new_for_everybody_with_the_reasons_and_writes_nothing(
    faculty: Faculty,
) -> None:
    before = Path(faculty.place).read_bytes()
    found = faculty.regrade()
    assert Path(faculty.place).read_bytes() == before
    assert {one: len(found.going(one)) for one in Shift} == {
        Shift.RAISED: 0,
        Shift.LOWERED: 1,
        Shift.UNCHANGED: 1,
    }
    (change,) = found.to_apply
    assert change.work.student == "s02"
    assert change.after.score < change.before.score
    lost = sum(
        one.before.points - one.after.points for one in change.items if one.before and one.after
    )
    assert change.before.score - change.after.score == pytest.approx(lost)
    assert (found.strangers, found.missing, found.lost) == ((), (), ())


def test_what_was_judged_to_look_is_taken_over_to_apply(
    faculty: Faculty, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept = KeptReports(tmp_path / "kept", {})
    looked = regrade(faculty.files, faculty.stricter, faculty.place, 0, NOW, kept=kept)
    monkeypatch.setattr("gripcourse.batch.run._grade", lambda *_: pytest.fail("graded again"))
    again = regrade(faculty.files, faculty.stricter, faculty.place, 0, NOW, kept=kept)
    assert again == looked
    assert len(apply_regrade(again, faculty.place, faculty.signed())) == 1


def test_applied_it_counts_and_taken_back_it_never_did(faculty: Faculty) -> None:
    first = faculty.regrade()
    assert len(apply_regrade(first, faculty.place, faculty.signed())) == 1
    assert faculty.regrade().to_apply == ()
    assert len(faculty.regrade(faculty.today).going(Shift.RAISED)) == 1
    assert undo_regrade(faculty.place, faculty.signed("поспешили")).undoes == 1
    assert faculty.regrade(faculty.today).to_apply == ()
    assert faculty.regrade().to_apply == first.to_apply


def test_marks_of_persons_survive_and_only_what_they_rest_on_outdates_them(
    faculty: Faculty,
) -> None:
    faculty.mark()
    found = faculty.regrade()
    (change,) = found.to_apply
    assert DRAWING not in {one.quantity for one in change.items}
    apply_regrade(found, faculty.place, faculty.signed())
    report = faculty.grade(faculty.stricter)["s02"]
    assert report.flags == ()
    assert report.score == pytest.approx(change.after.score)
    assert report.open_points == pytest.approx(change.after.open_points)


class TestPublished:
    def test_grading_again_does_not_change_what_was_told(self, faculty: Faculty) -> None:
        told = faculty.grade(faculty.today)["s02"]
        assert len(publish(faculty.place, ["s02"], faculty.signed())) == 1
        now = faculty.grade(faculty.stricter)["s02"]
        assert now.score == pytest.approx(told.score)
        assert [one.code for one in now.flags] == ["regrade_waits"]
        assert len(faculty.regrade().to_apply) == 1

    def test_it_gets_worse_only_where_somebody_says_so(self, faculty: Faculty) -> None:
        publish(faculty.place, (), faculty.signed())
        found = faculty.regrade()
        with pytest.raises(UsageError) as caught:
            apply_regrade(found, faculty.place, faculty.signed())
        (problem,) = caught.value.problems
        assert "s02" in str(problem.what)
        assert problem.step is NextStep.ALLOW_LOWER
        assert faculty.regrade().to_apply == found.to_apply
        apply_regrade(found, faculty.place, faculty.signed(), allow_lower=True)
        assert faculty.grade(faculty.stricter)["s02"].flags == ()

    def test_it_gets_better_without_more_ado(self, faculty: Faculty) -> None:
        apply_regrade(faculty.regrade(), faculty.place, faculty.signed())
        publish(faculty.place, (), faculty.signed())
        assert (
            len(apply_regrade(faculty.regrade(faculty.today), faculty.place, faculty.signed())) == 1
        )


class TestTakingBackWhatWasTold:
    """Students were told the raised results: taking them back needs a word, as lowering does."""

    @pytest.fixture
    def told(self, faculty: Faculty) -> Faculty:
        apply_regrade(faculty.regrade(), faculty.place, faculty.signed())
        publish(faculty.place, (), faculty.signed())
        apply_regrade(faculty.regrade(faculty.today), faculty.place, faculty.signed())
        return faculty

    def test_a_result_that_was_told_gets_worse_only_where_somebody_says_so(
        self, told: Faculty
    ) -> None:
        publish(told.place, (), told.signed())
        before = told.grade(told.today)["s02"].score
        with pytest.raises(
            UsageError, match=r"published to s02, who would get .*regrade stand"
        ) as no:
            undo_regrade(told.place, told.signed())
        assert [one.step for one in no.value.problems] == [NextStep.ALLOW_LOWER]
        assert told.grade(told.today)["s02"].score == before
        undo_regrade(told.place, told.signed(), allow_lower=True)
        assert told.grade(told.today)["s02"].score < before

    def test_whom_nobody_told_the_raised_result_loses_nothing(self, told: Faculty) -> None:
        assert undo_regrade(told.place, told.signed()).undoes == 2

    def test_what_gets_better_is_taken_back_without_more_ado(self, faculty: Faculty) -> None:
        apply_regrade(faculty.regrade(), faculty.place, faculty.signed())
        publish(faculty.place, (), faculty.signed())
        assert undo_regrade(faculty.place, faculty.signed()).undoes == 1


def test_what_was_said_of_the_time_stays_said_when_a_regrade_is_taken_back(
    faculty: Faculty,
) -> None:
    publish(faculty.place, (), faculty.signed())
    apply_regrade(faculty.regrade(), faculty.place, faculty.signed(), allow_lower=True)
    for _ in range(2):
        faculty.grade(faculty.stricter, NOW - timedelta(days=5))
    undo_regrade(faculty.place, faculty.signed())
    faculty.grade(faculty.stricter, NOW - timedelta(days=5))
    book = open_gradebook(faculty.place)
    (work,) = works_of(book.standing())["s02"]
    assert (work.attempt.regrade, work.handed_in) == (None, NOW - timedelta(days=5))
    # Kept once: the first grading, the regrade, and the time that was said.
    assert len(book.attempts({"s02"})) == 3


def test_files_that_were_not_graded_and_works_whose_file_is_missing_are_named(
    faculty: Faculty, issued: "Classroom", tmp_path: Path
) -> None:
    new = issued.hand_in("s03", correct, tmp_path / "s03.xlsx")
    found = regrade([faculty.files[0], new], faculty.today, faculty.place, 0, NOW)
    assert [Path(one).name for one in found.strangers] == ["s03.xlsx"]
    assert [one.student for one in found.missing] == ["s02"]


def test_what_fails_on_our_side_changes_nothing_and_is_named(faculty: Faculty) -> None:
    entry = faculty.today.register["s02"]
    gone = replace(entry, variant=replace(entry.variant, scheme="four_bar"))
    found = faculty.regrade(
        replace(faculty.today, register={**faculty.today.register, "s02": gone})
    )
    assert [Path(one).name for one in found.failed] == ["s02.xlsx"]
    assert len(found.incidents) == 1
    assert found.to_apply == ()


class TestRefusals:
    def test_without_a_reason_nothing_is_changed(self, faculty: Faculty) -> None:
        for act in (
            lambda: apply_regrade(faculty.regrade(), faculty.place, faculty.signed(" ")),
            lambda: undo_regrade(faculty.place, faculty.signed("")),
        ):
            with pytest.raises(UsageError) as caught:
                act()
            assert caught.value.problems[0].parameter == "why"
        assert len(faculty.regrade().to_apply) == 1

    def test_without_a_regrade_there_is_nothing_to_take_back(self, faculty: Faculty) -> None:
        with pytest.raises(UsageError, match="No regrade stands"):
            undo_regrade(faculty.place, faculty.signed())

    def test_who_has_handed_in_nothing_is_told_nothing(self, faculty: Faculty) -> None:
        with pytest.raises(UsageError, match="s09"):
            publish(faculty.place, ["s01", "s09"], faculty.signed())
        assert len(publish(faculty.place, (), faculty.signed())) == 2

    def test_without_a_gradebook_the_remedy_is_to_grade(
        self, issued: "Classroom", tmp_path: Path
    ) -> None:
        with pytest.raises(GradebookError):
            regrade([], issued.context, str(tmp_path / "no.sqlite"), 0, NOW)


def test_a_history_tells_what_happened_when_by_whom_and_why(faculty: Faculty) -> None:
    faculty.mark()
    publish(faculty.place, (), faculty.signed())
    apply_regrade(faculty.regrade(), faculty.place, faculty.signed("опечатка"), allow_lower=True)
    undo_regrade(faculty.place, faculty.signed("нет опечатки"))
    events = history(faculty.place, "s02")
    assert [one.at for one in events] == sorted(one.at for one in events)
    told = [(one.person, str(one.what).split()[0], one.why) for one in events]
    assert told[0] == ("", "Attempt", "")
    works = [str(one.what).partition(",")[0] for one in events if "Attempt" in str(one.what)]
    assert works == ["Attempt 1", "Attempt 1 in regrade 1"]
    assert any("(attempt 1)" in str(one.what) for one in events)
    assert ("Петров", f"{DRAWING}:", "") in told
    assert ("Петров", "Points", "") in told
    by_title = history(faculty.place, "s02", called={DRAWING: "Чертёж"}.__getitem__)
    assert [one for one in by_title if str(one.what).startswith("Чертёж: ")]
    assert told[-2:] == [("Петров", "Regrade", "опечатка"), ("Петров", "Regrade", "нет опечатки")]
    assert [one.why for one in history(faculty.place, "s01")] == ["", ""]
    assert history(faculty.place, "s03", {"s03"}) == ()
    with pytest.raises(UsageError, match="s04"):
        history(faculty.place, "s04", {"s03"})


def test_the_mark_that_counts_is_told_last_though_the_clock_was_set_back(faculty: Faculty) -> None:
    for hours, sizes in ((20, 1.0), (10, 0.5)):
        faculty.hours = hours
        at = faculty.signed().done_at
        draft = Draft("s02", DRAWING, {"sizes": sizes, "assembly": 0.5, "standards": 0.0})
        enter_mark(draft, faculty.today, faculty.place, "Петров", at)
    told = [one.at - NOW for one in history(faculty.place, "s02") if DRAWING in str(one.what)]
    assert told == [timedelta(hours=21), timedelta(hours=11)]


def test_works_are_graded_again_by_the_order_of_folders_that_told_whose_they_are(
    issued: "Classroom", tmp_path: Path
) -> None:
    bare = tmp_path / "Анна Иванова" / "ответы.xlsx"
    bare.parent.mkdir()
    book = load_workbook(issued.hand_in("s01", correct, tmp_path / "s01.xlsx"))
    del book["_gripcourse"]
    for name in [one for one in book.defined_names if one.startswith("meta.")]:
        del book.defined_names[name]
    book.properties, book.custom_doc_props = DocumentProperties(), CustomPropertyList()
    book.save(bare)
    place, wish = str(tmp_path / "gradebook.sqlite"), BatchWish(pattern="{name}/*")
    context = by_word(wish, [bare], issued.context)
    keep([Graded(grade_file(bare, context), "")], context, place, NOW)
    for said in (wish, BatchWish()):  # what was said once is known from the gradebook
        again = as_decided(issued.context, [bare], place, said)
        assert regrade([bare], again, place, 0, NOW).strangers == ()
    elsewhere = bare.rename(tmp_path / "ответы.xlsx")
    without = as_decided(issued.context, [elsewhere], place, BatchWish())
    assert regrade([elsewhere], without, place, 0, NOW).strangers == (str(elsewhere),)
