"""A calculation as a person does it: step by step, each from the numbers that stand before it."""

from collections.abc import Mapping
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.model import Kind, Quantity
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.tree import Call, Formula
from gripcourse.slips.model import Candidate
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import choose, reference_rounding
from gripcourse.units import factor
from gripcourse.virtual.arithmetic import Rounding, with_pi, written
from gripcourse.virtual.model import Behaviour, Carrying, Done

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Deviation:
    """What a student does otherwise than right at one quantity.

    Attributes:
        done: what it is.
        candidate: what is computed instead (a slip), or typed instead (a bare unit); else None.
        copied: the value that is taken over from somebody, in the declared unit; else NaN.
        cell: how that value stands in that somebody's cell.
    """

    done: Done
    candidate: Candidate | None = None
    copied: float = float("nan")
    cell: float | str | None = None


@dataclass(frozen=True, slots=True)
class Step:
    """One answered quantity, in its declared unit; NaN where there is no value.

    Attributes:
        right: what the right method gives with the student's numbers.
        value: what the student arrived at.
        typed: what the student writes into the workbook.
    """

    right: float
    value: float
    typed: float


@dataclass(frozen=True, slots=True)
class Calculation:
    """All steps of a student, and the numbers that the student went on with, in SI."""

    steps: Mapping[str, Step]
    values: Mapping[str, Array]


def calculate(
    plan: Plan,
    given: Mapping[str, float],
    behaviour: Behaviour,
    deviations: Mapping[str, Deviation],
) -> Calculation:
    """Compute a plan as one student does.

    Args:
        plan: what is computed.
        given: the issued values, in declared units.
        behaviour: figures, rounding, pi and constants of the student.
        deviations: what is done otherwise than right, by quantity.
    """
    values: dict[str, Array] = {}
    steps: dict[str, Step] = {}
    for name in _order(plan, deviations):
        quantity = plan.quantities[name]
        if quantity.kind is Kind.MANUAL:
            continue
        scale = factor(quantity.unit)
        if not quantity.kind.answered:
            known = behaviour.constants.get(name, quantity.value)
            values[name] = np.asarray(given[name] if known is None else known) * scale
            continue
        steps[name], carried = _step(plan, quantity, behaviour, values, deviations.get(name))
        values[name] = np.asarray(carried * scale)
    return Calculation(steps, values)


def by_formula(
    plan: Plan,
    quantity: Quantity,
    formula: Formula | None,
    values: Mapping[str, Array],
    behaviour: Behaviour,
) -> float:
    """Apply a formula to a student's numbers, in the declared unit; NaN where it has no value."""
    if formula is None:
        return float("nan")
    scale = factor(quantity.unit)
    nothing = np.asarray(np.nan)
    used = {name: values.get(name, nothing) for name in formula.names}
    result = evaluate(with_pi(formula, behaviour.pi), quantity.unit, used, plan.columns) / scale
    if quantity.choice is None:
        return float(result)
    required = _going_on_with(result, behaviour) * scale
    entry = choose(required, quantity.choice, reference_rounding(quantity, plan.convention), plan)
    return float(f"{float(entry) / scale:.12g}")


def _order(plan: Plan, deviations: Mapping[str, Deviation]) -> tuple[str, ...]:
    """Order the steps: a wrong method may need what the right one does not.

    Where it needs what only follows from it, it stays where it is and comes to nothing.
    """
    needed = dict(plan.inputs)
    for name, deviation in deviations.items():
        if deviation.candidate is not None:
            needed[name] = (*needed[name], *deviation.candidate.formula.names)
    try:
        return tuple(TopologicalSorter(needed).static_order())
    except CycleError:
        return tuple(plan.quantities)


def is_copied_from_a_table(quantity: Quantity) -> bool:
    """Tell whether a value is taken as it is printed: no figure of it is left out."""
    if quantity.kind in {Kind.CHOICE, Kind.VERDICT}:
        return True
    match quantity.formula:
        case Formula(tree=Call(function=name)):
            return quantity.kind is Kind.PICK and name != "interpolate"
    return False


def _step(
    plan: Plan,
    quantity: Quantity,
    behaviour: Behaviour,
    values: Mapping[str, Array],
    deviation: Deviation | None,
) -> tuple[Step, float]:
    """Return a step, and the value that the student goes on with, in the declared unit."""
    formula = plan.reference_formula(quantity.id)
    right = by_formula(plan, quantity, formula, values, behaviour)
    if deviation is None:
        return _ended(quantity, behaviour, right, right)
    instead = right
    if deviation.candidate is not None:
        instead = by_formula(plan, quantity, deviation.candidate.formula, values, behaviour)
    match deviation.done:
        case Done.SLIP:
            return _ended(quantity, behaviour, right, instead)
        case Done.ROUNDED_DOWN:
            return _ended(quantity, behaviour, right, _next_smaller(plan, quantity, right))
        case Done.COPIED:
            return Step(right, deviation.copied, deviation.copied), deviation.copied
        case Done.BARE_UNIT:
            # The student knows the right value and goes on with it.
            _, carried = _ended(quantity, behaviour, right, right)
            return Step(right, instead, _typed(quantity, instead, behaviour)), carried
        case _:
            return _ended(quantity, behaviour, right, right)


def _ended(
    quantity: Quantity, behaviour: Behaviour, right: float, value: float
) -> tuple[Step, float]:
    typed = _typed(quantity, value, behaviour)
    carried = value if behaviour.carrying is Carrying.CALCULATOR else typed
    return Step(right, value, typed), carried


def _typed(quantity: Quantity, value: float, behaviour: Behaviour) -> float:
    if is_copied_from_a_table(quantity):
        return value
    return float(written(value, behaviour.figures, behaviour.rounding))


def _going_on_with(value: Array, behaviour: Behaviour) -> Array:
    if behaviour.carrying is Carrying.CALCULATOR or behaviour.rounding is Rounding.FULL:
        return value
    return written(value, behaviour.figures, behaviour.rounding)


def _next_smaller(plan: Plan, quantity: Quantity, size: float) -> float:
    """Return the next smaller entry of a choice's series; NaN below the first."""
    if quantity.choice is None:
        return float("nan")
    entries = plan.columns[quantity.choice.column].sizes / factor(quantity.unit)
    below = entries[entries < size * (1 - 1e-6)]
    return float(f"{below.max():.12g}") if below.size else float("nan")
