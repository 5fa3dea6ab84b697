"""Numbers of some submissions, one after another, and which of them can say anything."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.cells import Flags, Floats, Ints
from gripcourse.likeness.typed_numbers import TypedNumbers
from gripcourse.slips.model import SlipId

_FILLER = 3  # unexplained cells with the same number: typed to fill them, not computed


@dataclass(frozen=True, slots=True)
class Columns:
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
class Laid:
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
    def of(cls, works: Sequence[TypedNumbers], columns: Columns) -> "Laid":
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
