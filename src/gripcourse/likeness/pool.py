"""All numbers of all submissions side by side, and what explains each of them without copying."""

import math
from array import array
from collections import Counter
from collections.abc import Container, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.cells import Floats, Ints
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import ComparedNumbers, Matches, Spread, density, last_unit
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
        spread: of its values.
        numbers: what was typed, by submission, then by quantity.
        explained: (numbers,); whether a number says nothing.
        slip: (numbers,); how common its slip is in the cohort; NaN where there is none.
    """

    students: tuple[str, ...]
    own: Ints
    issued: IssuedValues
    spread: Spread
    numbers: ComparedNumbers
    explained: Flags
    slip: Floats

    def part(self, which: slice) -> "ComparisonPool":
        """Return the same students with some of the numbers."""
        return replace(
            self,
            numbers=self.numbers.part(which),
            explained=self.explained[which],
            slip=self.slip[which],
        )


def pool(works: Iterable[ComparedWork], issued: IssuedValues) -> ComparisonPool:
    """Put the numbers of submissions side by side; all students own a row of issued values.

    Each is looked into once: a number is some two hundred bytes as an object, and forty here.
    """
    rows = {student: row for row, student in enumerate(issued.owners)}
    columns = issued.columns
    students: list[str] = []
    slips: dict[object, int] = {}
    wholes, reals = array("i"), array("d")
    for row, work in enumerate(works):
        students.append(work.student)
        for one in sorted(
            (one for one in _without_filler(work.numbers) if _is_comparable(one, columns)),
            key=lambda one: columns[one.quantity],
        ):
            slip = slips.setdefault((one.quantity, one.slip), len(slips)) if one.slip else -1
            wholes.extend((row, columns[one.quantity], one.explained, slip))
            reals.extend((one.value, one.half_unit))
    # Looked at as they lie there: a copy would take as much room again.
    of_row, column, explained, slip_of = np.frombuffer(wholes, np.int32).reshape(-1, 4).T
    value, half = np.frombuffer(reals).reshape(-1, 2).T
    return ComparisonPool(
        students=tuple(students),
        own=np.array([rows[student] for student in students], dtype=np.intp),
        issued=issued,
        spread=Spread.of(issued.values),
        numbers=ComparedNumbers(
            row=of_row,
            column=column,
            value=value,
            unit=last_unit(value, half),
        ),
        explained=explained != 0,
        slip=_slip_shares(column, slip_of),
    )


def _is_comparable(one: Typed, columns: Container[str]) -> bool:
    """Tell whether a number can say anything: a nought is nobody's."""
    return one.quantity in columns and one.value != 0 and math.isfinite(one.value)


def chance_of(pooled: ComparisonPool, found: Matches, chances: Chances) -> Floats:
    """Return how likely each number meets a certain other one without copying.

    Returns:
        (numbers,); 1 for what is explained.
    """
    near = density(pooled.numbers, pooled.spread) * found.window
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
        likely: (numbers,); that another makes the same mistake.
    """

    pooled: ComparisonPool
    likely: Floats

    def part(self, which: slice) -> "SharedMethods":
        """Return the same for some of the numbers."""
        return SharedMethods(self.pooled.part(which), self.likely[which])

    def chance(self, number: Ints, owner: Ints) -> Floats:
        """Return it for pairs of a number and a submission; 0 where they would differ."""
        pooled, values = self.pooled, self.pooled.issued.values
        column = pooled.numbers.column[number]
        right = values.at(pooled.own[pooled.numbers.row[number]], column)
        theirs = values.at(pooled.own[owner], column)
        shared = np.isclose(right, theirs, rtol=1e-6, atol=0.0)
        return np.where(shared, self.likely[number], 0.0)


def shared_methods(pooled: ComparisonPool, chances: Chances) -> SharedMethods:
    """Find out how common each mistake is among those who answered its quantity."""
    numbers = pooled.numbers
    right = pooled.issued.values.at(pooled.own[numbers.row], numbers.column)
    with np.errstate(divide="ignore", invalid="ignore"):
        common = _commonness(numbers.column, numbers.value / right)
    return SharedMethods(pooled, np.maximum(common, chances.shared))


def _without_filler(numbers: Sequence[Typed]) -> Iterator[Typed]:
    wrong = Counter(one.value for one in numbers if not one.explained)
    return (one for one in numbers if one.explained or wrong[one.value] < _FILLER)


def _slip_shares(column: Ints, slip: Ints) -> Floats:
    """Return which part of those who answered a quantity made the same slip; NaN for no slip.

    Args:
        column: (numbers,); the quantity of each.
        slip: (numbers,); each one of a quantity has its own number; −1 for none.
    """
    made = np.bincount(slip + 1)[slip + 1]
    return np.where(slip >= 0, made / np.bincount(column)[column], math.nan)


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
