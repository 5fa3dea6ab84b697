"""Steps that were not written down: what leads to an answer through no number of the student's."""

from collections.abc import Iterator, Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Quantity
from gripcourse.formula.evaluate import evaluate_sound
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.shortened import EXACTLY, uses_constant, with_constants
from gripcourse.solver.evaluation import Values
from gripcourse.solver.plan import Plan
from gripcourse.solver.sizes import choose, compute

UNWRITTEN: Final = 0.5
"""A step in the head is left out less often than it is written down."""


def unwritten_before(comparison: Comparison) -> Iterator[str]:
    """Yield all that leads to an answer through no number of the student's."""
    waiting = list(comparison.plan.inputs[comparison.quantity.id])
    seen: set[str] = set()
    while waiting:
        name = waiting.pop()
        if name not in seen and name not in comparison.follow_through.known:
            seen.add(name)
            yield name
            waiting += comparison.plan.inputs[name]


def carried_here(
    comparison: Comparison,
    name: str,
    values: NDArray[np.float64],
    constants: Mapping[str, float] = EXACTLY,
) -> NDArray[np.float64]:
    """Return what this answer would be, SI, for each value of an earlier quantity.

    Only the steps between the two are computed again, which the student did not write down.

    Args:
        comparison: of the answer.
        name: id of the quantity.
        values: of it, SI.
        constants: what people shorten constants to, SI, by name: those steps are computed again
            that use them, and those that follow.
    """
    plan, evaluation = comparison.plan, comparison.follow_through.evaluation
    asked = comparison.quantity.id
    between = {*unwritten_before(comparison), asked}
    found = dict(evaluation.values)
    found[name] = np.where(np.isnan(values), evaluation.computed[name], values)
    changed = {name}
    for step, quantity in plan.quantities.items():
        if (
            step in between
            and step != name
            and (not changed.isdisjoint(plan.inputs[step]) or uses_constant(plan, step, constants))
        ):
            found[step] = _computed(plan, quantity, found, constants)
            changed.add(step)
        if step == asked:
            break
    here = found[asked] if asked in changed else evaluation.computed[asked]
    return np.broadcast_to(here, values.shape)


def _computed(
    plan: Plan, quantity: Quantity, found: Values, constants: Mapping[str, float]
) -> NDArray[np.float64]:
    """Compute one step, SI, with shortened constants."""
    formula = with_constants(plan, quantity.id, constants) if constants else None
    if formula is None:
        return compute(plan, quantity, found)
    result = evaluate_sound(formula, quantity.unit, found, plan.columns)
    return choose(plan, quantity, result, found)
