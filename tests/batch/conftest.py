"""A context with a register of a few students, and a grader that other processes find."""

import importlib
from collections.abc import Callable
from dataclasses import replace
from datetime import date
from pathlib import Path
from types import ModuleType

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan
from gripcourse.variants.model import Issued, Student, Variant

STUDENTS = ("s01", "s02", "s03", "s04", "s05", "s06", "s07", "s08")


@pytest.fixture(scope="session")
def context(course: Course, policy: Policy, plan: Plan) -> GradingContext:
    """Everybody has the numbers of the worked example."""
    assert plan.scheme.example is not None
    given = {one.id: plan.scheme.example.given[one.id] for one in plan.givens}
    register = {
        name: Issued(
            student=Student(name, f"Студент {name}", "РТК-41", "", "ru", ""),
            variant=Variant("001", plan.scheme.id, dict(plan.options), given),
            issued_on=date(2026, 9, 7),
            deadline=None,
            signature="a1" * 32,
        )
        for name in STUDENTS
    }
    # The course is sent to every process: the scheme that they have is enough.
    only = replace(course, schemes={plan.scheme.id: plan.scheme})
    return GradingContext(only, policy, register)


@pytest.fixture
def fake(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module of graders for tests; a new process gets this path too."""
    monkeypatch.syspath_prepend(str(Path(__file__).parent))
    return importlib.import_module("fake_graders")


@pytest.fixture
def inbox(tmp_path: Path) -> Callable[..., list[Path]]:
    """Make a file per student that tells the fake grader what to do: `inbox(s01="good", …)`."""

    def make(**orders: str) -> list[Path]:
        files = [tmp_path / f"{name}.xlsx" for name in orders]
        for file, order in zip(files, orders.values(), strict=True):
            file.parent.mkdir(exist_ok=True)
            file.write_text(order, encoding="utf-8")
        return files

    return make
