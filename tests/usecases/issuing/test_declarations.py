"""Works on a corrected version are judged by the formulas that it was issued with."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path
from shutil import copytree

import pytest

from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.course.load import load_course
from gripcourse.grading.model import Report
from gripcourse.issuing.reissue import Correction
from gripcourse.issuing.store import read_register
from gripcourse.policy.model import Policy
from gripcourse.simulation.write import fill
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Message
from gripcourse.usecases.issuing.reissue import CorrectedOrder, reissue_order
from gripcourse.usecases.marks.opening import open_grading
from support.classroom import Classroom, open_classroom

ROSTER = "student,name,language\ns01,Иванова Анна,ru\n"
GRAVITY = "value = 9.81"


@dataclass(frozen=True, slots=True)
class Mended:
    """A course whose gravity was corrected after a student had worked with the other one."""

    classroom: Classroom
    work: Path
    notes: Sequence[Message]

    def judged(self, *, either: bool | None = None) -> Report:
        context = open_grading(self.classroom.course.root)
        return grade_file(self.work, replace(context, either_version=either))

    @property
    def kept(self) -> list[Path]:
        return sorted((self.classroom.course.root / "private" / "declarations").iterdir())


@pytest.fixture(scope="module")
def mended(tmp_path_factory: pytest.TempPathFactory, policy: Policy) -> Mended:
    folder = tmp_path_factory.mktemp("mended")
    classroom = open_classroom(folder, policy, ROSTER)
    file = classroom.course.root / "variants" / "course.toml"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            "gripcourse.usecases.issuing.handout.assignment_sheet", lambda *_: b"%PDF-1.7\n"
        )
        classroom.issue()
        work = classroom.hand_in("s01", correct, folder / "early.xlsx")
        text = file.read_text(encoding="utf-8")
        assert text.count(GRAVITY) == 1
        file.write_text(text.replace(GRAVITY, "value = 9.2"), encoding="utf-8")
        wanted = Correction(("s01",), "", "g was wrong", "Петров")
        order = CorrectedOrder(
            wanted, classroom.order.table, folder / "corrected", date(2026, 10, 5), None
        )
        course = load_course(classroom.course.root)
        issuing = reissue_order(course, policy, order, 0, lambda _: None)
    return Mended(classroom, work, issuing.notes)


def test_a_work_is_judged_by_the_declarations_that_its_version_was_issued_with(
    mended: Mended,
) -> None:
    report = mended.judged()
    course = mended.classroom.course
    first, _ = read_register(course.root, course.id).versions()["s01"]
    assert report.score == report.max_score
    assert report.declarations == first.declarations
    assert "that this version was issued with" in " ".join(map(str, report.remarks))
    assert [path.stem for path in mended.kept].count(first.declarations) == 1


def test_what_is_declared_otherwise_since_is_named(mended: Mended) -> None:
    gravity = mended.classroom.course.constants["gravity"].title.of("en")
    (said,) = map(str, mended.notes)
    assert said.endswith(f"with the same numbers. Declared otherwise since: {gravity}.")


def test_where_either_version_counts_each_is_judged_by_its_own(mended: Mended) -> None:
    report = mended.judged(either=True)
    assert (report.version, report.score) == (1, report.max_score)
    assert "not counted: 2" in " ".join(map(str, report.remarks))


@pytest.mark.parametrize("damage", [b"", b"PK"])
def test_where_they_were_lost_today_s_are_taken_and_it_is_said(
    mended: Mended, damage: bytes
) -> None:
    before = {path: path.read_bytes() for path in mended.kept}
    for path in mended.kept:
        path.write_bytes(damage)
    report = mended.judged()
    for path, content in before.items():
        path.write_bytes(content)
    assert report.score < report.max_score
    assert report.declarations == ""
    assert "judged by today's" in " ".join(map(str, report.remarks))


def test_where_either_counts_a_version_is_judged_by_todays_formulas_as_well(
    mended: Mended, tmp_path: Path
) -> None:
    root = tmp_path / "course"
    copytree(mended.classroom.course.root, root)
    course, policy = load_course(root), mended.classroom.policy
    wanted = Correction(("s01",), "007", "another row", "Петров")
    order = CorrectedOrder(wanted, mended.classroom.order.table, tmp_path / "third",
                           date(2026, 10, 6), None)  # fmt: skip
    reissue_order(course, policy, order, 0, lambda _: None)
    first, *_ = read_register(root, course.id).versions()["s01"]
    typed = correct(plan_of(course, first.variant.composition), first)
    assert typed is not None
    work = tmp_path / "by_the_right_formula.xlsx"
    fill(mended.classroom.workbook("s01"), typed, work)
    context = open_grading(root)
    own = grade_file(work, replace(context, either_version=False))
    assert own.score < own.max_score
    both = grade_file(work, replace(context, either_version=True))
    assert (both.version, both.score, both.declarations) == (1, both.max_score, "")
    said = " ".join(map(str, both.remarks))
    assert "are today's, which give more" in said
    assert "today's" not in " ".join(map(str, mended.judged(either=True).remarks))
