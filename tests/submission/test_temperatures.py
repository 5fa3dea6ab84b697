"""A temperature counts from 0 °C; kelvins measure it from absolute zero, or a difference of two."""

from dataclasses import replace

import pytest

from gripcourse.solver.plan import Plan
from gripcourse.submission.measure import Understood, from_text
from gripcourse.text.words import Message


@pytest.mark.parametrize(
    ("typed", "asked", "value"),
    [
        ("80 °C", "degC", 80.0),
        ("80°С", "degC", 80.0),  # the letter of the other alphabet
        ("80 ℃", "degC", 80.0),
        ("353,15 К", "degC", 80.0),
        ("353.15 kelvin", "degC", 80.0),
        ("16 K", "K", 16.0),
    ],
)
def test_a_temperature_is_read_as_it_is_written(
    plan: Plan, typed: str, asked: str, value: float
) -> None:
    quantity = replace(plan.answered[0], unit=asked)
    read = from_text(quantity, typed)
    assert isinstance(read, Understood)
    assert read.unit_fits
    assert read.value == value


@pytest.mark.parametrize(
    ("bounds", "value"),
    [((0.1, 200.0), 16.0), ((250.0, 600.0), 289.15)],
)
def test_degrees_where_kelvins_are_asked_are_what_its_bounds_admit(
    plan: Plan, bounds: tuple[float, float], value: float
) -> None:
    read = from_text(replace(plan.answered[0], unit="K", bounds=bounds), "16 °C")
    assert isinstance(read, Understood)
    assert read.value == value


@pytest.mark.parametrize("bounds", [(0.0, 1000.0), (20.0, 200.0)])
def test_degrees_that_bounds_do_not_tell_from_a_difference_are_not_guessed(
    plan: Plan, bounds: tuple[float, float]
) -> None:
    read = from_text(replace(plan.answered[0], unit="K", bounds=bounds), "16 °C")
    assert isinstance(read, Message)
    assert "difference" in str(read)


def test_degrees_of_an_angle_are_no_temperature(plan: Plan) -> None:
    read = from_text(replace(plan.answered[0], unit="degC"), "80°")
    assert isinstance(read, Understood)
    assert not read.unit_fits
