"""Numbers of a table most of whose cells are empty: nobody has the quantities of other schemes.

A cohort of ten thousand has some seven million cells; of one in ten anything is known.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.signedinteger[Any]]
Bits: TypeAlias = NDArray[np.uint8]


@dataclass(frozen=True, slots=True, eq=False)
class SparseTable:
    """The finite numbers of a table, column by column.

    Attributes:
        rows, columns: of the table.
        key: (cells,); column times rows, plus row; ascending; of 32 bits where they are enough.
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
        key, known = _keys(shape, row, column), np.isfinite(value)
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
        nothing = _keys(shape, np.zeros(0, dtype=np.int32), np.zeros(0, dtype=np.int32))
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
        wanted = _keys((self.rows, self.columns), row, column)
        place = np.minimum(np.searchsorted(self.key, wanted), len(self.key) - 1)
        return np.where(self.key[place] == wanted, self.value[place], np.nan)

    def dense(self, columns: Sequence[int] | Ints) -> Floats:
        """Return some columns with all their rows: (rows, columns), NaN where there is none."""
        return self.at(np.arange(self.rows)[:, None], np.asarray(columns, dtype=np.intp))

    @property
    def place(self) -> tuple[Ints, Ints]:
        """Row and column of each number: (cells,) each."""
        column, row = np.divmod(self.key, max(self.rows, 1))
        return row, column

    @property
    def begins(self) -> Ints:
        """Where the numbers of each column begin, and where those of the last one end."""
        ends = np.arange(1, self.columns + 1) * self.rows - 1  # of each column, its last key
        after = np.searchsorted(self.key, ends.astype(self.key.dtype), "right")
        return np.concatenate(([0], after))

    @property
    def bits(self) -> Bits:
        """Which cells have a number: of each row a bit for each column, as `np.packbits`."""
        found = np.zeros((self.rows, -(-self.columns // 8)), dtype=np.uint8)
        for column, (begin, end) in enumerate(pairwise(self.begins.tolist())):
            found[self.key[begin:end] - column * self.rows, column // 8] |= 128 >> column % 8
        return found


def _keys(shape: tuple[int, int], row: Ints, column: Ints) -> Ints:
    """Return the keys of cells; see `SparseTable`."""
    rows, columns = shape
    if rows * columns <= np.iinfo(np.int32).max:
        return column.astype(np.int32) * rows + row.astype(np.int32)
    return column.astype(np.int64) * rows + row.astype(np.int64)
