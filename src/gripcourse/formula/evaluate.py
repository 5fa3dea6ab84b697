"""Compute a formula for one variant or for many at once.

Everything is in SI and every intermediate value is finite or NaN: what has no value (a root of a
negative number, a division by zero, an overflow, a catalogue without such an entry, an operand that
was not supplied) is NaN and stays NaN.

Comparisons give 1.0 or 0.0, and NaN where an operand is NaN. Numbers that differ by less than a
billionth (`functions.SLACK`) are the same number that came by two routes: 24.4 <= 24.4 holds
however each side was computed, and exactly one of `a < b` and `a >= b` holds.
"""

from collections.abc import Mapping

import numpy as np

from gripcourse.formula.compiled import finite, of_arrays, of_numbers
from gripcourse.formula.functions import Array, Column
from gripcourse.formula.tree import Formula
from gripcourse.text.units import factor

__all__ = ["Array", "Column", "evaluate", "evaluate_number", "evaluate_sound", "finite"]


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
    used = {name: values[name] for name in formula.names}
    back = factor(unit) if formula.units else 1.0
    if all(value.ndim == 0 for value in used.values()):
        known = {name: float(value) for name, value in used.items()}
        if formula.units:
            known = {name: one / factor(formula.units[name]) for name, one in known.items()}
        if "numbers" not in formula.made:
            formula.made["numbers"] = of_numbers(formula.tree)
        return np.asarray(formula.made["numbers"](known, columns) * back, np.float64)
    if "arrays" not in formula.made:
        formula.made["arrays"] = of_arrays(formula.tree)
    with np.errstate(all="ignore"):
        if formula.units:
            used = {name: one / factor(formula.units[name]) for name, one in used.items()}
        result = formula.made["arrays"](used, columns)
        return np.asarray(result * back if formula.units else result, np.float64)


def evaluate_number(
    formula: Formula, unit: str, values: Mapping[str, float], columns: Mapping[str, Column]
) -> float:
    """Compute a formula from single numbers that are finite or NaN already; see `evaluate`.

    It is what `evaluate_sound` gives for them, without making an array of each number.
    """
    if "numbers" not in formula.made:
        formula.made["numbers"] = of_numbers(formula.tree)
    if not formula.units:
        return float(formula.made["numbers"](values, columns))
    known = {name: values[name] / factor(formula.units[name]) for name in formula.names}
    return float(formula.made["numbers"](known, columns) * factor(unit))
