"""Bands: how far an answer may be from the value that it is judged against."""

import math
from dataclasses import dataclass

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


@dataclass(frozen=True, slots=True)
class BandRule:
    """How wide the band of a quantity is round any value, in its declared unit.

    Attributes:
        relative, absolute: parts of the half width; the wider counts.
        beside_value: whether the absolute part stays a small share of the value.
    """

    relative: float
    absolute: float
    beside_value: bool

    def round(self, expected: float) -> float:
        """Return the half width round a value."""
        size = abs(expected)
        absolute = min(self.absolute, FLOOR_SHARE * size) if self.beside_value else self.absolute
        return max(size * self.relative, absolute)


def band_rule(quantity: Quantity, policy: Policy) -> BandRule:
    """Return the rule of the band round an expected value.

    The wider of a relative and an absolute part counts: near zero a relative band is empty. A
    quantity's own tolerance in the policy goes before its declaration, that before the default.
    A floor by unit stays small beside a value that cannot be zero: a floor of 0.01 mm is for
    differences that come near zero, and must not accept 0.006 mm for a deflection of 0.015 mm.
    """
    return _rule(quantity, _tolerance_of_kind(quantity, policy), policy)


def band_rules(quantity: Quantity, policy: Policy) -> tuple[BandRule, BandRule]:
    """Return both rules: round an expected value, and for a computed one."""
    rule = computed_band_rule(quantity, policy)
    return (band_rule(quantity, policy) if quantity.exact else rule), rule


def computed_band_rule(quantity: Quantity, policy: Policy) -> BandRule:
    """Return the rule for a computed value; of a decision: what it must not be below."""
    return _rule(quantity, tolerance_of(quantity, policy), policy)


def _rule(quantity: Quantity, tolerance: Tolerance, policy: Policy) -> BandRule:
    beside_value = _is_floor(quantity, policy) and _has_one_sign(quantity)
    return BandRule(tolerance.relative, tolerance.absolute, beside_value)


def band(quantity: Quantity, expected: float, policy: Policy) -> float:
    """Return the half width of the band round an expected value, in the declared unit."""
    return band_rule(quantity, policy).round(expected)


def bands(quantity: Quantity, expected: Array, policy: Policy) -> Array:
    """Return the half widths round many expected values, SI, in their shape."""
    tolerance = _tolerance_of_kind(quantity, policy)
    size = np.abs(expected)
    absolute = np.asarray(tolerance.absolute * factor(quantity.unit))
    if _is_floor(quantity, policy) and _has_one_sign(quantity):
        absolute = np.minimum(absolute, FLOOR_SHARE * size)
    widths: Array = np.maximum(size * tolerance.relative, absolute)
    return widths


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
