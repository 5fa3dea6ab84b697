"""When works were handed in, what that costs, and which of them counts: from files to reports."""

import os
from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING
from zoneinfo import ZoneInfo

import pytest

from gripcourse.batch.duplicates import doubles
from gripcourse.batch.graded import Graded, with_reports
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.cli.times_text import without_deadlines, without_times
from gripcourse.documents.report.soundness import time_sentence
from gripcourse.documents.report.standing import timing_texts
from gripcourse.errors import UsageError
from gripcourse.exports.grades import grades_text
from gripcourse.exports.make_report_result import report_result
from gripcourse.exports.platforms.moodle_words import HEADINGS, MoodleColumn
from gripcourse.gradebook.deadlines import Deadline
from gripcourse.gradebook.enter import Draft
from gripcourse.gradebook.timing import Waiver
from gripcourse.grading.model import Flag, FlagCode, Report, Timing
from gripcourse.policy.time_rules import AttemptRule, Counts, LateRule
from gripcourse.text.amounts import NO_BREAK_SPACE
from gripcourse.text.words import Words, message
from gripcourse.usecases.grading.grade import write_results
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.handed_in import HandingTime, handed_in_times
from gripcourse.usecases.marks.history import history, what_counts
from gripcourse.usecases.marks.mark import enter_mark
from gripcourse.usecases.marks.waive import waive
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
        alone = [grade_file(one, self.context) for one in self.files]
        graded = with_reports([Graded(one, "") for one in alone], doubles(alone))
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


def test_a_drawing_is_marked_once_whichever_work_counts(office: Office) -> None:
    """Marking again settles what is to be looked at, also where an earlier work counts."""
    office.context = replace(
        office.context, policy=replace(office.context.policy, attempts=AttemptRule(Counts.FIRST, 0))
    )
    first, last = office.grade()
    lines = {"sizes": 1.0, "assembly": 0.5, "standards": 0.0}
    draft = Draft("s01", "general_view_drawing", lines)
    enter_mark(draft, office.context, office.place, "Петров", NOW)
    marked = office.grade()
    assert [one.flags for one in marked] == [first.flags, last.flags]
    assert marked[0].open_points < first.open_points
    assert [one.timing.counts for one in marked if one.timing] == [True, False]


def test_of_a_waiver_the_report_says_until_when_it_holds(office: Office) -> None:
    """Else a student reads that lateness was waived, beside what it costs."""
    until = datetime(2026, 12, 2, 10, tzinfo=UTC)
    one = Waiver("s01", 0, until, False, "Петров", NOW, "Hospital.")
    office.grade()
    waive(one, office.place, office.context.register)
    told = " ".join(timing_texts(office.grade()[1], Words("en"))).replace(NO_BREAK_SPACE, " ")
    assert "days late: 2" in told
    assert "Lateness was waived until 2 Dec 2026, 12:00 UTC+2: Hospital." in told


def test_a_waiver_counts_from_the_next_grading_and_can_be_withdrawn(office: Office) -> None:
    assert office.timings()[1].deduction > 0
    office.waive()
    assert office.timings()[1].deduction == 0
    office.waive("ошибка", withdrawn=True)
    assert office.timings()[1].deduction > 0
    waived = [one for one in history(office.place, "s01") if one.person]
    assert [one.why for one in waived] == ["болезнь", "ошибка"]


def test_a_history_says_what_counts_and_what_it_was_before_lateness(office: Office) -> None:
    report = office.grade()[1]
    points = f"{0.8 * (report.score or 0):.4g} of {report.max_score:.4g} points"
    said = str(what_counts(office.place, "s01", office.context))
    assert f"attempt 2, {points}; before lateness (days late: 2) {report.score:.4g}." in said
    office.waive()
    said = str(what_counts(office.place, "s01", office.context))
    assert f"attempt 2, {report.score:.4g} of {report.max_score:.4g} points." in said


def test_the_report_and_the_table_say_what_lateness_costs(office: Office) -> None:
    reports = office.grade()
    said = " ".join(timing_texts(reports[1], Words("en")))
    assert "Attempt 2 of 2: this one counts." in said
    times = "3 Dec 2026, 14:00 UTC+2, the deadline was 1 Dec 2026, 23:59 UTC+2 (Europe/Kyiv)"
    assert f"{times}; days late: 2" in said.replace(NO_BREAK_SPACE, " ")
    assert reports[1].earned == pytest.approx(0.8 * reports[1].score)
    header, *rows = grades_text(reports).splitlines()
    columns = header.split(",")
    cells = dict(zip(columns, rows[1].split(","), strict=False))
    assert float(cells["earned"]) == pytest.approx(reports[1].earned, abs=1e-3)
    # Before lateness, and after it: two days of a tenth each.
    right = float(cells["score"]) / float(cells["max_score"])
    assert float(cells["percent"]) == pytest.approx(100 * right, abs=1e-3)
    assert float(cells["earned_percent"]) == pytest.approx(80 * right, abs=1e-3)
    told = report_result(reports[1], Words("en"))
    assert told.earned_percent == pytest.approx(0.8 * (told.percent or 0), abs=1e-3)
    assert [cells[name] for name in ("attempt", "counts", "handed_in", "days_late")] == [
        "2/2",
        "1",
        "2026-12-03T12:00Z",
        "2",
    ]


def test_where_the_rule_says_which_work_counts_nobody_is_asked(office: Office) -> None:
    several = Flag(FlagCode.SEVERAL_FILES, message("More files."))
    graded = [Graded(replace(grade_file(one, office.context), flags=(several,)), "")
              for one in office.files]  # fmt: skip
    known = handed_in_times((), office.files, KYIV)
    kept = keep(graded, office.context, office.place, NOW, known)
    assert [one.report.flags for one in kept] == [(), ()]


@pytest.mark.parametrize(
    ("counts", "most", "is_asked"),
    [
        (Counts.BEST, 0, False),
        (Counts.BEST, 2, False),
        (Counts.BEST, 1, True),
        (Counts.LAST, 0, True),
        (Counts.FIRST, 0, True),
    ],
)
def test_of_works_of_one_moment_the_best_counts_and_nobody_is_asked(
    office: Office, counts: Counts, most: int, *, is_asked: bool
) -> None:
    rules = replace(office.context.policy, attempts=AttemptRule(counts, most))
    office.context = replace(office.context, policy=rules)
    asked = [FlagCode.SEVERAL_FILES] * 2
    flags = [flag.code for one in office.grade("2026-12-01 10:00") for flag in one.flags]
    assert flags == (asked if is_asked else [])


def test_where_nobody_knows_when_works_came_lateness_may_decide_which_is_best(
    office: Office,
) -> None:
    rules = replace(office.context.policy, attempts=AttemptRule(Counts.BEST, 0))
    alone = [grade_file(one, office.context) for one in office.files]
    graded = with_reports([Graded(one, "") for one in alone], doubles(alone))
    for late, is_asked in ((rules.late, True), (None, False)):
        context = replace(office.context, policy=replace(rules, late=late))
        kept = keep(graded, context, office.place, NOW)
        assert [bool(one.report.flags) for one in kept] == [is_asked] * 2


def test_works_without_a_time_are_named_and_have_no_days_late(office: Office) -> None:
    graded = [Graded(grade_file(one, office.context), "") for one in office.files]
    reports = [one.report for one in keep(graded, office.context, office.place, NOW)]
    (said,) = without_times(reports, Words("en"))
    assert said.startswith("Nobody knows when these were handed in, so none of them is late (2)")
    late = replace(reports[0], file="c.zip/иванова_LATE_1_2_a.xlsx")
    (_, said) = without_times([late, reports[1]], Words("en"))
    assert said.endswith("takes nothing off here: иванова_LATE_1_2_a.xlsx.")
    header, row, _ = grades_text(reports).splitlines()
    assert dict(zip(header.split(","), row.split(","), strict=False))["days_late"] == ""
    assert [report_result(one, Words("en")).days_late for one in reports] == [None, None]
    assert "Nobody knows when this was handed in" in " ".join(timing_texts(reports[0], Words("en")))
    assert "handed in nobody knows when: 2." in time_sentence(reports, Words("en"))
    # Its own time may be that of unpacking a zip: nobody gets late by that.
    again = office.grade()
    assert [one.timing.handed_in for one in again if one.timing] == [None, None]
    assert list(without_times(office.grade("2026-12-01 10:00"), Words("en"))) == []


def test_whoever_has_no_deadline_is_named_where_lateness_costs(
    office: Office, tmp_path: Path
) -> None:
    def undated() -> tuple[str, ...]:
        graded = [Graded(one, "") for one in office.grade()]
        out, day = tmp_path / "out", NOW.date()
        outcome = write_results(graded, office.context, out, day, 0, print, lay_out=None)
        return outcome.undated

    assert undated() == ()
    register = {name: replace(one, deadline=None) for name, one in office.context.register.items()}
    office.context = replace(office.context, register=register)
    assert undated() == ("s01",)
    (said,) = without_deadlines(undated(), Words("en"))
    assert said.startswith("Lateness costs, but these students have no deadline (1): s01.")
    assert list(without_deadlines((), Words("en"))) == []
    office.context = replace(office.context, policy=replace(office.context.policy, late=None))
    assert undated() == ()


@pytest.mark.parametrize(("language", "written"), [
    ("en", "Wednesday, 2 December 2026, 3:05 PM"),
    ("ru", "среда, 2 декабря 2026, 15:05"),
    ("uk", "середа 2 грудня 2026 15:05"),
])  # fmt: skip
def test_a_grading_worksheet_says_when_its_participants_handed_in(
    language: str, written: str, tmp_path: Path
) -> None:
    words = HEADINGS[language]
    columns = [MoodleColumn.IDENTIFIER, MoodleColumn.NAME, MoodleColumn.GRADE,
               MoodleColumn.HANDED_IN_AT, MoodleColumn.GRADED_AT]  # fmt: skip
    sheet = tmp_path / "Grades.csv"
    rows = [
        "\t".join(words[one] for one in columns),
        f"Участник3\tЛи Ким\t\t{written}\t-",
        "Участник5\tЛи Ким\t\t-\t-",
    ]
    sheet.write_text("\n".join(rows), encoding="utf-8")
    zipped = [Path(f"a.zip/Ким Ли_{number}_assignsubmission_file/x.xlsx") for number in (3, 5)]
    times = handed_in_times([str(sheet)], zipped, KYIV)
    assert times == {
        str(zipped[0]): HandingTime(datetime(2026, 12, 2, 15, 5, tzinfo=KYIV), said=True)
    }
    hidden, team = (
        Path(f"a.zip/{name}_3_assignsubmission_file/x.xlsx") for name in ("Участник", "Бригада 7")
    )
    assert list(handed_in_times([str(sheet)], [hidden, team], KYIV)) == [str(hidden)]
    with pytest.raises(UsageError, match="No file of the batch has the number"):
        handed_in_times([str(sheet)], [Path("3.xlsx"), team], KYIV)


class TestDoubtfulTimes:
    """The deadline is half past three of the night in which clocks are set back at four."""

    @pytest.fixture
    def night(self, office: Office, monkeypatch: pytest.MonkeyPatch) -> Office:
        deadline = datetime(2026, 10, 25, 0, 30, tzinfo=UTC)
        monkeypatch.setattr(
            "gripcourse.usecases.marks.gradebook.course_deadlines",
            lambda *_: (Deadline("", "", deadline),),
        )
        office.files = [office.files[0]]
        return office

    def said(self, night: Office, written: str) -> tuple[Report, HandingTime]:
        (file,) = night.files
        alone = grade_file(file, night.context)
        part = Path(f"a.zip/Иванова Анна_3_assignsubmission_file/{file.name}")
        sheet = Path(night.place).with_name("Grades.csv")
        words = HEADINGS["ru"]
        columns = [MoodleColumn.IDENTIFIER, MoodleColumn.NAME, MoodleColumn.GRADE,
                   MoodleColumn.HANDED_IN_AT, MoodleColumn.GRADED_AT]  # fmt: skip
        heading = "\t".join(words[one] for one in columns)
        row = f"Участник3\tИванова Анна\t\t{written}\t-"
        sheet.write_text(f"{heading}\n{row}\n", encoding="utf-8")
        times = handed_in_times([str(sheet)], [part], KYIV)
        graded = [Graded(replace(alone, file=str(part)), "")]
        (kept,) = keep(graded, night.context, night.place, NOW, times)
        return kept.report, times[str(part)]

    def test_the_earlier_moment_counts_and_the_work_is_flagged(self, night: Office) -> None:
        report, time = self.said(night, "воскресенье, 25 октября 2026, 03:15")
        assert time.at == datetime(2026, 10, 25, 0, 15, tzinfo=UTC)
        assert report.timing is not None
        assert report.timing.days_late == 0
        (flag,) = report.flags
        assert flag.code is FlagCode.TIME_DOUBTFUL
        assert str(flag.message) == (
            "Clocks show 2026-10-25 03:15 twice: they are set back. The work was handed in then:"
            " days late by the earlier moment 0, by the later one 1. The earlier one counts until"
            " somebody says when it was handed in."
            " Write 2026-10-25 03:15+03:00 or 2026-10-25 03:15+02:00."
        )

    @pytest.mark.parametrize("clock", ["03:45", "02:59", "04:00"])
    def test_where_lateness_is_the_same_nothing_is_said(self, night: Office, clock: str) -> None:
        report, _ = self.said(night, f"воскресенье, 25 октября 2026, {clock}")
        assert report.flags == ()

    def test_an_hour_that_clocks_skip_means_the_earlier_moment(self, night: Office) -> None:
        _, time = self.said(night, "воскресенье, 29 марта 2026, 03:30")
        assert time.at == datetime(2026, 3, 29, 0, 30, tzinfo=UTC)
        assert time.later == datetime(2026, 3, 29, 1, 30, tzinfo=UTC)


def test_where_a_rule_says_which_of_several_works_counts_nobody_is_asked(office: Office) -> None:
    reports = office.grade()
    assert [one.flags for one in reports] == [(), ()]
    assert [report_result(one, Words("en")).counts for one in reports] == [False, True]


def test_without_a_rule_nothing_is_said_of_time(office: Office) -> None:
    office.context = replace(
        office.context, policy=replace(office.context.policy, late=None, attempts=None)
    )
    assert office.timings() == []
    reports = office.grade()
    assert {flag.code for one in reports for flag in one.flags} == {FlagCode.SEVERAL_FILES}
    assert [report_result(one, Words("en")).counts for one in reports] == [None, None]
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
