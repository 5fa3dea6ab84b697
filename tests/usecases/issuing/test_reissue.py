"""What was issued is corrected without fear: nobody's work is judged by numbers it never had."""

import sqlite3
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass, replace
from datetime import UTC, date, datetime
from pathlib import Path

import pytest
from openpyxl import load_workbook

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.batch.run import compared
from gripcourse.cli.demo.students import correct
from gripcourse.documents.assignment_sheet import sheet_values
from gripcourse.errors import GradebookError, GripcourseError, UsageError
from gripcourse.gradebook.store import open_gradebook
from gripcourse.grading.model import Report
from gripcourse.issuing.reissue import Correction
from gripcourse.issuing.store import read_register
from gripcourse.machine.database.home import gradebook_path
from gripcourse.policy.model import Policy
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.usecases.issuing.handout import workbook_path
from gripcourse.usecases.issuing.issue import Issuing
from gripcourse.usecases.issuing.reissue import CorrectedOrder, reissue_order
from gripcourse.usecases.marks.gradebook import keep, with_kept_versions
from gripcourse.usecases.marks.opening import grading_of
from gripcourse.usecases.marks.regrade import regrade
from gripcourse.variants.table import write_table
from gripcourse.workbook.cover import variant_text
from support.classroom import Classroom, open_classroom, table

NOW = datetime(2026, 12, 2, 9, tzinfo=UTC)
TODAY = date(2026, 10, 5)


def order(classroom: Classroom, *students: str, variant: str = "") -> CorrectedOrder:
    wanted = Correction(students, variant, "опечатка в таблице", "Петров")
    out = classroom.order.out.with_name("corrected")
    return CorrectedOrder(wanted, classroom.order.table, out, TODAY, None)


def corrected(
    classroom: Classroom, wanted: CorrectedOrder, on_counted: Callable[[int], None] = lambda _: None
) -> Issuing:
    return reissue_order(
        classroom.course, classroom.policy, wanted, 0, lambda _: None, on_counted=on_counted
    )


def correct_the_row(classroom: Classroom) -> None:
    """Variant 001 has a mass of 60 kg in the table; 58.5 were meant."""
    first, *rest = table(classroom.course)
    assert (first.id, first.given["mass"]) == ("001", 60)
    meant = replace(first, given={**first.given, "mass": 58.5})
    write_table(Path(str(classroom.order.table)), [meant, *rest], classroom.course)


@dataclass(frozen=True, slots=True)
class Term:
    """A student who worked on the first version, and the same one on the second."""

    classroom: Classroom
    said_by_issue: Issuing
    issuing: Issuing
    on_first: Path
    on_second: Path

    @property
    def context(self) -> GradingContext:
        return grading_of(self.classroom.course, self.classroom.policy)

    def workbook(self, version: int) -> Path:
        out = self.classroom.order.out
        return workbook_path(out if version == 1 else out.with_name("corrected"), "s01")

    def judged(self, file: Path, *, either: bool | None = None) -> Report:
        return grade_file(file, replace(self.context, either_version=either))


@pytest.fixture(scope="module")
def term(tmp_path_factory: pytest.TempPathFactory, policy: Policy) -> Term:
    folder = tmp_path_factory.mktemp("corrected")
    classroom = open_classroom(folder, policy)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            "gripcourse.usecases.issuing.handout.assignment_sheet", lambda *_: b"%PDF-1.7\n"
        )
        classroom.issue()
        on_first = classroom.hand_in("s01", correct, folder / "early.xlsx")
        correct_the_row(classroom)
        said = classroom.issue()
        issuing = corrected(classroom, order(classroom, "s01"))
    second = replace(classroom, order=replace(classroom.order, out=folder / "corrected"))
    on_second = second.hand_in("s01", correct, folder / "late.xlsx")
    return Term(classroom, said, issuing, on_first, on_second)


class TestDocuments:
    def test_issue_names_the_students_who_keep_numbers_that_the_table_has_no_longer(
        self, term: Term
    ) -> None:
        assert term.said_by_issue.outdated == ("s01",)

    def test_the_instructor_reads_what_changed(self, term: Term) -> None:
        (note,) = term.issuing.notes
        assert [Words(one).say(note).split(". ")[1] for one in LANGUAGES] == [
            "mass of the object: 60 kg → 58.5 kg.",
            "масса объекта: 60 кг → 58,5 кг.",
            "маса об’єкта: 60 кг → 58,5 кг.",
        ]

    def test_a_workbook_is_signed_for_its_version(self, term: Term) -> None:
        entries = read_register(term.classroom.course.root, term.classroom.course.id).versions()
        for entry in entries["s01"]:
            raw = read_workbook(term.workbook(entry.version))
            assert isinstance(raw, RawWorkbook)
            assert raw.identity.signature == entry.signature
            assert raw.givens["mass"].value == entry.variant.given["mass"]

    @pytest.mark.parametrize(
        ("language", "said"),
        [("en", "001, version 2"), ("ru", "001, версия 2"), ("uk", "001, версія 2")],
    )
    def test_a_version_after_the_first_is_named_with_its_variant(
        self, term: Term, language: str, said: str
    ) -> None:
        entry = term.classroom.register["s01"]
        assert variant_text(entry, Words(language)) == said
        assert variant_text(replace(entry, version=1), Words(language)) == "001"

    def test_sheet_and_workbook_say_which_version_they_are(self, term: Term) -> None:
        room = term.classroom
        said = sheet_values(
            room.register["s01"], room.plan("s01"), room.policy, room.course, Words("ru")
        )
        assert said["variant"] == "001, версия 2"
        cover = load_workbook(term.workbook(2)).worksheets[0]
        assert said["variant"] in {cell.value for row in cover.iter_rows() for cell in row}


class TestGrading:
    def test_a_work_is_judged_by_the_version_that_its_workbook_was_made_for(
        self, term: Term
    ) -> None:
        for file, version in ((term.on_first, 1), (term.on_second, 2)):
            report = term.judged(file)
            assert (report.student, report.version) == ("s01", version)
            assert report.score == report.max_score
            assert not {"signature", "givens_changed", "who_handed_in"} & {
                one.code.value for one in report.flags
            }
            assert f"version {version}" in str(report.remarks[0])

    def test_so_it_is_where_a_person_says_whose_it_is(self, term: Term) -> None:
        context = replace(term.context, whose={str(term.on_first): "s01"})
        report = grade_file(term.on_first, context)
        assert report.version == 1
        assert report.score == report.max_score

    def test_by_the_other_version_it_would_have_cost(self, term: Term) -> None:
        """Else the tests above would show nothing."""
        blind = replace(term.context, earlier={})
        whose = {str(term.on_first): "s01"}
        report = grade_file(term.on_first, replace(blind, whose=whose))
        assert report.score < report.max_score

    def test_numbers_of_an_earlier_version_are_nobody_elses(self, term: Term) -> None:
        (alone,) = compared([Graded(term.judged(term.on_first), "")], term.context)
        assert {one.code for one in alone.report.flags} == {
            one.code for one in term.judged(term.on_first).flags
        }
        assert not alone.incident

    def test_either_version_counts_the_better_one_and_says_so(self, term: Term) -> None:
        own, both = (term.judged(term.on_first, either=either) for either in (False, True))
        assert (both.version, both.score, both.flags) == (1, own.score, own.flags)
        assert both.either_version
        assert not own.either_version
        assert "version 1 counts" in str(both.remarks[0])
        copied = term.classroom.course.root.parent / "copied.xlsx"
        typed_for_second(term, copied)
        assert term.judged(copied).score < term.judged(copied, either=True).score
        assert term.judged(copied, either=True).version == 2


def typed_for_second(term: Term, target: Path) -> None:
    """Right answers of the second version, typed into the workbook of the first."""
    term.classroom.hand_in("s01", correct, target)


class TestGradebook:
    def test_which_version_counts_is_kept_and_a_regrade_keeps_to_it(
        self, term: Term, tmp_path: Path
    ) -> None:
        file, place = tmp_path / "copied.xlsx", str(tmp_path / "gradebook.sqlite")
        typed_for_second(term, file)
        report = term.judged(file, either=True)
        keep([Graded(report, "")], term.context, place, NOW)
        (attempt,) = open_gradebook(place).attempts()
        assert (attempt.version, attempt.either_version) == (2, True)
        assert regrade([file], term.context, place, 0, NOW).to_apply == ()
        again = grade_file(file, with_kept_versions(term.context, place))
        assert (again.version, again.score) == (2, report.score)
        taken_back = replace(term.context, either_version=False)
        (change,) = regrade([file], taken_back, place, 0, NOW).to_apply
        assert change.after.score < change.before.score


class TestRefusals:
    @pytest.mark.parametrize(
        ("students", "variant", "why"),
        [
            (("nobody",), "", "опечатка"),
            (("s01",), "005", ""),
            (("s01",), "", "опечатка"),
            (("s01",), "007", "опечатка"),
            (("s01",), "777", "опечатка"),
        ],
        ids=["unknown student", "no reason", "nothing new", "another's variant", "no variant"],
    )
    def test_what_cannot_be_done_writes_nothing(
        self, term: Term, students: tuple[str, ...], variant: str, why: str, tmp_path: Path
    ) -> None:
        root, id_ = term.classroom.course.root, term.classroom.course.id
        before = read_register(root, id_)
        wanted = order(term.classroom, *students, variant=variant)
        wanted = replace(
            wanted, correction=replace(wanted.correction, why=why), out=tmp_path / "out"
        )
        begun: list[int] = []
        with pytest.raises(UsageError):
            corrected(term.classroom, wanted, begun.append)
        assert begun == []
        assert read_register(root, id_) == before
        assert not (tmp_path / "out").exists()

    def test_before_anything_was_issued_there_is_nothing_to_correct(
        self, classroom: Classroom
    ) -> None:
        with pytest.raises(GripcourseError) as caught:
            corrected(classroom, order(classroom, "s01"))
        assert caught.value.problems[0].remedy
        assert not gradebook_path(classroom.course.root).exists()

    def test_a_register_that_another_program_keeps_locked_is_said_to_be_locked(
        self, term: Term, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr("gripcourse.machine.database.opening._SECONDS_TO_WAIT", 0.01)
        file = gradebook_path(term.classroom.course.root)
        wanted = order(term.classroom, "s01", variant="005")
        with closing(sqlite3.connect(file, isolation_level=None)) as other:
            other.execute("BEGIN IMMEDIATE")
            with pytest.raises(GradebookError) as caught:
                corrected(term.classroom, wanted)
            other.execute("ROLLBACK")
        (problem,) = caught.value.problems
        assert "Another program" in str(problem.what)
