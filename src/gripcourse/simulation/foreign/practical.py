"""A second way to compute: the text of a formula, in millimetres, newtons and seconds.

It shares nothing with the engine's own: Python reads the text, single numbers go through it, in
units in which engineers compute (mm, N, MPa, t), and tables are searched row by row. So a fault of
the engine's arithmetic, or of its carrying on, is not a fault of these students too.
"""

import ast
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Final

from gripcourse.course.model import Catalogue, Course
from gripcourse.text.units import factor

Numbers = Mapping[str, float]

_POISSON: Final = 0.3
_CLOSE: Final = 1e-9  # relative: numbers that came by two routes
_SIZES: Final[Numbers] = {
    "": 1.0, "1": 1.0, "%": 1e-2, "permille": 1e-3,
    "mm": 1.0, "cm": 10.0, "dm": 100.0, "m": 1e3, "um": 1e-3, "inch": 25.4,
    "l": 1e6, "s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0, "Hz": 1.0, "kHz": 1e3,
    "kg": 1e-3, "g": 1e-6, "t": 1.0,
    "N": 1.0, "kN": 1e3, "daN": 10.0, "MN": 1e6, "mN": 1e-3, "kgf": 9.80665, "tf": 9806.65,
    "MPa": 1.0, "Pa": 1e-6, "kPa": 1e-3, "GPa": 1e3, "bar": 0.1, "mbar": 1e-4, "atm": 0.101325,
    "J": 1e3, "kJ": 1e6, "MJ": 1e9, "W": 1e3, "kW": 1e6, "MW": 1e9,
    "rad": 1.0, "deg": math.pi / 180, "gon": math.pi / 200, "rpm": math.pi / 30,
    "A": 1.0, "V": 1e3, "ohm": 1e3, "T": 1e-3, "K": 1.0, "degC": 1.0,
}  # fmt: skip


@cache
def size_of(unit: str) -> float:
    """Return the size of a unit in mm, N, s, A and K.

    Raises:
        KeyError: the unit is not known here.
    """
    if unit in _SIZES:
        return _SIZES[unit]
    return _size(ast.parse(unit, mode="eval").body)


def _size(node: ast.expr) -> float:
    match node:
        case ast.Name(name):
            return _SIZES[name]
        case ast.Constant(int(number)):
            return float(number)
        case ast.BinOp(left, ast.Mult(), right):
            return _size(left) * _size(right)
        case ast.BinOp(left, ast.Div(), right):
            return _size(left) / _size(right)
        case ast.BinOp(left, ast.Pow(), ast.Constant(int(power))):
            return float(_size(left) ** power)
        case _:
            raise KeyError(ast.unparse(node))


@dataclass(frozen=True, slots=True)
class PracticalTable:
    """A column of a catalogue in practical units: sizes, and the values that are read there."""

    sizes: tuple[float, ...]
    values: tuple[float, ...]


@cache
def tables_of(course: Course) -> Mapping[str, PracticalTable]:
    """Return the columns of a course's catalogues, by `catalogue.column`."""
    return {
        f"{catalogue.id}.{name}": PracticalTable(
            _printed(catalogue, next(iter(catalogue.columns))), _printed(catalogue, name)
        )
        for catalogue in course.catalogues.values()
        for name in catalogue.columns
    }


def _printed(catalogue: Catalogue, name: str) -> tuple[float, ...]:
    """Return a column as it is printed, in practical units."""
    unit = catalogue.units[name]
    printed = (float(f"{one / factor(unit):.12g}") for one in catalogue.columns[name])
    return tuple(one * size_of(unit) for one in printed)


@cache
def parsed(text: str) -> ast.expr:
    """Return the tree of a formula's text."""
    return ast.parse(" ".join(text.split()), mode="eval").body


def computed(tree: ast.expr, numbers: Numbers, tables: Mapping[str, PracticalTable]) -> float:
    """Compute a tree; NaN where it has no value.

    Args:
        tree: of a formula.
        numbers: by name, `pi` among them.
        tables: columns of catalogues.
    """
    try:
        found = _value(tree, numbers, tables)
    except (ArithmeticError, ValueError):
        return math.nan
    return found if math.isfinite(found) else math.nan


def _value(  # noqa: PLR0911 (one for each sort of node)
    node: ast.expr, numbers: Numbers, tables: Mapping[str, PracticalTable]
) -> float:
    def of(one: ast.expr) -> float:
        return _value(one, numbers, tables)

    match node:
        case ast.Constant(int() | float() as number):
            return float(number)
        case ast.Name(name):
            return numbers[name]
        case ast.UnaryOp(ast.USub(), operand):
            return -of(operand)
        case ast.BinOp(left, operator, right):
            return _calculated(operator, of(left), of(right))
        case ast.BoolOp(ast.And(), parts):
            return float(all(of(part) for part in parts))
        case ast.Compare(left, operators, others):
            values = [of(left), *map(of, others)]
            pairs = zip(operators, values[:-1], values[1:], strict=True)
            return float(all(_holds(sign, one, other) for sign, one, other in pairs))
        case ast.Call(ast.Name(name), [ast.Constant(str(column)), argument]):
            return _read(name, tables[column], of(argument))
        case ast.Call(ast.Name(name), arguments):
            return _FUNCTIONS[name](*map(of, arguments))
        case _:
            raise ValueError(ast.dump(node))


def _calculated(operator: ast.operator, one: float, other: float) -> float:
    match operator:
        case ast.Add():
            return one + other
        case ast.Sub():
            return one - other
        case ast.Mult():
            return one * other
        case ast.Div():
            return one / other
        case _:
            return math.pow(one, other)


def _holds(sign: ast.cmpop, one: float, other: float) -> bool:
    if math.isnan(one) or math.isnan(other):
        raise ValueError(sign)
    same = math.isclose(one, other, rel_tol=_CLOSE)
    match sign:
        case ast.Lt():
            return one < other and not same
        case ast.LtE():
            return one <= other or same
        case ast.Gt():
            return one > other and not same
        case ast.GtE():
            return one >= other or same
        case _:
            return same


def _read(name: str, table: PracticalTable, at: float) -> float:
    """Read a table; a name that ends in `_before` or `_after` reads the row beside the right one.

    Raises:
        ValueError: the table has no such row.
    """
    if math.isnan(at):
        return math.nan
    kind, _, side = name.partition("_row_")
    if kind == "interpolate" and not side:
        return _between(table, at)
    row = _row(kind, table, at) + {"": 0, "before": -1, "after": 1}[side]
    if not 0 <= row < len(table.sizes):
        raise ValueError(name)
    return (table.sizes if kind in {"at_least", "nearest"} else table.values)[row]


def _row(kind: str, table: PracticalTable, at: float) -> int:
    rows = range(len(table.sizes))
    if kind == "at_least":
        return next((row for row in rows if table.values[row] >= at * (1 - _CLOSE)), len(rows))
    if kind == "nearest":
        return min(rows, key=lambda row: abs(table.values[row] - at))
    if kind == "lookup":
        same = (row for row in rows if math.isclose(table.sizes[row], at, rel_tol=_CLOSE))
        return next(same, len(rows))
    return min(rows, key=lambda row: abs(table.sizes[row] - at))


def _between(table: PracticalTable, at: float) -> float:
    pairs = list(zip(table.sizes, table.values, strict=True))
    for (low, first), (high, second) in pairwise(pairs):
        slack = _CLOSE * abs(at)
        if low - slack <= at <= high + slack:
            return first + (second - first) * (at - low) / (high - low)
    raise ValueError(at)


def _angle(rise: float, run: float) -> float:
    if rise == run == 0:
        raise ValueError(rise)
    return math.atan2(rise, run)


def _hertz(ratio: float) -> float:
    """Return the coefficient of the pressure of crossed cylinders; K. L. Johnson, §4.2.

    The axes of the ellipse are found by halving, with the elliptic integrals of scipy.
    """
    from scipy.special import ellipe, ellipkm1  # noqa: PLC0415 (only where cylinders cross)

    wanted = max(ratio, 1 / ratio)
    low, high = 1e-4, 1.0 - 1e-7
    for _ in range(60):
        axes = (low + high) / 2
        first, second = float(ellipkm1(axes**2)), float(ellipe(1 - axes**2))
        if (second / axes**2 - first) / (first - second) > wanted:
            low = axes
        else:
            high = axes
    gap = (first - second) / (1 - axes**2)
    return math.cbrt(3 / (32 * math.pi * axes**3 * gap**2 * (1 - _POISSON**2) ** 2))


def _mean(*values: float) -> float:
    return math.fsum(values) / len(values)


def _extreme(take: Callable[[Sequence[float]], float]) -> Callable[..., float]:
    return lambda *values: math.nan if any(map(math.isnan, values)) else take(values)


_FUNCTIONS: Final[Mapping[str, Callable[..., float]]] = {
    "sqrt": math.sqrt, "cbrt": math.cbrt, "sin": math.sin, "cos": math.cos, "tan": math.tan,
    "asin": math.asin, "acos": math.acos, "atan": math.atan, "atan2": _angle, "abs": abs,
    "exp": math.exp, "log": math.log, "hypot": math.hypot, "min": _extreme(min),
    "max": _extreme(max), "mean": _mean, "hertz_crossed": _hertz,
    "exceeds": lambda one, other: float(one > other),
}  # fmt: skip
