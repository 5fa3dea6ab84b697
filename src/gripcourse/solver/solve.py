"""One pure function serves the solver, the grader, the diagnosis and what-if.

`evaluate(plan, known)`: a value in `known` replaces the formula's value for everything downstream.
All values are in SI; NaN means "not supplied" in `known` and "cannot be computed" in the result.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gripcourse.course.compose import reference_formula
from gripcourse.course.quantity import Choice, Quantity, Rounding
from gripcourse.formula.evaluate import evaluate_sound, finite
from gripcourse.solver.columns import evaluate_columns
from gripcourse.solver.evaluation import Evaluation, Values
from gripcourse.solver.numbers import evaluate_numbers
from gripcourse.solver.plan import Plan
from gripcourse.solver.steps import entry_of, reference_rounding
from gripcourse.text.units import factor

__all__ = [
    "Evaluation", "Values", "choose", "compute", "evaluate", "from_si", "reference_rounding",
    "solve_variant", "to_si",
]  # fmt: skip

_NOTHING = 1e-12  # of a declared unit: what is left where equal numbers were subtracted


def evaluate(plan: Plan, known: Mapping[str, ArrayLike]) -> Evaluation:
    """Compute every quantity of a plan, known values first.

    Args:
        plan: what is computed.
        known: SI values by id, scalars or arrays of one shape (n,); NaN where not supplied,
            infinite where supplied but no number: what needs it has no value. They must hold the
            givens, and may hold anything else.

    Returns:
        Values and computed values, each of shape () or (n,); NaN where an input is missing or
        outside a formula's domain.
    """
    supplied = {name: np.asarray(value, np.float64) for name, value in known.items()}
    if any(one.ndim for one in supplied.values()):
        return evaluate_columns(plan, supplied)
    return evaluate_numbers(plan, {name: float(one) for name, one in supplied.items()}).as_arrays()


def solve_variant(plan: Plan, given: Mapping[str, float]) -> dict[str, float]:
    """Compute one variant in declared units.

    Args:
        plan: what is computed.
        given: givens, and constants or decisions that differ, in declared units.

    Returns:
        The value of every quantity but the manual ones, in declared units; NaN where it cannot be
        computed.
    """
    return from_si(plan, evaluate_numbers(plan, to_si(plan, given)).values)


def to_si(plan: Plan, values: Mapping[str, float]) -> dict[str, float]:
    """Convert values by id from declared units to SI."""
    return {name: value * factor(plan.quantities[name].unit) for name, value in values.items()}


def from_si(plan: Plan, values: Mapping[str, NDArray[np.float64] | float]) -> dict[str, float]:
    """Convert single values by id from SI to declared units."""
    return {
        name: _tidy(float(value) / factor(plan.quantities[name].unit))
        for name, value in values.items()
    }


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
    if quantity.choice is None:
        return result
    return choose(result, quantity.choice, reference_rounding(quantity, plan.convention), plan)


def choose(
    required: NDArray[np.float64], choice: Choice, rounding: Rounding, plan: Plan
) -> NDArray[np.float64]:
    """Return the entry of a choice's series for a required value (SI, any shape)."""
    call = entry_of(choice.column, rounding)
    return evaluate_sound(call, "", {"required": finite(np.asarray(required))}, plan.columns)


def _tidy(value: float) -> float:
    """Remove what floating point adds: 63 mm, not 63.00000000000001 mm, and 0°, not -2.6e-15°."""
    return 0.0 if abs(value) < _NOTHING else float(f"{value:.14g}")
