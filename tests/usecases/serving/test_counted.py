"""The desk tells of every student what grading tells: which work counts, and what is left of it."""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING
from unittest.mock import patch
from zoneinfo import ZoneInfo

import pytest

from gripcourse.access.desk.store import open_desk
from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import blank, correct
from gripcourse.gradebook.timing import Waiver
from gripcourse.grading.model import Report
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.database.home import home_of
from gripcourse.policy.time_rules import AttemptRule, Counts, LateRule
from gripcourse.usecases.grading.collect import collect
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.handed_in import HandingTime, handed_in_times
from gripcourse.usecases.marks.mark import existing_gradebook
from gripcourse.usecases.marks.waive import waive
from gripcourse.usecases.serving.begin_grading import begin_grading
from gripcourse.usecases.serving.counted import counted_works, which_counts
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.figures import group_figures
from gripcourse.usecases.serving.hand_in import hand_in
from gripcourse.web.group import rows_of
from support.classroom import KEY, forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

NOW = datetime(2026, 12, 9, 9, tzinfo=UTC)
RULE = LateRule(0.1, 0.5, 0, "UTC")
"""The last day is the first of December."""


@dataclass(frozen=True, slots=True)
class Term:
    """A class whose works are graded, and its desk."""

    context: DeskContext
    folder: Path
    classroom: "Classroom"

    def grade(self, days: Mapping[str, int]) -> dict[str, Report]:
        """Grade a work of each student, handed in on a day of December."""
        context = GradingContext(self.context.course, self.context.policy, self.context.register())
        graded, times = [], {}
        for name, day in days.items():
            behaviour = forget_one_jaw if name.endswith("again") else correct
            work = self.classroom.hand_in(name[:3], behaviour, self.folder / f"{name}.xlsx")
            graded.append(Graded(grade_file(work, context), ""))
            times[str(work)] = HandingTime(datetime(2026, 12, day, 12, tzinfo=UTC), said=True)
        kept = keep(graded, context, home_of(self.context.course.root), NOW, times)
        return {name: one.report for name, one in zip(days, kept, strict=True)}

    def bring(self, student: str, works: Sequence[Path], hours: int = 1) -> None:
        """Hand works in at the server, each some hours after what came before by its clock."""
        issued, before = self.context.register()[student], self.context.desk.hand_ins(student)
        for number, work in enumerate(works, start=len(before)):
            at = NOW + timedelta(hours=number * hours)
            hand_in(self.context, issued, NamedBytes(work.name, work.read_bytes()), at)

    def grade_collected(self) -> list[str]:
        """Grade as the server has it done; return the digests of what it collected, as it came."""
        with patch("subprocess.Popen") as begun:
            begin_grading(self.context, self.folder, 0, "Dr. Ray")
        (command,) = begun.call_args.args
        said = [one.partition("=")[2] for one in command if one.startswith("--handed-in=")]
        files = collect([Path(command[5])]).files
        context = GradingContext(self.context.course, self.context.policy, self.context.register())
        graded = [Graded(grade_file(one, context), "") for one in files]
        times = handed_in_times(said, files, ZoneInfo("UTC"))
        kept = keep(graded, context, home_of(self.context.course.root), NOW, times)
        return [one.report.digest for one in kept]

    def waive(self, student: str) -> None:
        waiver = Waiver(student, 0, None, False, "Dr. Ray", NOW, "Hospital.")
        waive(waiver, home_of(self.context.course.root), self.context.register())

    def ruled(self, late: LateRule | None, attempts: AttemptRule | None) -> "Term":
        policy = replace(self.context.policy, late=late, attempts=attempts)
        return replace(self, context=replace(self.context, policy=policy))


@pytest.fixture
def term(classroom: "Classroom", tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Term:
    monkeypatch.setattr("gripcourse.usecases.issuing.handout.assignment_sheet", lambda *_: b"%PDF")
    classroom.issue()
    desk = open_desk(home_of(classroom.course.root), classroom.course.id)
    context = DeskContext(classroom.course, classroom.policy, KEY, desk)
    return Term(context, tmp_path, classroom).ruled(RULE, None)


def test_figures_and_group_take_off_what_lateness_costs_unless_it_was_waived(term: Term) -> None:
    term.waive("s03")
    reports = term.grade({"s01": 1, "s02": 3, "s03": 3})
    whole = reports["s01"].max_score
    assert [one.score for one in reports.values()] == pytest.approx([whole] * 3)
    rows = {row.issued.student.id: row for row in rows_of(term.context)}
    # Two days of a tenth each.
    earned = {name: row.earned / whole for name, row in rows.items()}
    assert earned == pytest.approx({"s01": 1.0, "s02": 0.8, "s03": 1.0})
    assert [row.points for row in rows.values()] == pytest.approx([whole] * 3)
    found = group_figures(term.context)
    assert found.mean == pytest.approx(2.8 / 3)
    assert (found.median, found.scores) == (pytest.approx(1.0), (0,) * 8 + (1, 2))
    # How hard the assignment was has nothing to do with when it came.
    assert all(one.share == pytest.approx(1.0) for one in found.sections)
    free = group_figures(term.ruled(None, None).context)
    assert free.mean == pytest.approx(1.0)


def test_of_several_works_the_desk_takes_the_one_that_grading_takes(term: Term) -> None:
    days = {"s01": 1, "s01-again": 2}
    for rule in Counts:
        ruled = term.ruled(RULE, AttemptRule(rule, 0))
        counting = [one for one in ruled.grade(days).values() if one.timing and one.timing.counts]
        found = counted_works(ruled.context, {"s01"})["s01"]
        assert [(one.digest, one.earned) for one in counting] == [
            (found.attempt.digest, pytest.approx(found.earned))
        ]


def test_of_works_that_came_by_the_server_that_one_counts_which_the_policy_names(
    term: Term, tmp_path: Path
) -> None:
    """The best came before the last: who gives up the one for the other has both handed in."""
    works = [
        term.classroom.hand_in("s01", behaviour, tmp_path / f"{behaviour.__name__}.xlsx")
        for behaviour in (forget_one_jaw, correct, blank)
    ]
    term.bring("s01", works)
    first, best, last = (hashlib.sha256(one.read_bytes()).hexdigest() for one in works)
    for rule, collected, counting in (
        (None, [last], last),
        (AttemptRule(Counts.LAST, 0), [last], last),
        (AttemptRule(Counts.BEST, 0), [first, best, last], best),
        (AttemptRule(Counts.FIRST, 0), [first, best, last], first),
        (AttemptRule(Counts.LAST, 2), [first, best, last], best),
    ):
        ruled = term.ruled(None, rule)
        assert ruled.grade_collected() == collected
        assert counted_works(ruled.context)["s01"].attempt.digest == counting


def test_a_work_that_is_handed_in_again_after_another_is_the_last_one(
    term: Term, tmp_path: Path
) -> None:
    """Each was graded before the next came: the gradebook knows the first from the first batch."""
    first, second = (
        term.classroom.hand_in("s01", behaviour, tmp_path / f"{behaviour.__name__}.xlsx")
        for behaviour in (correct, blank)
    )
    for rule in (AttemptRule(Counts.LAST, 0), None):
        ruled = term.ruled(None, rule)
        for work in (first, second, first):
            ruled.bring("s01", [work])
            collected = [hashlib.sha256(work.read_bytes()).hexdigest()]
            assert ruled.grade_collected() == collected
            assert [counted_works(ruled.context)["s01"].attempt.digest] == collected


def test_a_student_is_told_which_workbook_counts() -> None:
    rules = (None, *(AttemptRule(counts, most) for most in (0, 3) for counts in Counts))
    rules += (AttemptRule(Counts.LAST, 1),)
    assert [str(which_counts(one)) for one in rules] == [
        "The last workbook counts.",
        "The first workbook counts.",
        "The last workbook counts.",
        "The best workbook counts.",
        "The first workbook counts.",
        "Of the first 3 workbooks the last one counts.",
        "Of the first 3 workbooks the best one counts.",
        "The first workbook counts.",
    ]


@pytest.mark.parametrize("at_once", [True, False])
@pytest.mark.parametrize(
    ("rule", "counting"),
    [(AttemptRule(Counts.LAST, 0), 1), (AttemptRule(Counts.FIRST, 0), 0), (None, 1)],
)
def test_a_clock_that_was_set_back_makes_no_later_work_the_earlier_one(
    term: Term, rule: AttemptRule | None, counting: int, *, at_once: bool
) -> None:
    ruled = term.ruled(RULE, rule)
    works = [
        term.classroom.hand_in("s01", one, term.folder / f"{name}.xlsx")
        for name, one in (("a", correct), ("b", forget_one_jaw))
    ]
    digests = [hashlib.sha256(one.read_bytes()).hexdigest() for one in works]
    if at_once:
        ruled.bring("s01", works, hours=-1)
        ruled.grade_collected()
    else:
        for work in works:
            ruled.bring("s01", [work], hours=-1)
            ruled.grade_collected()
    assert counted_works(ruled.context)["s01"].attempt.digest == digests[counting]
    known = existing_gradebook(home_of(term.context.course.root)).attempts({"s01"})
    # Lateness is counted from what the receipt says.
    times = {one.digest: one.handed_in for one in known}
    assert all(times[one.digest] == one.at for one in term.context.desk.hand_ins("s01")
               if one.digest in times)  # fmt: skip
