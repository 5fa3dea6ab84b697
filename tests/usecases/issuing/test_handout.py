"""Every student gets a folder; a document that fails is named and the others go on."""

import hashlib
import pickle
from collections.abc import Callable
from datetime import date
from functools import partial
from pathlib import Path

import openpyxl
import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.errors import CourseError, Problem
from gripcourse.issuing.allotment import Terms, extend
from gripcourse.issuing.register import Register
from gripcourse.issuing.roster import read_roster
from gripcourse.policy.load import load_policy
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import message
from gripcourse.usecases.issuing import handout as module
from gripcourse.usecases.issuing.handout import Handout, IssuingContext, issue, issue_one
from gripcourse.variants.model import Issued
from gripcourse.variants.table import read_table

# Its sheets are laid out and its works solved in less time than those of the reference course.
ROOT = Path(__file__).parents[3] / "examples" / "belt_drive"
TERMS = Terms(bytes(range(32)), date(2026, 9, 1), date(2026, 12, 1))


@pytest.fixture(scope="module")
def course() -> Course:
    return load_course(ROOT)


@pytest.fixture(scope="module")
def entries(course: Course) -> tuple[Issued, ...]:
    """What the first three students of the reference roster are issued."""
    students = read_roster(ROOT / "variants" / "roster.csv").students[:3]
    variants = read_table(ROOT / "variants" / "tables" / "main.csv", course)
    return extend(Register(course.id, ()), students, variants, TERMS).register.entries


@pytest.fixture
def context(course: Course, tmp_path: Path) -> IssuingContext:
    return IssuingContext(course, load_policy(course), partial(plan_of, course), tmp_path / "out")


@pytest.fixture
def quick_sheets(monkeypatch: pytest.MonkeyPatch) -> None:
    """Sheets that need no layout: these tests are about files."""
    monkeypatch.setattr(module, "assignment_sheet", lambda *_: b"%PDF-quick")


def fail_for(student: str, fault: Exception) -> Callable[..., bytes]:
    def sheet(entry: Issued, *_: object) -> bytes:
        if entry.student.id == student:
            raise fault
        return b"%PDF-quick"

    return sheet


@pytest.mark.usefixtures("quick_sheets")
def test_every_student_gets_a_folder_with_sheet_and_workbook(
    context: IssuingContext, entries: tuple[Issued, ...]
) -> None:
    handouts = issue(context, entries)
    assert [handout.faults for handout in handouts] == [(), (), ()]
    for entry in entries:
        name = entry.student.id
        folder = context.out / name
        assert {path.name for path in folder.iterdir()} == {
            f"assignment_{name}.pdf",
            f"{name}.xlsx",
        }


def test_the_sheet_is_a_pdf_and_the_workbook_opens(
    context: IssuingContext, entries: tuple[Issued, ...]
) -> None:
    sheet, workbook = issue_one(context, entries[0]).files
    assert sheet.read_bytes().startswith(b"%PDF-")
    assert openpyxl.load_workbook(workbook).sheetnames


@pytest.mark.usefixtures("quick_sheets")
def test_progress_is_told_after_each_student(
    context: IssuingContext, entries: tuple[Issued, ...]
) -> None:
    told: list[str] = []

    def note(handout: Handout) -> None:
        told.append(handout.student)

    issue(context, entries, note)
    assert told == [entry.student.id for entry in entries]


@pytest.mark.usefixtures("quick_sheets")
def test_issuing_again_writes_the_same_files(
    context: IssuingContext, entries: tuple[Issued, ...]
) -> None:
    def digests() -> list[str]:
        files = [path for handout in issue(context, entries) for path in handout.files]
        return [hashlib.sha256(path.read_bytes()).hexdigest() for path in files]

    assert digests() == digests()


def test_a_failing_document_is_named_and_the_others_are_written(
    context: IssuingContext, entries: tuple[Issued, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = entries[1].student.id
    monkeypatch.setattr(module, "assignment_sheet", fail_for(broken, ZeroDivisionError("by zero")))
    first, second, third = issue(context, entries)
    assert len(first.files) == len(third.files) == 2
    assert [path.name for path in second.files] == [f"{broken}.xlsx"]
    (fault,) = second.faults
    assert str(fault) == (
        f"assignment_{broken}.pdf of {broken} was not written: ZeroDivisionError: by zero."
    )


def test_a_fault_of_the_course_is_told_with_its_remedy(
    context: IssuingContext, entries: tuple[Issued, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = entries[0].student.id
    problem = Problem("x", "", message("The template is missing."), message("Restore it."))
    monkeypatch.setattr(module, "assignment_sheet", fail_for(broken, CourseError([problem])))
    (fault,) = issue_one(context, entries[0]).faults
    assert "The template is missing. Restore it." in str(fault)


def test_an_old_document_stays_when_the_new_one_fails(
    context: IssuingContext, entries: tuple[Issued, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    name = entries[0].student.id
    old = context.out / name / f"assignment_{name}.pdf"
    old.parent.mkdir(parents=True)
    old.write_bytes(b"old")
    monkeypatch.setattr(module, "assignment_sheet", fail_for(name, OSError("disk is full")))
    issue_one(context, entries[0])
    assert old.read_bytes() == b"old"


def test_a_variant_that_cannot_be_solved_is_not_handed_out(
    context: IssuingContext, entries: tuple[Issued, ...]
) -> None:
    entry = entries[0]
    given = {**entry.variant.given, "motor_speed": 0.0}
    variant = type(entry.variant)(
        entry.variant.id, entry.variant.scheme, entry.variant.options, given
    )
    broken = type(entry)(entry.student, variant, entry.issued_on, None, entry.signature)
    handout = issue_one(context, broken)
    assert handout.files == ()
    assert handout.faults
    assert not context.out.exists()


def test_a_handout_can_be_sent_between_processes(
    context: IssuingContext, entries: tuple[Issued, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = entries[0].student.id
    monkeypatch.setattr(module, "assignment_sheet", fail_for(broken, OSError("disk is full")))
    handout = issue_one(context, entries[0])
    assert pickle.loads(pickle.dumps(handout)) == handout  # noqa: S301 - made a line above
