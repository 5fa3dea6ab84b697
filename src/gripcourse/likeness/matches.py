"""Equal numbers among many, found by sorting, and how likely chance makes each.

Rows are submissions, columns quantities. Nothing here compares all with all: what is kept of equal
numbers is where their run begins and ends, which takes no more room than the numbers themselves.

Numbers of a large cohort stand in several tables, of which one is in memory at a time. How common a
number is among all is counted first; then each table is looked through for who has the same.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gripcourse.likeness.cells import Bits, Flags, Floats, Ints, SparseTable
from gripcourse.likeness.persons import RepeatedValues

_FIGURES = 3  # that a typed number has at least: a spreadsheet keeps 5,00 as 5
_OWN_ROUNDING = 0.002  # relative: what intermediate rounding moves a copied value off the exact one
_WIDEST_SPREAD = 0.5  # of the logarithm: wrong values spread at least so far
_SAME = 1e-9  # relative
_HITS_AT_ONCE = 100_000


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
class OrderedValues:
    """Numbers that others have, in the order of their size.

    Attributes:
        values: of owners (rows) and quantities (columns).
        begins: (quantities + 1,); where the numbers of each quantity begin in what follows.
        order: (cells,); places in `values` of one quantity's numbers after the other's, from the
            smallest up.
        known: (owners, bytes); which quantities each has a number of, a bit for each.
    """

    values: SparseTable
    begins: Ints
    order: Ints
    known: Bits

    def places(self, column: int) -> Ints:
        """Return where the numbers of a quantity are, from the smallest up."""
        return self.order[self.begins[column] : self.begins[column + 1]]

    def owner(self, place: Ints) -> Ints:
        """Return whose the numbers at some places in `values` are."""
        return self.values.key[place] // self.values.columns


@dataclass(frozen=True, slots=True)
class SoughtNumbers:
    """Numbers that others may have too.

    Attributes:
        column: quantity of each.
        value: of each, in the declared unit.
        reach: how far the same number may be.
    """

    column: Ints
    value: Floats
    reach: Floats

    @property
    def window(self) -> Floats:
        """Relative width in which each counts as the same."""
        return np.asarray(2 * (self.reach / np.abs(self.value)))

    def some(self, which: Flags) -> "SoughtNumbers":
        """Return some of them."""
        return SoughtNumbers(self.column[which], self.value[which], self.reach[which])

    def runs(self, others: OrderedValues) -> tuple[Ints, Ints]:
        """Return where the run of those that have the same begins in the order, and has ended."""
        begin, end = others.begins[self.column], others.begins[self.column + 1]
        first = _found(others, begin, end, self.value - self.reach, np.less) - begin
        after = _found(others, begin, end, self.value + self.reach, np.less_equal) - begin
        return first, after


@dataclass(frozen=True, slots=True)
class Matches:
    """For typed numbers the owners in one table that have the same: a run in the order of size.

    Attributes:
        sought: the numbers.
        others: the table.
        first, after: (numbers,); where the run begins, and where it has ended; nowhere for a number
            that was not looked for.
    """

    sought: SoughtNumbers
    others: OrderedValues
    first: Ints
    after: Ints

    @classmethod
    def of(cls, sought: SoughtNumbers, which: Flags, others: OrderedValues) -> "Matches":
        """Look for some of the numbers."""
        first, after = np.zeros((2, len(which)), dtype=np.intp)
        first[which], after[which] = sought.some(which).runs(others)
        return cls(sought, others, first, after)

    def owners(self, chosen: Ints) -> tuple[Ints, Ints]:
        """Return, for each hit of some numbers, the number and the owner."""
        count = self.after[chosen] - self.first[chosen]
        start = np.repeat(self.first[chosen] - np.concatenate(([0], np.cumsum(count)[:-1])), count)
        number = np.repeat(chosen, count)
        place = start + np.arange(len(number))
        begin = self.others.begins[self.sought.column[number]]
        return number, self.others.owner(self.others.order[begin + place]).astype(np.intp)

    def are_same(self, number: Ints, owner: Ints) -> Flags:
        """Tell of pairs of a number and an owner whether that owner has the same."""
        theirs = self.others.values.at(owner, self.sought.column[number])
        value, reach = self.sought.value[number], self.sought.reach[number]
        return (theirs >= value - reach) & (theirs <= value + reach)


def last_unit(value: Floats, half_unit: Floats) -> Floats:
    """Return one unit of the last typed digit, at most one of the third figure."""
    third = 10.0 ** (np.floor(np.log10(np.abs(value))) - (_FIGURES - 1))
    return np.minimum(2 * half_unit, third)


def in_order(values: SparseTable) -> OrderedValues:
    """Order the numbers of each quantity by size."""
    begins, order = values.by_column
    known = np.zeros((values.rows, -(-values.columns // 8)), dtype=np.uint8)
    for column, (begin, end) in enumerate(pairwise(begins.tolist())):
        mine = order[begin:end]
        known[values.key[mine] // values.columns, column // 8] |= 128 >> column % 8
        order[begin:end] = mine[np.argsort(values.value[mine], kind="stable")]
    return OrderedValues(values, begins, order, known)


def same_as_issued(numbers: ComparedNumbers, moved: float = _OWN_ROUNDING) -> SoughtNumbers:
    """Seek the variants whose right values numbers are.

    Args:
        numbers: what was typed.
        moved: relative; how far a taken number may be from the right one before it is typed, where
            that is more than one unit of its last digit.
    """
    reach = np.maximum(numbers.unit, moved * np.abs(numbers.value) + numbers.unit / 2)
    return SoughtNumbers(numbers.column, numbers.value, reach * (1 + _SAME))


def same_as_typed(numbers: ComparedNumbers, moved: float = 0.0) -> SoughtNumbers:
    """Seek the submissions in which the same was typed, but for rounding; its own is among them.

    Args:
        numbers: what was typed.
        moved: relative; how far a taken number may be from what the other typed.
    """
    reach = np.maximum(numbers.unit / 2, _SAME * np.abs(numbers.value))
    reach += moved * np.abs(numbers.value)
    return SoughtNumbers(numbers.column, numbers.value, reach * (1 + _SAME))


@dataclass(frozen=True, slots=True)
class Met:
    """How many of all owners have the same numbers.

    Attributes:
        same: of each portion of the numbers that were sought: (numbers,), who has the same.
        all: (quantities,); who has any number of a quantity.
    """

    same: tuple[Ints, ...]
    all: Ints

    def share(self, portion: int, sought: SoughtNumbers, but_for: int) -> Floats:
        """Return the part of all owners that have the same numbers.

        Args:
            portion: place of the numbers among the portions.
            sought: the numbers.
            but_for: how many of those who have the same do not count as others.
        """
        others = np.maximum(self.same[portion] - but_for, 0)
        return np.asarray(others / np.maximum(self.all[sought.column], 1))


def met(
    portions: Callable[[], Iterator[SoughtNumbers]],
    tables: Iterable[SparseTable],
    repeated: RepeatedValues | None = None,
) -> Met:
    """Count who has the same numbers.

    Args:
        portions: yields what is sought, the same each time.
        tables: of all owners, the one below the other.
        repeated: what owners of several rows have several numbers of; each of them counts once.
    """
    same = list[Ints]()
    everybody: Ints = np.zeros(0, dtype=np.intp)
    for table in tables:
        others = in_order(table)
        counts = others.begins[1:] - others.begins[:-1]
        everybody = everybody + counts if len(everybody) else counts
        for place, sought in enumerate(portions()):
            first, after = sought.runs(others)
            count: Ints = (after - first).astype(np.int32)
            if place < len(same):
                same[place] += count
            else:
                same.append(count)
    if repeated is not None:
        others = in_order(repeated.lower)
        everybody = everybody - (others.begins[1:] - others.begins[:-1])
        for place, sought in enumerate(portions()):
            same[place] -= _repetitions(sought, others, repeated.upper)
    return Met(tuple(same), everybody)


def _repetitions(sought: SoughtNumbers, lower: OrderedValues, upper: SparseTable) -> Ints:
    """Count for each number the pairs of one owner's numbers that are both the same as it."""
    first, after = sought.runs(lower)
    found, count = Matches(sought, lower, first, after), np.zeros(len(first), dtype=np.int32)
    portion = np.cumsum(after - first) // _HITS_AT_ONCE
    for chosen in np.split(np.arange(len(first)), np.flatnonzero(np.diff(portion)) + 1):
        number, row = found.owners(chosen)
        largest = sought.value[number] + sought.reach[number]
        both = upper.at(row, sought.column[number]) <= largest
        count += np.bincount(number[both], minlength=len(first)).astype(np.int32)
    return count


@dataclass(frozen=True, slots=True)
class Spread:
    """How the right values of all variants spread, by quantity, in logarithms of their sizes.

    Attributes:
        middle: (quantities,).
        width: (quantities,); not too narrow.
    """

    middle: Floats
    width: Floats

    @classmethod
    def of(cls, tables: Sequence[SparseTable]) -> "Spread":
        """Return how the numbers of each column of tables spread that stand one below the other."""
        count = max((table.columns for table in tables), default=0)
        numbers: Floats = np.zeros(count)
        sums: Floats = np.zeros(count)
        for column, logs in _logs(tables):
            numbers[column] += len(logs)
            sums[column] = _sum(logs, sums[column])
        of_each = np.maximum(numbers, 1)
        middle = sums / of_each
        squares: Floats = np.zeros(count)
        for column, logs in _logs(tables):
            squares[column] = _sum((logs - middle[column]) ** 2, squares[column])
        return cls(middle, np.maximum(np.sqrt(squares / of_each), _WIDEST_SPREAD))


def _logs(tables: Iterable[SparseTable]) -> Iterator[tuple[int, Floats]]:
    """Yield the logarithms of what stands in each column of each table, but for noughts."""
    for table in tables:
        begins, order = table.by_column
        for column, (begin, end) in enumerate(pairwise(begins.tolist())):
            sizes: Floats = np.abs(table.value[order[begin:end]])
            yield column, np.log(sizes[sizes != 0])


def density(numbers: ComparedNumbers, spread: Spread) -> Floats:
    """Return the probability that a wrong number falls near each, per relative width.

    Wrong numbers spread as the right ones of all variants do: log-normally, and not too narrowly.
    """
    wide = spread.width[numbers.column]
    away = (np.log(np.abs(numbers.value)) - spread.middle[numbers.column]) / wide
    result: Floats = np.exp(-(away**2) / 2) / (wide * math.sqrt(2 * math.pi))
    return result


def _sum(values: Floats, before: float) -> float:
    """Add numbers up one after the other: judgements must not hang on how they are parted."""
    return float(np.add.accumulate(np.concatenate(([before], values)))[-1])


def _found(
    others: OrderedValues, begin: Ints, end: Ints, value: Floats, is_before: np.ufunc
) -> Ints:
    """Return where each value's place is among some of the ordered, by one binary search of all.

    Args:
        others: the ordered.
        begin: (values,); where those among which each value is sought begin.
        end: (values,); where these have ended.
        value: what is sought.
        is_before: whether one of the ordered stands before the value's place.
    """
    order, values = others.order, others.values.value
    while (left := begin < end).any():
        middle = (begin + end) // 2
        # Where nothing is left, the place may be that after the last.
        before = is_before(values[order[np.where(left, middle, 0)]], value)
        begin = np.where(left & before, middle + 1, begin)
        end = np.where(left & ~before, middle, end)
    return begin
