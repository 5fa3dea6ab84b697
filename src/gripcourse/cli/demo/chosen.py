"""What the scripted students stumble over, chosen from the declarations of their assignment.

A demo runs on any course: where a course anticipates a slip, a student makes it; where it has sizes
in series, one takes them too small; where its sources err, one computes as they print.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Final

import numpy as np

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import solve_variant, to_si
from gripcourse.text.units import dimension, factor

_CLEAR: Final = 0.05  # relative; a wrong value that nobody takes for a rounded right one
_LARGER_UNITS: Final = ("kN", "m", "cm", "kPa", "kW", "kN*m", "min", "kg", "g", "l/min", "bar")


def early_mistake(plan: Plan, given: Mapping[str, float]) -> tuple[str, float] | None:
    """Return the first computed quantity that can go wrong early, and its wrong value.

    The first slip that the course declares, else twice the right value; None where there is nothing
    to compute, or where everything after the mistake would have no value.
    """
    right = solve_variant(plan, given)
    computed = [one for one in plan.answered if one.kind is Kind.FORMULA]
    for wrong in (_slipped, _doubled):
        for quantity in computed:
            for value in wrong(plan, quantity, right):
                clear = abs(value - right[quantity.id]) > _CLEAR * abs(right[quantity.id])
                if clear and is_solved(plan, {**given, quantity.id: value}):
                    return quantity.id, value
    return None


def smaller_sizes(plan: Plan, given: Mapping[str, float], count: int) -> dict[str, float]:
    """Return the first sizes of series that have a smaller neighbour, each as that neighbour."""
    right, found = solve_variant(plan, given), dict[str, float]()
    for quantity in plan.answered:
        below = _next_smaller(plan, quantity, right[quantity.id])
        if below is None or not is_solved(plan, {**given, **found, quantity.id: below}):
            continue
        found[quantity.id] = below
        if len(found) == count:
            break
    return found


def measured(plan: Plan) -> Sequence[Quantity]:
    """Return the computed quantities that have a unit, in the order in which they are asked."""
    return [one for one in plan.answered if one.kind is Kind.FORMULA and one.unit]


def larger_unit(unit: str) -> str | None:
    """Return another unit of the same dimension that people use, None where there is none."""
    for other in _LARGER_UNITS:
        if dimension(other) == dimension(unit) and factor(other) != factor(unit):
            return other
    return None


def is_solved(plan: Plan, known: Mapping[str, float]) -> bool:
    """Tell whether every answer has a value."""
    values = solve_variant(plan, known)
    return all(math.isfinite(values[one.id]) for one in plan.answered)


def _slipped(plan: Plan, quantity: Quantity, right: Mapping[str, float]) -> Iterator[float]:
    """Yield what the declared slips of a quantity give that cost points, in its unit."""
    known = {name: np.asarray(value) for name, value in to_si(plan, right).items()}
    for slip in quantity.slips:
        if slip.credit < 1:
            value = evaluate_formula(slip.formula, quantity.unit, known, plan.columns)
            yield float(value) / factor(quantity.unit)


def _doubled(_plan: Plan, quantity: Quantity, right: Mapping[str, float]) -> Iterator[float]:
    yield 2 * right[quantity.id]


def _next_smaller(plan: Plan, quantity: Quantity, value: float) -> float | None:
    if quantity.choice is None:
        return None
    scale = factor(quantity.unit)
    sizes = (size / scale for size in plan.columns[quantity.choice.column].sizes)
    below = [size for size in sizes if size < value * (1 - 1e-3)]
    return float(f"{below[-1]:.12g}") if below else None
