"""All numbers of all submissions side by side, and what explains each of them without copying."""

from array import array
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, pairwise
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.cells import Flags, Floats, Ints, SparseTable, keys_of
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.laid import Columns, Laid
from gripcourse.likeness.matches import ComparedNumbers, Spread, last_unit
from gripcourse.likeness.model import Chances, ComparedWork
from gripcourse.likeness.own_versions import OwnVersions
from gripcourse.likeness.persons import had_again, of_several
from gripcourse.machine.shelf import Shelved

if TYPE_CHECKING:
    from gripcourse.slips.model import SlipId

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
        common: (slips,); how common each is among the students who answered its quantity.
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
        for works, first in _since(self.works):
            yield from _parts(self, works, first)


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
    submitter = versions.person[own]
    return ComparisonPool(
        students=tuple(issued.owners[row] for row in gathering.own),
        own=own,
        issued=issued,
        person=versions.person,
        submitter=submitter,
        variants=versions.variants_of_others(own),
        spread=Spread.of(issued.values),
        works=tables,
        common=_common(gathering, tables, submitter),
    )


def _common(gathering: "_Gathering", tables: Sequence[PooledWorks], submitter: Ints) -> Floats:
    """Return how common each slip is; a student who handed in two works is one student."""
    counts = np.array([gathering.slipped[one] for one in gathering.slips.values()], np.float64)
    quantity = np.array([place for place, _ in gathering.slips], dtype=np.intp)
    answered = gathering.answered
    several = of_several(submitter)
    if several.any():
        cells = [_of_submitters(*one, submitter, several) for one in _since(tables)]
        (who, slip), (whose, column) = (
            np.concatenate(one, axis=1) for one in zip(*cells, strict=True)
        )
        counts -= had_again(who, slip, len(counts))
        answered = answered - had_again(whose, column, len(answered))
    return counts / answered[quantity]


def _since(tables: Sequence[PooledWorks]) -> Iterator[tuple[PooledWorks, int]]:
    """Yield each table with the submission, among all, of its first row."""
    first = 0
    for works in tables:
        yield works, first
        first += len(works.own)


def _of_submitters(
    works: PooledWorks, first: int, submitter: Ints, which: Flags
) -> tuple[Ints, Ints]:
    """Return who made which slip, and who answered which quantity, of some submissions."""
    row, column = works.typed.place
    of_slip, person = first + row[works.slipped], submitter[first + row]
    chosen, of_which = which[of_slip], which[first + row]
    slips = np.array([submitter[of_slip[chosen]], works.slip[chosen]], dtype=np.intp)
    return slips, np.array([person[of_which], column[of_which]], dtype=np.intp)


class _Gathering:
    """What is known of a cohort's submissions while they come one after another."""

    def __init__(self, issued: IssuedValues, moved: float) -> None:
        self.issued, self.moved = issued, moved
        self.versions = OwnVersions.of(issued)
        self.columns = Columns(issued.columns)
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
            found = Laid.of([work.numbers for work in portion], self.columns)
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
