"""Steps that were not written down: what leads to an answer through no number of the student's."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from gripcourse.grading.comparison import Comparison
from gripcourse.solver.sizes import compute


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
    comparison: Comparison, name: str, values: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return what this answer would be, SI, for each value of an earlier quantity.

    Only the steps between the two are computed again, which the student did not write down.
    """
    plan, evaluation = comparison.plan, comparison.follow_through.evaluation
    asked = comparison.quantity.id
    between = {*unwritten_before(comparison), asked}
    found = dict(evaluation.values)
    found[name] = np.where(np.isnan(values), evaluation.computed[name], values)
    changed = {name}
    for step, quantity in plan.quantities.items():
        if step in between and step != name and not changed.isdisjoint(plan.inputs[step]):
            found[step] = compute(plan, quantity, found)
            changed.add(step)
        if step == asked:
            break
    here = found[asked] if asked in changed else evaluation.computed[asked]
    return np.broadcast_to(here, values.shape)
