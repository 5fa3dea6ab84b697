"""The reference course, the variant of its worked example, and an entry of the register."""

from datetime import date
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.solver.plan import Plan, default_options, make_plan
from gripcourse.variants.model import Issued, Student, Variant

SCHEME = "rack_parallelogram"


@pytest.fixture(scope="session")
def course() -> Course:
    return load_course(Path(__file__).parents[2])


@pytest.fixture(scope="session")
def plan(course: Course) -> Plan:
    return make_plan(course, SCHEME, default_options(course.schemes[SCHEME]))


@pytest.fixture(scope="session")
def variant(plan: Plan) -> Variant:
    example = plan.scheme.example
    assert example is not None
    given = {quantity.id: example.given[quantity.id] for quantity in plan.givens}
    return Variant("07", SCHEME, dict(plan.options), given)


@pytest.fixture(scope="session")
def issued(variant: Variant) -> Issued:
    student = Student("s001", '=HYPERLINK("x") & Ко', "РТ-41", "", "ru", "07")
    return Issued(student, variant, date(2026, 2, 3), date(2026, 4, 1), "ab" * 32)
