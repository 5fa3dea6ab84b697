from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

import pytest

from gripcourse.course.model import Course
from gripcourse.drawing.general_view import GeneralView, general_view
from gripcourse.drawing.title_block import TitleBlock
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.variants.table import read_table
from gripcourse.words import Words

BLOCK = TitleBlock("007 GA", "a gripper", "General arrangement", "Somebody")


@dataclass(frozen=True, slots=True)
class Drawn:
    """A variant with its general view."""

    plan: Plan
    values: Mapping[str, float]
    view: GeneralView


@pytest.fixture(scope="session")
def draw(course: Course) -> Callable[..., Drawn]:
    """Draw a variant; a drawing in a language is made once."""
    table = read_table(course.root / "variants" / "tables" / "main.csv", course)
    variants = {one.id: one for one in table}

    @cache
    def drawn(identifier: str, language: str = "ru") -> Drawn:
        variant = variants[identifier]
        plan = make_plan(course, variant.scheme, variant.options)
        values = solve_variant(plan, variant.given)
        assert plan.scheme.view is not None
        made = general_view(plan, plan.scheme.view, values, BLOCK, Words(language))
        return Drawn(plan, values, made)

    return drawn
