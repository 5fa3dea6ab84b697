"""Numbers as people write them down: so many figures, rounded or cut off, with their own pi."""

from enum import StrEnum
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gripcourse.formula.tree import Formula
from gripcourse.slips.rewrite import number, renamed

# What a calculator shows. A result of 2.9999999999999996 stands on its display as 3.
DISPLAY: Final = 10


class Rounding(StrEnum):
    """What becomes of the figures that are not written."""

    ROUND = "round"
    TRUNCATE = "truncate"
    FULL = "full"  # all that the calculator shows are written


def written(value: ArrayLike, figures: int, rounding: Rounding) -> NDArray[np.float64]:
    """Return numbers as they are written down.

    Args:
        value: any shape; NaN stays NaN.
        figures: significant figures, at least 1; without meaning for `FULL`.
        rounding: of the others.
    """
    exact = np.asarray(value, dtype=np.float64)
    shown = figures if rounding is not Rounding.FULL else DISPLAY
    known = np.isfinite(exact) & (exact != 0)
    size = np.where(known, np.abs(exact), 1.0)
    places = shown - 1 - np.floor(np.log10(size)).astype(np.int64)
    # Powers of ten up to 22 are exact: dividing by one is right where multiplying by 0.01 is not.
    up, down = 10.0 ** np.maximum(places, 0), 10.0 ** np.maximum(-places, 0)
    displayed = np.round(exact * up / down, DISPLAY - shown)
    whole = np.trunc(displayed) if rounding is Rounding.TRUNCATE else np.rint(displayed)
    return np.where(known, whole * down / up, exact)


def with_pi(formula: Formula, pi: float) -> Formula:
    """Return a formula with another number in the place of pi."""
    if pi == np.pi:
        return formula
    tree = renamed(formula.tree, {"pi": number(pi)})
    return formula if tree == formula.tree else Formula("", tree, formula.units)
