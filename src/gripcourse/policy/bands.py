"""Bands: how far an answer may be from the value that it is judged against."""

import math

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Kind, Quantity, Tolerance
from gripcourse.policy.model import Policy
from gripcourse.text.units import factor

Array = NDArray[np.float64]

# Values that are read from a table or a series differ only by how floating point writes them.
_EXACT = 1e-6
# Most that a floor by unit may be of a value that cannot be zero.
FLOOR_SHARE = 0.02
# An answer exactly on the edge of the band passes, whatever the last bit says.
SLACK = 1 + 1e-9


def band(quantity: Quantity, expected: float, policy: Policy) -> float:
    """Return the half width of the band round an expected value, in the declared unit.

    The wider of a relative and an absolute part counts: near zero a relative band is empty. A
    quantity's own tolerance in the policy goes before its declaration, that before the default.
    """
    tolerance = _tolerance_of_kind(quantity, policy)
    return max(abs(expected) * tolerance.relative, _absolute(quantity, expected, tolerance, policy))


def computed_band(quantity: Quantity, expected: float, policy: Policy) -> float:
    """Return the half width of the band round a computed value, in the declared unit.

    For a decision it is that of the value which the decision must not be below.
    """
    tolerance = tolerance_of(quantity, policy)
    return max(abs(expected) * tolerance.relative, _absolute(quantity, expected, tolerance, policy))


def bands(quantity: Quantity, expected: Array, policy: Policy) -> Array:
    """Return the half widths round many expected values, SI, in their shape."""
    tolerance = _tolerance_of_kind(quantity, policy)
    size = np.abs(expected)
    absolute = np.asarray(tolerance.absolute * factor(quantity.unit))
    if _is_floor(quantity, policy) and _has_one_sign(quantity):
        absolute = np.minimum(absolute, FLOOR_SHARE * size)
    widths: Array = np.maximum(size * tolerance.relative, absolute)
    return widths


def _absolute(quantity: Quantity, expected: float, tolerance: Tolerance, policy: Policy) -> float:
    """Return the absolute part: a floor by unit stays small beside a value that cannot be zero.

    A floor of 0.01 mm is for differences that come near zero. It must not accept 0.006 mm for a
    deflection of 0.015 mm.
    """
    if _is_floor(quantity, policy) and _has_one_sign(quantity):
        return min(tolerance.absolute, FLOOR_SHARE * abs(expected))
    return tolerance.absolute


def _is_floor(quantity: Quantity, policy: Policy) -> bool:
    """Tell whether the absolute part is the default of the unit, not one of the quantity's own."""
    own = policy.tolerances.get(quantity.id) or quantity.tolerance
    return own is None or not own.absolute


def _has_one_sign(quantity: Quantity) -> bool:
    low, high = quantity.bounds
    return low > 0 or high < 0


def tolerance_of(quantity: Quantity, policy: Policy) -> Tolerance:
    """Return the tolerance that applies to a quantity."""
    own = policy.tolerances.get(quantity.id) or quantity.tolerance or policy.tolerance
    return Tolerance(own.relative, own.absolute or policy.floors.get(quantity.unit, 0.0))


def _tolerance_of_kind(quantity: Quantity, policy: Policy) -> Tolerance:
    if quantity.exact and quantity.kind is not Kind.VERDICT:
        return Tolerance(_EXACT, 0.0)
    return tolerance_of(quantity, policy)


def within(value: float, expected: float, half_width: float) -> bool:
    """Tell whether a value lies in the band; a value that cannot be computed matches nothing."""
    if not (math.isfinite(value) and math.isfinite(expected)):
        return False
    return abs(value - expected) <= half_width * SLACK
