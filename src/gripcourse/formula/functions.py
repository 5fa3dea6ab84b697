"""The functions of the formula language.

A function is one record of `FUNCTIONS`: how it is computed, what it does to dimensions, how it is
printed and what a spreadsheet calls it. To add one, write its numpy form, choose or write a rule
(`rules`) and a printed form (`boxes`), and add the record; a spreadsheet form is not obligatory.

Where a function has no value (a root of a negative number, a catalogue without such an entry) its
numpy form gives NaN, and its spreadsheet form an error.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from types import MappingProxyType
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from gripcourse.formula import boxes, rules
from gripcourse.formula.hertz import crossed_cylinders
from gripcourse.formula.places import places
from gripcourse.formula.tree import Call, Node, Number

Array: TypeAlias = NDArray[np.float64]

SLACK: Final = 1e-9
"""Numbers that differ by less than this share are the same number that came by two routes."""


@dataclass(frozen=True, slots=True)
class Column:
    """A column of a catalogue, in SI: the sizes and, row by row, the values that are looked up."""

    sizes: Array
    values: Array


Compute: TypeAlias = Callable[[tuple[Array, ...], Column | None], Array]


@dataclass(frozen=True, slots=True)
class Function:
    """A function of the formula language.

    Attributes:
        name: as formulas call it.
        least: least number of arguments, not counting the column.
        most: greatest number of arguments.
        reads_column: whether its first argument is the text "catalogue.column".
        compute: from arrays in SI to an array in SI; NaN where it has no value.
        rule: what it does to dimensions.
        form: how it is printed.
        excel: spreadsheet form with places `{0}`, `{1}`, `{arguments}`, `{sizes}` and `{values}`;
            None where no spreadsheet can compute it.
        takes_entry: whether it gives what stands in a table, as it stands there: nobody rounds it.
    """

    name: str
    least: int
    most: int
    reads_column: bool
    compute: Compute
    rule: rules.Rule
    form: boxes.Form
    excel: str | None
    takes_entry: bool = False


def _of(function: Callable[..., Array]) -> Compute:
    """Make a numpy function of a fixed number of arrays computable."""

    def compute(arguments: tuple[Array, ...], _column: Column | None) -> Array:
        return function(*arguments)

    return compute


def _folded(function: Callable[[Array, Array], Array]) -> Compute:
    """Make a function of two arrays one of any number of arrays."""

    def compute(arguments: tuple[Array, ...], _column: Column | None) -> Array:
        return reduce(function, arguments)

    return compute


def _direction(rise: Array, run: Array) -> Array:
    """Return the angle of a direction, in rad; no direction has no angle."""
    return np.where((rise == 0) & (run == 0), np.nan, np.arctan2(rise, run))


def _exceeds(one: Array, other: Array) -> Array:
    """Return 1 where one number is above the other and 0 where it is not; NaN where one is NaN."""
    known = np.isfinite(one) & np.isfinite(other)
    return np.where(known, np.greater(one, other).astype(np.float64), np.nan)


def at_least(arguments: tuple[Array, ...], column: Column | None) -> Array:
    """Return the size of the first row whose value is not below the argument, NaN above the last.

    A value that is below the argument by less than `SLACK` counts as equal.
    """
    (wanted,), series = arguments, _needed(column)
    row = places(series.values, wanted - SLACK * np.abs(wanted))
    return _entry(series.sizes, row, np.isfinite(wanted) & (row < series.values.size))


def nearest(arguments: tuple[Array, ...], column: Column | None) -> Array:
    """Return the size of the row whose value is nearest; the lower where two are equally near."""
    (wanted,), series = arguments, _needed(column)
    above = np.clip(np.searchsorted(series.values, wanted), 0, series.values.size - 1)
    below = np.maximum(above - 1, 0)
    down = np.abs(wanted - series.values[below])
    up = np.abs(series.values[above] - wanted)
    row = np.where(down <= up + SLACK * np.abs(wanted), below, above)
    return _entry(series.sizes, row, np.isfinite(wanted))


def lookup(arguments: tuple[Array, ...], column: Column | None) -> Array:
    """Return the value of the first row whose size equals the argument within `SLACK`, else NaN."""
    (size,), series = arguments, _needed(column)
    order = np.argsort(series.sizes, kind="stable")
    slack = SLACK * np.abs(size)
    row = order.take(places(series.sizes[order], size - slack), mode="clip")
    return _entry(series.values, row, np.abs(series.sizes[row] - size) <= slack)


def interpolate(arguments: tuple[Array, ...], column: Column | None) -> Array:
    """Return the value at a size between two rows, on the straight line; NaN outside the table.

    The sizes must grow, which catalogues are checked for.
    """
    (size,), series = arguments, _needed(column)
    slack = SLACK * np.abs(size)
    inside = (size >= series.sizes[0] - slack) & (size <= series.sizes[-1] + slack)
    return np.where(inside, np.interp(size, series.sizes, series.values), np.nan)


def _entry(entries: Array, row: NDArray[np.intp], there: NDArray[np.bool_]) -> Array:
    """Take entries by row number, NaN where there is none."""
    taken = entries.take(row, mode="clip")
    return taken if there.all() else np.where(there, taken, np.nan)


def _needed(column: Column | None) -> Column:
    if column is None:
        raise TypeError("a catalogue function was called without its column")
    return column


def _one(
    name: str, ufunc: Callable[..., Array], rule: rules.Rule, form: boxes.Form, excel: str
) -> Function:
    """Declare a function of one number."""
    return Function(name, 1, 1, False, _of(ufunc), rule, form, excel)


_MANY: Final = 20
_SQUARE_ROOT: Final = rules.alike(Fraction(1, 2))
_CUBE_ROOT: Final = rules.alike(Fraction(1, 3))
_SAME: Final = rules.alike()
_ANGLE: Final = rules.alike(Fraction(0))

# SUMPRODUCT makes a spreadsheet work through whole columns without an array formula. INDEX fails,
# as it should, on the row after the last.
_AT_LEAST: Final = "INDEX({sizes},SUMPRODUCT(--({values}<({0})-ABS({0})*1E-9))+1)"
_NEAREST: Final = (
    "INDEX({sizes},SUMPRODUCT(--({values}<({0})-SUMPRODUCT(MIN(ABS({values}-({0}))))"
    "-ABS({0})*1E-9))+1)"
)
_LOOKUP: Final = "INDEX({values},SUMPRODUCT(MATCH(1,--(ABS({sizes}-({0}))<=ABS({0})*1E-9),0)))"

# The row above the size, at most the last but one; a size above the last row divides by zero.
_ROW: Final = "MIN(MATCH(({0})+ABS({0})*1E-9,{sizes},1),ROWS({sizes})-1)"
_INTERPOLATE: Final = (
    f"((INDEX({{values}},{_ROW})+(({{0}})-INDEX({{sizes}},{_ROW}))"
    f"*(INDEX({{values}},{_ROW}+1)-INDEX({{values}},{_ROW}))"
    f"/(INDEX({{sizes}},{_ROW}+1)-INDEX({{sizes}},{_ROW})))"
    "/IF(({0})-MAX({sizes})<=ABS({0})*1E-9,1,0))"
)

FUNCTIONS: Final[Mapping[str, Function]] = MappingProxyType(
    {
        function.name: function
        for function in (
            _one("sqrt", np.sqrt, _SQUARE_ROOT, boxes.root(""), "SQRT({0})"),
            # A spreadsheet has no real root of a negative number to a broken exponent.
            _one("cbrt", np.cbrt, _CUBE_ROOT, boxes.root("3"), "(SIGN({0})*ABS({0})^(1/3))"),
            _one("sin", np.sin, rules.plain, boxes.word("sin"), "SIN({0})"),
            _one("cos", np.cos, rules.plain, boxes.word("cos"), "COS({0})"),
            _one("tan", np.tan, rules.plain, boxes.word("tan", "tg"), "TAN({0})"),
            _one("asin", np.arcsin, rules.plain, boxes.word("arcsin"), "ASIN({0})"),
            _one("acos", np.arccos, rules.plain, boxes.word("arccos"), "ACOS({0})"),
            _one("atan", np.arctan, rules.plain, boxes.word("arctan", "arctg"), "ATAN({0})"),
            _one("abs", np.abs, _SAME, boxes.bars, "ABS({0})"),
            _one("exp", np.exp, rules.plain, boxes.word("exp"), "EXP({0})"),
            _one("log", np.log, rules.plain, boxes.word("ln"), "LN({0})"),
            # A spreadsheet names the run first and the rise second.
            Function(
                "atan2", 2, 2, False, _of(_direction), _ANGLE, boxes.word("atan2"), "ATAN2({1},{0})"
            ),
            Function(
                "hypot", 2, 2, False, _of(np.hypot), _SAME, boxes.hypotenuse, "SQRT(SUMSQ({0},{1}))"
            ),
            Function(
                "min", 2, _MANY, False, _folded(np.minimum), _SAME, boxes.word("min"),
                "MIN({arguments})",
            ),
            Function(
                "max", 2, _MANY, False, _folded(np.maximum), _SAME, boxes.word("max"),
                "MAX({arguments})",
            ),
            Function(
                "exceeds", 2, 2, False, _of(_exceeds), _ANGLE,
                boxes.word("exceeds", "превышает", uk="перевищує"),
                "IF({0}>{1},1,0)",
            ),
            Function(
                "at_least", 1, 1, True, at_least, rules.size_of_value,
                boxes.entry("≥", "min"), _AT_LEAST, takes_entry=True,
            ),
            Function(
                "nearest", 1, 1, True, nearest, rules.size_of_value,
                boxes.entry("≈", ""), _NEAREST, takes_entry=True,
            ),
            Function(
                "lookup", 1, 1, True, lookup, rules.value_of_size,
                boxes.reading, _LOOKUP, takes_entry=True,
            ),
            Function(
                "interpolate", 1, 1, True, interpolate, rules.value_of_size,
                boxes.reading, _INTERPOLATE,
            ),
            # No spreadsheet has elliptic integrals.
            Function(
                "hertz_crossed", 1, 1, False, _of(crossed_cylinders), rules.plain,
                boxes.called("Hertz"), None,
            ),
        )
    }
)  # fmt: skip


def is_entry(node: Node) -> bool:
    """Tell whether an expression is an entry of a table, and not a number computed from entries."""
    match node:
        case Call("min" | "max", arguments):
            return all(map(is_entry, arguments))
        case Call(function):
            return FUNCTIONS[function].takes_entry
        case Number():
            return True
        case _:
            return False
