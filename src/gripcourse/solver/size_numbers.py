"""The same as `sizes` for one variant: plain numbers, no arrays."""

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from gripcourse.course.compose import reference_formula
from gripcourse.course.quantity import Choice, Quantity, Rounding
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.solver.plan import Plan
from gripcourse.solver.sizes import entry_of, reference_rounding, reference_steps_up
from gripcourse.text.units import factor

_AS_COMPUTED: Final[Mapping[str, float]] = MappingProxyType({})


def compute_number(plan: Plan, quantity: Quantity, values: Mapping[str, float]) -> float:
    """Compute one quantity at given values of its inputs; see `sizes.compute`."""
    if quantity.value is not None:
        return quantity.value * factor(quantity.unit)
    formula = reference_formula(quantity, plan.convention)
    if formula is None:
        return math.nan
    result = evaluate_number(formula, quantity.unit, values, plan.columns)
    return result if quantity.choice is None else choose_number(plan, quantity, result, values)


def choose_number(
    plan: Plan, quantity: Quantity, required: float, values: Mapping[str, float]
) -> float:
    """Return the size that the reference of a choice is; see `sizes.choose`."""
    if quantity.choice is None:
        return required
    rounding = reference_rounding(quantity, plan.convention)
    first = entry_number(plan, quantity.choice, rounding, required)
    if math.isnan(first) or not reference_steps_up(quantity, plan.convention):
        return first
    sizes = plan.columns[quantity.choice.column].sizes
    larger = sizes[sizes.searchsorted(first) :].tolist()
    sound = (one for one in larger if size_will_do(plan, quantity, one, values))
    return next(sound, math.nan)


def entry_number(plan: Plan, choice: Choice, rounding: Rounding, required: float) -> float:
    """Return the entry of a choice's series for a required value in SI; see `sizes.entry`."""
    known = {"required": required if math.isfinite(required) else math.nan}
    return evaluate_number(entry_of(choice.column, rounding), "", known, plan.columns)


def size_will_do(
    plan: Plan,
    quantity: Quantity,
    size: float,
    values: Mapping[str, float],
    shares: Mapping[str, float] = _AS_COMPUTED,
) -> bool:
    """Tell whether a size of a choice that steps up satisfies its condition; see `will_do`.

    Args:
        plan: that the choice belongs to.
        quantity: the choice.
        size: to be tried, SI.
        values: what the condition needs besides, SI, finite or NaN.
        shares: what is computed from the size counts as so many times what its formula gives.
    """
    if quantity.choice is None or quantity.choice.condition is None:
        return True
    trial = {**values, quantity.id: size}
    for name in plan.step_ups[quantity.id].between:
        computed = compute_number(plan, plan.quantities[name], trial)
        trial[name] = computed * shares.get(name, 1.0)
    return evaluate_number(quantity.choice.condition, "", trial, plan.columns) == 1.0
