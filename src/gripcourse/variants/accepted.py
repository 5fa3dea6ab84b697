"""The variants that a drawing let through, and whether one more is far enough from all of them.

Drawing is one by one, and its tables are small: a candidate is compared with all rows at once. A
finished table of any size is measured by `apart`.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gripcourse.policy.bands import SLACK
from gripcourse.solver.family import Rows
from gripcourse.variants.answers import AnswerItem, section_totals
from gripcourse.variants.apart import ApartLimits
from gripcourse.variants.feasible import Array

_VALUE, _REACH, _POINTS, _SECTION = range(4)
_LAYERS = 4
_ROOM = 16  # rows and columns to begin with


@dataclass(frozen=True, slots=True)
class Answers:
    """The answers of some candidates of one scheme with the same options.

    Attributes:
        places: column of each quantity in the table of what was let through, shape (q,).
        layers: values (NaN for none), reach of the bands, points, number of the section; shape
            (4, k, q).
        totals: points by candidate and section, shape (k, sections).
    """

    places: Rows
    layers: Array
    totals: Array


@dataclass(slots=True)
class Accepted:
    """The rows that were let through so far.

    Attributes:
        limits: what two variants may share.
        sections: how many sections the course has.
        columns: column of each quantity that occurred.
        layers: as in `Answers`, with room for more rows and columns.
        totals: points by row and section.
        size: how many rows are used.
    """

    limits: ApartLimits
    sections: int
    columns: dict[str, int] = field(default_factory=dict)
    layers: Array = field(default_factory=lambda: np.zeros((_LAYERS, 0, 0)))
    totals: Array = field(default_factory=lambda: np.zeros((0, 0)))
    size: int = 0

    def answers(self, items: Sequence[AnswerItem], count: int) -> Answers:
        """Arrange the answers of `count` candidates; new quantities get a column."""
        layers = np.zeros((_LAYERS, count, len(items)))
        layers[_VALUE] = np.nan
        for column, item in enumerate(items):
            self.columns.setdefault(item.quantity, len(self.columns))
            layers[_VALUE, item.rows, column] = item.values
            layers[_REACH, item.rows, column] = item.half_widths * SLACK
            layers[_POINTS, item.rows, column] = item.points
            layers[_SECTION, item.rows, column] = item.sections
        self._make_room()
        places = np.array([self.columns[item.quantity] for item in items], dtype=np.intp)
        return Answers(places, layers, section_totals(items, count, self.sections))

    def take(self, answers: Answers, candidate: int) -> bool:
        """Let a candidate through if it is far enough from all rows; tell whether it is."""
        own, totals = answers.layers[:, candidate], answers.totals[candidate]
        if not self._is_apart(answers.places, own, totals):
            return False
        self.add(answers, candidate)
        return True

    def add(self, answers: Answers, candidate: int) -> None:
        """Count a candidate among the rows, however near to them it is."""
        own, totals = answers.layers[:, candidate], answers.totals[candidate]
        self._make_room()
        self.layers[:, self.size, answers.places] = own
        self.totals[self.size] = totals
        self.size += 1

    def _is_apart(self, places: Rows, own: Array, totals: Array) -> bool:
        """Compare both ways: what the candidate and what each row would get from the other."""
        if not self.size:
            return True
        rows = self.layers[:, : self.size, places]
        distance = np.abs(rows[_VALUE] - own[_VALUE])  # NaN, and so no coincidence, for none
        for student, theirs in ((own[:, None, :], totals), (rows, self.totals[: self.size])):
            fits = distance <= student[_REACH]
            points = np.where(fits, student[_POINTS], 0.0)
            if self._exceeds(points, student[_SECTION], theirs):
                return False
        return True

    def _exceeds(self, points: Array, sections: NDArray[np.float64], totals: Array) -> bool:
        """Tell whether shared points go above a limit, whole or in a section, in any row."""
        if (points.sum(axis=1) > self.limits.whole * SLACK * totals.sum(axis=-1)).any():
            return True
        return any(
            (
                np.where(sections == section, points, 0.0).sum(axis=1)
                > self.limits.section * SLACK * totals[..., section]
            ).any()
            for section in range(self.sections)
        )

    def _make_room(self) -> None:
        height, width = self.layers.shape[1:]
        if self.size < height and len(self.columns) <= width:
            return
        height, width = max(height, 2 * self.size, _ROOM), max(width, 2 * len(self.columns), _ROOM)
        layers, totals = np.zeros((_LAYERS, height, width)), np.zeros((height, self.sections))
        layers[_VALUE] = np.nan
        layers[:, : self.layers.shape[1], : self.layers.shape[2]] = self.layers
        if self.size:
            totals[: self.size] = self.totals[: self.size]
        self.layers, self.totals = layers, totals
