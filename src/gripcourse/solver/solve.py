"""One pure function serves the solver, the grader, the diagnosis and what-if.

`evaluate(plan, known)`: a value in `known` replaces the formula's value for everything downstream.
All values are in SI; NaN means "not supplied" in `known` and "cannot be computed" in the result.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gripcourse.solver.columns import evaluate_columns
from gripcourse.solver.evaluation import Evaluation, Values
from gripcourse.solver.numbers import evaluate_numbers
from gripcourse.solver.plan import Plan
from gripcourse.text.units import factor

__all__ = ["Evaluation", "Values", "evaluate", "from_si", "solve_variant", "to_si"]

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


def _tidy(value: float) -> float:
    """Remove what floating point adds: 63 mm, not 63.00000000000001 mm, and 0°, not -2.6e-15°."""
    return 0.0 if abs(value) < _NOTHING else float(f"{value:.14g}")
