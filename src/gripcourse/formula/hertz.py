"""Hertz's contact of two cylinders that cross at a right angle.

The greatest pressure is m·∛(F·E²/R²), with R the larger radius, E = 2·E1·E2/(E1 + E2) and a
Poisson ratio of 0.3 of both; m depends on the ratio of the radii alone. The ellipse of contact
follows from complete elliptic integrals (K. L. Johnson, Contact Mechanics, §4.2), computed here by
the arithmetic-geometric mean; tables of m in handbooks have two or three figures.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_POISSON: Final = 0.3
_STEPS_OF_MEAN: Final = 7  # quadratic: 1e-16 from an ellipse as flat as 1 to 10 000
_STEPS_OF_AXES: Final = 24  # each leaves at most a seventh of the error
_SLOPE: Final = 1.75  # of log(radii) by log(axes), which lies between 1.5 and 2
_FLATTEST: Final = 1e-6  # ratio of radii; below it the ellipse is a line for all that matters


def crossed_cylinders(ratio: Array) -> Array:
    """Return m for a ratio of the radii, whichever of the two is larger.

    Args:
        ratio: of the radii, any shape; a ratio and its reciprocal are the same contact.

    Returns:
        The coefficient m, of the same shape; NaN where the ratio is not positive or too extreme.
    """
    with np.errstate(all="ignore"):
        smaller = np.minimum(ratio, 1 / ratio)
        wanted = np.log(np.where(smaller >= _FLATTEST, smaller, np.nan))
        axes = np.exp(_log_axes(wanted))
        share, first_kind = _integrals(axes)
        growth = np.pi / (6 * (1 - _POISSON**2) * first_kind * share)
        return np.asarray(3 / (2 * np.pi * axes) * np.cbrt(growth) ** 2)


def _log_axes(wanted: Array) -> Array:
    """Find the logarithm of the ratio of the ellipse's axes (minor to major) for one of radii."""
    found = wanted / _SLOPE
    for _ in range(_STEPS_OF_AXES):
        share, _kind = _integrals(np.exp(found))
        found = found - (2 * found + np.log(share / (1 - share)) - wanted) / _SLOPE
    return found


def _integrals(axes: Array) -> tuple[Array, Array]:
    """Return (K - E)/(e²·K) and K, where e² = 1 - axes² is the square of the eccentricity.

    Both without a difference of nearly equal numbers, so that a circle is no special case.
    """
    arithmetic, geometric = np.ones_like(axes), axes
    share, weight = np.full_like(axes, 0.5), 1.0
    gap = ((1 - axes) / 2) ** 2  # square of half the difference of the means
    relative = (1 - axes) / (4 * (1 + axes))  # the same over e²
    for _ in range(_STEPS_OF_MEAN):
        arithmetic, geometric = (arithmetic + geometric) / 2, np.sqrt(arithmetic * geometric)
        share, weight = share + weight * relative, 2 * weight
        narrowing = gap / (2 * (arithmetic + geometric)) ** 2
        relative, gap = relative * narrowing, gap * narrowing
    return share, np.pi / (arithmetic + geometric)
