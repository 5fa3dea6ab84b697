"""A cell is a number exactly as written, or no number."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.variants.cells import converted, exact_number, number_text


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("60", 60.0),
        ("0.15", 0.15),
        ("-5.5", -5.5),
        ("−5.5", -5.5),
        ("+3", 3.0),
        (".5", 0.5),
        ("5.", 5.0),
        ("2e5", 2e5),
        ("1E-3", 1e-3),
        ("1 234.5", 1234.5),
        ("1\u00a0234.5", 1234.5),
        ("1\u202f234", 1234.0),
    ],
)
def test_numbers_with_a_point_are_read_in_every_table(text: str, value: float) -> None:
    assert exact_number(text, decimal_comma=False) == value
    assert exact_number(text, decimal_comma=True) == value


@pytest.mark.parametrize("text", ["0", "-0,0", "0e-999", "0.000E9"])
def test_a_zero_is_a_zero_however_it_is_written(text: str) -> None:
    assert exact_number(text, decimal_comma=True) == 0


def test_a_comma_is_decimal_only_where_it_cannot_group() -> None:
    assert exact_number("1,234", decimal_comma=True) == 1.234
    assert exact_number("1,234", decimal_comma=False) is None


@pytest.mark.parametrize(
    "text",
    [
        "",
        "60 kg",
        "1.2.3",
        "1,2,3",
        "1,234.5",
        "nan",
        "inf",
        "1e999",
        "1e-999",
        "0x10",
        "1_000",
        "--5",
    ],
)
def test_what_is_not_one_number_is_none(text: str) -> None:
    assert exact_number(text, decimal_comma=True) is None


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_written_number_is_read_back_equal(value: float) -> None:
    assert exact_number(number_text(value), decimal_comma=False) == value


def test_whole_numbers_are_written_without_a_point() -> None:
    assert [number_text(value) for value in (60.0, -0.0, 2e5, 0.15)] == [
        "60",
        "0",
        "200000",
        "0.15",
    ]


def test_conversion_adds_no_digits() -> None:
    assert converted(0.15, "m", "mm") == 150.0
    assert converted(100.0, "bar", "MPa") == 10.0
    assert converted(0.1 + 0.2, "mm", "mm") == 0.1 + 0.2
