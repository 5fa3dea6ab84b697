"""A plan made into functions, one for each quantity: computing asks no declaration again."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import cast

from gripcourse.course.compose import reference_formula
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import Array, array_function, number_function
from gripcourse.formula.tree import Formula
from gripcourse.solver.plan import Plan
from gripcourse.solver.size_numbers import choose_number
from gripcourse.solver.sizes import (
    choose,
    entry_of,
    reference_rounding,
    reference_steps_up,
)
from gripcourse.text.units import factor

OfNumbers = Callable[[Mapping[str, float]], float]
OfColumns = Callable[[Mapping[str, Array], Array | None], Array]


@dataclass(frozen=True, slots=True)
class Step:
    """How one quantity is computed.

    Attributes:
        name: its id.
        inputs: ids of what it is computed from; of a number that is declared, or given, none.
        number: computes it, in SI, from the numbers of its inputs: all finite or NaN.
    """

    name: str
    inputs: tuple[str, ...]
    number: OfNumbers


def steps_of(plan: Plan) -> tuple[Step, ...]:
    """Return the steps of a plan, inputs before what needs them; what a person does has none."""
    if "steps" not in plan.made:
        plan.made["steps"] = tuple(
            _step(plan, one) for one in plan.quantities.values() if one.kind is not Kind.MANUAL
        )
    return cast("tuple[Step, ...]", plan.made["steps"])


def column_functions(plan: Plan) -> Mapping[str, OfColumns]:
    """Return what computes each quantity that has inputs from arrays; see `array_function`."""
    if "columns" not in plan.made:
        plan.made["columns"] = {
            step.name: _of_columns(plan, plan.quantities[step.name], formula)
            for step in steps_of(plan)
            if (formula := plan.reference_formula(step.name)) is not None and step.inputs
        }
    return cast("Mapping[str, OfColumns]", plan.made["columns"])


def _step(plan: Plan, quantity: Quantity) -> Step:
    formula = reference_formula(quantity, plan.convention)
    if quantity.value is not None:
        return Step(quantity.id, (), _always(quantity.value * factor(quantity.unit)))
    if formula is None:
        return Step(quantity.id, (), _always(math.nan))
    compute = number_function(formula, quantity.unit, plan.columns)
    if quantity.choice is None:
        return Step(quantity.id, formula.names, compute)
    if reference_steps_up(quantity, plan.convention):
        return Step(
            quantity.id,
            plan.inputs[quantity.id],
            lambda values: choose_number(plan, quantity, compute(values), values),
        )
    entry = entry_of(quantity.choice.column, reference_rounding(quantity, plan.convention))
    taken = number_function(entry, "", plan.columns)
    return Step(quantity.id, formula.names, lambda values: taken({"required": compute(values)}))


def _always(number: float) -> OfNumbers:
    return lambda _values: number


def _of_columns(plan: Plan, quantity: Quantity, formula: Formula) -> OfColumns:
    compute = array_function(formula, quantity.unit, plan.columns)
    if quantity.choice is None:
        return compute
    if reference_steps_up(quantity, plan.convention):
        return lambda values, into: choose(plan, quantity, compute(values, into), values)
    entry = entry_of(quantity.choice.column, reference_rounding(quantity, plan.convention))
    taken = array_function(entry, "", plan.columns)
    return lambda values, into: taken({"required": compute(values, into)}, into)
