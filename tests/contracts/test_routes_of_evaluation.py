"""A formula gives the same by every route: walked as a tree, for one number, for whole columns."""

import math
from collections.abc import Iterator, Mapping

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.formula.evaluate import Column, evaluate
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.tree import Call, Formula, Name, Negation, Node, Number, Operation
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate as solve
from gripcourse.solver.solve import to_si

NAN = math.nan
# Of each input in turn: what has no value, or takes a formula out of its domain.
ODD = (0.0, -1.0, NAN, math.inf, 1e-320, 1e300, -1e300)


def walked(node: Node, values: Mapping[str, float], columns: Mapping[str, Column]) -> float:
    """Compute a formula by walking its tree, every step finite or NaN."""
    match node:
        case Number(value):
            return value
        case Name(id="pi"):
            return math.pi
        case Name(name):
            return values[name]
        case Negation(operand):
            return -walked(operand, values, columns)
        case Operation(operator, left, right):
            return known(
                combined(operator, *(walked(one, values, columns) for one in (left, right)))
            )
        case Call(name, arguments, column):
            found = tuple(np.asarray(walked(one, values, columns)) for one in arguments)
            with np.errstate(all="ignore"):
                return known(
                    float(
                        FUNCTIONS[name].compute(found, None if column is None else columns[column])
                    )
                )


def combined(operator: str, left: float, right: float) -> float:
    """Combine two numbers; NaN wherever one of them is."""
    if math.isnan(left) or math.isnan(right):
        return NAN
    same = abs(left - right) <= 1e-9 * max(abs(left), abs(right))
    with np.errstate(all="ignore"):
        return float(
            {
                "+": lambda: left + right,
                "-": lambda: left - right,
                "*": lambda: left * right,
                "/": lambda: np.divide(left, right),
                "**": lambda: np.power(left, right),
                "<": lambda: left < right and not same,
                "<=": lambda: left < right or same,
                ">": lambda: left > right and not same,
                ">=": lambda: left > right or same,
                "==": lambda: same,
                "and": lambda: left * right,
            }[operator]()
        )


def known(value: float) -> float:
    """Make infinities NaN."""
    return value if math.isfinite(value) else NAN


def plans(course: Course) -> Iterator[Plan]:
    """Yield the plan of every worked example."""
    for scheme in course.schemes.values():
        if scheme.example is not None:
            yield make_plan(course, scheme.id, scheme.example.options)


def formulas(course: Course) -> Iterator[tuple[Plan, Formula, dict[str, float]]]:
    """Yield every formula of the worked examples once, with the values of its names there."""
    seen = set()
    for plan in plans(course):
        example = plan.scheme.example
        given = {} if example is None else example.given
        own = {name: value for name, value in given.items() if name in plan.quantities}
        values = solve(plan, to_si(plan, own)).values
        for name in plan.quantities:
            formula = plan.reference_formula(name)
            if formula is not None and not formula.units and id(formula) not in seen:
                seen.add(id(formula))
                yield plan, formula, {one: float(values[one]) for one in formula.names}


def test_a_formula_gives_the_same_walked_as_a_tree_for_one_number_and_for_columns(
    course: Course,
) -> None:
    for plan, formula, usual in formulas(course):
        rows = [usual, {name: value * 1.07 for name, value in usual.items()}]
        rows += [{**usual, name: odd} for name in usual for odd in ODD]
        table = {name: np.array([row[name] for row in rows]) for name in usual}
        columns = np.broadcast_to(evaluate(formula, "", table, plan.columns), len(rows))
        for row, together in zip(rows, columns, strict=True):
            sound = {name: known(value) for name, value in row.items()}
            single = {name: np.asarray(value) for name, value in row.items()}
            expected = pytest.approx(walked(formula.tree, sound, plan.columns), 1e-12, nan_ok=True)
            assert float(together) == expected, (formula.text, row)
            assert float(evaluate(formula, "", single, plan.columns)) == expected, formula.text


def test_a_large_table_is_solved_as_its_variants_are_one_by_one(course: Course) -> None:
    plan = next(plans(course))
    example = plan.scheme.example
    assert example is not None
    given = to_si(plan, {k: v for k, v in example.given.items() if k in plan.quantities})
    spread = np.random.default_rng(1).uniform(0.95, 1.05, 40_001)
    known_values = {name: value * spread for name, value in given.items()}
    first = next(iter(given))
    known_values[first] = np.where(spread > 1.04, NAN, known_values[first])
    known_values[plan.answered[3].id] = np.where(spread > 1, 1.5, NAN)
    whole = solve(plan, known_values)
    for row in (0, 16_383, 16_384, 40_000):
        alone = solve(plan, {name: value[row] for name, value in known_values.items()})
        for large, small in ((whole.values, alone.values), (whole.computed, alone.computed)):
            assert {
                name: float(np.broadcast_to(one, 40_001)[row]) for name, one in large.items()
            } == (
                pytest.approx({name: float(one) for name, one in small.items()}, 1e-12, nan_ok=True)
            )
