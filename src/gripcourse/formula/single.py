"""The functions of the formula language for single numbers, where their array form takes long.

Each gives the same bits as its record in `FUNCTIONS`. Roots and choices are exact anywhere; sines
and the like are numpy's here too, since the system's differ from them in the last place. None of
them makes numpy warn, so that nothing needs `errstate`.
"""

import math
from collections.abc import Callable, Mapping
from functools import reduce
from types import MappingProxyType
from typing import Final

import numpy as np

from gripcourse.formula.functions import SLACK, Column


def _root(value: float) -> float:
    return math.sqrt(value) if value >= 0 else math.nan


def _numpys(ufunc: np.ufunc) -> Callable[[float], float]:
    """Make a function of numpy that has a value at every number one of single numbers."""
    return lambda value: float(ufunc(value))


def _of_share(ufunc: np.ufunc) -> Callable[[float], float]:
    """Make an inverse of sine or cosine one of single numbers."""
    return lambda value: float(ufunc(value)) if -1 <= value <= 1 else math.nan


def _direction(rise: float, run: float) -> float:
    return float(np.arctan2(rise, run)) if rise or run else math.nan


def _lesser(one: float, other: float) -> float:
    return one if one < other or math.isnan(one) else other


def _greater(one: float, other: float) -> float:
    return one if one > other or math.isnan(one) else other


def _exceeds(one: float, other: float) -> float:
    return math.nan if math.isnan(one) or math.isnan(other) else float(one > other)


def _at_least(wanted: float, series: Column) -> float:
    if math.isnan(wanted):
        return math.nan
    row = int(series.values.searchsorted(wanted - SLACK * abs(wanted)))
    return float(series.sizes[row]) if row < series.sizes.size else math.nan


def _lookup(size: float, series: Column) -> float:
    if math.isnan(size):
        return math.nan
    order = series.sizes.argsort(kind="stable")
    place = int(series.sizes.searchsorted(size - SLACK * abs(size), sorter=order))
    row = order[min(place, order.size - 1)]
    found = abs(float(series.sizes[row]) - size) <= SLACK * abs(size)
    return float(series.values[row]) if found else math.nan


SINGLE: Final[Mapping[str, Callable[..., float]]] = MappingProxyType(
    {
        "sqrt": _root,
        "cbrt": _numpys(np.cbrt),
        "sin": _numpys(np.sin),
        "cos": _numpys(np.cos),
        "tan": _numpys(np.tan),
        "asin": _of_share(np.arcsin),
        "acos": _of_share(np.arccos),
        "atan": _numpys(np.arctan),
        "atan2": _direction,
        "abs": abs,
        "min": lambda *numbers: reduce(_lesser, numbers),
        "max": lambda *numbers: reduce(_greater, numbers),
        "exceeds": _exceeds,
        "at_least": _at_least,
        "lookup": _lookup,
    }
)
"""By name; the others (`exp`, `hypot`, ...) are rare, and their array form serves."""
