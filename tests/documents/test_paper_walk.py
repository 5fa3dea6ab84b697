"""Whoever has the sheet of paper alone comes to the reference: a sheet has one reading.

The student of `support.paper_walk` computes every answer from the printed text, the printed series
and equations that were written without a look at the declarations.
"""

import tomllib
from pathlib import Path
from typing import Final

import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.documents.assignment_sheet import asked_items, given_data
from gripcourse.policy.bands import band
from gripcourse.policy.load import load_policy
from gripcourse.solver.plan import Plan, default_options, make_plan, usual_values
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from support.paper_walk import UNITS, equations_of, read_item, walk

_WALKS: Final = Path(__file__).parents[1] / "support" / "paper" / "walks.toml"
WALKS: Final = tomllib.loads(_WALKS.read_text(encoding="utf-8"))["walks"]
PAPER: Final = Words("en")


def usual_plan(scheme: str, course: Course) -> Plan:
    return make_plan(course, scheme, default_options(course.schemes[scheme]))


@pytest.mark.parametrize("scheme", WALKS)
def test_every_answer_follows_from_the_paper_alone(scheme: str, course: Course) -> None:
    plan = usual_plan(scheme, course)
    policy = load_policy(plan.course)
    values = usual_values(plan)
    given = given_data((*plan.givens, *plan.constants), values, PAPER)
    items = asked_items(plan.answered, plan, policy, PAPER)
    found = walk(given, items, equations_of(WALKS[scheme]))
    reference = solve_variant(plan, values)
    wrong = {}
    for quantity, item in zip(plan.answered, items, strict=True):
        asked = read_item(item)
        answer, right = found[asked.symbol] / UNITS[asked.unit], reference[quantity.id]
        reach = 0.0 if quantity.kind is Kind.VERDICT else band(quantity, right, policy)
        if not abs(answer - right) <= max(reach, 1e-9 * abs(right)):
            wrong[asked.symbol] = (answer, right)
    assert not wrong
