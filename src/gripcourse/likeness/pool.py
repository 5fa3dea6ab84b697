"""All numbers of all submissions side by side, and what explains each of them without copying."""

from array import array
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import accumulate, islice, pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.cells import Flags, Floats, Ints, SparseTable, keys_of
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import ComparedNumbers, Spread, last_unit
from gripcourse.likeness.model import Chances, ComparedWork
from gripcourse.likeness.own_versions import OwnVersions
from gripcourse.likeness.typed_numbers import TypedNumbers
from gripcourse.machine.shelf import Shelved
from gripcourse.slips.model import SlipId

_FILLER = 3  # unexplained cells with the same number: typed to fill them, not computed
_AT_ONCE: Final = 100  # submissions that are looked into together
_TOGETHER: Final = 1000  # submissions in one table: what lies in memory of them at a time
_MOVED: Final = max(Chances().moved)


@dataclass(frozen=True, slots=True)
class PooledWorks:
    """The numbers of some submissions; nothing stands here twice.

    Attributes:
        own: row of each submission's variant in the tables of issued values.
        typed: what was typed, of submissions (rows) and quantities (columns); never zero.
        right: (numbers,); what the student's own variant has for each; NaN for nothing.
        half_unit: (numbers,); half a unit of the last digit of each, as a place in what follows.
        half_units: all different ones.
        explained: (numbers,); whether a number says nothing.
        slipped: the numbers that have a slip, in their order.
        slip: of each of these its slip, as a place in `ComparisonPool.common`.
    """

    own: Ints
    typed: SparseTable
    right: Floats
    half_unit: Ints
    half_units: Floats
    explained: Flags
    slipped: Ints
    slip: Ints

    @property
    def of_right(self) -> SparseTable:
        """The right numbers, as a table of the same submissions and quantities."""
        known = np.isfinite(self.right)
        typed = self.typed
        return SparseTable(typed.rows, typed.columns, typed.key[known], self.right[known])

    @property
    def ratios(self) -> SparseTable:
        """By how much each number is larger than the right one; nothing where there is none."""
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = self.typed.value / self.right
        known, typed = np.isfinite(ratio), self.typed
        return SparseTable(typed.rows, typed.columns, typed.key[known], ratio[known])


@dataclass(frozen=True, slots=True)
class ComparisonPool:
    """The numbers of a cohort, in tables of which one is in memory at a time.

    Attributes:
        students: of the submissions.
        own: row of each submission's variant in the tables of issued values.
        issued: these tables.
        person: (rows of these tables,); the first row of the same student.
        submitter: (submissions,); likewise of each.
        variants: how many rows of other students all submissions are compared with.
        spread: of their values.
        works: the numbers, the submissions of the first table before those of the second.
        common: (slips,); how common each is among those who answered its quantity.
    """

    students: tuple[str, ...]
    own: Ints
    issued: IssuedValues
    person: Ints
    submitter: Ints
    variants: int
    spread: Spread
    works: Sequence[PooledWorks]
    common: Floats

    def parts(self) -> Iterator["PooledPart"]:
        """Part the numbers into those of as many submissions as are compared together."""
        first = 0
        for works in self.works:
            yield from _parts(self, works, first)
            first += len(works.own)


@dataclass(frozen=True, slots=True)
class PooledPart:
    """Some numbers of a cohort, for a while.

    Attributes:
        pooled: all of them.
        first: the submission, among all, whose row is 0.
        begin: the first row that has any of these numbers.
        numbers: what was typed, by submission, then by quantity.
        right: (numbers,); what the student's own variant has for each; NaN for nothing.
        explained: (numbers,); whether a number says nothing.
        slip: (numbers,); its slip; −1 where there is none.
    """

    pooled: ComparisonPool
    first: int
    begin: int
    numbers: ComparedNumbers
    right: Floats
    explained: Flags
    slip: Ints


def _parts(pooled: ComparisonPool, works: PooledWorks, first: int) -> Iterator[PooledPart]:
    typed, count = works.typed, len(works.own)
    rows = np.array([*range(0, count, _AT_ONCE), count])
    begins = np.searchsorted(typed.key, (rows * typed.columns).astype(typed.key.dtype))
    for begin, end in pairwise(begins.tolist()):
        which = slice(begin, end)
        row, column = np.divmod(typed.key[which], typed.columns)
        value, half_unit = typed.value[which], works.half_units[works.half_unit[which]]
        slip = np.full(len(value), -1, dtype=np.int32)
        since, until = np.searchsorted(works.slipped, (begin, end))
        slip[works.slipped[since:until] - begin] = works.slip[since:until]
        numbers = ComparedNumbers(row, column, value, last_unit(value, half_unit))
        at = int(row[0]) if len(row) else 0
        yield PooledPart(
            pooled, first, at, numbers, works.right[which], works.explained[which], slip
        )


def pool(
    works: Iterable[ComparedWork], issued: IssuedValues, moved: float = _MOVED
) -> ComparisonPool:
    """Put the numbers of submissions side by side; all students own a row of issued values.

    Each is looked into once: it is asked for, and let go when the next ones come.

    Args:
        works: the submissions.
        issued: the right values of every issued variant.
        moved: relative; how far a number may be from the right one of another version of the same
            student, which explains it.
    """
    gathering = _Gathering(issued, moved)
    tables = Shelved(gathering.tables(iter(works)))
    own, versions = np.frombuffer(gathering.own, np.int32), gathering.versions
    counts = np.array([gathering.slipped[one] for one in gathering.slips.values()], np.float64)
    quantity = np.array([place for place, _ in gathering.slips], dtype=np.intp)
    return ComparisonPool(
        students=tuple(issued.owners[row] for row in gathering.own),
        own=own,
        issued=issued,
        person=versions.person,
        submitter=versions.person[own],
        variants=versions.variants_of_others(own),
        spread=Spread.of(issued.values),
        works=tables,
        common=counts / gathering.answered[quantity],
    )


class _Gathering:
    """What is known of a cohort's submissions while they come one after another."""

    def __init__(self, issued: IssuedValues, moved: float) -> None:
        self.issued, self.moved = issued, moved
        self.versions = OwnVersions.of(issued)
        self.columns = _Columns(issued.columns)
        self.own = array("i")
        self.slips: dict[tuple[int, SlipId], int] = {}
        self.slipped: Counter[int] = Counter()
        self.answered = np.zeros(len(issued.quantities), dtype=np.intp)

    def tables(self, works: Iterator[ComparedWork]) -> Iterator[PooledWorks]:
        """Yield the numbers of so many submissions as stand in one table."""
        while (found := self._table(islice(works, _TOGETHER))) is not None:
            yield found

    def _table(self, works: Iterator[ComparedWork]) -> PooledWorks | None:
        """Put submissions side by side; None for none."""
        half_units: dict[float, int] = {}
        rows: list[Ints] = []
        columns: list[Ints] = []
        told, values, of_unit, slipped, of_slip = (array(kind) for kind in "bdiii")
        begin = len(self.own)
        while portion := tuple(islice(works, _AT_ONCE)):
            found = _Laid.of([work.numbers for work in portion], self.columns)
            usable = found.usable
            slip = found.slips(usable, self.slips)
            chosen = found.chosen(usable)
            has_slip = np.flatnonzero(slip[chosen] >= 0).astype(np.int32)
            slipped.frombytes((has_slip + len(values)).tobytes())
            of_slip.frombytes(slip[chosen[has_slip]].tobytes())
            rows.append(found.row[chosen] + np.int32(len(self.own) - begin))
            columns.append(found.column[chosen])
            told.frombytes(found.explained[chosen].tobytes())
            values.frombytes(found.value[chosen].tobytes())
            of_unit.frombytes(_numbered(found.half_unit[chosen], half_units).tobytes())
            self.answered += np.bincount(found.column[chosen], minlength=len(self.answered))
            self.own.extend(map(self.versions.row, portion))
        if len(self.own) == begin:
            return None
        own = np.array(self.own[begin:], dtype=np.int32)
        row, column = np.concatenate(rows), np.concatenate(columns)
        shape = len(own), len(self.issued.quantities)
        self.slipped.update(of_slip)
        unit, units = np.frombuffer(of_unit, np.int32), np.array(list(half_units), np.float64)
        typed = np.frombuffer(values)
        explained = np.array(told, dtype=np.bool_)
        if self.versions.several:
            numbers = typed, units[unit]
            explained |= self.versions.explained(own, row, column, numbers, self.moved)
        return PooledWorks(
            own=own,
            typed=SparseTable(*shape, keys_of(shape, row, column), typed),
            right=self.issued.at(own[row], column),
            half_unit=unit,
            half_units=units,
            explained=explained,
            slipped=np.frombuffer(slipped, np.int32),
            slip=np.frombuffer(of_slip, np.int32),
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
        works: what was typed in each submission.
        row: which of these submissions each is of.
        column: quantity of each; −1 where no variant has it.
        value, half_unit, explained: of each; see `Typed`.
        begins: (submissions,); where the numbers of each begin.
    """

    works: Sequence[TypedNumbers]
    row: NDArray[np.int32]
    column: NDArray[np.int32]
    value: Floats
    half_unit: Floats
    explained: Flags
    begins: Sequence[int]

    @classmethod
    def of(cls, works: Sequence[TypedNumbers], columns: _Columns) -> "_Laid":
        """Lay them out."""
        counts = [len(one) for one in works]
        return cls(
            works=works,
            row=np.repeat(np.arange(len(works), dtype=np.int32), counts),
            column=np.concatenate([columns.of(one.names) for one in works]),
            value=np.concatenate([one.values for one in works]),
            half_unit=np.concatenate([one.half_units for one in works]),
            explained=np.concatenate([one.explained for one in works]),
            begins=[0, *accumulate(counts[:-1])],
        )

    def slips(self, usable: Flags, known: dict[tuple[int, SlipId], int]) -> NDArray[np.int32]:
        """Return the number of the slip of each, −1 where there is none; new ones become known."""
        slip = np.full(len(self.value), -1, dtype=np.int32)
        for begin, work in zip(self.begins, self.works, strict=True):
            for place, one in work.slips.items():
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
