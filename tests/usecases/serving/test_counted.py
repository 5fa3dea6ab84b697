"""The desk tells of every student what grading tells: which work counts, and what is left of it."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.access.desk.store import open_desk
from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import GradingContext, grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.gradebook.timing import Waiver
from gripcourse.grading.model import Report
from gripcourse.machine.database.home import home_of
from gripcourse.policy.time_rules import AttemptRule, Counts, LateRule
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.handed_in import HandingTime
from gripcourse.usecases.marks.waive import waive
from gripcourse.usecases.serving.counted import counted_works
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.figures import group_figures
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
