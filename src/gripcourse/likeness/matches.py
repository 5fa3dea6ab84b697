"""Equal numbers among many, found by sorting, and how likely chance makes each.

Rows are submissions, columns quantities. Nothing here compares all with all.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

_FIGURES = 3  # that a typed number has at least: a spreadsheet keeps 5,00 as 5
_OWN_ROUNDING = 0.002  # relative: what intermediate rounding moves a copied value off the exact one
_WIDEST_SPREAD = 0.5  # of the logarithm: wrong values spread at least so far
_SAME = 1e-9  # relative

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class ComparedNumbers:
    """Typed numbers, one after another.

    Attributes:
        row: submission of each.
        column: quantity of each.
        value: in the declared unit; never zero.
        unit: of the last digit, of three figures at least.
    """

    row: Ints
    column: Ints
    value: Floats
    unit: Floats


@dataclass(frozen=True, slots=True)
class Matches:
    """Pairs of a number and an owner that has the same.

    Attributes:
        number: index of the number.
        owner: row of the owner.
        share: part of all owners of the quantity that have the same, but for those it is about.
        window: relative width in which a number counts as the same.
    """

    number: Ints
    owner: Ints
    share: Floats
    window: Floats


def last_unit(value: Floats, half_unit: Floats) -> Floats:
    """Return one unit of the last typed digit, at most one of the third figure."""
    third = 10.0 ** (np.floor(np.log10(np.abs(value))) - (_FIGURES - 1))
    return np.minimum(2 * half_unit, third)


def same_as_issued(
    numbers: ComparedNumbers, values: Floats, moved: float = _OWN_ROUNDING
) -> Matches:
    """Find the variants whose right values the numbers are.

    Args:
        numbers: to find.
        values: (owners, quantities), the right ones.
        moved: relative; how far a taken number may be from the right one, where that is more than
            one unit of its last digit.
    """
    reach = np.maximum(numbers.unit, moved * np.abs(numbers.value))
    return _matches(numbers, values, reach * (1 + _SAME), 1)


def same_as_typed(numbers: ComparedNumbers, rows: int, columns: int) -> Matches:
    """Find the submissions in which the same was typed, but for rounding."""
    values = np.full((rows, columns), math.nan)
    values[numbers.row, numbers.column] = numbers.value
    reach = np.maximum(numbers.unit / 2, _SAME * np.abs(numbers.value))
    found = _matches(numbers, values, reach * (1 + _SAME), 2)  # the pair itself
    other = numbers.row[found.number] != found.owner
    return Matches(
        *(part[other] for part in (found.number, found.owner, found.share, found.window))
    )


def density(numbers: ComparedNumbers, values: Floats) -> Floats:
    """Return the probability that a wrong number falls near each, per relative width.

    Wrong numbers spread as the right ones of all variants do: log-normally, and not too narrowly.
    """
    sizes = np.abs(np.where(values == 0, np.nan, values))
    with np.errstate(invalid="ignore"):
        logs = np.log(sizes)
    known = np.isfinite(logs)
    count = np.maximum(known.sum(axis=0), 1)
    middle = np.where(known, logs, 0).sum(axis=0) / count
    spread = np.sqrt((np.where(known, logs - middle, 0) ** 2).sum(axis=0) / count)
    wide = np.maximum(spread, _WIDEST_SPREAD)[numbers.column]
    away = (np.log(np.abs(numbers.value)) - middle[numbers.column]) / wide
    result: Floats = np.exp(-(away**2) / 2) / (wide * math.sqrt(2 * math.pi))
    return result


def _matches(numbers: ComparedNumbers, values: Floats, reach: Floats, apart: int) -> Matches:
    """Find for each number the rows of `values` within reach, by binary search.

    Args:
        numbers: to find.
        values: (owners, quantities).
        reach: (numbers,); how far a value may be.
        apart: how many of those found do not count as others.
    """
    found: list[tuple[Ints, Ints, Floats]] = []
    for column in np.unique(numbers.column):
        mine = np.flatnonzero(numbers.column == column)
        order = np.argsort(values[:, column], kind="stable")  # NaN last
        ordered = values[order, column]
        known = int(np.isfinite(ordered).sum())
        low = np.searchsorted(ordered[:known], numbers.value[mine] - reach[mine], "left")
        high = np.searchsorted(ordered[:known], numbers.value[mine] + reach[mine], "right")
        count = high - low
        first = np.repeat(low - np.concatenate(([0], np.cumsum(count)[:-1])), count)
        owner = order[first + np.arange(count.sum())]
        share = np.repeat(np.maximum(count - apart, 0) / max(known, 1), count)
        found.append((np.repeat(mine, count), owner, share))
    if not found:
        nothing = np.zeros(0, dtype=np.intp)
        return Matches(nothing, nothing, np.zeros(0), np.zeros(0))
    number, owner, share = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return Matches(number, owner, share, 2 * (reach / np.abs(numbers.value))[number])
