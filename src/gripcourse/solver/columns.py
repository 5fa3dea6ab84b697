"""The same calculation as `numbers.evaluate_numbers` for many variants: a column for a quantity.

What is the same for all variants is one number, of shape (), and computed once.
"""

import math
from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from gripcourse.formula.evaluate import Array, finite, is_finite
from gripcourse.solver.evaluation import Evaluation, Values
from gripcourse.solver.plan import Plan
from gripcourse.solver.steps import OfColumns, column_functions, steps_of

# Variants computed at once. Of fewer, calling numpy takes as long as computing; of more, what one
# operation wrote is no longer in the processor's cache when the next one reads it.
_TOGETHER = 65536


def evaluate_columns(plan: Plan, known: Values) -> Evaluation:
    """Compute every quantity of a plan, known values first; see `solve.evaluate`.

    Args:
        plan: what is computed.
        known: SI values by id, of shape () or of one other shape.
    """
    shape = next(one.shape for one in known.values() if one.ndim)
    values: dict[str, Array] = {}
    computed: dict[str, Array] = {}
    functions = column_functions(plan)
    blanks = {name: one for name, one in known.items() if one.ndim and not is_finite(one)}
    differing: set[str] = set()  # from variant to variant
    filled: list[str] = []
    for step in steps_of(plan):
        name = step.name
        if differing.isdisjoint(step.inputs):
            numbers = {one: float(values[one]) for one in step.inputs}
            computed[name] = np.asarray(step.number(numbers))
        else:
            computed[name] = np.empty(shape)
        if name in blanks:
            values[name] = np.empty(shape)
        else:
            values[name] = _settled(known.get(name), computed[name])
        if values[name].ndim:
            differing.add(name)
        if computed[name].ndim or name in blanks:
            filled.append(name)
    with np.errstate(all="ignore"):
        for rows in _blocks(shape[0]):
            part = Evaluation(_rows(values, rows), _rows(computed, rows))
            _fill(filled, functions, part, _rows(blanks, rows))
    return Evaluation(values, computed)


def _fill(
    names: Iterable[str], functions: Mapping[str, OfColumns], part: Evaluation, blanks: Values
) -> None:
    """Fill the columns of some of the variants, inputs before what needs them."""
    for name in names:
        into = part.computed[name]
        if into.ndim:
            result = functions[name](part.values, into)
            if result is not into:
                np.copyto(into, result)
        if name in blanks:
            own = blanks[name]
            np.copyto(part.values[name], finite(np.where(np.isnan(own), into, own)))


def _blocks(size: int) -> Iterator[slice | None]:
    """Yield which variants are computed together; None for all."""
    if size <= _TOGETHER:
        yield None
        return
    for start in range(0, size, _TOGETHER):
        yield slice(start, start + _TOGETHER)


def _rows(columns: Values, rows: slice | None) -> Values:
    """Take some of the variants; one number is that of all."""
    if rows is None:
        return columns
    return {name: one[rows] if one.ndim else one for name, one in columns.items()}


def _settled(known: Array | None, computed: Array) -> Array:
    """Return the values of a quantity that is known of all variants, or of none."""
    if known is None:
        return computed
    if known.ndim:
        return known
    if math.isnan(known):
        return computed
    number = finite(known)
    return np.full(computed.shape, number) if computed.ndim else number
