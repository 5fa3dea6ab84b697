"""The versions that each student was issued: which row a work belongs to, and what is its own."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.likeness.cells import Flags, Floats, Ints
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import ComparedNumbers, last_unit, same_as_issued
from gripcourse.likeness.model import ComparedWork
from gripcourse.likeness.persons import persons_of


@dataclass(frozen=True, slots=True)
class OwnVersions:
    """The rows of issued values by student.

    Attributes:
        issued: these values.
        person: (rows,); the first row of the same student.
        first: by student, that row.
        several: by first row, all rows of who has several; of a large cohort few have.
    """

    issued: IssuedValues
    person: Ints
    first: Mapping[str, int]
    several: Mapping[int, Sequence[int]]

    @classmethod
    def of(cls, issued: IssuedValues) -> "OwnVersions":
        """Look through the owners of the rows."""
        person = persons_of(issued.owners)
        several: dict[int, list[int]] = {}
        for row in np.flatnonzero(person != np.arange(len(person))).tolist():
            several.setdefault(int(person[row]), [int(person[row])]).append(row)
        first = {issued.owners[row]: row for row in np.unique(person).tolist()}
        return cls(issued, person, first, several)

    def row(self, work: ComparedWork) -> int:
        """Return the row of the variant that a work was judged by."""
        first = self.first[work.student]
        return self.several[first][work.version] if work.version else first

    def variants_of_others(self, own: Ints) -> int:
        """Return how many rows of other students works are compared with, all together.

        Args:
            own: (works,); the row of each.
        """
        rows = np.bincount(self.person, minlength=len(self.person))
        return len(own) * len(self.person) - int(rows[self.person[own]].sum())

    def explained(
        self, own: Ints, row: Ints, column: Ints, numbers: tuple[Floats, Floats], moved: float
    ) -> Flags:
        """Tell which numbers are right in another version of the same student.

        Args:
            own: (works,); the row of each in the tables of issued values.
            row: (numbers,); the work of each, ascending.
            column: (numbers,); the quantity of each.
            numbers: value and half a unit of the last digit of each.
            moved: relative; how far a number may be from the right one.
        """
        value, half_unit = numbers
        explained: Flags = np.zeros(len(value), dtype=np.bool_)
        begins = np.searchsorted(row, np.arange(len(own) + 1))
        which, others = [np.zeros(0, dtype=np.intp)], [np.zeros(0, dtype=np.intp)]
        for work, mine in enumerate(own.tolist()):
            for other in self.several.get(int(self.person[mine]), ()):
                if other != mine:
                    which.append(np.arange(begins[work], begins[work + 1]))
                    others.append(np.full(len(which[-1]), other))
        place, theirs = np.concatenate(which), np.concatenate(others)
        if len(place):
            compared = ComparedNumbers(
                row[place],
                column[place],
                value[place],
                last_unit(value[place], half_unit[place]),
            )
            right = self.issued.at(theirs, compared.column)
            near = np.abs(compared.value - right) <= same_as_issued(compared, moved).reach
            explained[place[near]] = True
        return explained
