"""A course of one's own with a small roster, its assignments issued once for all tests."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path
from typing import TypeAlias

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.cli.demo.students import Behaviour
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.issuing.store import read_register
from gripcourse.policy.model import Policy
from gripcourse.simulation.write import Typed, fill
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.init import init_course
from gripcourse.usecases.issuing.handout import issue_one as usual
from gripcourse.usecases.issuing.handout import workbook_path
from gripcourse.usecases.issuing.issue import IssueOne, Issuing, Order, issue_order
from gripcourse.variants.model import Issued, Variant
from gripcourse.variants.table import write_table

KEY = bytes(range(32))
ROSTER = """\
student,name,group,email,language,variant
s01,Иванова Анна,РТК-41,,ru,
s02,Шевченко Оксана,РТК-41,,uk,007
s03,Julia Carter,РТК-42,,en,
"""

OwnCourse: TypeAlias = Callable[..., Course]


@dataclass(frozen=True, slots=True, repr=False)
class Classroom:
    """A course whose assignments can be issued, and what was issued."""

    course: Course
    policy: Policy
    order: Order

    def issue(self, issue_one: IssueOne = usual, **changes: object) -> Issuing:
        """Issue by the order, or by one that differs; the register keeps what was issued."""
        order = replace(self.order, **changes)  # type: ignore[arg-type]
        workers = 0 if issue_one is usual else 1  # only what may fail needs a process of its own
        return issue_order(
            self.course, self.policy, order, workers, lambda _: None, issue_one=issue_one
        )

    @property
    def register(self) -> Mapping[str, Issued]:
        return read_register(self.course.root, self.course.id).by_student()

    @property
    def context(self) -> GradingContext:
        return GradingContext(self.course, self.policy, self.register)

    def with_its_scheme(self) -> "Classroom":
        """Leave out all other schemes, where the course is sent to many processes."""
        schemes = {"rack_parallelogram": self.course.schemes["rack_parallelogram"]}
        return replace(self, course=replace(self.course, schemes=schemes))

    def plan(self, student: str) -> Plan:
        variant = self.register[student].variant
        return make_plan(self.course, variant.scheme, variant.options)

    def workbook(self, student: str) -> Path:
        return workbook_path(self.order.out, student)

    def hand_in(self, student: str, behaviour: Behaviour, target: Path) -> Path:
        """Let a student fill in the workbook in some way."""
        typed = behaviour(self.plan(student), self.register[student])
        assert typed is not None
        fill(self.workbook(student), typed, target)
        return target


def table(course: Course) -> list[Variant]:
    """Seven variants of the worked example of the guide, one lighter than the other."""
    scheme = course.schemes["rack_parallelogram"]
    assert scheme.example is not None
    plan = make_plan(course, scheme.id, scheme.example.options)
    given = {one.id: float(scheme.example.given[one.id]) for one in plan.givens}
    return [
        Variant(f"00{number}", scheme.id, dict(plan.options), {**given, "mass": 65.0 - 5 * number})
        for number in range(1, 8)
    ]


def forget_one_jaw(plan: Plan, issued: Issued) -> Typed:
    """Forget that friction acts at both jaws, and compute on faultlessly."""
    right = solve_variant(plan, issued.variant.given)
    wrong = {**issued.variant.given, "grip_force": 2 * right["grip_force"]}
    values = solve_variant(plan, wrong)
    return {
        one.id: ("да" if values[one.id] else "нет") if one.kind is Kind.VERDICT else values[one.id]
        for one in plan.answered
    }


def open_classroom(folder: Path, policy: Policy, roster: str = ROSTER) -> Classroom:
    """Make a course with a known key and this roster; nothing is issued yet."""
    root = folder / "course"
    init_course(root, KEY, Words("en"))
    course = load_course(root)
    (root / "variants" / "roster.csv").write_text(roster, encoding="utf-8")
    write_table(root / "variants" / "tables" / "rack.csv", table(course), course)
    order = Order(
        roster=root / "variants" / "roster.csv",
        table=root / "variants" / "tables" / "rack.csv",
        out=folder / "assignments",
        today=date(2026, 9, 7),
        deadline=date(2026, 12, 1),
    )
    return Classroom(course, policy, order)


@pytest.fixture(scope="session")
def issued(tmp_path_factory: pytest.TempPathFactory, policy: Policy) -> Classroom:
    """Three students with their workbooks; nobody may change this course.

    Laying out three sheets takes longer than all the rest, and nobody reads these.
    """
    classroom = open_classroom(tmp_path_factory.mktemp("issued"), policy)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            "gripcourse.usecases.issuing.handout.assignment_sheet", lambda *_: b"%PDF-1.7\n"
        )
        issuing = classroom.issue()
    assert all(not one.faults for one in issuing.handouts)
    return classroom


@pytest.fixture
def classroom(tmp_path: Path, policy: Policy) -> Classroom:
    """A course of one test, nothing issued."""
    return open_classroom(tmp_path, policy)
