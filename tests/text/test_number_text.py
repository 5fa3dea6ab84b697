import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.text.number_reading import NumberRead, read_number
from gripcourse.text.number_text import format_number

FINITE = st.floats(allow_nan=False, allow_infinity=False, min_value=-1e300, max_value=1e300)


@pytest.mark.parametrize(
    ("value", "language", "written"),
    [
        (1234.5, "ru", "1234,5"),
        (12345.6, "ru", "12\u202f346"),
        (12345.6, "uk", "12\u202f346"),
        (12345.6, "en", "12\u202f346"),
        (123456789, "ru", "123\u202f460\u202f000"),
        (-5.5, "ru", "\u22125,5"),
        (-5.5, "en", "\u22125.5"),
        (60.0844, "ru", "60,084"),
        (63.0, "ru", "63"),
        (0.0001, "ru", "0,0001"),
        (0.00001234567, "ru", "1,2346·10⁻⁵"),
        (2.5e9, "en", "2.5·10⁹"),
        (999_999_999.9, "en", "1·10⁹"),
        (0.0, "ru", "0"),
        (-0.0, "ru", "0"),
        (math.nan, "ru", "—"),
        (math.inf, "ru", "∞"),
        (-math.inf, "ru", "\u2212∞"),
    ],
)
def test_a_number_is_written_as_the_language_writes_it(
    value: float, language: str, written: str
) -> None:
    assert format_number(value, language) == written


def test_the_number_of_figures_is_kept_and_zeros_at_the_end_are_cut() -> None:
    assert format_number(math.pi, "en", 3) == "3.14"
    assert format_number(2.0004, "en", 3) == "2"


@given(FINITE, st.sampled_from(["ru", "uk"]))
def test_what_is_written_with_all_figures_reads_back_as_the_same_number(
    value: float, language: str
) -> None:
    read = read_number(format_number(value, language, 17))
    assert isinstance(read, NumberRead)
    assert read.value == value
    assert read.unit == ""


@given(st.floats(min_value=1e-200, max_value=1), st.integers(1, 15))
def test_the_half_unit_tells_how_far_rounding_can_have_moved_a_fraction(
    value: float, figures: int
) -> None:
    read = read_number(format_number(value, "ru", figures))
    assert isinstance(read, NumberRead)
    assert abs(read.value - value) <= read.half_unit + 1e-15 * value  # floats are not decimal
