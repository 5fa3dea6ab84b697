"""The coefficient of crossed cylinders against printed tables and other integrals."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula.hertz import crossed_cylinders

# Computed with exact elliptic integrals, to four figures; the first is the sphere on a plane.
EXACT = {
    1.0: 0.3880,
    0.9: 0.4020,
    0.8: 0.4186,
    0.7: 0.4385,
    0.6: 0.4634,
    0.5: 0.4954,
    0.4: 0.5388,
    0.3: 0.6025,
    0.2: 0.7097,
    0.15: 0.8002,
    0.1: 0.9520,
    0.05: 1.2934,
}


@pytest.mark.parametrize(("ratio", "expected"), EXACT.items())
def test_it_agrees_with_the_exact_table(ratio: float, expected: float) -> None:
    assert float(crossed_cylinders(np.asarray(ratio))) == pytest.approx(expected, abs=5.1e-5)


def test_equal_cylinders_press_as_a_sphere_on_a_plane() -> None:
    sphere = (1.5 / np.pi) * (4 / (6 * (1 - 0.3**2))) ** (2 / 3)
    assert float(crossed_cylinders(np.asarray(1.0))) == pytest.approx(sphere, rel=1e-12)


@given(st.floats(1e-3, 1))
def test_it_solves_hertz_equations_with_other_integrals(ratio: float) -> None:
    """Put the pressure back into Hertz's equations, integrated by quadrature."""
    m = float(crossed_cylinders(np.asarray(ratio)))
    # With F = R = E = 1: semi-axes a > b from p0 = 3F/(2πab) and the curvature 1/R along a.
    product = 3 / (2 * np.pi * m)
    low, high = np.sqrt(product), np.sqrt(product) * 1e3
    for _ in range(60):
        a = np.sqrt(low * high)
        low, high = (a, high) if _curvatures(a, product / a)[0] > 1 else (low, a)
    along, across = _curvatures(a, product / a)
    assert along == pytest.approx(1, rel=1e-9)
    assert across == pytest.approx(1 / ratio, rel=1e-7)


def _curvatures(a: float, b: float) -> tuple[float, float]:
    """Return 1/R of both cylinders for the ellipse a, b under a unit force, E = 1, ν = 0.3."""
    # The midpoint rule is as good as exact for a smooth periodic integrand.
    step = np.pi / 2 / 4000
    t = (np.arange(4000) + 0.5) * step
    delta = np.sqrt(a**2 * np.cos(t) ** 2 + b**2 * np.sin(t) ** 2)
    along = 2 * float(np.sum(np.cos(t) ** 2 / delta**3)) * step
    across = 2 * float(np.sum(np.sin(t) ** 2 / delta**3)) * step
    factor = 3 * (1 - 0.3**2) / np.pi
    return factor * along, factor * across


def test_a_ratio_and_its_reciprocal_are_the_same_contact() -> None:
    ratios = np.array([0.05, 0.3, 0.99])
    np.testing.assert_allclose(crossed_cylinders(1 / ratios), crossed_cylinders(ratios), rtol=1e-12)


@pytest.mark.parametrize("ratio", [0.0, -0.5, 1e-7, 1e7, np.nan])
def test_what_is_no_pair_of_cylinders_has_no_coefficient(ratio: float) -> None:
    assert np.isnan(crossed_cylinders(np.asarray(ratio)))


def test_it_grows_without_a_jump_as_the_smaller_radius_shrinks() -> None:
    found = crossed_cylinders(np.geomspace(1, 1e-5, 4000))
    assert np.all(np.diff(found) > 0)
    assert np.max(np.diff(np.log(found))) < 0.003
