"""Numbers of a table most of whose cells are empty: nobody has the quantities of other schemes.

A cohort of ten thousand has some seven million cells; of one in ten anything is known.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.signedinteger[Any]]
Bits: TypeAlias = NDArray[np.uint8]
Flags: TypeAlias = NDArray[np.bool_]

_AT_ONCE: Final = 100_000  # cells that are put in another order together


@dataclass(frozen=True, slots=True, eq=False)
class SparseTable:
    """The finite numbers of a table, row by row.

    Attributes:
        rows, columns: of the table.
        key: (cells,); row times columns, plus column; ascending; of 32 bits where they are enough.
        value: (cells,); finite.
    """

    rows: int
    columns: int
    key: Ints
    value: Floats

    @classmethod
    def of(cls, shape: tuple[int, int], row: Ints, column: Ints, value: Floats) -> "SparseTable":
        """Put numbers into a table; of several in one cell the last counts."""
        rows, columns = shape
        key, known = keys_of(shape, row, column), np.isfinite(value)
        if not known.all():
            key, value = key[known], value[known]
        order = np.argsort(key, kind="stable")
        is_last = np.diff(key[order], append=-1) != 0
        order = order[is_last]
        return cls(rows, columns, key[order], value[order])

    @classmethod
    def joined(cls, shape: tuple[int, int], parts: Sequence["SparseTable"]) -> "SparseTable":
        """Put tables of this shape together, no two of which have the same cell."""
        rows, columns = shape
        nothing = keys_of(shape, np.zeros(0, dtype=np.int32), np.zeros(0, dtype=np.int32))
        key = np.concatenate([nothing, *(one.key for one in parts)])
        key.sort()
        value = np.empty(len(key))
        # One after the other: an order of all of them would take as much room again.
        for one in parts:
            value[np.searchsorted(key, one.key)] = one.value
        return cls(rows, columns, key, value)

    @classmethod
    def of_table(cls, table: Floats) -> "SparseTable":
        """Return the numbers of a whole table, NaN where there is none."""
        row, column = np.nonzero(np.isfinite(table))
        rows, columns = table.shape
        return cls.of((rows, columns), row, column, table[row, column])

    def at(self, row: Ints, column: Ints) -> Floats:
        """Return the numbers of cells, NaN for the empty ones."""
        if not len(self.key):
            return np.full(np.broadcast(row, column).shape, np.nan)
        wanted = keys_of((self.rows, self.columns), row, column)
        place = np.minimum(np.searchsorted(self.key, wanted), len(self.key) - 1)
        return np.where(self.key[place] == wanted, self.value[place], np.nan)

    def dense(self, columns: Sequence[int] | Ints) -> Floats:
        """Return some columns with all their rows: (rows, columns), NaN where there is none."""
        return self.at(np.arange(self.rows)[:, None], np.asarray(columns, dtype=np.intp))

    @property
    def place(self) -> tuple[Ints, Ints]:
        """Row and column of each number: (cells,) each."""
        row, column = np.divmod(self.key, max(self.columns, 1))
        return row, column

    @property
    def by_column(self) -> tuple[Ints, Ints]:
        """Where the numbers are, one column after the other, in each by row.

        Returns:
            (columns + 1,), where each column begins in what follows, and where the last one ends;
            (cells,), the places of the numbers.
        """
        parts = [slice(at, at + _AT_ONCE) for at in range(0, len(self.key), _AT_ONCE)]
        counts = np.zeros((len(parts), self.columns), dtype=np.intp)
        for number, part in enumerate(parts):
            counts[number] = np.bincount(self.key[part] % self.columns, minlength=self.columns)
        begins = np.concatenate(([0], np.cumsum(counts.sum(axis=0))))
        order = np.empty(len(self.key), dtype=np.int32)
        # All at once would take as much room again.
        for at, count, part in zip(begins[:-1] + _before(counts), counts, parts, strict=True):
            mine = np.argsort(self.key[part] % self.columns, kind="stable")
            place = np.repeat(at - _before(count), count) + np.arange(len(mine))
            order[place] = part.start + mine
        return begins, order


def _before(counts: Ints) -> Ints:
    """Return of each count the sum of those before it."""
    return np.asarray(np.cumsum(counts, axis=0) - counts)


def keys_of(shape: tuple[int, int], row: Ints, column: Ints) -> Ints:
    """Return the keys of cells, of 32 bits where they are enough; see `SparseTable`."""
    rows, columns = shape
    kind = np.int32 if rows * columns <= np.iinfo(np.int32).max else np.int64
    begin = np.multiply(row, columns, dtype=kind)
    return np.asarray(np.add(begin, column, dtype=kind))
