"""A calculation as a person does it: step by step, each from the numbers that stand before it."""

from collections.abc import Mapping
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from gripcourse.course.quantity import Choice, Kind, Quantity
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.tree import Formula
from gripcourse.simulation.arithmetic import PI, Array, Hand, with_own_pi
from gripcourse.simulation.model import ActionKind
from gripcourse.slips.model import Candidate
from gripcourse.solver.plan import Plan
from gripcourse.solver.sizes import choose
from gripcourse.text.units import factor

# Of a declared unit: what floating point leaves where equal numbers were subtracted is written 0.
_NOTHING: Final = 1e-12


@dataclass(frozen=True, slots=True)
class Deviation:
    """What a student does otherwise than right at one quantity.

    Attributes:
        done: what it is.
        candidate: what is computed instead (a slip), or typed instead (a bare unit); else None.
        copied: the value that is taken over from somebody, in the declared unit; else NaN.
        cell: how that value stands in that somebody's cell.
    """

    done: ActionKind
    candidate: Candidate | None = None
    copied: float = float("nan")
    cell: float | str | None = None


@dataclass(frozen=True, slots=True)
class WorkedStep:
    """One answered quantity in its declared unit, shape (n,) or (); NaN where there is no value.

    Attributes:
        right: what the right method gives with the student's numbers.
        typed: what the student writes into the workbook.
    """

    right: Array
    typed: Array


@dataclass(frozen=True, slots=True)
class Calculation:
    """All steps of a student, and the numbers that the student went on with, in SI."""

    steps: Mapping[str, WorkedStep]
    values: Mapping[str, Array]


def calculate(
    plan: Plan, given: Mapping[str, ArrayLike], hand: Hand, deviations: Mapping[str, Deviation]
) -> Calculation:
    """Compute a plan as students do.

    Args:
        plan: what is computed.
        given: the issued values in declared units, shape (n,) or ().
        hand: how the students compute and write.
        deviations: what is done otherwise than right, by quantity.
    """
    values: dict[str, Array] = {PI: hand.pi}
    steps: dict[str, WorkedStep] = {}
    for name in _order(plan, deviations):
        quantity = plan.quantities[name]
        if quantity.kind is Kind.MANUAL:
            continue
        scale = factor(quantity.unit)
        if not quantity.kind.answered:
            taken = given[name] if quantity.value is None else quantity.value
            values[name] = np.asarray(hand.constants.get(name, taken)) * scale
            continue
        steps[name], carried = _step(plan, quantity, hand, values, deviations.get(name))
        values[name] = carried * scale
    return Calculation(steps, values)


def by_formula(
    plan: Plan, quantity: Quantity, formula: Formula | None, values: Mapping[str, Array], hand: Hand
) -> Array:
    """Apply a formula to students' numbers, in the declared unit; NaN where it has no value."""
    nothing = np.asarray(np.nan)
    if formula is None:
        return nothing
    scale = factor(quantity.unit)
    own = with_own_pi(formula)
    used = {name: values.get(name, nothing) for name in own.names}
    exact = evaluate(own, quantity.unit, used, plan.columns) / scale
    result = np.where(np.abs(exact) < _NOTHING, 0.0, exact)
    if quantity.choice is None:
        return result
    required = hand.going_on_with(result, hand.written(result)) * scale
    return choose(plan, quantity, required, values) / scale


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


def _step(
    plan: Plan,
    quantity: Quantity,
    hand: Hand,
    values: Mapping[str, Array],
    deviation: Deviation | None,
) -> tuple[WorkedStep, Array]:
    """Return a step, and the value that the students go on with, in the declared unit."""
    formula = plan.reference_formula(quantity.id)
    right = by_formula(plan, quantity, formula, values, hand)
    if deviation is None:
        return _ended(quantity, hand, right, right)
    instead = right
    if deviation.candidate is not None:
        instead = by_formula(plan, quantity, deviation.candidate.formula, values, hand)
    match deviation.done:
        case ActionKind.SLIP:
            return _ended(quantity, hand, right, instead)
        case ActionKind.ROUNDED_DOWN if quantity.choice is not None:
            smaller = _next_smaller(plan, quantity.choice, right * factor(quantity.unit))
            return _ended(quantity, hand, right, smaller / factor(quantity.unit))
        case ActionKind.COPIED:
            copied = np.asarray(deviation.copied)
            return WorkedStep(right, copied), copied
        case ActionKind.BARE_UNIT:
            # The student knows the right value and goes on with it.
            _, carried = _ended(quantity, hand, right, right)
            return WorkedStep(right, _typed(quantity, instead, hand)), carried
        case _:
            return _ended(quantity, hand, right, right)


def _ended(quantity: Quantity, hand: Hand, right: Array, value: Array) -> tuple[WorkedStep, Array]:
    typed = _typed(quantity, value, hand)
    return WorkedStep(right, typed), hand.going_on_with(value, typed)


def _typed(quantity: Quantity, value: Array, hand: Hand) -> Array:
    return value if quantity.exact else hand.written(value)


def _next_smaller(plan: Plan, choice: Choice, size: Array) -> Array:
    """Return the next smaller entry of a series, SI; NaN below the first."""
    entries = plan.columns[choice.column].sizes
    place = np.searchsorted(entries, size * (1 - 1e-6)) - 1
    return np.where(place >= 0, entries[np.maximum(place, 0)], np.nan)
