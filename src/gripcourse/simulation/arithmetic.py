"""Numbers as people write them down: so many figures, rounded or cut off, with their own pi.

Everything works on arrays, one entry per student, and on single numbers as arrays of shape ().
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gripcourse.formula.tree import Formula, Name, Node, walk
from gripcourse.slips.rewrite import renamed

Array = NDArray[np.float64]

DISPLAY: Final = 10
"""Figures that a calculator shows: a result of 2.9999999999999996 stands on its display as 3."""

_REMEMBERED: Final = 1024  # formulas with pi, and ways to get them wrong

PI: Final = "π"
"""Where a student's own pi stands among the values; no quantity can be called so."""


class DigitRounding(StrEnum):
    """What becomes of the figures that are not written."""

    ROUND = "round"
    TRUNCATE = "truncate"
    FULL = "full"  # all that the calculator shows are written


@dataclass(frozen=True, slots=True)
class Hand:
    """How students compute and write, arrays of shape (n,), or () for one student.

    Attributes:
        figures: significant figures that are written, 1 to `DISPLAY`.
        cuts: whether the others are cut off instead of rounded.
        keeps: whether the next step is computed with what the calculator holds, not with what was
            written.
        pi: the students'.
        constants: of the course, as the students take them, in declared units.
    """

    figures: NDArray[np.int64]
    cuts: NDArray[np.bool_]
    keeps: NDArray[np.bool_]
    pi: Array
    constants: Mapping[str, Array]

    def written(self, value: ArrayLike) -> Array:
        """Return what is written of numbers."""
        return written(value, self.figures, self.cuts)

    def going_on_with(self, value: Array, typed: Array) -> Array:
        """Return the number that the next step is computed with."""
        return np.where(self.keeps, value, typed)


def written(value: ArrayLike, figures: ArrayLike, cuts: ArrayLike) -> Array:
    """Return numbers as they are written down.

    Args:
        value: any shape; NaN stays NaN.
        figures: significant figures, 1 to `DISPLAY`.
        cuts: whether the others are cut off instead of rounded.
    """
    exact = np.asarray(value, dtype=np.float64)
    known = np.isfinite(exact) & (exact != 0)
    size = np.where(known, np.abs(exact), 1.0)
    places = np.asarray(figures) - 1 - np.floor(np.log10(size)).astype(np.int64)
    # Powers of ten up to 22 are exact: dividing by one is right where multiplying by 0.01 is not.
    up, down = 10.0 ** np.maximum(places, 0), 10.0 ** np.maximum(-places, 0)
    hidden = 10.0 ** (DISPLAY - np.asarray(figures))
    displayed = np.rint(np.where(known, exact, 0.0) * up / down * hidden) / hidden
    whole = np.where(cuts, np.trunc(displayed), np.rint(displayed))
    return np.where(known, whole * down / up, exact)


def with_own_pi(formula: Formula) -> Formula:
    """Return a formula that takes pi from the values, where it uses it."""
    if not any(isinstance(part, Name) and part.id == "pi" for part in walk(formula.tree)):
        return formula
    return _with_own_pi(formula.tree, tuple(formula.units.items()))


@lru_cache(maxsize=_REMEMBERED)
def _with_own_pi(tree: Node, units: tuple[tuple[str, str], ...]) -> Formula:
    named = {**dict(units), PI: ""} if units else {}
    return Formula("", renamed(tree, {"pi": Name(PI)}), named)
