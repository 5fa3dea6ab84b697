"""Rows of issued values that belong to one person: whoever was issued to twice has two of them.

Versions of one assignment are alike. So they are no strangers to each other: what both have is had
by one person, and nobody is suspected for a number of another version of his own.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from gripcourse.likeness.cells import Flags, Floats, Ints, SparseTable


def persons_of(owners: Iterable[str]) -> Ints:
    """Return for each row the first one of the same owner: (rows,)."""
    first: dict[str, int] = {}
    return np.array([first.setdefault(one, row) for row, one in enumerate(owners)], dtype=np.intp)


def of_several(person: Ints) -> Flags:
    """Tell which rows are of a person who has several: (rows,)."""
    several: Flags = np.bincount(person, minlength=len(person))[person] > 1
    return several


def had_again(person: Ints, what: Ints, kinds: int) -> Ints:
    """Return how often each kind of things is had by a person who has it already: (kinds,).

    Args:
        person: (things,); who has each.
        what: (things,); of which kind each is.
        kinds: how many there are.
    """
    once = np.unique(person * kinds + what) % max(kinds, 1)
    again: Ints = np.bincount(what, minlength=kinds) - np.bincount(once, minlength=kinds)
    return again


@dataclass(frozen=True, slots=True)
class RepeatedValues:
    """Of the numbers that one person has of one quantity, each with the next larger one.

    Of any that lie in one window there is one more than such pairs, whatever their number: so the
    persons are the rows without the pairs.

    Attributes:
        lower: of rows and quantities; the smaller number of each pair.
        upper: of the same cells; the larger one.
    """

    lower: SparseTable
    upper: SparseTable

    @classmethod
    def of(cls, tables: Iterable[SparseTable], person: Ints) -> "RepeatedValues | None":
        """Find them; None where each row is of another person.

        Args:
            tables: one below the other.
            person: (rows,); as `persons_of` returns them.
        """
        repeated = of_several(person)
        if not repeated.any():
            return None
        columns, cells = 0, list[tuple[Ints, Ints, Floats]]()
        for table, found in _cells(tables, repeated):
            columns = table.columns
            cells.append(found)
        row, column, value = (np.concatenate(one) for one in zip(*cells, strict=True))
        order = np.lexsort((value, column, person[row]))
        row, column, value = row[order], column[order], value[order]
        same = (person[row[1:]] == person[row[:-1]]) & (column[1:] == column[:-1])
        row, column, shape = row[:-1][same], column[:-1][same], (len(person), columns)
        return cls(
            SparseTable.of(shape, row, column, value[:-1][same]),
            SparseTable.of(shape, row, column, value[1:][same]),
        )


def _cells(
    tables: Iterable[SparseTable], which: Flags
) -> Iterator[tuple[SparseTable, tuple[Ints, Ints, Floats]]]:
    """Yield each table with row, column and number of the cells of some rows among all."""
    first = 0
    for table in tables:
        row, column = table.place
        mine = which[first + row]
        yield table, (first + row[mine], column[mine], table.value[mine])
        first += table.rows
