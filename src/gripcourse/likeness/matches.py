"""Equal numbers among many, found by sorting, and how likely chance makes each.

Rows are submissions, columns quantities. Nothing here compares all with all: what is kept of equal
numbers is where their run begins and ends, which takes no more room than the numbers themselves.
"""

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gripcourse.likeness.cells import Bits, Flags, Floats, Ints, SparseTable

_FIGURES = 3  # that a typed number has at least: a spreadsheet keeps 5,00 as 5
_OWN_ROUNDING = 0.002  # relative: what intermediate rounding moves a copied value off the exact one
_WIDEST_SPREAD = 0.5  # of the logarithm: wrong values spread at least so far
_SAME = 1e-9  # relative


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
class Matches:
    """For typed numbers the owners that have the same: a run of them in the order of size.

    Attributes:
        numbers: what was typed.
        others: where it was looked for.
        reach: (numbers,); how far the same number may be.
        first, after: (numbers,); where the run begins, and where it has ended; nowhere for a number
            that was not looked for.
        share: (numbers,); part of all owners of the quantity that have the same, but for those
            whom the number is about.
        window: (numbers,); relative width in which a number counts as the same.
    """

    numbers: ComparedNumbers
    others: OrderedValues
    reach: Floats
    first: Ints
    after: Ints
    share: Floats
    window: Floats

    def owners(self, chosen: Ints) -> tuple[Ints, Ints]:
        """Return, for each hit of some numbers, the number and the owner."""
        count = self.after[chosen] - self.first[chosen]
        start = np.repeat(self.first[chosen] - np.concatenate(([0], np.cumsum(count)[:-1])), count)
        number = np.repeat(chosen, count)
        place = start + np.arange(len(number))
        begin = self.others.begins[self.numbers.column[number]]
        return number, self.others.owner(self.others.order[begin + place]).astype(np.intp)

    def are_same(self, number: Ints, owner: Ints) -> Flags:
        """Tell of pairs of a number and an owner whether that owner has the same."""
        theirs = self.others.values.at(owner, self.numbers.column[number])
        value, reach = self.numbers.value[number], self.reach[number]
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


def same_as_issued(
    numbers: ComparedNumbers, which: Flags, issued: OrderedValues, moved: float = _OWN_ROUNDING
) -> Matches:
    """Find the variants whose right values numbers are.

    Args:
        numbers: what was typed.
        which: (numbers,); whether each is looked for.
        issued: the right ones.
        moved: relative; how far a taken number may be from the right one before it is typed, where
            that is more than one unit of its last digit.
    """
    reach = np.maximum(numbers.unit, moved * np.abs(numbers.value) + numbers.unit / 2)
    return _matches(numbers, which, issued, reach * (1 + _SAME), 1)


def same_as_typed(
    numbers: ComparedNumbers, which: Flags, typed: OrderedValues, moved: float = 0.0
) -> Matches:
    """Find the submissions in which the same was typed, but for rounding; its own is among them.

    Args:
        numbers: what was typed.
        which: (numbers,); whether each is looked for.
        typed: in all submissions.
        moved: relative; how far a taken number may be from what the other typed.
    """
    reach = np.maximum(numbers.unit / 2, _SAME * np.abs(numbers.value))
    reach += moved * np.abs(numbers.value)
    return _matches(numbers, which, typed, reach * (1 + _SAME), 2)  # the pair itself


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
    def of(cls, values: SparseTable) -> "Spread":
        """Return how the numbers of each column of a table spread."""
        middles, wides = np.zeros(values.columns), np.full(values.columns, _WIDEST_SPREAD)
        begins, order = values.by_column
        for column, (begin, end) in enumerate(pairwise(begins.tolist())):
            sizes = np.abs(values.value[order[begin:end]])
            logs = np.log(sizes[sizes != 0])
            count = max(len(logs), 1)
            middles[column] = _sum(logs) / count
            spread = math.sqrt(_sum((logs - middles[column]) ** 2) / count)
            wides[column] = max(spread, _WIDEST_SPREAD)
        return cls(middles, wides)


def density(numbers: ComparedNumbers, spread: Spread) -> Floats:
    """Return the probability that a wrong number falls near each, per relative width.

    Wrong numbers spread as the right ones of all variants do: log-normally, and not too narrowly.
    """
    wide = spread.width[numbers.column]
    away = (np.log(np.abs(numbers.value)) - spread.middle[numbers.column]) / wide
    result: Floats = np.exp(-(away**2) / 2) / (wide * math.sqrt(2 * math.pi))
    return result


def _sum(values: Floats) -> float:
    """Add numbers up one after the other: judgements must not hang on how they are parted."""
    return float(np.add.accumulate(values)[-1]) if len(values) else 0.0


def _matches(
    numbers: ComparedNumbers, which: Flags, others: OrderedValues, reach: Floats, apart: int
) -> Matches:
    """Find for each number the run of owners within reach.

    Args:
        numbers: what was typed.
        which: (numbers,); whether each is looked for.
        others: where.
        reach: (numbers,); how far a value may be.
        apart: how many of those found do not count as others.
    """
    wanted = np.flatnonzero(which)
    column, value, near = numbers.column[wanted], numbers.value[wanted], reach[wanted]
    begin, end = others.begins[column], others.begins[column + 1]
    first, after = np.zeros((2, len(numbers.value)), dtype=np.intp)
    first[wanted] = _sought(others, begin, end, value - near, np.less) - begin
    after[wanted] = _sought(others, begin, end, value + near, np.less_equal) - begin
    share = np.zeros(len(numbers.value))
    share[wanted] = np.maximum((after - first)[wanted] - apart, 0) / np.maximum(end - begin, 1)
    window = 2 * (reach / np.abs(numbers.value))
    return Matches(numbers, others, reach, first, after, share, window)


def _sought(
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
