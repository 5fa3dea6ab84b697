"""All numbers of all submissions side by side, and what explains each of them without copying."""

import math
from collections import Counter
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import ComparedNumbers, Floats, Ints, Matches, density, last_unit
from gripcourse.likeness.model import Chances, ComparedWork, Typed

_FILLER = 3  # unexplained cells with the same number: typed to fill them, not computed
_SAME_RATIO = 1e-3  # relative: as exactly as people type

Flags = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class ComparisonPool:
    """The numbers of a cohort.

    Attributes:
        students: of the submissions.
        own: row of each submission's student in the table of issued values.
        issued: that table.
        numbers: what was typed, by submission, then by quantity.
        explained: (numbers,); whether a number says nothing.
        slip: (numbers,); how common its slip is in the cohort; NaN where there is none.
    """

    students: tuple[str, ...]
    own: Ints
    issued: IssuedValues
    numbers: ComparedNumbers
    explained: Flags
    slip: Floats


def pool(works: Sequence[ComparedWork], issued: IssuedValues) -> ComparisonPool:
    """Put the numbers of submissions side by side; all students own a row of issued values."""
    rows = {student: row for row, student in enumerate(issued.owners)}
    columns = issued.columns
    kept = [
        (row, one)
        for row, work in enumerate(works)
        for one in sorted(
            (one for one in _without_filler(work.numbers) if _is_comparable(one, columns)),
            key=lambda one: columns[one.quantity],
        )
    ]
    typed = [one for _, one in kept]
    return ComparisonPool(
        students=tuple(work.student for work in works),
        own=np.array([rows[work.student] for work in works], dtype=np.intp),
        issued=issued,
        numbers=_numbers([row for row, _ in kept], typed, columns),
        explained=np.array([one.explained for one in typed], dtype=np.bool_),
        slip=_slip_shares(typed),
    )


def _is_comparable(one: Typed, columns: Container[str]) -> bool:
    """Tell whether a number can say anything: a nought is nobody's."""
    return one.quantity in columns and one.value != 0 and math.isfinite(one.value)


def _numbers(
    rows: Sequence[int], typed: Sequence[Typed], columns: Mapping[str, int]
) -> ComparedNumbers:
    value = np.array([one.value for one in typed], dtype=np.float64)
    half = np.array([one.half_unit for one in typed], dtype=np.float64)
    return ComparedNumbers(
        row=np.array(rows, dtype=np.intp),
        column=np.array([columns[one.quantity] for one in typed], dtype=np.intp),
        value=value,
        unit=last_unit(value, half),
    )


def chance_of(pooled: ComparisonPool, found: Matches, chances: Chances) -> Floats:
    """Return how likely each number meets a certain other one without copying.

    Returns:
        (numbers,); 1 for what is explained.
    """
    near = density(pooled.numbers, pooled.issued.values) * found.window
    wrong = np.maximum(np.maximum(near, found.share), chances.least)
    discrete = pooled.issued.discrete[pooled.numbers.column]
    wrong = np.where(discrete, np.maximum(wrong, chances.discrete), wrong)
    slip = np.maximum(pooled.slip, chances.slip)
    chance = np.where(np.isnan(slip), wrong, np.maximum(wrong, slip))
    result: Floats = np.where(pooled.explained, 1.0, np.minimum(chance, 1.0))
    return result


@dataclass(frozen=True, slots=True)
class SharedMethods:
    """How likely two students make the same mistake, where it gives them the same number.

    Attributes:
        pooled: the numbers.
        right: (numbers,); the right value of each, for its own student.
        likely: (numbers,); that another makes the same mistake.
    """

    pooled: ComparisonPool
    right: Floats
    likely: Floats

    def chance(self, number: Ints, owner: Ints) -> Floats:
        """Return it for pairs of a number and a submission; 0 where they would differ."""
        pooled = self.pooled
        theirs = pooled.issued.values[pooled.own[owner], pooled.numbers.column[number]]
        shared = np.isclose(self.right[number], theirs, rtol=1e-6, atol=0.0)
        return np.where(shared, self.likely[number], 0.0)


def shared_methods(pooled: ComparisonPool, chances: Chances) -> SharedMethods:
    """Find out how common each mistake is among those who answered its quantity."""
    numbers = pooled.numbers
    right = pooled.issued.values[pooled.own[numbers.row], numbers.column]
    with np.errstate(divide="ignore", invalid="ignore"):
        common = _commonness(numbers.column, numbers.value / right)
    return SharedMethods(pooled, right, np.maximum(common, chances.shared))


def _without_filler(numbers: Sequence[Typed]) -> Iterator[Typed]:
    wrong = Counter(one.value for one in numbers if not one.explained)
    return (one for one in numbers if one.explained or wrong[one.value] < _FILLER)


def _slip_shares(numbers: Sequence[Typed]) -> Floats:
    """Return which part of those who answered a quantity made the same slip; NaN for no slip."""
    answered = Counter(one.quantity for one in numbers)
    made = Counter((one.quantity, one.slip) for one in numbers)
    shares = [
        made[one.quantity, one.slip] / answered[one.quantity] if one.slip else math.nan
        for one in numbers
    ]
    return np.array(shares, dtype=np.float64)


def _commonness(column: Ints, ratio: Floats) -> Floats:
    """Return which part of a quantity's numbers is off by the same ratio, but for this one."""
    result = np.zeros(len(ratio))
    for one in np.unique(column):
        mine = np.flatnonzero((column == one) & np.isfinite(ratio))
        ordered = np.sort(ratio[mine])
        reach = np.abs(ratio[mine]) * _SAME_RATIO
        low = np.searchsorted(ordered, ratio[mine] - reach, "left")
        high = np.searchsorted(ordered, ratio[mine] + reach, "right")
        result[mine] = (high - low - 1) / max(len(mine), 1)
    return result
