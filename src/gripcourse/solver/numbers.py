"""The same calculation as `solve.evaluate` for one variant: plain numbers, no arrays.

An operation of numpy on a single number takes many times as long as the arithmetic itself, and a
work is judged by some thousand of them.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gripcourse.solver.evaluation import Evaluation
from gripcourse.solver.plan import Plan
from gripcourse.solver.steps import steps_of


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
    for step in steps_of(plan):
        number = computed[step.name] = step.number(values)
        if step.name in known:
            supplied = known[step.name]
            if not math.isnan(supplied):
                number = float(supplied) if math.isfinite(supplied) else math.nan
        values[step.name] = number
    return PlainNumbers(values, computed)
