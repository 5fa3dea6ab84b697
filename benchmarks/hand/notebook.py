"""What a student writes down: every number rounded as it is typed, and used as it was written."""

from bisect import bisect_left
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import acos, asin, atan, atan2, cos, degrees, radians, sin, tan
from typing import Final

from hand.sheet import Sheet

_FIGURES: Final = 5


@dataclass(frozen=True)
class Notebook:
    """A calculation as it grows.

    Attributes:
        sheet: what was issued.
        wrong: what is done in place of the right step, by the quantity in which it is done.
        written: what is written so far: numbers in the units of the sheet, yes and no.
    """

    sheet: Sheet
    wrong: "Mapping[str, Step]" = field(default_factory=dict)
    written: dict[str, float] = field(default_factory=dict)

    def __getitem__(self, name: str) -> float:
        return self.written[name] if name in self.written else self.sheet.given[name]

    def __setitem__(self, name: str, value: float) -> None:
        if name in self.wrong:
            value = self.wrong[name](self, value)
        self.written[name] = value if isinstance(value, bool) else float(f"{value:.{_FIGURES}g}")

    def __contains__(self, name: str) -> bool:
        return name in self.written or name in self.sheet.given

    def get(self, name: str, otherwise: float) -> float:
        """Return a number, or another one where the sheet has no such quantity."""
        return {**self.sheet.given, **self.written}.get(name, otherwise)

    def asks(self, name: str) -> bool:
        """Tell whether the workbook has a cell for a quantity."""
        return name in self.sheet.asked

    def option(self, name: str) -> str:
        """Return what the variant chooses; empty where there is no choice."""
        return self.sheet.options.get(name, "")

    def choose(
        self,
        name: str,
        series: str,
        least: float,
        will_do: "Callable[[float], bool]" = lambda _: True,
    ) -> None:
        """Accept the smallest size of a series that is not below a value and will do."""
        sizes = self.sheet.table(series).column("")
        self[name] = next(one for one in sizes if not_below(one, least) and will_do(one))

    def typed(self, name: str) -> float | str:
        """Return what goes into the cell of an answer."""
        value = self.written[name]
        return ("yes" if value else "no") if isinstance(value, bool) else value

    def row(self, table: str, key: str, at: float, column: str) -> float:
        """Read a table: the entry of a column in the row whose key this is."""
        found = self.sheet.table(table)
        return found.column(column)[found.column(key).index(at)]

    def row_not_below(self, table: str, column: str, least: float, key: str) -> float:
        """Return the key of the first row whose entry in a column is not below a value."""
        found = self.sheet.table(table)
        place = next(i for i, one in enumerate(found.column(column)) if not_below(one, least))
        return found.column(key)[place]

    def between_rows(self, table: str, key: str, at: float, column: str) -> float:
        """Read a table on a straight line between two rows."""
        found = self.sheet.table(table)
        pairs = sorted(zip(found.column(key), found.column(column), strict=True))
        above = min(max(bisect_left([one for one, _ in pairs], at), 1), len(pairs) - 1)
        (x1, y1), (x2, y2) = pairs[above - 1], pairs[above]
        return y1 + (y2 - y1) * (min(max(at, pairs[0][0]), pairs[-1][0]) - x1) / (x2 - x1)


Step = Callable[[Notebook, float], float]
"""A step done wrong: what is written there, from the notebook and the right number."""


def not_below(size: float, least: float) -> bool:
    """Tell whether a size is at least a value, but for the last figure that was rounded."""
    return size >= least * (1 - 1e-9)


def sine(angle: float) -> float:
    """Return the sine of an angle in degrees."""
    return sin(radians(angle))


def cosine(angle: float) -> float:
    """Return the cosine of an angle in degrees."""
    return cos(radians(angle))


def tangent(angle: float) -> float:
    """Return the tangent of an angle in degrees."""
    return tan(radians(angle))


def arcsine(ratio: float) -> float:
    """Return the angle in degrees that has a sine."""
    return degrees(asin(ratio))


def arccosine(ratio: float) -> float:
    """Return the angle in degrees that has a cosine."""
    return degrees(acos(ratio))


def arctangent(ratio: float) -> float:
    """Return the angle in degrees that has a tangent."""
    return degrees(atan(ratio))


def direction(across: float, along: float) -> float:
    """Return the angle in degrees from the axis to a point."""
    return degrees(atan2(across, along))
