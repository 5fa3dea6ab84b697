"""Numbers of answer cells in the declared unit, with the unit that stands behind a typed one."""

import math
import re
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Final

from gripcourse.course.quantity import Quantity
from gripcourse.submission.dates import names_month
from gripcourse.submission.significant_digits import figures_of_number
from gripcourse.text.digit_groups import A_DATE
from gripcourse.text.number_reading import (
    Figures,
    NumberRead,
    Unreadable,
    read_number,
    readable,
)
from gripcourse.text.typed_forms import AMONG_DIGITS
from gripcourse.text.units import UnitError, dimension, factor, read_unit, unit_text
from gripcourse.text.words import LANGUAGES, Message, Texts, message

# `H7`, `h6`, `H7/m6`, `d11`: a tolerance of fit behind a size, or behind its unit. Units and their
# powers, as m2, have other letters or lower powers. Letters of two alphabets look the same: Н7.
_GRADE: Final = r"(?:1[0-8]|[1-9])"
_COARSER: Final = r"(?:1[0-8]|[6-9])"
_FIT: Final = re.compile(
    rf"(?P<unit>(?:мм|mm)?)\.?\s*"
    rf"(?:(?:[HhEFfGgJjKknNPpRrSsНЕКРекнр]|js|JS){_GRADE}|[DMUdmuМм]{_COARSER})"
    rf"(?:/(?:js|JS|[a-zA-ZАВСНЕКМРасекмнр]){_GRADE})?"
)
# `1h30`, `0b1`, `12Н13`: a letter among digits; no unit has such a power. `12 мм2` may be one.
_AMONG_DIGITS: Final = re.compile(r"[^\W\d_]{1,3}(\d+)")
_POWERS: Final = frozenset({"2", "3", "4"})
_FIT_LEFT_OUT: Final = message("The tolerance behind the size was left out.")
_ANGLES: Final = frozenset({"deg", "rad", "gon"})
_PERCENT: Final = "%"
_CELSIUS, _KELVIN = "degC", "K"
_ABSOLUTE_ZERO: Final = -273.15  # °C, by definition of the scale
# Where turns are asked, one in a minute is a turn; one in a second is a turn or a radian.
_TURNS: Final = {"1/min": "rpm", "Hz": "rps"}
_TURNS_OR_RADIANS: Final = "1/s"
# What a number format writes: quoted, letter by letter behind backslashes, or as it stands.
_WRITTEN: Final = re.compile(r'"([^"]{1,20})"|((?:\\.|[^\W\d_a-zA-Z]){1,20})')
# Commas behind the last digit show thousands, as 12.5 for 12500.
_THOUSANDS: Final = re.compile(r"[0#?](,+)(?![0#?,])")
_KEPT: Final = 1024  # number formats: a workbook has few
_OUT_OF_RANGE: Final = message("The number is too large or too small to compute with.")


@dataclass(frozen=True, slots=True)
class Understood:
    """A value that was read.

    Attributes:
        value: in the declared unit; as typed where the typed unit does not fit.
        half_unit: half a unit of the last digit, likewise.
        unit: the unit that was typed, in our spelling; empty for none.
        unit_fits: False where that unit measures something else.
        remarks: how it was read, where the cell is not a plain number.
        figures: that were typed; None where that cannot be told.
    """

    value: float
    half_unit: float
    unit: str
    unit_fits: bool
    remarks: tuple[Message, ...]
    figures: Figures | None


def from_number(
    quantity: Quantity, value: float, number_format: str, *, typed: bool = True
) -> Understood | Message:
    """Read a cell that holds a number.

    Args:
        quantity: that the cell answers.
        value: as the file stores it; an integer may have any size.
        number_format: of the cell; a percent format shows a hundred times the value.
        typed: False for the result of a formula, whose figures nobody typed.
    """
    try:
        number = float(value)
    except OverflowError:
        return _OUT_OF_RANGE
    if not math.isfinite(number):
        return _OUT_OF_RANGE
    figures = figures_of_number(number, number_format) if typed else None
    plain = _plain(number, _half_unit(number), (), figures)
    shown = _unit_shown(number_format)
    if shown not in {None, quantity.unit}:
        seen = number / _thousands(number_format)
        read = NumberRead(seen, _half_unit(seen), "", (), figures)
        return _measured(read, str(shown), quantity)
    if _PERCENT not in number_format or quantity.unit == "":
        return plain
    if quantity.unit == _PERCENT:
        # As a person reads it: 5.5, not what multiplying adds at the end.
        value = float(f"{100 * number:.15g}")
        return replace(plain, value=value, half_unit=100 * plain.half_unit)
    remark = message(
        "The cell has a percent format: it shows {shown} %, but its value is {number}.",
        shown=readable(100 * number),
        number=readable(number),
    )
    return replace(plain, remarks=(remark,))


@lru_cache(maxsize=_KEPT)
def _unit_shown(number_format: str) -> str | None:
    """Return the unit that a number format writes behind every number; None for none."""
    written = _WRITTEN.findall(number_format.partition(";")[0])
    words = [(quoted or escaped.replace("\\", "")).strip() for quoted, escaped in written]
    units = (read_unit(one) for one in words if one)
    return next((unit for unit in units if unit and _measures(unit)), None)


def _thousands(number_format: str) -> float:
    """Return by how much a number format divides what it shows."""
    found = _THOUSANDS.search(number_format.partition(";")[0])
    return 1000.0 ** len(found[1]) if found else 1.0


def from_text(quantity: Quantity, text: str) -> Understood | Message:
    """Read a cell that holds text: a number, perhaps with a unit behind it."""
    read = read_number(text)
    if isinstance(read, Unreadable):
        return read.reason
    if quantity.unit == "mm" and (fit := _FIT.fullmatch(read.unit)):
        read = replace(read, unit=fit["unit"], remarks=(*read.remarks, _FIT_LEFT_OUT))
    unit = read_unit(read.unit) if read.unit else ""
    if _is_among_digits(read, unit):
        return AMONG_DIGITS
    if unit is None and names_month(read.unit):
        return A_DATE
    if unit is None or not _measures(unit):
        unknown = message(
            "The text “{text}” after the number is no known unit; the number was taken in the "
            "unit that the workbook asks for.",
            text=read.unit,
        )
        remarks = (_as_number(read), *read.remarks, unknown)
        return _plain(read.value, read.half_unit, remarks, read.figures)
    if unit in {"", quantity.unit}:
        remarks = (_as_number(read), *read.remarks)
        return replace(_plain(read.value, read.half_unit, remarks, read.figures), unit=unit)
    return _measured(read, unit, quantity)


def _is_among_digits(read: NumberRead, unit: str | None) -> bool:
    """Tell whether a letter of an unknown meaning stands between two numbers."""
    found = _AMONG_DIGITS.match(read.unit)
    if found is None:
        return False
    return found[1] not in _POWERS if unit is not None else read.close


def _measured(read: NumberRead, unit: str, quantity: Quantity) -> Understood | Message:
    """Read a number in another unit than the declared one: converted, or told that it is unfit."""
    if quantity.unit in _TURNS.values():
        if unit == _TURNS_OR_RADIANS:
            return message(
                "{number} turns or radians in a second? Write the number in {declared}.",
                number=readable(read.value),
                declared=_written(quantity.unit),
            )
        unit = _TURNS.get(unit, unit)
    if {unit, quantity.unit} == {_CELSIUS, _KELVIN}:
        return _temperature(read, unit, quantity)
    if _fits(unit, quantity.unit):
        return _converted(read, unit, quantity)
    remarks = (*read.remarks, _unfit(unit, quantity))
    plain = _plain(read.value, read.half_unit, remarks, read.figures)
    return replace(plain, unit=unit, unit_fits=False)


def _plain(
    value: float, half_unit: float, remarks: tuple[Message, ...], figures: Figures | None
) -> Understood:
    return Understood(value, half_unit, "", unit_fits=True, remarks=remarks, figures=figures)


def _half_unit(value: float) -> float:
    """Return half a unit of the last digit that a spreadsheet shows, of fifteen at most."""
    digits, _, exponent = f"{value:.15g}".partition("e")
    decimals = len(digits.partition(".")[2])
    return float(f"5e{int(exponent or 0) - decimals - 1}") if value else 0.0


def _measures(unit: str) -> bool:
    """Whether a unit has a finite size; a power like `mm**9999` has none."""
    try:
        return math.isfinite(factor(unit)) and factor(unit) > 0
    except (UnitError, ArithmeticError):
        return False


def _fits(unit: str, declared: str) -> bool:
    """Whether a value can be converted; an angle is a plain number, but no percentage is one."""
    same_kind = (unit in _ANGLES) == (declared in _ANGLES)
    return same_kind and dimension(unit) == dimension(declared)


def _converted(
    read: NumberRead, unit: str, quantity: Quantity, zero: float = 0.0
) -> Understood | Message:
    scale = factor(unit) / factor(quantity.unit)
    # Without what the conversion adds at the end.
    value = float(f"{read.value * scale + zero:.14g}")
    is_lost = value == 0 == zero and read.value != 0
    if is_lost or not math.isfinite(value):
        return _OUT_OF_RANGE
    remark = message(
        "Read as {number} {unit} = {value} {declared}; the cell needs the number alone.",
        number=readable(read.value),
        unit=_written(unit),
        value=readable(value),
        declared=_written(quantity.unit),
    )
    plain = _plain(value, read.half_unit * scale, (remark, *read.remarks), read.figures)
    return replace(plain, unit=unit)


def _temperature(read: NumberRead, unit: str, quantity: Quantity) -> Understood | Message:
    """Read kelvins where a temperature in °C is asked, and °C where kelvins are.

    What is asked in kelvins is a temperature or a difference of two: its bounds tell, or nothing.
    """
    if unit == _CELSIUS:
        least, most = quantity.bounds
        zeros = [zero for zero in (0.0, -_ABSOLUTE_ZERO) if least <= read.value + zero <= most]
        if len(zeros) == 1:
            return _converted(read, unit, quantity, zeros[0])
        return message(
            "{number} °C: a temperature, or a difference of two? Write the number in {declared}.",
            number=readable(read.value),
            declared=_written(quantity.unit),
        )
    return _converted(read, unit, quantity, _ABSOLUTE_ZERO)


def _as_number(read: NumberRead) -> Message:
    return message(
        "The cell holds text, which was read as the number {number}; the cell needs the number "
        "alone, typed with the decimal sign of the spreadsheet program.",
        number=readable(read.value),
    )


def _unfit(unit: str, quantity: Quantity) -> Message:
    if quantity.unit == "":
        return message(
            "The unit {unit} does not fit: {title} is a plain number.",
            unit=_written(unit),
            title=quantity.title,
        )
    return message(
        "The unit {unit} does not fit: {title} is asked in {declared}.",
        unit=_written(unit),
        title=quantity.title,
        declared=_written(quantity.unit),
    )


def _written(unit: str) -> Texts:
    """Return a unit as each language writes it."""
    return Texts({language: unit_text(unit, language) for language in LANGUAGES})
