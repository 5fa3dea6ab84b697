"""Compute a formula for one variant or for many at once.

Everything is in SI and every intermediate value is finite or NaN: what has no value (a root of a
negative number, a division by zero, an overflow, a catalogue without such an entry, an operand that
was not supplied) is NaN and stays NaN.

Comparisons give 1.0 or 0.0, and NaN where an operand is NaN. Numbers that differ by less than a
billionth (`functions.SLACK`) are the same number that came by two routes: 24.4 <= 24.4 holds
however each side was computed, and exactly one of `a < b` and `a >= b` holds.
"""

from collections.abc import Callable, Mapping
from typing import TypeAlias

import numpy as np

from gripcourse.formula.compiled import finite, is_finite, of_arrays, of_numbers
from gripcourse.formula.functions import Array, Column
from gripcourse.formula.tree import Formula
from gripcourse.text.units import factor

__all__ = [
    "Array", "Column", "array_function", "evaluate", "evaluate_number", "evaluate_sound", "finite",
    "is_finite", "number_function",
]  # fmt: skip

OfKnown: TypeAlias = Callable[[Mapping[str, float]], float]
IntoColumn: TypeAlias = Callable[[Mapping[str, Array], Array | None], Array]


def evaluate(
    formula: Formula, unit: str, values: Mapping[str, Array], columns: Mapping[str, Column]
) -> Array:
    """Compute a formula.

    Args:
        formula: an empirical one converts its names to its own units, and its result from `unit`.
        unit: of the quantity that the formula computes; only an empirical formula depends on it.
        values: of every name, in SI; arrays of one shape, or single numbers.
        columns: by `catalogue.column`, in SI.

    Returns:
        The result in SI, shaped as the values are together; NaN where there is none.
    """
    return evaluate_sound(
        formula,
        unit,
        {name: finite(np.asarray(values[name], np.float64)) for name in formula.names},
        columns,
    )


def evaluate_sound(
    formula: Formula, unit: str, values: Mapping[str, Array], columns: Mapping[str, Column]
) -> Array:
    """Compute a formula from float arrays that are finite or NaN already; see `evaluate`."""
    if all(values[name].ndim == 0 for name in formula.names):
        known = {name: float(values[name]) for name in formula.names}
        return np.asarray(evaluate_number(formula, unit, known, columns), np.float64)
    with np.errstate(all="ignore"):
        return np.asarray(array_function(formula, unit, columns)(values, None), np.float64)


def evaluate_number(
    formula: Formula, unit: str, values: Mapping[str, float], columns: Mapping[str, Column]
) -> float:
    """Compute a formula from single numbers that are finite or NaN already; see `evaluate`.

    It is what `evaluate_sound` gives for them, without making an array of each number.
    """
    if formula.units:
        return number_function(formula, unit, columns)(values)
    if "numbers" not in formula.made:
        formula.made["numbers"] = of_numbers(formula.tree)
    return float(formula.made["numbers"](values, columns))


def number_function(formula: Formula, unit: str, columns: Mapping[str, Column]) -> OfKnown:
    """Return what computes a formula from single numbers; see `evaluate_number`."""
    if "numbers" not in formula.made:
        formula.made["numbers"] = of_numbers(formula.tree)
    compute = formula.made["numbers"]
    if not formula.units:
        return lambda values: float(compute(values, columns))
    back, factors = factor(unit), _factors(formula)

    def computed(values: Mapping[str, float]) -> float:
        known = {name: values[name] / one for name, one in factors.items()}
        return float(compute(known, columns) * back)

    return computed


def array_function(formula: Formula, unit: str, columns: Mapping[str, Column]) -> IntoColumn:
    """Return what computes a formula from arrays that are finite or NaN already, not all single.

    Whoever calls it keeps numpy's warnings away. It may be given a column for the result, which
    need not be where the result is then.
    """
    if "arrays" not in formula.made:
        formula.made["arrays"] = of_arrays(formula.tree)
    compute = formula.made["arrays"]
    if not formula.units:
        return lambda values, into: compute(values, columns, into)
    back, factors = factor(unit), _factors(formula)

    def computed(values: Mapping[str, Array], into: Array | None) -> Array:
        known = {name: values[name] / one for name, one in factors.items()}
        return np.asarray(compute(known, columns, into) * back)

    return computed


def _factors(formula: Formula) -> dict[str, float]:
    return {name: factor(formula.units[name]) for name in formula.names}
