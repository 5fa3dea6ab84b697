"""The diagrams of all issued variants, laid out once."""

from collections.abc import Mapping
from dataclasses import dataclass

import pytest

from gripcourse.course.model import Course
from gripcourse.drawing.layout import Layout, lay_out
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.variants.table import read_table

LANGUAGE = "ru"


@dataclass(frozen=True, slots=True)
class Drawn:
    """A variant's plan and given values, and its diagram in Russian."""

    name: str
    plan: Plan
    given: Mapping[str, float]
    layout: Layout


@pytest.fixture(scope="session")
def drawn(course: Course) -> tuple[Drawn, ...]:
    """Every variant of the course's table."""
    found = []
    for variant in read_table(course.root / "variants" / "tables" / "main.csv", course):
        plan = make_plan(course, variant.scheme, variant.options)
        layout = lay_out(plan, variant.given, LANGUAGE)
        assert layout is not None, f"{variant.scheme} {variant.id} has no diagram"
        found.append(Drawn(f"{variant.scheme} {variant.id}", plan, variant.given, layout))
    return tuple(found)


@pytest.fixture(scope="session")
def one_of_each(drawn: tuple[Drawn, ...]) -> tuple[Drawn, ...]:
    """The first variant of each scheme."""
    return tuple({one.plan.scheme.id: one for one in reversed(drawn)}.values())
