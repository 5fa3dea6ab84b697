import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.text.number_reading import LONGEST, NumberRead, Unreadable, read_number


def read(text: str) -> NumberRead:
    result = read_number(text)
    assert isinstance(result, NumberRead), result
    return result


def reason(text: str) -> str:
    result = read_number(text)
    assert isinstance(result, Unreadable), result
    return str(result.reason)


@pytest.mark.parametrize(
    ("typed", "value"),
    [
        ("12,5", 12.5),
        ("12.5", 12.5),
        ("  12,5 ", 12.5),
        ("+3", 3.0),
        (",5", 0.5),
        ("5,", 5.0),
        ("12,5.", 12.5),
        ("-5,5", -5.5),
        ("\u22125.5", -5.5),
        ("\u2013 5,5", -5.5),
        ("\u20145,5", -5.5),
        ("\u20115,5", -5.5),
        ("1 250,5", 1250.5),
        ("1\u00a0250,5", 1250.5),
        ("1\u202f250\u2009000", 1_250_000.0),
        ("\ufeff12,5\u200b", 12.5),
        ("'12,5", 12.5),
        ("1e3", 1000.0),
        ("1,5E-3", 0.0015),
        ("1,5е3", 1500.0),
        ("1,5Е+03", 1500.0),
        ("1,5*10^3", 1500.0),
        ("1,5*10**3", 1500.0),
        ("1,5·10^3", 1500.0),
        ("1,5 × 10³", 1500.0),
        ("1,5х10³", 1500.0),
        ("1,5x10^(-3)", 0.0015),
        ("1,5·10⁻³", 0.0015),
        ("10³", 1000.0),
        ("10^-2", 0.01),
        ("0", 0.0),
        ("0,000", 0.0),
    ],
)
def test_one_number_is_read_however_it_is_typed(typed: str, value: float) -> None:
    result = read(typed)
    assert result.value == value
    assert result.unit == ""


def test_a_typed_minus_zero_is_zero() -> None:
    assert math.copysign(1, read("-0").value) == 1


@pytest.mark.parametrize(
    ("typed", "half"),
    [("12,5", 0.05), ("12,50", 0.005), ("1500", 0.5), ("1,5e3", 50.0), ("0,000", 0.0005)],
)
def test_half_a_unit_of_the_last_typed_digit_is_known(typed: str, half: float) -> None:
    assert read(typed).half_unit == pytest.approx(half, rel=1e-12)


@pytest.mark.parametrize(
    ("typed", "unit"),
    [
        ("12,5 Н", "Н"),
        ("12,5кН", "кН"),
        ("12 м/с2", "м/с2"),
        ("12 м/с^2", "м/с^2"),
        ("12 м·с-2", "м*с-2"),
        ("12 мм²", "мм²"),
        ("5%", "%"),
        ("36,87°", "°"),
        ("1,5·10³ Н", "Н"),
        ("12 ед.", "ед"),
        ("12 (мм)", "(мм)"),
    ],
)
def test_what_stands_behind_the_number_is_kept_as_its_unit(typed: str, unit: str) -> None:
    assert read(typed).unit == unit


@pytest.mark.parametrize("typed", ["1,250", "1.250", "-12,345"])
def test_a_single_sign_before_three_digits_is_decimal_and_is_remarked_on(typed: str) -> None:
    result = read(typed)
    assert abs(result.value) < 100
    assert "decimal sign" in str(result.remarks[0])


@pytest.mark.parametrize("typed", ["0,250", "12,5", "1250,125"])
def test_a_sign_that_can_only_be_decimal_is_not_remarked_on(typed: str) -> None:
    assert read(typed).remarks == ()


@pytest.mark.parametrize(
    ("typed", "value"),
    [("1.250,5", 1250.5), ("1,250.5", 1250.5), ("1.250.000", 1_250_000.0), ("1,250,000", 1.25e6)],
)
def test_signs_between_groups_of_three_are_read_and_remarked_on(typed: str, value: float) -> None:
    result = read(typed)
    assert result.value == value
    assert "groups of three" in str(result.remarks[0])


@pytest.mark.parametrize("typed", ["≈12,5", "~12,5", "= 12,5", "D_тр = 12,5", "F=12,5"])
def test_a_sign_or_symbol_before_the_number_is_left_out_and_remarked_on(typed: str) -> None:
    result = read(typed)
    assert result.value == 12.5
    assert "left out" in str(result.remarks[0])


@pytest.mark.parametrize(
    "typed",
    [
        *("12-13", "12…13", "12..13", "12±1", "12 ± 0,5", "12 13", "12; 13", "12 или 13"),
        *("12 мм (13)", "12,5 13,5", "1,5*2", "2^3", "5²", "1:30", "12x13"),
        *("12,345 678", "12 3456"),
    ],
)
def test_ranges_several_numbers_and_calculations_are_not_one_number(typed: str) -> None:
    assert "One number is needed" in reason(typed)


@pytest.mark.parametrize("typed", ["=1,5*2", "=A1", "=СУММ(A1;B2)", "="])
def test_a_formula_in_a_text_cell_is_told_as_one(typed: str) -> None:
    assert "formula was typed" in reason(typed)


@pytest.mark.parametrize("typed", ["1.5.26", "31.12.2025"])
def test_a_typed_date_is_told_as_one(typed: str) -> None:
    assert "date" in reason(typed)


@pytest.mark.parametrize("typed", ["٧٬٦٤٥٫٥", "۷۶۴۵٫۵", "７６４５．５", "7645٫5"])
def test_digits_of_other_keyboards_are_digits(typed: str) -> None:
    found = read_number(typed)
    assert isinstance(found, NumberRead)
    assert (found.value, found.half_unit) == (7645.5, 0.05)


@pytest.mark.parametrize(
    "typed", ["", "x", "inf", "nan", "∞", "-", ".", "१", "одиннадцать", "#Н/Д"]
)
def test_text_that_does_not_begin_with_a_number_is_unreadable(typed: str) -> None:
    assert "does not begin with a number" in reason(typed)


@pytest.mark.parametrize(
    "typed", ["1e400", "10^400", "1e-400", "0e400", "1e" + "9" * 150, "5·10^" + "9" * 150]
)
def test_a_number_beyond_what_computers_hold_is_unreadable_and_never_zero(typed: str) -> None:
    assert "too large or too small" in reason(typed)


@pytest.mark.parametrize("typed", ["1.2.3,4", "1,25.5.5", "12.34,5"])
def test_signs_that_make_no_groups_are_not_guessed_at(typed: str) -> None:
    assert reason(typed)


@pytest.mark.parametrize(
    "typed", ["1" * (LONGEST + 1), "1 " * 500_000, "(" * 1_000_000, "x" * 1000]
)
def test_a_long_text_is_refused_for_its_length(typed: str) -> None:
    assert "too long" in reason(typed)


@given(st.text(max_size=250))
def test_no_text_raises_or_gives_anything_but_a_finite_number(text: str) -> None:
    result = read_number(text)
    if isinstance(result, NumberRead):
        assert math.isfinite(result.value)
        assert math.isfinite(result.half_unit)


@given(st.text(alphabet="0123456789.,-+eЕ ·*^³⁻()=≈xмН%°±…", max_size=40))
def test_no_mixture_of_what_numbers_are_made_of_raises(text: str) -> None:
    result = read_number(text)
    assert isinstance(result, NumberRead | Unreadable)
    if isinstance(result, NumberRead):
        assert any(sign.isdigit() for sign in text)


@given(
    whole=st.integers(0, 10**9),
    decimals=st.text(alphabet="0123456789", max_size=6),
    minus=st.sampled_from(["", "-", "\u2212", "\u2013"]),
    space=st.sampled_from(["", " ", "\u00a0", "\u202f"]),
    sign=st.sampled_from([",", "."]),
    unit=st.sampled_from(["", " Н", "мм", " м/с²"]),
)
def test_grouping_signs_and_units_never_change_the_number(
    whole: int, decimals: str, minus: str, space: str, sign: str, unit: str
) -> None:
    grouped = f"{whole:,}".replace(",", space)
    typed = f"{minus}{grouped}{sign + decimals if decimals else ''}{unit}"
    expected = float(f"{'-' if minus else ''}{whole}.{decimals or '0'}")
    assert read(typed).value == expected


@pytest.mark.parametrize(
    "typed",
    ["2pi", "2 пи", "3 pi/4", "2 пі", "1e3e3", "12e+", "12e-", "1 ООО", "12 OOO", "1 ооо Н"],
)
def test_what_multiplies_a_number_or_hides_its_digits_is_no_unit(typed: str) -> None:
    assert reason(typed)
