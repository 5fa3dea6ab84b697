"""The same calculation as `solve.evaluate` for one variant: plain numbers, no arrays.

An operation of numpy on a single number takes many times as long as the arithmetic itself, and a
work is judged by some thousand of them.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gripcourse.course.compose import reference_formula
from gripcourse.course.quantity import Choice, Kind, Quantity, Rounding
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Evaluation, entry_of, reference_rounding
from gripcourse.text.units import factor


@dataclass(frozen=True, slots=True)
class PlainNumbers:
    """The values of a plan in SI, by id: finite or NaN. See `solve.Evaluation`."""

    values: Mapping[str, float]
    computed: Mapping[str, float]

    def as_arrays(self) -> Evaluation:
        """Return the same as arrays of shape ()."""
        return Evaluation(
            {name: np.asarray(value) for name, value in self.values.items()},
            {name: np.asarray(value) for name, value in self.computed.items()},
        )


def evaluate_numbers(plan: Plan, known: Mapping[str, float]) -> PlainNumbers:
    """Compute every quantity of a plan, known values first.

    Args:
        plan: what is computed.
        known: SI values by id; NaN where not supplied, infinite where supplied but no number.

    Returns:
        What `solve.evaluate` gives.
    """
    values: dict[str, float] = {}
    computed: dict[str, float] = {}
    for name, quantity in plan.quantities.items():
        if quantity.kind is Kind.MANUAL:
            continue
        number = computed[name] = _computed(plan, quantity, values)
        supplied = known.get(name, math.nan)
        if not math.isnan(supplied):
            number = float(supplied) if math.isfinite(supplied) else math.nan
        values[name] = number
    return PlainNumbers(values, computed)


def _computed(plan: Plan, quantity: Quantity, values: Mapping[str, float]) -> float:
    if quantity.value is not None:
        return quantity.value * factor(quantity.unit)
    formula = reference_formula(quantity, plan.convention)
    if formula is None:
        return math.nan
    result = evaluate_number(formula, quantity.unit, values, plan.columns)
    if quantity.choice is None:
        return result
    return choose_number(
        result, quantity.choice, reference_rounding(quantity, plan.convention), plan
    )


def choose_number(required: float, choice: Choice, rounding: Rounding, plan: Plan) -> float:
    """Return the entry of a choice's series for a required value in SI; see `solve.choose`."""
    known = {"required": required if math.isfinite(required) else math.nan}
    return evaluate_number(entry_of(choice.column, rounding), "", known, plan.columns)
