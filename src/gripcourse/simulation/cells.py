"""How a number stands in its cell: as a number, or as text with comma, groups and units."""

import math
from collections.abc import Iterable
from decimal import Decimal

import numpy as np

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.simulation.arithmetic import DISPLAY, DigitRounding
from gripcourse.simulation.model import Behaviour, Style
from gripcourse.text.conventions import decimal_sign
from gripcourse.text.units import dimension, factor, unit_text

_YES_AND_NO = {"en": ("yes", "no"), "ru": ("да", "нет"), "uk": ("так", "ні")}
_GROUP_SIGNS = ("\u00a0", "\u202f", "\u2009", " ")
_GROUPED_FROM = 5  # digits before the decimal sign
_WHOLE_POWER = 1e-9


def cell_of(
    quantity: Quantity,
    value: float,
    behaviour: Behaviour,
    language: str,
    units: Iterable[str],
) -> float | str | None:
    """Return what a student puts into a cell.

    Args:
        quantity: that is answered.
        value: in the declared unit; NaN where the student has none.
        behaviour: how the student writes.
        language: the student's.
        units: that people use, for a student who types numbers in another unit and says so.
    """
    if math.isnan(value):
        return None
    if quantity.kind is Kind.VERDICT:
        return _YES_AND_NO[language][0 if value else 1]
    if behaviour.style is Style.NUMBER:
        return float(f"{value:.15g}")
    if behaviour.style is Style.TEXT or not quantity.unit:
        return _text(_digits(quantity, value, behaviour), behaviour, language)
    unit = quantity.unit
    if behaviour.style is Style.TEXT_IN_OTHER_UNIT:
        others = [one for one in units if _is_a_power_of_ten(one, unit)]
        unit = others[behaviour.seed % len(others)] if others else unit
    return with_unit(quantity, value, unit, behaviour, language)


def with_unit(
    quantity: Quantity, value: float, unit: str, behaviour: Behaviour, language: str
) -> str:
    """Write a number of the declared unit, converted by a power of ten, with a unit behind it."""
    digits = _digits(quantity, value, behaviour)
    if dimension(unit) == dimension(quantity.unit):
        power = math.log10(factor(quantity.unit) / factor(unit))
        digits = digits.scaleb(round(power))
    return f"{_text(digits, behaviour, language)} {unit_text(unit, language)}"


def unfit_unit(quantity: Quantity, units: Iterable[str], rng: np.random.Generator) -> str | None:
    """Draw a unit that measures something else than a quantity does; None where there is none."""
    unfit = [one for one in units if one and dimension(one) != dimension(quantity.unit)]
    return str(rng.choice(unfit)) if unfit else None


def _is_a_power_of_ten(unit: str, declared: str) -> bool:
    # What has no dimension may still be a share or an angle: nobody writes 80 % as 0.8 rad.
    if (
        unit == declared
        or dimension(unit) != dimension(declared)
        or dimension(unit) == dimension("")
    ):
        return False
    power = math.log10(factor(declared) / factor(unit))
    return bool(unit) and abs(power - round(power)) < _WHOLE_POWER


def _digits(quantity: Quantity, value: float, behaviour: Behaviour) -> Decimal:
    """Return a number with the zeros at its end that a person writes: 2.50 has three figures."""
    if quantity.exact:
        return Decimal(f"{value:.12g}")
    if behaviour.rounding is DigitRounding.FULL:
        return Decimal(f"{value:.{DISPLAY}g}")
    return Decimal(f"{value:.{behaviour.figures - 1}e}")


def _text(digits: Decimal, behaviour: Behaviour, language: str) -> str:
    whole, _, decimals = f"{digits:f}".partition(".")
    sign, size = ("-", whole[1:]) if whole.startswith("-") else ("", whole)
    if len(size) >= _GROUPED_FROM:
        # Spaces in every language: a lone comma between groups could as well be a decimal sign.
        group = _GROUP_SIGNS[behaviour.seed % len(_GROUP_SIGNS)]
        size = f"{int(size):,}".replace(",", group)
    point = decimal_sign(language)
    return f"{sign}{size}{point}{decimals}" if decimals else f"{sign}{size}"
