"""Compute a formula for one variant or for many at once.

Everything is in SI and every intermediate value is finite or NaN: what has no value (a root of a
negative number, a division by zero, an overflow, a catalogue without such an entry, an operand that
was not supplied) is NaN and stays NaN.

Comparisons give 1.0 or 0.0, and NaN where an operand is NaN. Numbers that differ by less than a
billionth (`functions.SLACK`) are the same number that came by two routes: 24.4 <= 24.4 holds
however each side was computed, and exactly one of `a < b` and `a >= b` holds.
"""

from collections.abc import Callable, Mapping
from typing import Final, assert_never

import numpy as np

from gripcourse.formula.functions import FUNCTIONS, SLACK, Array, Column
from gripcourse.formula.tree import (
    Call,
    Formula,
    Name,
    Negation,
    Node,
    Number,
    Operation,
    Operator,
)
from gripcourse.text.units import factor

__all__ = ["Array", "Column", "evaluate"]


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
    with np.errstate(all="ignore"):
        used = {name: _finite(np.asarray(values[name], np.float64)) for name in formula.names}
        if formula.units:
            scaled = {name: value / factor(formula.units[name]) for name, value in used.items()}
            result = _value(formula.tree, scaled, columns) * factor(unit)
        else:
            result = _value(formula.tree, used, columns)
    return np.asarray(result, np.float64)


def _value(node: Node, values: Mapping[str, Array], columns: Mapping[str, Column]) -> Array:
    """Compute a node; finite or NaN."""
    match node:
        case Number(value):
            return np.asarray(value)
        case Name(id="pi"):
            return np.asarray(np.pi)
        case Name(name):
            return values[name]
        case Negation(operand):
            return np.negative(_value(operand, values, columns))
        case Operation(operator, left, right):
            operation = _OPERATIONS[operator]
            return _finite(operation(_value(left, values, columns), _value(right, values, columns)))
        case Call(name, arguments, column):
            found = tuple(_value(argument, values, columns) for argument in arguments)
            series = None if column is None else columns[column]
            return _finite(FUNCTIONS[name].compute(found, series))
        case _:
            assert_never(node)


def _finite(value: Array) -> Array:
    """Make infinities NaN, so that none comes back as a number: arctan(1/0), 1/(1/0)."""
    finite = np.isfinite(value)
    return value if finite.all() else np.where(finite, value, np.nan)


def _power(base: Array, exponent: Array) -> Array:
    """Raise to a power; NaN stays NaN, where numpy makes NaN ** 0 and 1 ** NaN one."""
    known = ~(np.isnan(base) | np.isnan(exponent))
    return np.where(known, np.power(base, exponent), np.nan)


def _slack(left: Array, right: Array) -> Array:
    return SLACK * np.maximum(np.abs(left), np.abs(right))


def _verdict(left: Array, right: Array, holds: Array) -> Array:
    return np.where(np.isnan(left) | np.isnan(right), np.nan, holds)


def _at_most(left: Array, right: Array) -> Array:
    return _verdict(left, right, np.asarray(left <= right + _slack(left, right), np.float64))


def _at_least(left: Array, right: Array) -> Array:
    return _at_most(right, left)


def _below(left: Array, right: Array) -> Array:
    return 1.0 - _at_most(right, left)


def _above(left: Array, right: Array) -> Array:
    return 1.0 - _at_most(left, right)


def _equal(left: Array, right: Array) -> Array:
    return _at_most(left, right) * _at_most(right, left)


_OPERATIONS: Final[Mapping[Operator, Callable[[Array, Array], Array]]] = {
    "+": np.add,
    "-": np.subtract,
    "*": np.multiply,
    "/": np.divide,
    "**": _power,
    "<": _below,
    "<=": _at_most,
    ">": _above,
    ">=": _at_least,
    "==": _equal,
    "and": np.multiply,
}
