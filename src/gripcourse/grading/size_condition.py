"""Whether a size satisfies the condition of its choice, at the numbers that it is judged with."""

import math
from collections.abc import Callable, Mapping
from typing import SupportsFloat, TypeAlias

from gripcourse.course.quantity import Quantity
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.solver.numbers import PlainNumbers
from gripcourse.solver.plan import Plan
from gripcourse.solver.size_numbers import size_will_do

Satisfies: TypeAlias = Callable[[float], bool]
"""Tells whether a size, SI, satisfies the condition of its choice."""


def by_formulas(plan: Plan, quantity: Quantity, values: Mapping[str, SupportsFloat]) -> Satisfies:
    """Judge a size by what the formulas make of it; a condition that only checks, by the values.

    Args:
        plan: that the choice belongs to.
        quantity: the choice.
        values: SI, of what the condition and the way to it use.
    """
    condition = None if quantity.choice is None else quantity.choice.condition
    if condition is None:
        return lambda _: True
    if quantity.steps_up:
        known = {name: float(values[name]) for name in plan.step_ups[quantity.id].outside}
        return lambda size: size_will_do(plan, quantity, size, known)
    known = {name: float(values[name]) for name in condition.names if name != quantity.id}
    columns = plan.columns
    return lambda size: evaluate_number(condition, "", {**known, quantity.id: size}, columns) == 1.0


def conditions_at_own(
    plan: Plan, quantity: Quantity, numbers: PlainNumbers
) -> tuple[Satisfies, ...]:
    """Return the ways in which a size may satisfy a condition at a student's own numbers.

    Args:
        plan: that the choice belongs to.
        quantity: the choice.
        numbers: the student's, and what follows from them.
    """
    first = by_formulas(plan, quantity, numbers.values)
    return (first, _as_written(plan, quantity, numbers)) if quantity.steps_up else (first,)


def _as_written(plan: Plan, quantity: Quantity, numbers: PlainNumbers) -> Satisfies:
    """Judge a size by what the student wrote of what is computed from it.

    Who has computed twice the stress has done so for every size that was tried: what the formulas
    make of another size is taken in the proportion in which the written number stands to them.
    """
    known = {name: numbers.values[name] for name in plan.step_ups[quantity.id].outside}
    shares = {name: _share(plan, numbers, name) for name in plan.step_ups[quantity.id].between}
    return lambda size: size_will_do(plan, quantity, size, known, shares)


def _share(plan: Plan, numbers: PlainNumbers, name: str) -> float:
    """Return what a number is of the one that its formula gives; 1 where that says nothing."""
    written, computed = numbers.values[name], numbers.computed[name]
    share = written / computed if computed else math.nan
    return share if math.isfinite(share) and not plan.quantities[name].exact else 1.0
