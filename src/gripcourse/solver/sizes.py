"""The sizes that choices take, for any number of variants at once."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.compose import reference_formula
from gripcourse.course.quantity import Choice, Convention, Quantity, Rounding
from gripcourse.formula.evaluate import evaluate_sound, finite
from gripcourse.formula.tree import Call, Formula, Name
from gripcourse.solver.evaluation import Values
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor

_SERIES = 256  # of catalogues, whose formulas are kept


def compute(plan: Plan, quantity: Quantity, values: Values) -> NDArray[np.float64]:
    """Compute one quantity at given values of its inputs.

    Args:
        plan: that the quantity belongs to.
        quantity: what is computed.
        values: SI values of its inputs, by id: finite or NaN.

    Returns:
        SI; NaN for a given number, which nothing computes.
    """
    if quantity.value is not None:
        return np.asarray(quantity.value * factor(quantity.unit))
    formula = reference_formula(quantity, plan.convention)
    if formula is None:
        return np.asarray(np.nan)
    result = evaluate_sound(formula, quantity.unit, values, plan.columns)
    return result if quantity.choice is None else choose(plan, quantity, result, values)


def choose(
    plan: Plan, quantity: Quantity, required: NDArray[np.float64], values: Values
) -> NDArray[np.float64]:
    """Return the size that the reference of a choice is for a required value.

    Args:
        plan: that the choice belongs to.
        quantity: the choice; without one the required value itself is returned.
        required: what the size must not be below, or be near to, SI, any shape.
        values: SI, finite or NaN; of what decides about a size where the choice steps up.

    Returns:
        SI; NaN where no size of the series will do.
    """
    if quantity.choice is None:
        return required
    first = entry(plan, quantity.choice, reference_rounding(quantity, plan.convention), required)
    if reference_steps_up(quantity, plan.convention):
        return _stepped_up(plan, quantity, first, values)
    return first


def entry(
    plan: Plan, choice: Choice, rounding: Rounding, required: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the entry of a choice's series for a required value (SI, any shape)."""
    call = entry_of(choice.column, rounding)
    return evaluate_sound(call, "", {"required": finite(np.asarray(required))}, plan.columns)


def _stepped_up(
    plan: Plan, quantity: Quantity, first: NDArray[np.float64], values: Values
) -> NDArray[np.float64]:
    """Go from the first size up to one that satisfies the condition; NaN where none does."""
    used = {name: values[name] for name in plan.step_ups[quantity.id].outside}
    shape = np.broadcast_shapes(first.shape, *(one.shape for one in used.values()))
    size = np.broadcast_to(first, shape).ravel().copy()
    known = {name: np.broadcast_to(finite(one), shape).ravel() for name, one in used.items()}
    waiting = np.flatnonzero(np.isfinite(size))
    while waiting.size:
        trial = {name: one[waiting] for name, one in known.items()}
        waiting = waiting[~will_do(plan, quantity, size[waiting], trial)]
        size[waiting] = _next_larger(plan, quantity, size[waiting])
        waiting = waiting[np.isfinite(size[waiting])]
    return size.reshape(shape)


def will_do(
    plan: Plan, quantity: Quantity, size: NDArray[np.float64], values: Values
) -> NDArray[np.bool_]:
    """Tell whether sizes of a choice that steps up satisfy its condition.

    Args:
        plan: that the choice belongs to.
        quantity: the choice.
        size: to be tried, SI.
        values: what the condition needs besides, and what is computed from the size needs; SI,
            finite or NaN. What it says of these themselves is not looked at.
    """
    if quantity.choice is None or quantity.choice.condition is None:
        return np.ones(size.shape, dtype=np.bool_)
    trial = way_to_condition(plan, quantity, size, values)
    met = evaluate_sound(quantity.choice.condition, "", trial, plan.columns)
    return np.broadcast_to(met == 1.0, size.shape)


def way_to_condition(
    plan: Plan, quantity: Quantity, size: NDArray[np.float64], values: Values
) -> dict[str, NDArray[np.float64]]:
    """Return all that the condition needs, SI: what is computed from sizes too; see `will_do`."""
    trial = {**values, quantity.id: size}
    for name in plan.step_ups[quantity.id].between:
        trial[name] = compute(plan, plan.quantities[name], trial)
    return trial


def _next_larger(plan: Plan, quantity: Quantity, size: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the next larger sizes of a choice's series; NaN above the last."""
    sizes = () if quantity.choice is None else plan.columns[quantity.choice.column].sizes
    larger = np.append(sizes, np.nan)
    return np.asarray(larger[np.searchsorted(larger[:-1], size, side="right")])


@lru_cache(maxsize=_SERIES)
def entry_of(column: str, rounding: Rounding) -> Formula:
    """Return the formula that takes an entry from a series; what is made of it stays with it."""
    function = "at_least" if rounding is Rounding.UP else "nearest"
    return Formula("", Call(function, (Name("required"),), column), {})


def reference_rounding(quantity: Quantity, convention: Convention) -> Rounding:
    """Return how a convention takes the entry of a choice from its series."""
    printed = [one.rounding for one in quantity.as_printed if one.rounding is not None]
    if convention is Convention.AS_PRINTED and printed:
        return printed[0]
    return quantity.choice.rounding if quantity.choice is not None else Rounding.UP


def reference_steps_up(quantity: Quantity, convention: Convention) -> bool:
    """Tell whether a convention takes a larger size where the first breaks its condition."""
    return quantity.steps_up and reference_rounding(quantity, convention) is Rounding.UP
