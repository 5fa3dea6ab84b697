"""All numbers of all submissions side by side, and what explains each of them without copying."""

from array import array
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import accumulate, islice

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.cells import Floats, Ints
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import ComparedNumbers, Matches, Spread, density, last_unit
from gripcourse.likeness.model import Chances, ComparedWork
from gripcourse.slips.model import SlipId

_FILLER = 3  # unexplained cells with the same number: typed to fill them, not computed
_AT_ONCE = 100  # submissions that are looked into together
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
        slip: (numbers,); its slip, as a place in what follows; −1 where there is none.
        common: (slips,); how common each is among those who answered its quantity.
    """

    students: tuple[str, ...]
    own: Ints
    issued: IssuedValues
    spread: Spread
    numbers: ComparedNumbers
    explained: Flags
    slip: Ints
    common: Floats

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

    Each is looked into once: it is asked for, and let go when the next ones come.
    """
    rows = {student: row for row, student in enumerate(issued.owners)}
    columns = _Columns(issued.columns)
    students: list[str] = []
    slips: dict[tuple[int, SlipId], int] = {}
    of_row, of_column, told, values, units, of_slip = (array(kind) for kind in "iibddi")
    left = iter(works)
    while portion := tuple(islice(left, _AT_ONCE)):
        found = _Laid.of(portion, columns)
        usable = found.usable
        slip = found.slips(portion, usable, slips)
        chosen = found.chosen(usable)
        value = found.value[chosen]
        of_row.frombytes((found.row[chosen] + len(students)).tobytes())
        of_column.frombytes(found.column[chosen].tobytes())
        told.frombytes(found.explained[chosen].tobytes())
        values.frombytes(value.tobytes())
        units.frombytes(last_unit(value, found.half_unit[chosen]).tobytes())
        of_slip.frombytes(slip[chosen].tobytes())
        students += (work.student for work in portion)
    column, slip = np.frombuffer(of_column, np.int32), np.frombuffer(of_slip, np.int32)
    quantity = np.array([place for place, _ in slips], dtype=np.intp)
    return ComparisonPool(
        students=tuple(students),
        own=np.array([rows[student] for student in students], dtype=np.intp),
        issued=issued,
        spread=Spread.of(issued.values),
        numbers=ComparedNumbers(
            row=np.frombuffer(of_row, np.int32),
            column=column,
            value=np.frombuffer(values),
            unit=np.frombuffer(units),
        ),
        explained=np.frombuffer(told, np.bool_),
        slip=slip,
        common=_commonness_of_slips(slip, quantity, column),
    )


@dataclass(frozen=True, slots=True)
class _Columns:
    """Columns of quantities; of works that are asked for the same ones they are found once."""

    by_quantity: Mapping[str, int]
    found: dict[str, NDArray[np.int32]] = field(default_factory=dict)

    def of(self, names: str) -> NDArray[np.int32]:
        """Return the columns of the quantities of a work, −1 where no variant has one."""
        if names not in self.found:
            columns = [self.by_quantity.get(one, -1) for one in names.split()]
            self.found[names] = np.array(columns, np.int32)
        return self.found[names]


@dataclass(frozen=True, slots=True)
class _Laid:
    """The numbers of some submissions, as they were typed, one after another.

    Attributes:
        row: which of these submissions each is of.
        column: quantity of each; −1 where no variant has it.
        value, half_unit, explained: of each; see `Typed`.
        begins: (submissions,); where the numbers of each begin.
    """

    row: NDArray[np.int32]
    column: NDArray[np.int32]
    value: Floats
    half_unit: Floats
    explained: Flags
    begins: Sequence[int]

    @classmethod
    def of(cls, works: Sequence[ComparedWork], columns: _Columns) -> "_Laid":
        """Lay them out."""
        numbers = [work.numbers for work in works]
        counts = [len(one) for one in numbers]
        return cls(
            row=np.repeat(np.arange(len(works), dtype=np.int32), counts),
            column=np.concatenate([columns.of(one.names) for one in numbers]),
            value=np.concatenate([one.values for one in numbers]),
            half_unit=np.concatenate([one.half_units for one in numbers]),
            explained=np.concatenate([one.explained for one in numbers]),
            begins=[0, *accumulate(counts[:-1])],
        )

    def slips(
        self, works: Sequence[ComparedWork], usable: Flags, known: dict[tuple[int, SlipId], int]
    ) -> NDArray[np.int32]:
        """Return the number of the slip of each, −1 where there is none; new ones become known."""
        slip = np.full(len(self.value), -1, dtype=np.int32)
        for begin, work in zip(self.begins, works, strict=True):
            for place, one in work.numbers.slips.items():
                if usable[begin + place]:
                    key = int(self.column[begin + place]), one
                    slip[begin + place] = known.setdefault(key, len(known))
        return slip

    def chosen(self, usable: Flags) -> Ints:
        """Return the places of those that can say anything, by submission, then by quantity."""
        order = np.lexsort((self.column, self.row))
        return order[usable[order]]

    @property
    def usable(self) -> Flags:
        """Which can say anything: a nought is nobody's, and nor is what fills cells."""
        usable: Flags = (self.column >= 0) & (self.value != 0) & np.isfinite(self.value)
        wrong = np.flatnonzero(~self.explained)
        if not len(wrong):
            return usable
        ordered = wrong[np.lexsort((self.value[wrong], self.row[wrong]))]
        row, value = self.row[ordered], self.value[ordered]
        is_first = np.r_[True, (row[1:] != row[:-1]) | (value[1:] != value[:-1])]
        run = np.cumsum(is_first) - 1
        usable[ordered[np.bincount(run)[run] >= _FILLER]] = False
        return usable


def chance_of(pooled: ComparisonPool, found: Matches, chances: Chances) -> Floats:
    """Return how likely each number meets a certain other one without copying.

    Returns:
        (numbers,); 1 for what is explained.
    """
    near = density(pooled.numbers, pooled.spread) * found.window
    wrong = np.maximum(np.maximum(near, found.share), chances.least)
    discrete = pooled.issued.discrete[pooled.numbers.column]
    wrong = np.where(discrete, np.maximum(wrong, chances.discrete), wrong)
    made = pooled.slip >= 0
    chance = wrong.copy()
    chance[made] = np.maximum(
        wrong[made], np.maximum(pooled.common[pooled.slip[made]], chances.slip)
    )
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
    likely = np.zeros(len(numbers.value))
    order = np.argsort(numbers.column, kind="stable").astype(np.int32)
    ends = np.flatnonzero(np.diff(numbers.column[order])) + 1
    # One quantity after the other: all of them at once would take as much room again.
    for mine in np.split(order, ends):
        right = pooled.issued.values.at(pooled.own[numbers.row[mine]], numbers.column[mine])
        with np.errstate(divide="ignore", invalid="ignore"):
            likely[mine] = _commonness(numbers.value[mine] / right)
    return SharedMethods(pooled, np.maximum(likely, chances.shared, out=likely))


def _commonness_of_slips(slip: Ints, quantity: Ints, column: Ints) -> Floats:
    """Return which part of those who answered a quantity made each slip.

    Args:
        slip: (numbers,); each one of a quantity has its own number; −1 for none.
        quantity: (slips,); the quantity of each.
        column: (numbers,); the quantity of each.
    """
    made = np.bincount(slip[slip >= 0], minlength=len(quantity))
    answered = np.bincount(column, minlength=int(quantity.max(initial=-1)) + 1)
    return np.asarray(made / answered[quantity])


def _commonness(ratio: Floats) -> Floats:
    """Return which part of a quantity's numbers is off by the same ratio, but for this one."""
    result = np.zeros(len(ratio))
    mine = np.flatnonzero(np.isfinite(ratio))
    ordered = np.sort(ratio[mine])
    reach = np.abs(ratio[mine]) * _SAME_RATIO
    low = np.searchsorted(ordered, ratio[mine] - reach, "left")
    high = np.searchsorted(ordered, ratio[mine] + reach, "right")
    result[mine] = (high - low - 1) / max(len(mine), 1)
    return result
