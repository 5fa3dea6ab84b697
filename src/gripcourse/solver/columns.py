"""The same calculation as `numbers.evaluate_numbers` for many variants: a column for a quantity.

What is the same for all variants is one number, of shape (), and computed once.
"""

import math
from collections.abc import Mapping

import numpy as np

from gripcourse.formula.evaluate import Array, finite
from gripcourse.solver.evaluation import Evaluation, Values
from gripcourse.solver.plan import Plan
from gripcourse.solver.steps import OfColumns, column_functions, steps_of

_TOGETHER = 16384  # variants computed at once: their columns stay in the processor's cache


def evaluate_columns(plan: Plan, known: Values) -> Evaluation:
    """Compute every quantity of a plan, known values first; see `solve.evaluate`.

    Args:
        plan: what is computed.
        known: SI values by id, of shape () or of one other shape.
    """
    shape = next(one.shape for one in known.values() if one.ndim)
    values: dict[str, Array] = {}
    computed: dict[str, Array] = {}
    differing: dict[str, OfColumns] = {}
    for step in steps_of(plan):
        name = step.name
        if all(values[one].ndim == 0 for one in step.inputs):
            numbers = {one: float(values[one]) for one in step.inputs}
            computed[name] = np.asarray(step.number(numbers))
        else:
            computed[name] = np.empty(shape)
            differing[name] = column_functions(plan)[name]
        values[name] = _values(known[name], computed[name]) if name in known else computed[name]
    blanks = {name: one for name, one in known.items() if _has_blanks(one)}
    with np.errstate(all="ignore"):
        for start in range(0, shape[0], _TOGETHER):
            rows = slice(start, start + _TOGETHER)
            part = Evaluation(_rows(values, rows), _rows(computed, rows))
            _compute(differing, part, _rows(blanks, rows))
    return Evaluation(values, computed)


def _compute(differing: Mapping[str, OfColumns], part: Evaluation, blanks: Values) -> None:
    """Fill the columns of some of the variants, inputs before what needs them."""
    for name, value in part.values.items():
        into = part.computed[name]
        if name in differing:
            result = differing[name](part.values, into)
            if result is not into:
                np.copyto(into, result)
        if name in blanks:
            own = blanks[name]
            np.copyto(value, finite(np.where(np.isnan(own), into, own)))


def _rows(columns: Values, rows: slice) -> dict[str, Array]:
    """Take some of the variants; one number is that of all."""
    return {name: one[rows] if one.ndim else one for name, one in columns.items()}


def _values(known: Array, computed: Array) -> Array:
    """Return what holds the values of a quantity that is known of some or all variants.

    It is finite or NaN, and filled later where something is known of some variants only.
    """
    if known.ndim:
        return np.empty(known.shape) if _has_blanks(known) else known
    if math.isnan(known):
        return computed
    number = finite(known)
    return np.full(computed.shape, number) if computed.ndim else number


def _has_blanks(known: Array) -> bool:
    """Tell whether some variants lack a number that others have."""
    return bool(known.ndim) and not np.isfinite(known).all()
