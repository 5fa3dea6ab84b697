"""When works were handed in, what that costs, and which of them counts: from files to reports."""

import os
from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING
from zoneinfo import ZoneInfo

import pytest

from gripcourse.batch.one_file import grade_file
from gripcourse.batch.run import Graded
from gripcourse.demo.students import correct
from gripcourse.documents.report.standing import timing_texts
from gripcourse.errors import UsageError
from gripcourse.exports.grades import grades_text
from gripcourse.gradebook.timing import Waiver
from gripcourse.grading.model import Report, Timing
from gripcourse.policy.time_rules import AttemptRule, Counts, LateRule
from gripcourse.text.words import Words
from gripcourse.usecases.gradebook import keep
from gripcourse.usecases.handed_in import handed_in_times
from gripcourse.usecases.history import history
from gripcourse.usecases.waive import waive
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

NOW = datetime(2026, 12, 9, 9, tzinfo=UTC)
KYIV = ZoneInfo("Europe/Kyiv")


class Office:
    """Two works of one student, graded as often as a test wants; the deadline is 1 December."""

    def __init__(self, classroom: "Classroom", files: Sequence[Path], folder: Path) -> None:
        rules = {
            "late": LateRule(0.1, 0.5, 0, "Europe/Kyiv"),
            "attempts": AttemptRule(Counts.LAST, 0),
        }
        context = classroom.context
        self.context = replace(context, policy=replace(context.policy, **rules))  # type: ignore[arg-type]
        self.files, self.place = files, str(folder / "gradebook.sqlite")

    def grade(self, *said: str) -> list[Report]:
        graded = [Graded(grade_file(one, self.context), "") for one in self.files]
        times = handed_in_times(said, self.files, KYIV)
        return [one.report for one in keep(graded, self.context, self.place, NOW, times)]

    def timings(self, *said: str) -> list[Timing]:
        return [one.timing for one in self.grade(*said) if one.timing is not None]

    def waive(self, why: str = "болезнь", student: str = "s01", *, withdrawn: bool = False) -> None:
        waiver = Waiver(student, 0, None, withdrawn, "Петров", NOW, why)
        waive(waiver, self.place, self.context.register)


@pytest.fixture(scope="module")
def files(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    folder = tmp_path_factory.mktemp("inbox")
    made = [
        issued.hand_in("s01", correct, folder / "first" / "s01.xlsx"),
        issued.hand_in("s01", forget_one_jaw, folder / "second" / "s01.xlsx"),
    ]
    for day, one in zip((1, 3), made, strict=True):
        moment = datetime(2026, 12, day, 12, tzinfo=UTC).timestamp()
        os.utime(one, (moment, moment))
    return made


@pytest.fixture
def office(issued: "Classroom", files: list[Path], tmp_path: Path) -> Office:
    return Office(issued, files, tmp_path)


def test_the_files_own_time_counts_and_the_last_work_does(office: Office) -> None:
    first, second = office.timings()
    assert (first.days_late, first.counts, first.number, first.of) == (0, False, 1, 2)
    assert (second.days_late, second.counts, second.deduction) == (2, True, pytest.approx(0.2))


def test_what_a_person_says_goes_before_it_and_stays_said(office: Office) -> None:
    office.grade()
    office.grade("second/s01.xlsx=2026-11-30 10:00")
    told, _ = [one.timing for one in office.grade()], office.files
    assert [one.days_late for one in told if one] == [0, 0]
    assert [one.counts for one in told if one] == [True, False]


def test_a_waiver_counts_from_the_next_grading_and_can_be_withdrawn(office: Office) -> None:
    assert office.timings()[1].deduction > 0
    office.waive()
    assert office.timings()[1].deduction == 0
    office.waive("ошибка", withdrawn=True)
    assert office.timings()[1].deduction > 0
    waived = [one for one in history(office.place, "s01") if one.person]
    assert [one.why for one in waived] == ["болезнь", "ошибка"]


def test_the_report_and_the_table_say_what_lateness_costs(office: Office) -> None:
    reports = office.grade()
    said = " ".join(timing_texts(reports[1], Words("en")))
    assert "Attempt 2 of 2: this one counts." in said
    assert "2026-12-03 14:00, the deadline was 2026-12-01 23:59; days late: 2" in said
    assert reports[1].earned == pytest.approx(0.8 * reports[1].score)
    header, *rows = grades_text(reports).splitlines()
    columns = header.split(",")
    cells = dict(zip(columns, rows[1].split(","), strict=False))
    assert float(cells["earned"]) == pytest.approx(reports[1].earned, abs=1e-3)
    assert [cells[name] for name in ("attempt", "counts", "handed_in", "days_late")] == [
        "2/2",
        "1",
        "2026-12-03T12:00Z",
        "2",
    ]


def test_without_a_rule_nothing_is_said_of_time(office: Office) -> None:
    office.context = replace(
        office.context, policy=replace(office.context.policy, late=None, attempts=None)
    )
    assert office.timings() == []
    assert "earned" not in grades_text(office.grade())


class TestRefusals:
    def test_a_moment_that_is_none_and_a_file_that_is_not_there_are_named(
        self, files: list[Path]
    ) -> None:
        with pytest.raises(UsageError) as caught:
            handed_in_times(["tomorrow", "s09.xlsx=2026-12-01"], files, KYIV)
        assert [str(one.what) for one in caught.value.problems] == [
            "'tomorrow' is no day.",
            "No file of the batch is called 's09.xlsx'.",
        ]

    def test_a_waiver_needs_a_student_a_reason_and_something_to_withdraw(
        self, office: Office
    ) -> None:
        with pytest.raises(UsageError) as caught:
            office.waive(" ", "s09")
        assert [one.parameter for one in caught.value.problems] == ["student", "why"]
        with pytest.raises(UsageError, match="no waiver that counts"):
            office.waive(withdrawn=True)
