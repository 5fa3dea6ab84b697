import csv
from collections import defaultdict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Protocol

import pytest

from gripcourse.course.model import Course
from gripcourse.drawing.paper.title_block import variant_block
from gripcourse.drawing.view.general_view import GeneralView, general_view
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from support.issued_table import issued_table

REPOSITORY = Path(__file__).parents[2]
SHOWN_BY_OPTIONS = ("mounting", "drive")
SIZES = ("diameter_max [mm]", "object_length [mm]")
# The longest that a sheet must hold: who it fits, everybody fits.
LONG = "Константинопольская-Задунайская Александра Максимилиановна Я."
GROUP = "Група РТ-41мп, Національний технічний університет «Київський політехнічний інститут»"


@dataclass(frozen=True, slots=True)
class Drawn:
    """A variant with its general view."""

    plan: Plan
    values: Mapping[str, float]
    view: GeneralView


Solve = Callable[[str], tuple[Plan, Mapping[str, float]]]


class Draw(Protocol):
    """The fixture that draws a variant."""

    def __call__(self, identifier: str, language: str = "ru") -> Drawn: ...


def issued() -> dict[str, list[dict[str, str]]]:
    """The rows of the course's table by scheme, each scheme's from the smallest to the largest."""
    found = defaultdict(list)
    table = REPOSITORY / "variants" / "tables" / "main.csv"
    with table.open(encoding="utf-8-sig", newline="") as stream:
        for row in csv.DictReader(stream):
            found[row["scheme"]].append(row)
    return {scheme: sorted(rows, key=size) for scheme, rows in found.items()}


def size(row: dict[str, str]) -> float:
    return next(float(row[one].replace(",", ".")) for one in SIZES if row.get(one))


def some_variants() -> list[str]:
    """Of each scheme the smallest, the largest, and one for each option that a view shows."""
    found = []
    for rows in issued().values():
        ends = rows[0], rows[-1]
        chosen, seen = {one["variant"] for one in ends}, set[tuple[str, str]]()
        for row in (*ends, *rows):
            options = {(name, row[name]) for name in SHOWN_BY_OPTIONS if row.get(name)}
            if options - seen:
                chosen.add(row["variant"])
            seen |= options
        found += sorted(chosen)
    return found


@pytest.fixture(scope="session")
def any_variants() -> list[str]:
    """Several variants of each scheme, each a subtest: a test of its own takes much longer."""
    return some_variants()


@pytest.fixture(scope="session")
def other_language() -> Callable[[str], str]:
    """Choose a language that a variant is drawn in besides Russian: English or Ukrainian."""
    return lambda identifier: ("en", "uk")[int(identifier) % 2]


@pytest.fixture(scope="session")
def small_variants() -> list[str]:
    """The smallest variant of each scheme, each a subtest."""
    return [one[0]["variant"] for one in issued().values()]


@pytest.fixture(scope="session")
def smallest() -> Mapping[str, str]:
    """The smallest variant of each scheme."""
    return {scheme: rows[0]["variant"] for scheme, rows in issued().items()}


@pytest.fixture(scope="session")
def solved(course: Course) -> Solve:
    """Solve a variant of the course's table."""
    variants = {one.id: one for one in issued_table(course)}

    def find(identifier: str) -> tuple[Plan, Mapping[str, float]]:
        variant = variants[identifier]
        plan = make_plan(course, variant.scheme, variant.options)
        return plan, solve_variant(plan, variant.given)

    return find


@pytest.fixture(scope="session")
def draw(solved: Solve) -> Draw:
    """Draw a variant with long names on its sheet; a drawing in a language is made once."""

    @cache
    def drawn(identifier: str, language: str = "ru") -> Drawn:
        plan, values = solved(identifier)
        assert plan.scheme.view is not None
        words = Words(language)
        own = variant_block(plan, identifier, LONG, words)
        block = replace(own, checked=LONG, organisation=GROUP)
        made = general_view(plan, plan.scheme.view, values, block, words)
        return Drawn(plan, values, made)

    return drawn
