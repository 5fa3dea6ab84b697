"""Numbers as people write them down."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.simulation.arithmetic import PI, with_own_pi, written

FIGURES = st.integers(1, 10)
NUMBERS = st.floats(1e-12, 1e12) | st.floats(-1e12, -1e-12)


@pytest.mark.parametrize(
    ("value", "figures", "cuts", "expected"),
    [
        (1836.4, 3, False, 1840.0),
        (1836.4, 3, True, 1830.0),
        (0.0123456, 4, False, 0.01235),
        (0.0123456, 4, True, 0.01234),
        (-2.999, 3, True, -2.99),
        (999.6, 3, False, 1000.0),
        (0.0, 3, False, 0.0),
    ],
)
def test_the_other_figures_are_rounded_or_cut_off(
    *,
    value: float,
    figures: int,
    cuts: bool,
    expected: float,
) -> None:
    assert float(written(value, figures, cuts)) == expected


def test_what_floating_point_adds_is_not_cut_off_as_a_whole_unit() -> None:
    assert float(written(2.9999999999999996, 3, cuts=True)) == 3.0
    assert float(written(0.1 + 0.2, 4, cuts=True)) == 0.3


def test_a_value_that_is_none_stays_none() -> None:
    assert math.isnan(float(written(math.nan, 3, cuts=False)))


def test_many_students_write_at_once() -> None:
    found = written(np.array([12345.0, 12345.0]), np.array([3, 4]), np.array([False, True]))
    assert found.tolist() == [12300.0, 12340.0]


@given(value=NUMBERS, figures=FIGURES, cuts=st.booleans())
def test_less_than_a_unit_of_the_last_figure_is_lost(
    *,
    value: float,
    figures: int,
    cuts: bool,
) -> None:
    lost = abs(float(written(value, figures, cuts)) - value)
    # The display's own ten figures come first.
    unit = 10.0 ** (math.floor(math.log10(abs(value))) - figures + 1)
    assert lost <= (1.0 if cuts else 0.5) * unit * (1 + 1e-9) + 1e-9 * abs(value)


@given(value=NUMBERS, figures=FIGURES, cuts=st.booleans())
def test_what_is_written_is_written_the_same_again(
    *,
    value: float,
    figures: int,
    cuts: bool,
) -> None:
    once = written(value, figures, cuts)
    assert float(written(once, figures, cuts)) == float(once)


def test_a_student_computes_with_an_own_pi() -> None:
    formula = with_own_pi(Formula("", parse("pi*bore**2/4"), {}))
    values = {"bore": np.asarray(2.0), PI: np.asarray(3.14)}
    assert float(evaluate(formula, "m**2", values, {})) == pytest.approx(3.14)


def test_a_formula_without_pi_is_left_alone() -> None:
    formula = Formula("", parse("bore/2"), {})
    assert with_own_pi(formula) is formula
