"""Marks by hand from entering to the reports: never overwritten, flagged when to look again."""

import json
from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, date, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.errors import GradebookError, GripcourseError, NextStep, UsageError
from gripcourse.gradebook.enter import Draft
from gripcourse.grading.model import Finding, Outcome, Report
from gripcourse.usecases.grading.grade import GradingOutcome as Batch
from gripcourse.usecases.grading.grade import write_results
from gripcourse.usecases.marks import gradebook
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.mark import (
    Marking,
    enter_mark,
    enter_table,
    existing_gradebook,
    what_waits,
)
from support.classroom import forget_one_jaw
from support.pages import no_pages

if TYPE_CHECKING:
    from support.classroom import Classroom

NOW = datetime(2026, 12, 2, 9, tzinfo=UTC)
DRAWING, DIAGRAM = "general_view_drawing", "kinematic_diagram"
LINES = {"sizes": 1.0, "assembly": 0.5, "standards": 0.0}
SHARE = 0.4 + 0.3 * 0.5


def nothing(_: Path) -> None:
    """Show no progress."""


class Office:
    """A gradebook and files that are graded into it, as often as a test wants."""

    def __init__(self, classroom: "Classroom", folder: Path) -> None:
        self.classroom, self.folder = classroom, folder
        self.place = str(folder / "gradebook.sqlite")
        self.context = classroom.context

    def keep(self, files: Sequence[Path], **changes: object) -> tuple[Graded, ...]:
        context = replace(self.context, **changes)  # type: ignore[arg-type]
        # In this process: other tests grade in processes of their own.
        return keep(
            [Graded(grade_file(one, context), "") for one in files], context, self.place, NOW
        )

    def grade(self, files: Sequence[Path], **changes: object) -> dict[str, Report]:
        """Grade files and let the marks enter, as the command does; the reports by student."""
        return {one.report.student: one.report for one in self.keep(files, **changes)}

    def write(self, files: Sequence[Path], out: Path) -> Batch:
        return write_results(self.keep(files), self.context, out, date(2026, 12, 2), 0, nothing)

    def mark(self, quantity: str = DRAWING, student: str = "s01", **draft: object) -> Marking:
        wanted = Draft(student, quantity, **{"lines": {}, **draft})  # type: ignore[arg-type]
        return enter_mark(wanted, self.context, self.place, "Петров", NOW + timedelta(hours=1))

    def table(self, text: str) -> Marking:
        path = self.folder / "marks.csv"
        path.write_text(text, encoding="utf-8")
        return enter_table(path, self.context, self.place, "Петров", NOW + timedelta(hours=1))

    @property
    def kept(self) -> list[tuple[str, str, int]]:
        entries = existing_gradebook(self.place).entries()
        return [(one.mark.student, one.mark.quantity, one.mark.number) for one in entries]


def item(report: Report, quantity: str) -> Finding:
    return next(one for one in report.findings if one.quantity == quantity)


def said(error: GripcourseError) -> list[tuple[str, str]]:
    return [(str(problem.key), str(problem.what)) for problem in error.problems]


@pytest.fixture(scope="module")
def files(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """A right workbook and one with an early slip."""
    folder = tmp_path_factory.mktemp("inbox")
    return [
        issued.hand_in("s01", correct, folder / "s01.xlsx"),
        issued.hand_in("s02", forget_one_jaw, folder / "s02.xlsx"),
    ]


@pytest.fixture
def office(issued: "Classroom", files: list[Path], tmp_path: Path) -> Office:
    """Both files are graded, nothing is marked."""
    office = Office(issued, tmp_path)
    office.grade(files)
    return office


class TestAMarkedDrawing:
    def test_it_waits_marked_it_counts(self, office: Office, files: list[Path]) -> None:
        before = office.grade(files)["s01"]
        assert item(before, DRAWING).is_open
        (entered,) = office.mark(lines=LINES).items
        possible = item(before, DRAWING).max_points
        assert entered.points == pytest.approx(SHARE * possible)
        after = office.grade(files)["s01"]
        assert after.score == pytest.approx(before.score + SHARE * possible)
        assert after.max_score == pytest.approx(before.max_score + possible)
        assert after.open_points == pytest.approx(before.open_points - possible)
        assert after.flags == before.flags

    def test_grading_again_never_overwrites_it(self, office: Office, files: list[Path]) -> None:
        office.mark(lines=LINES)
        first = office.grade(files)
        assert office.grade(files) == first
        assert office.kept == [("s01", DRAWING, 1)]
        assert len(existing_gradebook(office.place).attempts()) == 2

    def test_another_file_is_flagged_and_the_mark_still_counts(
        self, office: Office, issued: "Classroom", tmp_path: Path
    ) -> None:
        office.mark(lines=LINES)
        new = issued.hand_in("s01", forget_one_jaw, tmp_path / "new" / "s01.xlsx")
        report = office.grade([new])["s01"]
        assert [flag.code for flag in report.flags] == ["mark_outdated"]
        assert item(report, DRAWING).points == pytest.approx(
            SHARE * item(report, DRAWING).max_points
        )
        office.mark(lines=LINES)
        assert office.grade([new])["s01"].flags == ()
        assert office.kept == [("s01", DRAWING, 1), ("s01", DRAWING, 2)]

    def test_a_policy_that_changes_other_results_outdates_it_not(
        self, office: Office, files: list[Path]
    ) -> None:
        office.mark(student="s02", lines=LINES)
        stricter = replace(office.context.policy, carried_credit=0.5)
        assert office.grade(files, policy=stricter)["s02"].flags == ()

    def test_it_stands_in_the_results_of_the_batch(
        self, office: Office, files: list[Path], tmp_path: Path
    ) -> None:
        office.mark(lines=LINES, comment="Нет масштаба")
        with no_pages():
            batch = office.write(files, tmp_path / "graded")
        assert not batch.needs_person
        written = json.loads((tmp_path / "graded" / "grades.json").read_text(encoding="utf-8"))
        first = next(one for one in written["reports"] if one["student"] == "s01")
        decision = next(one for one in first["findings"] if one["quantity"] == DRAWING)["decision"]
        assert decision["lines"] == LINES
        assert decision["comment"] == "Нет масштаба"
        assert decision["marker"] == "Петров"
        assert decision["outdated"] is False
        others = [one["decision"] for one in first["findings"] if one["quantity"] != DRAWING]
        assert set(others) == {None}
        assert not (tmp_path / "graded" / "incidents.log").exists()


class TestDecisions:
    def test_an_overruled_answer_counts_as_the_person_says(
        self, office: Office, files: list[Path]
    ) -> None:
        before = item(office.grade(files)["s02"], "grip_force")
        office.mark("grip_force", "s02", credit=0.5, override=True, comment="описка в условии")
        after = item(office.grade(files)["s02"], "grip_force")
        assert before.outcome is not Outcome.MANUAL
        assert after.points == pytest.approx(0.5 * before.max_points)
        assert after.decision is not None
        assert after.decision.automatic is before.outcome

    def test_withdrawn_it_counts_no_longer_and_is_not_forgotten(
        self, office: Office, files: list[Path]
    ) -> None:
        before = office.grade(files)
        office.mark("grip_force", "s02", credit=0.5, override=True, comment="описка в условии")
        (taken,) = office.mark("grip_force", "s02", withdraw=True, comment="не описка").items
        assert taken.points is None
        assert office.grade(files) == before
        assert len(office.kept) == 2


class TestTheTable:
    TABLE = (
        "student;quantity;sizes;assembly;standards;symbols;scale;letters\n"
        f"s01;{DRAWING};1;0,5;0;;;\n"
        f"s01;{DIAGRAM};;;;1;1;0,5\n"
        f"s02;{DRAWING};0;0;0;;;\n"
        f"s02;{DIAGRAM};;;;;;\n"
    )

    def test_every_row_is_a_mark(self, office: Office, files: list[Path]) -> None:
        marking = office.table(self.TABLE)
        assert (len(marking.items), marking.empty) == (3, 1)
        report = office.grade(files)["s01"]
        assert report.open_points == 0
        drawing = item(report, DRAWING)
        assert drawing.points == pytest.approx(SHARE * drawing.max_points)
        assert [one.quantity for one in what_waits(office.place)] == [DIAGRAM]

    def test_the_same_table_again_enters_nothing(self, office: Office) -> None:
        office.table(self.TABLE)
        again = office.table(self.TABLE)
        assert (again.items, again.unchanged) == ((), 3)

    def test_all_problems_come_at_once_and_nothing_is_half_written(self, office: Office) -> None:
        wrong = (
            "student;quantity;sizes;assembly;standards;symbols\n"
            f"s01;{DRAWING};1;0,5;0;\n"
            f"s1;{DRAWING};1;1;1;\n"
            f"s03;{DRAWING};1;1;1;\n"
            f"s02;{DRAWING};1;1,5;1;1\n"
            "s02;drive_force;1;;;\n"
        )
        with pytest.raises(UsageError) as caught:
            office.table(wrong)
        assert said(caught.value)[:4] == [
            ("row 3, column student", "The register has no student 's1'."),
            ("row 4, column student", "No file of s03 has been graded yet."),
            ("row 5, column assembly", "The share is 1.5."),
            ("row 5, column symbols", "The rubric has no line 'symbols'."),
        ]
        assert said(caught.value)[4][0] == "row 6, column quantity"
        assert office.kept == []


class TestFaults:
    def test_what_is_wrong_is_named_by_its_field(self, office: Office) -> None:
        with pytest.raises(UsageError) as caught:
            office.mark(lines={**LINES, "sizes": 2.0}, points=99.0)
        assert [one.parameter for one in caught.value.problems] == ["points", "lines"]
        with pytest.raises(UsageError) as caught:
            office.mark("drawing", points=1.0)
        (problem,) = caught.value.problems
        assert problem.parameter == "quantity"
        assert DRAWING in str(problem.remedy)
        assert DIAGRAM in str(problem.remedy)
        assert office.kept == []

    def test_without_a_gradebook_the_remedy_is_to_grade(
        self, issued: "Classroom", tmp_path: Path
    ) -> None:
        nowhere = str(tmp_path / "gradebook.sqlite")
        with pytest.raises(GradebookError) as caught:
            what_waits(nowhere)
        assert caught.value.problems[0].step is NextStep.GRADE
        with pytest.raises(GradebookError):
            enter_mark(Draft("s01", DRAWING, LINES), issued.context, nowhere, "Петров", NOW)
        assert list(tmp_path.iterdir()) == []


def test_nobodys_file_makes_no_gradebook(issued: "Classroom", tmp_path: Path) -> None:
    stranger = tmp_path / "x.xlsx"
    stranger.write_bytes(b"")
    office = Office(issued, tmp_path)
    (report,) = office.grade([stranger]).values()
    assert not report.judged
    assert not Path(office.place).exists()


def test_what_somebody_else_keeps_meanwhile_is_found_there(
    office: Office, files: list[Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two batches of the same works at once: the second has read the gradebook before the first."""
    graded = [Graded(grade_file(one, office.context), "") for one in files]
    place, read = str(tmp_path / "both.sqlite"), gradebook._known  # noqa: SLF001 (the moment between)

    def overtaken(*asked: Any) -> Any:  # noqa: ANN401 (as it is)
        monkeypatch.setattr(gradebook, "_known", read)
        found = read(*asked)
        keep(graded, office.context, place, NOW)
        return found

    monkeypatch.setattr(gradebook, "_known", overtaken)
    kept = keep(graded, office.context, place, NOW)
    assert [one.report.findings for one in kept] == [one.report.findings for one in graded]
    assert len(existing_gradebook(place).attempts({"s01", "s02"})) == len(graded)
