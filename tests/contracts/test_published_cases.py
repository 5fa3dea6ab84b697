"""Numbers printed in the literature, or of another method, come out of the course."""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from gripcourse.course.model import Course
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant

CASES = Path(__file__).parents[2] / "variants" / "published_cases.toml"


@dataclass(frozen=True, slots=True)
class Case:
    """A calculation of others: what it gives and chooses, and the values it prints.

    Attributes:
        id, scheme, source: what it is and where it is printed.
        options: of the scheme.
        known: givens, constants and decisions that differ from the worked example's.
        expected: value and tolerated difference by quantity. All in declared units.
    """

    id: str
    scheme: str
    source: Mapping[str, str]
    options: Mapping[str, str]
    known: Mapping[str, float]
    expected: Mapping[str, tuple[float, float]]


def read_case(table: Mapping[str, Any]) -> Case:
    """Read one table of the file."""
    return Case(
        id=table["id"],
        scheme=table["scheme"],
        source=table["source"],
        options=table["options"],
        known={**table.get("given", {}), **table.get("chosen", {})},
        expected={name: (value, margin) for name, (value, margin) in table["expected"].items()},
    )


PUBLISHED = [read_case(one) for one in tomllib.loads(CASES.read_text(encoding="utf-8"))["case"]]


@pytest.mark.parametrize("case", PUBLISHED, ids=[case.id for case in PUBLISHED])
def test_a_published_number_comes_out(course: Course, case: Case) -> None:
    example = course.schemes[case.scheme].example
    assert example is not None
    plan = make_plan(course, case.scheme, {**example.options, **case.options})
    assert case.known.keys() <= plan.quantities.keys()
    known = {one.id for one in (*plan.givens, *plan.constants)}
    given = {name: value for name, value in example.given.items() if name in known}
    values = solve_variant(plan, {**given, **case.known})
    wrong = {
        name: values[name]
        for name, (expected, difference) in case.expected.items()
        if values[name] != pytest.approx(expected, rel=1e-12, abs=difference)
    }
    assert case.expected
    assert wrong == {}


def test_every_published_case_cites_a_work_of_the_course(course: Course) -> None:
    assert {case.source["work"] for case in PUBLISHED} <= course.works.keys()
    assert len({case.id for case in PUBLISHED}) == len(PUBLISHED) > 0
