"""All numbers of all submissions side by side, and what explains each of them without copying."""

from array import array
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import accumulate, islice

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.cells import Flags, Floats, Ints, SparseTable, keys_of
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import ComparedNumbers, Spread, last_unit
from gripcourse.likeness.model import ComparedWork
from gripcourse.slips.model import SlipId

_FILLER = 3  # unexplained cells with the same number: typed to fill them, not computed
_AT_ONCE = 100  # submissions that are looked into together


@dataclass(frozen=True, slots=True)
class ComparisonPool:
    """The numbers of a cohort; of ten thousand works a million, so nothing stands here twice.

    Attributes:
        students: of the submissions.
        own: row of each submission's student in the table of issued values.
        issued: that table.
        spread: of its values.
        typed: what was typed, of submissions (rows) and quantities (columns); never zero.
        half_unit: (numbers,); half a unit of the last digit of each, as a place in what follows.
        half_units: all different ones.
        explained: (numbers,); whether a number says nothing.
        slipped: the numbers that have a slip, in their order.
        slip: of each of these its slip, as a place in what follows.
        common: (slips,); how common each is among those who answered its quantity.
    """

    students: tuple[str, ...]
    own: Ints
    issued: IssuedValues
    spread: Spread
    typed: SparseTable
    half_unit: Ints
    half_units: Floats
    explained: Flags
    slipped: Ints
    slip: Ints
    common: Floats

    def part(self, which: slice) -> "PooledPart":
        """Return some of the numbers, all that is known of each beside it."""
        row, column = np.divmod(self.typed.key[which], self.typed.columns)
        value, half_unit = self.typed.value[which], self.half_units[self.half_unit[which]]
        slip = np.full(len(value), -1, dtype=np.int32)
        begin, end = np.searchsorted(self.slipped, (which.start, which.stop))
        slip[self.slipped[begin:end] - which.start] = self.slip[begin:end]
        numbers = ComparedNumbers(row, column, value, last_unit(value, half_unit))
        return PooledPart(self, which, numbers, self.explained[which], slip)


@dataclass(frozen=True, slots=True)
class PooledPart:
    """Some numbers of a cohort, for a while.

    Attributes:
        pooled: all of them.
        which: of these.
        numbers: what was typed, by submission, then by quantity.
        explained: (numbers,); whether a number says nothing.
        slip: (numbers,); its slip; −1 where there is none.
    """

    pooled: ComparisonPool
    which: slice
    numbers: ComparedNumbers
    explained: Flags
    slip: Ints


def pool(works: Iterable[ComparedWork], issued: IssuedValues) -> ComparisonPool:
    """Put the numbers of submissions side by side; all students own a row of issued values.

    Each is looked into once: it is asked for, and let go when the next ones come.
    """
    rows = {student: row for row, student in enumerate(issued.owners)}
    columns = _Columns(issued.columns)
    students: list[str] = []
    slips: dict[tuple[int, SlipId], int] = {}
    half_units: dict[float, int] = {}
    keys: list[Ints] = []
    told, values, of_unit, slipped, of_slip = (array(kind) for kind in "bdiii")
    answered = np.zeros(len(issued.quantities), dtype=np.intp)
    left = iter(works)
    while portion := tuple(islice(left, _AT_ONCE)):
        found = _Laid.of(portion, columns)
        usable = found.usable
        slip = found.slips(portion, usable, slips)
        chosen = found.chosen(usable)
        has_slip = np.flatnonzero(slip[chosen] >= 0).astype(np.int32)
        slipped.frombytes((has_slip + len(values)).tobytes())
        of_slip.frombytes(slip[chosen[has_slip]].tobytes())
        so_far = len(students) + len(portion), len(issued.quantities)
        keys.append(keys_of(so_far, found.row[chosen] + len(students), found.column[chosen]))
        told.frombytes(found.explained[chosen].tobytes())
        values.frombytes(found.value[chosen].tobytes())
        of_unit.frombytes(_numbered(found.half_unit[chosen], half_units).tobytes())
        answered += np.bincount(found.column[chosen], minlength=len(answered))
        students += (work.student for work in portion)
    quantity = np.array([place for place, _ in slips], dtype=np.intp)
    of_all = np.frombuffer(of_slip, np.int32)
    return ComparisonPool(
        students=tuple(students),
        own=np.array([rows[student] for student in students], dtype=np.int32),
        issued=issued,
        spread=Spread.of(issued.values),
        typed=SparseTable(
            rows=len(students),
            columns=len(issued.quantities),
            key=np.concatenate([np.zeros(0, dtype=np.int32), *keys]),
            value=np.frombuffer(values),
        ),
        half_unit=np.frombuffer(of_unit, np.int32),
        half_units=np.array(list(half_units), dtype=np.float64),
        explained=np.frombuffer(told, np.bool_),
        slipped=np.frombuffer(slipped, np.int32),
        slip=of_all,
        common=np.bincount(of_all, minlength=len(quantity)) / answered[quantity],
    )


def _numbered(values: Floats, known: dict[float, int]) -> NDArray[np.int32]:
    """Return the number of each value; new ones become known."""
    different, place = np.unique(values, return_inverse=True)
    numbers = [known.setdefault(one, len(known)) for one in different.tolist()]
    return np.array(numbers, dtype=np.int32)[place]


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
        order = order[usable[order]]
        row, column = self.row[order], self.column[order]
        # Of several of one quantity the last counts.
        is_last = np.r_[(row[1:] != row[:-1]) | (column[1:] != column[:-1]), True]
        return np.asarray(order[is_last[: len(order)]])

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
