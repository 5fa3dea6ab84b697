"""Issuing: a folder per student, once and for good."""

import stat
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.errors import GripcourseError, RegisterError, TableError
from gripcourse.issuing.register_file import old_register_path
from gripcourse.issuing.signature import key_path, verify
from gripcourse.machine.database.home import gradebook_path
from gripcourse.policy.model import Policy
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook
from gripcourse.usecases.issuing.handout import Handout, IssuingContext
from gripcourse.usecases.issuing.issue import issue_order
from gripcourse.variants.model import Issued
from support.classroom import ROSTER, Classroom, open_classroom
from support.pages import not_laid_out

STUDENTS = ("s01", "s02", "s03")


def contents(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def nothing_made(_context: IssuingContext, entry: Issued) -> Handout:
    return Handout(entry.student.id, (), ())


ONE = ROSTER.partition("s02,")[0]


@pytest.fixture(scope="module")
def complete(tmp_path_factory: pytest.TempPathFactory, policy: Policy) -> Classroom:
    """One student, whose sheet is made too; nobody may change this course."""
    classroom = open_classroom(tmp_path_factory.mktemp("complete"), policy, ONE)
    with not_laid_out():
        classroom.issue()
    return classroom


class TestDocuments:
    def test_every_student_gets_a_folder_with_a_sheet_and_a_workbook(
        self, issued: Classroom
    ) -> None:
        expected = {f"{one}/assignment_{one}.pdf" for one in STUDENTS}
        expected |= {f"{one}/{one}.xlsx" for one in STUDENTS}
        assert set(contents(issued.order.out)) == expected

    def test_how_many_there_are_is_told_before_the_first_is_made(
        self, classroom: Classroom
    ) -> None:
        told: list[object] = []
        issue_order(
            classroom.course,
            classroom.policy,
            classroom.order,
            0,
            told.append,
            on_counted=told.append,
            issue_one=nothing_made,
        )
        assert told == [len(STUDENTS), *STUDENTS]

    def test_what_is_handed_out_is_for_its_owner_alone(self, issued: Classroom) -> None:
        written = [issued.order.out, *issued.order.out.rglob("*")]
        assert len(written) == 1 + 3 * 3
        assert [one for one in written if one.stat().st_mode & 0o077] == []

    def test_a_workbook_carries_its_student_the_variant_and_the_signature(
        self, issued: Classroom
    ) -> None:
        for student in STUDENTS:
            raw = read_workbook(issued.workbook(student))
            entry = issued.register[student]
            assert isinstance(raw, RawWorkbook)
            assert raw.identity.student == student
            assert raw.identity.variant == entry.variant.id
            assert raw.identity.signature == entry.signature
            key = bytes(range(32))
            assert verify(key, issued.course.id, student, entry.variant, entry.signature)

    def test_the_roster_may_fix_a_variant(self, issued: Classroom) -> None:
        variants = {name: entry.variant.id for name, entry in issued.register.items()}
        assert variants == {"s01": "001", "s02": "007", "s03": "002"}

    def test_issuing_again_later_gives_the_same_bytes(
        self, complete: Classroom, tmp_path: Path
    ) -> None:
        """The register keeps the day of issue, so that a lost sheet is made again as it was."""
        with not_laid_out():
            again = complete.issue(out=tmp_path, today=complete.order.today.replace(day=30))
        assert [one.student for one in again.handouts] == ["s01"]
        assert len(contents(tmp_path)) == 2
        assert contents(tmp_path) == contents(complete.order.out)

    def test_a_fresh_course_with_the_same_key_and_dates_gives_the_same_bytes(
        self, complete: Classroom, policy: Policy, tmp_path: Path
    ) -> None:
        fresh = open_classroom(tmp_path, policy, ONE)
        with not_laid_out():
            fresh.issue()
        assert contents(fresh.order.out) == contents(complete.order.out)


class TestLaterChanges:
    def test_a_student_added_later_changes_nobody_elses_numbers(
        self, classroom: Classroom, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        without_documents(monkeypatch)
        classroom.issue()
        before = classroom.register
        roster = classroom.order.roster
        head, *rows = roster.read_text(encoding="utf-8").splitlines()
        late = ["a00,Абрамов Пётр,РТК-41,,ru,", *reversed(rows)]
        roster.write_text("\n".join([head, *late]) + "\n", encoding="utf-8")
        classroom.issue()
        after = classroom.register
        assert {name: after[name] for name in before} == before
        assert after["a00"].variant.id not in {one.variant.id for one in before.values()}

    def test_a_changed_table_changes_no_issued_numbers_and_is_said(
        self, classroom: Classroom, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        without_documents(monkeypatch)
        classroom.issue()
        before = classroom.register
        table = classroom.order.table
        rows = table.read_text(encoding="utf-8-sig").splitlines()
        rows[1], rows[2] = rows[2].replace("002,", "001,", 1), rows[1].replace("001,", "002,", 1)
        table.write_text("\n".join(rows) + "\n", encoding="utf-8")
        issuing = classroom.issue()
        assert classroom.register == before
        said = " ".join(str(note) for note in issuing.notes)
        assert "s01" in said
        assert "s03" in said
        assert "s02" not in said

    def test_a_font_that_the_sheets_ask_for_in_vain_is_named_once(
        self, classroom: Classroom, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        without_documents(monkeypatch)
        classroom.issue()
        own = classroom.course.root / "templates" / "style"
        own.mkdir(parents=True, exist_ok=True)
        rule = 'h1 { font-family: "No Such Family" }\n'
        (own / "assignment.css").write_text(rule + rule.replace("h1", "h2"), encoding="utf-8")
        (note,) = classroom.issue().notes
        assert "No Such Family is missing" in str(note)

    def test_another_deadline_is_not_applied_silently(
        self, classroom: Classroom, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        without_documents(monkeypatch)
        classroom.issue()
        issuing = classroom.issue(deadline=None)
        assert {one.deadline for one in classroom.register.values()} == {classroom.order.deadline}
        assert issuing.notes == ()
        issuing = classroom.issue(deadline=classroom.order.deadline.replace(day=24))
        assert len(issuing.notes) == len(STUDENTS)


class TestRefusals:
    def test_nothing_is_written_where_the_roster_is_wrong(self, classroom: Classroom) -> None:
        roster = classroom.order.roster
        text = roster.read_text(encoding="utf-8")
        roster.write_text(text + "s01,Иванов Пётр,РТК-42,,ru,\n", encoding="utf-8")
        refused(classroom, TableError, "s01", "row 5")

    def test_nothing_is_written_where_variants_are_short(self, classroom: Classroom) -> None:
        table = classroom.order.table
        rows = table.read_text(encoding="utf-8-sig").splitlines()
        table.write_text("\n".join([*rows[:2], rows[7]]) + "\n", encoding="utf-8")
        refused(classroom, TableError, "Students who need a variant: 2; variants that are free: 1")

    def test_nothing_is_written_where_a_fixed_variant_is_unknown(
        self, classroom: Classroom
    ) -> None:
        roster = classroom.order.roster
        text = roster.read_text(encoding="utf-8")
        roster.write_text(text.replace(",007", ",777"), encoding="utf-8")
        refused(classroom, TableError, "s02", "777")

    def test_nothing_more_is_issued_when_the_key_was_lost(
        self, classroom: Classroom, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        without_documents(monkeypatch)
        classroom.issue()
        key = key_path(classroom.course.root)
        key.unlink()
        with pytest.raises(RegisterError, match="key"):
            classroom.issue()
        assert not key.exists()

    def test_the_first_issue_makes_a_key_that_only_its_owner_reads(
        self, classroom: Classroom, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        without_documents(monkeypatch)
        key = key_path(classroom.course.root)
        key.unlink()
        (made, *_) = classroom.issue().notes
        assert str(key) in str(made)
        assert stat.S_IMODE(key.stat().st_mode) == 0o600
        assert [note for note in classroom.issue().notes if str(key) in str(note)] == []

    def test_a_damaged_register_is_never_overwritten(self, classroom: Classroom) -> None:
        path = old_register_path(classroom.course.root)
        path.parent.mkdir(exist_ok=True)
        path.write_text('{"format": 1, "issued": [', encoding="utf-8")
        with pytest.raises(RegisterError):
            classroom.issue()
        assert path.read_text(encoding="utf-8") == '{"format": 1, "issued": ['
        assert not classroom.order.out.exists()

    def test_a_table_of_a_wrong_kind_is_named(self, classroom: Classroom) -> None:
        changed = replace(classroom, order=replace(classroom.order, table=classroom.order.roster))
        refused(changed, TableError, "roster.csv")


def refused(classroom: Classroom, kind: type[GripcourseError], *said: str) -> None:
    """Check that issuing is refused, says all of this, and leaves nothing behind."""
    with pytest.raises(kind) as caught:
        classroom.issue()
    assert all(part in str(caught.value) for part in said), str(caught.value)
    assert not classroom.order.out.exists()
    private = gradebook_path(classroom.course.root).parent
    assert {path.name for path in private.iterdir()} <= {"key"}


def without_documents(monkeypatch: pytest.MonkeyPatch) -> None:
    """Issue without laying out documents: these tests are about who gets which numbers."""
    monkeypatch.setattr("gripcourse.usecases.issuing.issue.write_handouts", lambda *_: ())
