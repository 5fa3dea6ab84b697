"""Whoever writes few digits writes all numbers so, and is known by it."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from gripcourse.grading.last_digits import LastDigit, rule_of
from gripcourse.submission.model import Answer

ASKED = 3  # figures of a careful student

WHOLE = LastDigit(decimals=1, whole_from=10.0)
ONE_DECIMAL = LastDigit(decimals=1)
TWO_FIGURES = LastDigit(figures=2)


@pytest.fixture
def cells(read_answer: Callable[..., Answer]) -> Callable[..., list[Answer]]:
    """Numbers as they were typed."""

    def make(*values: float) -> list[Answer]:
        return [replace(read_answer("q", value), half_unit=0.5) for value in values]

    return make


def test_whole_numbers_with_a_decimal_below_ten(cells: Callable[..., list[Answer]]) -> None:
    assert rule_of(cells(145, 3.1, 0.6, 26, 1250, 8.4), ASKED) == WHOLE


def test_one_decimal_of_large_numbers_too(cells: Callable[..., list[Answer]]) -> None:
    assert rule_of(cells(145.2, 3.1, 0.6, 26.7, 1250.3, 8.4), ASKED) == ONE_DECIMAL


def test_two_figures_of_large_numbers_too(cells: Callable[..., list[Answer]]) -> None:
    assert rule_of(cells(150, 3.1, 0.63, 27, 1300, 8.4, 0.021), ASKED) == TWO_FIGURES


def test_three_figures_of_which_some_end_in_zeros_are_no_few_digits(
    cells: Callable[..., list[Answer]],
) -> None:
    """5.00 stands as 5 in a cell, and 0.630 as 0.63."""
    assert rule_of(cells(145, 3.14, 0.63, 26.7, 5, 8.41, 0.512), ASKED) is None


@pytest.mark.parametrize(
    ("rule", "value", "written"),
    [
        (WHOLE, 26.5, 27),
        (WHOLE, -8.46, -8.5),
        (WHOLE, 0.0027, 0.0027),
        (ONE_DECIMAL, 26.54, 26.5),
        (TWO_FIGURES, 1255, 1300),
        (TWO_FIGURES, 0.0, 0.0),
    ],
)
def test_a_result_is_written_by_the_rule(rule: LastDigit, value: float, written: float) -> None:
    assert rule.written(value) == pytest.approx(written)
