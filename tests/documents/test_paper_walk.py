"""Whoever has the sheet of paper alone comes to the reference: a sheet has one reading.

The student of `support.paper_walk` computes every answer from the printed text, the printed series
and equations that were written without a look at the declarations.
"""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import pytest

from gripcourse.course.compose import part_ids
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.documents.assignment_sheet import asked_items, given_data
from gripcourse.policy.bands import band
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from gripcourse.variants.model import Variant
from support.issued_table import issued_table
from support.paper_walk import UNITS, equations_of, read_item, walk

REPOSITORY: Final = Path(__file__).parents[2]
SCHEMES: Final = sorted(one.name for one in (REPOSITORY / "variants" / "schemes").iterdir())
PAPER: Final = Words("en")
# What an angle is counted from, or which way.
_WHENCE: Final = re.compile("positive|without a sign|from the ")


def parts_of(variant: Variant, course: Course) -> tuple[str, ...]:
    """Return the names of what a variant is composed of, its scheme last."""
    return (*part_ids(course.schemes[variant.scheme], variant.options), variant.scheme)


def enough(course: Course) -> Iterator[Variant]:
    """Yield variants of the issued table in which every scheme and every part occurs."""
    seen: set[str] = set()
    for variant in issued_table(course):
        parts = {*parts_of(variant, course)}
        if parts - seen:
            seen |= parts
            yield variant


@pytest.fixture(scope="module")
def variants(course: Course) -> tuple[Variant, ...]:
    return tuple(enough(course))


@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_answer_follows_from_the_paper_alone(
    scheme: str, variants: tuple[Variant, ...], course: Course, policy: Policy
) -> None:
    of_the_scheme = [one for one in variants if one.scheme == scheme]
    assert of_the_scheme
    for variant in of_the_scheme:
        answer_from_paper(variant, course, policy)


def answer_from_paper(variant: Variant, course: Course, policy: Policy) -> None:
    plan = make_plan(course, variant.scheme, variant.options)
    given = given_data((*plan.givens, *plan.constants), variant.given, PAPER)
    items = asked_items(plan.answered, plan, policy, PAPER)
    found = walk(given, items, equations_of(parts_of(variant, course)))
    answers = {
        quantity.id: found[asked.symbol] / UNITS[asked.unit]
        for quantity, asked in zip(plan.answered, map(read_item, items), strict=True)
    }
    # What is read between the rows of a table has a tolerance of its own; the rest follows from it.
    own = {one.id for one in plan.answered if one.tolerance is not None}
    reference = solve_variant(plan, variant.given)
    following = solve_variant(plan, {**variant.given, **{name: answers[name] for name in own}})
    for quantity in plan.answered:
        right = (reference if quantity.id in own else following)[quantity.id]
        exact = quantity.kind is Kind.VERDICT
        reach = 0.0 if exact else band(quantity, right, policy)
        off = abs(answers[quantity.id] - right)
        assert off <= max(reach, 1e-9 * abs(right)), (variant.id, quantity.id)


def test_an_angle_that_is_obtuse_or_negative_anywhere_says_whence_it_is_counted(
    course: Course, policy: Policy
) -> None:
    silent: dict[tuple[str, str], str] = {}
    for variant in issued_table(course):
        plan = make_plan(course, variant.scheme, variant.options)
        reference = solve_variant(plan, variant.given)
        told = asked_items(plan.answered, plan, policy, PAPER)
        for quantity, item in zip(plan.answered, told, strict=True):
            sharp = 0 <= reference[quantity.id] <= 90
            if quantity.unit == "deg" and not sharp and not _WHENCE.search(item.text):
                silent[variant.scheme, quantity.id] = item.text
    assert silent == {}
