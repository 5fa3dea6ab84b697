"""A formula made into functions, once, so that computing does not walk its tree again and again.

There are two of them, which do the same: one for numpy arrays, one for single numbers, because an
operation of numpy on a single number takes fifty times as long as the arithmetic itself.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final, TypeAlias, assert_never

import numpy as np

from gripcourse.formula.functions import FUNCTIONS, SLACK, Array, Column
from gripcourse.formula.powers import power_of_arrays, power_of_numbers, raised
from gripcourse.formula.single import SINGLE
from gripcourse.formula.tree import Call, Name, Negation, Node, Number, Operation, Operator

Columns: TypeAlias = Mapping[str, Column]
OfArrays: TypeAlias = Callable[[Mapping[str, Array], Columns, Array | None], Array]
OfNumbers: TypeAlias = Callable[[Mapping[str, float], Columns], float]


# What these make of numbers is a number or NaN.
_NEVER_INFINITE: Final = frozenset(
    {"sqrt", "cbrt", "sin", "cos", "asin", "acos", "atan", "abs", "min", "max"}
)


def finite(value: Array) -> Array:
    """Make infinities NaN, so that none comes back as a number: arctan(1/0), 1/(1/0)."""
    if value.ndim == 0:  # a call of numpy on one number costs as much as on a thousand
        return value if math.isfinite(value) else np.asarray(np.nan)
    infinite = np.isinf(value)
    there_are = np.logical_or.reduce(infinite, axis=None)
    return np.where(infinite, np.nan, value) if there_are else value


def is_finite(value: Array) -> bool:
    """Tell whether all of an array are numbers."""
    return bool(np.logical_and.reduce(np.isfinite(value), axis=None))


def of_arrays(node: Node) -> OfArrays:
    """Make a function of arrays in SI, finite or NaN; so is what it returns.

    It may be given a column to put its result and what leads to it into; it need not use it.
    """
    return _sound(_part(node))


@dataclass(frozen=True, slots=True)
class _Factor:
    """A part of a formula of arrays.

    Attributes:
        compute: its function; the names' values are finite or NaN.
        overflows: whether infinities may come out of it. Sums and products keep them infinite or
            make them NaN, so that one look at the end of them is enough. Everything else must see
            NaN: 1 / infinity would be 0.
    """

    compute: OfArrays
    overflows: bool


def _part(node: Node) -> _Factor:
    match node:
        case Number(value):
            return _Factor(_constant(np.asarray(value)), overflows=False)
        case Name(id="pi"):
            return _Factor(_constant(np.asarray(np.pi)), overflows=False)
        case Name(name):
            return _Factor(lambda values, _columns, _into: values[name], overflows=False)
        case Negation(operand):
            inner = _part(operand)
            return _Factor(_negative(inner.compute), inner.overflows)
        case Operation():
            return _operation_part(node)
        case Call(name, arguments, column):
            call = _call(name, tuple(map(of_arrays, arguments)), column)
            return _Factor(call, overflows=name not in _NEVER_INFINITE)
        case _:
            assert_never(node)


def _operation_part(node: Operation) -> _Factor:
    match node:
        case Operation("+" | "-" | "*" as operator, left, right):
            first, second = _part(left).compute, _part(right).compute
            return _Factor(_arithmetic(_UFUNCS[operator], first, second), overflows=True)
        case Operation("/", left, right):
            first, second = _part(left).compute, of_arrays(right)
            return _Factor(_arithmetic(np.divide, first, second), overflows=True)
        case Operation("**", base, Number(exponent)) if exponent:
            # NaN to a power that is a number, and not 0, is NaN without our doing.
            return _Factor(_power_of(of_arrays(base), exponent), overflows=True)
        case Operation(operator, left, right):
            first, second = of_arrays(left), of_arrays(right)
            both = _operation(_OF_ARRAYS[operator], first, second)
            return _Factor(both, overflows=operator == "**")


def _sound(part: _Factor) -> OfArrays:
    """Make what comes out finite or NaN."""
    compute = part.compute
    if not part.overflows:
        return compute
    return lambda values, columns, into: finite(compute(values, columns, into))


def of_numbers(node: Node) -> OfNumbers:
    """Make a function of single numbers in SI, finite or NaN; so is what it returns."""
    part = _single(node)
    compute = part.compute
    if not part.overflows:
        return compute
    return lambda values, columns: _known(compute(values, columns))


@dataclass(frozen=True, slots=True)
class _Single:
    """A part of a formula of single numbers; see `_Factor`."""

    compute: OfNumbers
    overflows: bool


def _single(node: Node) -> _Single:
    match node:
        case Number(value):
            return _Single(lambda _values, _columns: value, overflows=False)
        case Name(id="pi"):
            return _Single(lambda _values, _columns: math.pi, overflows=False)
        case Name(name):
            return _Single(lambda values, _columns: values[name], overflows=False)
        case Negation(operand):
            inner = _single(operand)
            negated = inner.compute
            return _Single(lambda values, columns: -negated(values, columns), inner.overflows)
        case Operation():
            return _single_operation(node)
        case Call(name, arguments, column):
            call = _single_call(name, tuple(map(of_numbers, arguments)), column)
            return _Single(call, overflows=name not in _NEVER_INFINITE)
        case _:
            assert_never(node)


def _single_operation(node: Operation) -> _Single:
    match node:
        case Operation("+" | "-" | "*" as operator, left, right):
            first, second = _single(left).compute, _single(right).compute
            return _Single(_ARITHMETIC[operator](first, second), overflows=True)
        case Operation("/", left, right):
            return _Single(_quotient(_single(left).compute, of_numbers(right)), overflows=True)
        case Operation("**", base, Number(exponent)) if exponent:
            return _Single(_number_power_of(of_numbers(base), exponent), overflows=True)
        case Operation(operator, left, right):
            first, second = of_numbers(left), of_numbers(right)
            operation = _OF_NUMBERS[operator]
            return _Single(
                lambda values, columns: operation(first(values, columns), second(values, columns)),
                overflows=False,
            )


def _number_power_of(base: OfNumbers, exponent: float) -> OfNumbers:
    raised_to = power_of_numbers(exponent)
    return lambda values, columns: raised_to(base(values, columns))


def _sum(first: OfNumbers, second: OfNumbers) -> OfNumbers:
    return lambda values, columns: first(values, columns) + second(values, columns)


def _difference(first: OfNumbers, second: OfNumbers) -> OfNumbers:
    return lambda values, columns: first(values, columns) - second(values, columns)


def _product(first: OfNumbers, second: OfNumbers) -> OfNumbers:
    return lambda values, columns: first(values, columns) * second(values, columns)


def _quotient(first: OfNumbers, second: OfNumbers) -> OfNumbers:
    def quotient(values: Mapping[str, float], columns: Columns) -> float:
        divisor = second(values, columns)
        return first(values, columns) / divisor if divisor else math.nan

    return quotient


def _constant(value: Array) -> OfArrays:
    return lambda _values, _columns, _into: value


def _negative(operand: OfArrays) -> OfArrays:
    def negative(values: Mapping[str, Array], columns: Columns, into: Array | None) -> Array:
        value = operand(values, columns, into)
        return np.asarray(np.negative(value, into if value.ndim else None))

    return negative


def _arithmetic(operation: np.ufunc, left: OfArrays, right: OfArrays) -> OfArrays:
    """Make an operation of two parts; the first may lie where the result will."""

    def arithmetic(values: Mapping[str, Array], columns: Columns, into: Array | None) -> Array:
        first, second = left(values, columns, into), right(values, columns, None)
        result: Array = operation(first, second, into if first.ndim or second.ndim else None)
        return result

    return arithmetic


def _operation(
    operation: Callable[[Array, Array], Array], left: OfArrays, right: OfArrays
) -> OfArrays:
    return lambda values, columns, _into: operation(
        left(values, columns, None), right(values, columns, None)
    )


def _power_of(base: OfArrays, exponent: float) -> OfArrays:
    raised_to = power_of_arrays(exponent)
    return lambda values, columns, into: raised_to(base(values, columns, into))


def _call(name: str, arguments: tuple[OfArrays, ...], column: str | None) -> OfArrays:
    compute = FUNCTIONS[name].compute

    def call(values: Mapping[str, Array], columns: Columns, _into: Array | None) -> Array:
        found = tuple(one(values, columns, None) for one in arguments)
        return compute(found, None if column is None else columns[column])

    return call


def _single_call(name: str, arguments: tuple[OfNumbers, ...], column: str | None) -> OfNumbers:
    plain = SINGLE.get(name)
    if plain is None:
        return _lent_call(name, arguments, column)
    if column is not None:
        (argument,) = arguments
        return lambda values, columns: plain(argument(values, columns), columns[column])
    if len(arguments) == 1:
        (argument,) = arguments
        return lambda values, columns: plain(argument(values, columns))
    return lambda values, columns: plain(*(one(values, columns) for one in arguments))


def _lent_call(name: str, arguments: tuple[OfNumbers, ...], column: str | None) -> OfNumbers:
    """Make a function that has an array form only one of single numbers."""
    compute = FUNCTIONS[name].compute

    def call(values: Mapping[str, float], columns: Columns) -> float:
        found = tuple(np.asarray(one(values, columns)) for one in arguments)
        with np.errstate(all="ignore"):
            return float(compute(found, None if column is None else columns[column]))

    return call


def _known(value: float) -> float:
    return value if math.isfinite(value) else math.nan


def _power(base: Array, exponent: Array) -> Array:
    """Raise to a power; NaN stays NaN, where numpy makes NaN ** 0 and 1 ** NaN one."""
    known = ~(np.isnan(base) | np.isnan(exponent))
    return np.where(known, np.power(base, exponent), np.nan)


def _number_power(base: float, exponent: float) -> float:
    if math.isnan(base) or math.isnan(exponent):
        return math.nan
    return _known(raised(base, exponent))


def _at_most(left: Array, right: Array) -> Array:
    bound = right + SLACK * np.maximum(np.abs(left), np.abs(right))
    holds, unknown = np.asarray(left <= bound, np.float64), np.isnan(bound)
    return np.where(unknown, np.nan, holds) if unknown.any() else holds


def _number_at_most(left: float, right: float) -> float:
    if math.isnan(left) or math.isnan(right):
        return math.nan
    return float(left <= right + SLACK * max(abs(left), abs(right)))


_UFUNCS: Final = {"+": np.add, "-": np.subtract, "*": np.multiply}
_OF_ARRAYS: Final[Mapping[Operator, Callable[[Array, Array], Array]]] = {
    "**": _power,
    "<": lambda left, right: 1.0 - _at_most(right, left),
    "<=": _at_most,
    ">": lambda left, right: 1.0 - _at_most(left, right),
    ">=": lambda left, right: _at_most(right, left),
    "==": lambda left, right: _at_most(left, right) * _at_most(right, left),
    "and": np.multiply,
}
_ARITHMETIC: Final[Mapping[Operator, Callable[[OfNumbers, OfNumbers], OfNumbers]]] = {
    "+": _sum,
    "-": _difference,
    "*": _product,
}
_OF_NUMBERS: Final[Mapping[Operator, Callable[[float, float], float]]] = {
    "**": _number_power,
    "<": lambda left, right: 1.0 - _number_at_most(right, left),
    "<=": _number_at_most,
    ">": lambda left, right: 1.0 - _number_at_most(left, right),
    ">=": lambda left, right: _number_at_most(right, left),
    "==": lambda left, right: _number_at_most(left, right) * _number_at_most(right, left),
    "and": lambda left, right: left * right,
}
