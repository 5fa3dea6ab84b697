"""What was handed out to who left, or under a second id, is found, judged and remembered."""

import shutil
from dataclasses import replace
from datetime import UTC, date, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.errors import UsageError
from gripcourse.gradebook.enter import Draft
from gripcourse.grading.model import KnownBy, Outcome, Report
from gripcourse.issuing.reissue import Correction
from gripcourse.issuing.withdrawal import Withdrawal
from gripcourse.machine.database.home import home_of
from gripcourse.usecases.grading.batch_tables import missing, write_tables
from gripcourse.usecases.issuing.handout import Handout, IssuingContext
from gripcourse.usecases.issuing.reissue import CorrectedOrder, reissue_order
from gripcourse.usecases.marks.batch_wish import BatchWish
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.history import history
from gripcourse.usecases.marks.mark import enter_mark, what_waits
from gripcourse.usecases.marks.opening import as_wished, open_grading, register_of
from gripcourse.usecases.marks.regrade import regrade
from gripcourse.usecases.marks.withdraw import withdraw
from gripcourse.usecases.serving.desk import open_books
from gripcourse.usecases.serving.links import make_links, open_link, revoke_links, token_of
from gripcourse.variants.model import Issued
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

NOW = datetime(2026, 12, 2, 9, tzinfo=UTC)


@pytest.fixture
def root(issued: "Classroom", tmp_path: Path) -> Path:
    """A course of one's own in which three assignments are handed out."""
    return shutil.copytree(issued.course.root, tmp_path / "course")


@pytest.fixture(scope="module")
def work(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The right answers to what was issued to s03, in a file whose name tells nothing."""
    return issued.hand_in("s03", correct, tmp_path_factory.mktemp("inbox") / "ответы.xlsx")


def join(root: Path, *, undo: bool = False) -> list[str]:
    same_as = "" if undo else "s01"
    wanted = Withdrawal("s03", same_as, undo, "Сменила фамилию", "Петров", NOW)
    return [str(one) for one in withdraw(wanted, root, home_of(root)).notes]


def graded(root: Path, *files: Path) -> list[Report]:
    context = open_grading(root)
    reports = [Graded(grade_file(one, context), "") for one in files]
    return [one.report for one in keep(reports, context, home_of(root), NOW)]


def test_a_work_on_the_second_sheet_is_the_persons_and_is_judged_by_that_sheet(
    root: Path, work: Path
) -> None:
    (alone,) = graded(root, work)
    join(root)
    (report,) = graded(root, work)
    assert (report.student, report.known_by, report.flags) == ("s01", KnownBy.SIGNATURE, ())
    assert report.variant == register_of(root).versions()["s01"][0].variant.id == alone.variant
    assert report.score == alone.score > 0
    assert "issued to s03, which was joined with s01" in str(report.remarks[0])
    assert {one.id for one in missing([report], open_grading(root))} == {"s02"}


def test_of_a_work_on_the_second_sheet_mistakes_are_named_and_followed_as_of_any(
    issued: "Classroom", root: Path, tmp_path: Path
) -> None:
    file = issued.hand_in("s03", forget_one_jaw, tmp_path / "ответы.xlsx")
    (alone,) = graded(root, file)
    join(root)
    # Of the program's own: nothing that the gradebook keeps decides.
    (report,) = (grade_file(one, open_grading(root)) for one in [file])
    found = [(one.quantity, one.outcome, one.points, one.slip) for one in report.findings]
    assert found == [(one.quantity, one.outcome, one.points, one.slip) for one in alone.findings]
    assert {Outcome.SLIP, Outcome.CARRIED} <= {one.outcome for one in report.findings}


def test_a_work_on_the_first_sheet_is_judged_as_ever(
    issued: "Classroom", root: Path, tmp_path: Path
) -> None:
    join(root)
    (report,) = graded(root, issued.hand_in("s01", correct, tmp_path / "a.xlsx"))
    assert (report.student, report.variant) == ("s01", "001")
    assert (report.flags, report.remarks) == ((), ())


def test_a_path_with_the_second_id_names_the_person(root: Path, work: Path, tmp_path: Path) -> None:
    join(root)
    path = tmp_path / "s03.xlsx"
    shutil.copy(work, path)
    assert graded(root, path)[0].student == "s01"
    path = tmp_path / "s02.xlsx"
    shutil.copy(work, path)
    assert "that of s01" in str(graded(root, path)[0].flags[0].message)


def test_nothing_waits_twice_and_nothing_is_missed_of_what_was_graded_before(
    root: Path, work: Path
) -> None:
    graded(root, work)
    join(root)
    graded(root, work)
    context = open_grading(root)
    waits = what_waits(home_of(root), context.joins)
    assert {one.student for one in waits} == {"s01"}
    found = regrade([work], context, home_of(root), 0, NOW)
    assert ([one.work.student for one in found.changes], found.missing) == (["s01"], ())


def test_marks_by_hand_that_become_the_persons_are_named(root: Path, work: Path) -> None:
    assert len(join(root)) == 1
    join(root, undo=True)
    graded(root, work)
    draft = Draft("s03", "general_view_drawing", {"sizes": 1.0, "assembly": 1.0, "standards": 1.0})
    enter_mark(draft, open_grading(root), home_of(root), "Петров", NOW)
    _, note = join(root)
    assert note.startswith("1 mark by hand that was given to s03 is that of s01 now")


def test_the_history_of_both_tells_it(root: Path, work: Path) -> None:
    graded(root, work)
    join(root)
    join(root, undo=True)
    register = register_of(root)
    for student in ("s01", "s03"):
        events = history(
            home_of(root), student, register.by_student(), withdrawals=register.withdrawals
        )
        told = [str(one.what) for one in events if one.why == "Сменила фамилию"]
        assert told == [
            "s03 was joined with s01: works of both are those of s01.",
            "s03 and s01 are two again.",
        ]


def test_nobody_waits_for_who_left_but_the_work_is_graded(root: Path, work: Path) -> None:
    wanted = Withdrawal("s03", "", False, "Отчислена", "Петров", NOW)
    withdraw(wanted, root, home_of(root))
    assert {one.id for one in missing([], open_grading(root))} == {"s01", "s02"}
    (report,) = graded(root, work)
    assert (report.student, report.judged) == ("s03", True)


def test_who_left_has_no_row_among_those_who_are_missing(root: Path, tmp_path: Path) -> None:
    wanted = Withdrawal("s03", "", False, "Отчислена", "Петров", NOW)
    withdraw(wanted, root, home_of(root))
    write_tables((), open_grading(root), tmp_path / "out")
    csv = (tmp_path / "out" / "grades.csv").read_text(encoding="utf-8-sig")
    assert [line.partition(",")[0] for line in csv.splitlines()] == ["student", "s01", "s02"]


def test_a_link_that_the_second_id_got_opens_the_page_of_the_person(root: Path) -> None:
    context = open_books(root)
    token = token_of(context, "s03", NOW + timedelta(days=1))
    join(root)
    found = open_link(context, token, NOW)
    assert isinstance(found, Issued)
    assert found.student.id == "s01"
    assert [one.issued.student.id for one in make_links(context, "https://x.org", 1, NOW)] == [
        "s01",
        "s02",
    ]


def test_revoked_no_link_of_the_person_opens_anything_under_either_id(root: Path) -> None:
    context = open_books(root)
    tokens = [token_of(context, one, NOW + timedelta(days=1)) for one in ("s01", "s03")]
    join(root)
    revoke_links(context, "s03", "Петров", NOW)
    assert not any(isinstance(open_link(context, one, NOW), Issued) for one in tokens)


def no_documents(_context: IssuingContext, entry: Issued) -> Handout:
    return Handout(entry.student.id, (), ())


def reissued_to(
    root: Path, issued: "Classroom", student: str, variant: str, out: Path, deadline: date | None
) -> None:
    """Issue anew on the day on which a test joins; without a day everybody's own is kept."""
    order = CorrectedOrder(
        Correction((student,), variant, "Опечатка", "Петров"),
        issued.order.table,
        out,
        NOW.date(),
        deadline,
    )
    course = replace(issued.course, root=root)
    reissue_order(course, issued.policy, order, 0, lambda _: None, issue_one=no_documents)


def test_who_is_named_by_the_second_id_is_issued_anew_as_the_person(
    issued: "Classroom", root: Path, tmp_path: Path
) -> None:
    join(root)
    reissued_to(root, issued, "s03", "005", tmp_path / "corrected", None)
    versions = register_of(root).versions()["s01"]
    assert [(one.issued_as, one.version) for one in versions] == [("s03", 1), ("", 1), ("", 2)]


def test_a_version_that_was_issued_while_two_were_joined_leaves_each_their_own_day(
    issued: "Classroom", root: Path, tmp_path: Path
) -> None:
    """The later day of the second id counts as long as they are one person, and no longer."""
    reissued_to(root, issued, "s03", "006", tmp_path / "later", date(2026, 12, 20))
    join(root)
    reissued_to(root, issued, "s01", "005", tmp_path / "corrected", None)
    person = register_of(root).by_student()["s01"]
    assert (person.version, person.deadline) == (2, date(2026, 12, 20))
    assert open_grading(root).register["s01"].deadline == date(2026, 12, 20)
    notes = join(root, undo=True)
    entries = register_of(root).by_student()
    assert [entries[one].deadline for one in ("s01", "s03")] == [
        date(2026, 12, 1),
        date(2026, 12, 20),
    ]
    assert "s01 has the deadline 2026-12-01 again" in notes[1]
    assert "version 2 was issued meanwhile and says 2026-12-20" in notes[1]


def test_a_day_that_is_named_for_a_version_stays(
    issued: "Classroom", root: Path, tmp_path: Path
) -> None:
    join(root)
    reissued_to(root, issued, "s01", "005", tmp_path / "corrected", date(2026, 12, 30))
    assert not any("deadline" in note for note in join(root, undo=True))
    assert register_of(root).by_student()["s01"].deadline == date(2026, 12, 30)


def test_a_later_day_that_is_no_longer_a_persons_is_said(
    issued: "Classroom", root: Path, tmp_path: Path
) -> None:
    reissued_to(root, issued, "s03", "006", tmp_path / "later", date(2026, 12, 20))
    join(root)
    assert "s01 has the deadline 2026-12-01 again, not 2026-12-20." in join(root, undo=True)


def test_nobody_is_joined_with_an_id_that_is_joined_itself(root: Path) -> None:
    join(root)
    wanted = Withdrawal("s02", "s03", False, "Один человек", "Петров", NOW)
    with pytest.raises(UsageError) as refused:
        withdraw(wanted, root, home_of(root))
    (problem,) = refused.value.problems
    assert "s03 was joined with s01 already" in str(problem.what)


def test_an_order_of_folders_names_a_joined_person_by_either_id(root: Path, work: Path) -> None:
    join(root)
    file = shutil.copy(work, work.with_name("s03_work.xlsx"))
    wish = BatchWish(pattern="{id}_*.xlsx")
    context, _ = as_wished(wish, [file], open_grading(root), None, 0)
    assert context.pattern is not None
    part = context.pattern.part_of(str(file))
    assert part is not None
    assert part.identifier == "s03"
