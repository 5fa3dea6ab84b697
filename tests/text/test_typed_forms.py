"""How people write numbers when they write more than digits."""

import pytest

from gripcourse.text.number_reading import NumberRead, Unreadable, read_number
from gripcourse.text.typed_forms import ALL_DIGITS, AMONG_DIGITS, MARKED


@pytest.mark.parametrize(
    ("typed", "value", "unit"),
    [
        ("36°52'12\"", 36.87, "°"),
        ("36° 52′ 12″", 36.87, "°"),
        ("25°30'", 25.5, "°"),
        ("25º30'", 25.5, "°"),
        ("25 град 30 мин", 25.5, "°"),
        ("25 град. 30 хв. 36 сек", 25.51, "°"),
        ("-12°30'", -12.5, "°"),
        ("0°0,5'", 0.5 / 60, "°"),
        ("1/2", 0.5, ""),
        ("3/4", 0.75, ""),
        ("1 1/2", 1.5, ""),
        ("½", 0.5, ""),
        ("2½", 2.5, ""),
        ("ок. 12", 12.0, ""),
        ("около 12,5", 12.5, ""),
        ("прибл. 12", 12.0, ""),
        ("примерно 12", 12.0, ""),
        ("близько 12", 12.0, ""),
        ("approx. 12", 12.0, ""),
        ("Ø12,5", 12.5, ""),
        ("ф 16", 16.0, ""),
        ("Ø 16 мм", 16.0, "мм"),
        ("12'500", 12500.0, ""),
        ("1’250’000,5", 1250000.5, ""),
        ("１２，５", 12.5, ""),
        ('"12,5"', 12.5, ""),
        ("«12,5 мм»", 12.5, "мм"),
        ("16 (ГОСТ 6636-69)", 16.0, ""),
        ("16 мм (по ГОСТ 6636-69)", 16.0, "мм"),
        ("63 (ряд 1)", 63.0, ""),
        ("97,31 (по формуле 3)", 97.31, ""),
        ("97,31 Н (см. рис. 2)", 97.31, "Н"),
        ("97.31 N (eq. 28)", 97.31, "N"),
        ("α = 25°30'", 25.5, "°"),
        ("ок. 25°30'", 25.5, "°"),
        ("2 1/2 мм", 2.5, "мм"),
        ("1½ мм", 1.5, "мм"),
        ("50ᵍ", 50.0, "gon"),
    ],
)
def test_what_people_type_is_read(typed: str, value: float, unit: str) -> None:
    read = read_number(typed)
    assert isinstance(read, NumberRead)
    assert read.value == pytest.approx(value)
    assert read.unit == unit


@pytest.mark.parametrize(
    "typed",
    ["39ОО", "1O5", "3o", "1l5", "12,O", "3б", "1З", "3З4", "2B4", "12 тыс", "1,5 млн", "2 тис."],
)
def test_nothing_is_guessed(typed: str) -> None:
    read = read_number(typed)
    assert isinstance(read, Unreadable)
    assert str(read.reason) in {str(AMONG_DIGITS), str(ALL_DIGITS)}


@pytest.mark.parametrize(
    "typed", ["32/12", "12/1", "1/0", "25°75'", "12-13", "12…13", "12,5±0,1", "25º30"]
)
def test_what_may_mean_two_things_is_asked_about(typed: str) -> None:
    assert isinstance(read_number(typed), Unreadable)


@pytest.mark.parametrize("typed", ['12.5"', "30'", "5''", "12 ′"])
def test_a_mark_that_may_be_minutes_or_inches_is_asked_about(typed: str) -> None:
    read = read_number(typed)
    assert isinstance(read, Unreadable)
    assert str(read.reason) == str(MARKED)


@pytest.mark.parametrize("typed", ["12 l", "12 l/min", "12 об/мин", "12 В", "5 Ом", "12 o'clock"])
def test_letters_of_units_are_no_digits(typed: str) -> None:
    assert isinstance(read_number(typed), NumberRead)


def test_minutes_are_known_to_half_a_minute() -> None:
    read = read_number("25°30'")
    assert isinstance(read, NumberRead)
    assert read.half_unit == pytest.approx(0.5 / 60)
    assert read_number("1/2") == NumberRead(0.5, 0.0, "", (), None)
