"""One number out of what a person typed: comma or point, groups, powers of ten, a unit behind it.

A text is cut to a bounded length first and then read once from left to right; no rule looks back.
Characters are mapped one by one, not by Unicode's compatibility forms, which turn `10³` into `103`.
"""

import math
from dataclasses import dataclass, replace

from gripcourse.text.digit_groups import (
    DIGITS,
    SEPARATORS,
    SEVERAL,
    Digits,
    NotANumber,
    digits_of,
    taken,
)
from gripcourse.text.typed_forms import refusal, special_form, tidied
from gripcourse.text.words import Message, message

LONGEST = 200
"""Characters of the longest text that is read as a number."""

_INVISIBLE = "\ufeff\u200b\u200c\u200d\u200e\u200f\u2060\u00ad"
_MINUS_SIGNS = "\u2212\u2013\u2014\u2011\u2010\ufe63\uff0d"
_SPACES = "\u00a0\u202f\u2009\u2007\u2008\u200a\u2002\u2003\t\r\n"
_TIMES_SIGNS = "×·⋅∙"
_PLAIN = str.maketrans(
    dict.fromkeys(_INVISIBLE, "")
    | dict.fromkeys(_MINUS_SIGNS, "-")
    | dict.fromkeys(_SPACES, " ")
    | dict.fromkeys(_TIMES_SIGNS, "*")
)
_ABOUT = "≈≃≅~∼"
_EXPONENT_LETTERS = "eEеЕ"  # Latin and Cyrillic
_ENDS_OF_POWER = frozenset({"", "+", "-", *DIGITS})
_TIMES = "*xXхХ"  # Latin and Cyrillic
_SUPERSCRIPTS = "⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_FROM_SUPERSCRIPT = str.maketrans(_SUPERSCRIPTS, "+-" + DIGITS)
_DEGREE_SIGNS = "°º˚"
_LONGEST_SYMBOL = 20  # of `D_max = 12`
_CALCULATED = "πΠ√∞½¼¾⅓"  # behind a number they multiply it or add to it
_PI = frozenset({"pi", "пи", "пі"})

_FORMULA = message(
    "A formula was typed into a cell that holds text. Set the cell's format to General and type "
    "the formula again."
)
TOO_LONG = message("The text is too long to be a number.")
_OUT_OF_RANGE = message("The number is too large or too small to compute with.")
_SIGN_LEFT_OUT = message("The sign before the number was left out; type the number alone.")
_SYMBOL_LEFT_OUT = message("The symbol before the number was left out; type the number alone.")


@dataclass(frozen=True, slots=True)
class Figures:
    """How many significant figures were typed.

    Attributes:
        least: that are certain; zeros at the end of a whole number may only fill its places.
        most: that it can have been; None for no bound, where zeros may have been lost.
    """

    least: int
    most: int | None


@dataclass(frozen=True, slots=True)
class NumberRead:
    """A number that was understood.

    Attributes:
        value: the number as typed, whatever unit stands behind it.
        half_unit: half a unit of the last typed digit.
        unit: what stands behind the number, as it was typed; empty for nothing.
        remarks: what had to be decided to read it.
        figures: as typed; None where that says nothing: a zero, a bare power of ten.
        close: whether the unit was typed without a space before it.
    """

    value: float
    half_unit: float
    unit: str
    remarks: tuple[Message, ...]
    figures: Figures | None
    close: bool = False


@dataclass(frozen=True, slots=True)
class Unreadable:
    """A text that is no single number, and why."""

    reason: Message


def read_number(text: str) -> NumberRead | Unreadable:
    """Read one number, with whatever stands behind it as its unit.

    Args:
        text: what was typed, of any length and content.

    Returns:
        The number, or the reason why it is not one; never raises.
    """
    if len(text.strip()) > LONGEST:
        return Unreadable(TOO_LONG)
    typed = text.translate(_PLAIN).strip()
    special = special_form(typed)
    if special is not None:
        return NumberRead(special.value, special.half_unit, special.unit, (), None)
    plain, remarks = tidied(typed)
    bare, left_out = _without_prefix(plain.removeprefix("'").strip().rstrip(" .,;"))
    try:
        read = _read(bare)
    except NotANumber as fault:
        return Unreadable(_FORMULA if plain.startswith("=") else fault.reason)
    return replace(read, remarks=(*remarks, *left_out, *read.remarks))


def _read(bare: str) -> NumberRead:
    """Read a form of its own, or digits where nothing speaks against it."""
    special = special_form(bare)
    if special is not None:
        return NumberRead(special.value, special.half_unit, special.unit, (), None)
    reason = refusal(bare)
    if reason is not None:
        raise NotANumber(reason)
    return _read_bare(bare)


def _without_prefix(text: str) -> tuple[str, tuple[Message, ...]]:
    """Take away `≈`, `=` or `D =` before the number."""
    bare = text.lstrip(_ABOUT + "= ")
    if bare != text:
        return bare, (_SIGN_LEFT_OUT,)
    symbol, equals, number = text.partition("=")
    if equals and symbol[:1].isalpha() and len(symbol) <= _LONGEST_SYMBOL and "=" not in number:
        return number.lstrip(_ABOUT + " "), (_SYMBOL_LEFT_OUT,)
    return text, ()


def _read_bare(text: str) -> NumberRead:
    """Read a sign, digits, a power of ten and a unit."""
    sign, unsigned = ("-", text[1:]) if text.startswith("-") else ("", text.removeprefix("+"))
    body, rest = taken(unsigned.lstrip(), DIGITS + SEPARATORS + " ")
    digits = digits_of(body.rstrip())
    exponent, tail = _exponent(digits, rest)
    exact = _stands_for_ten(digits, rest)
    mantissa = "1" if exact else digits.text
    last = exponent - digits.decimals
    value = float(f"{sign}{mantissa}e{last}") or 0.0  # a typed -0 is a plain zero
    half_unit = 0.0 if exact else float(f"5e{last - 1}")
    if math.isinf(value) or math.isinf(half_unit) or (value == 0 and mantissa.strip("0")):
        raise NotANumber(_OUT_OF_RANGE)
    remarks = _about_separators(digits, value)
    figures = None if exact else _figures(digits)
    close = " " not in (text.removesuffix(tail)[-1:], tail[:1])
    return NumberRead(value, half_unit, _unit(tail), remarks, figures, close)


def _figures(digits: Digits) -> Figures | None:
    typed = digits.text.lstrip("0")
    certain = typed if digits.decimals else typed.rstrip("0")
    return Figures(len(certain), len(typed)) if typed else None


def _about_separators(digits: Digits, value: float) -> tuple[Message, ...]:
    return tuple(
        message("{how} The number read is {number}.", how=remark, number=readable(value))
        for remark in digits.remarks
    )


def readable(value: float) -> int | float:
    """Make a whole number an integer, so that a sentence shows all of its digits."""
    exactly = 1e15
    return int(value) if value.is_integer() and abs(value) < exactly else value


def _exponent(digits: Digits, rest: str) -> tuple[int, str]:
    """Read a power of ten and return it with what stands behind it."""
    if _stands_for_ten(digits, rest):
        return _power(rest)
    if rest[:1] and rest[0] in _EXPONENT_LETTERS:
        sign, unsigned = _sign(rest[1:])
        exponent, tail = taken(unsigned, DIGITS)
        if exponent:
            return int(sign + exponent), tail
    if rest[:1] and rest[0] in _TIMES:
        ten = rest[1:].lstrip(" ")
        power = ten[2:].lstrip(" ")
        if ten.startswith("10") and _starts_power(power):
            return _power(power)
    return 0, rest


def _stands_for_ten(digits: Digits, rest: str) -> bool:
    """Whether this is `10³` or `10^3`, a power of ten with nothing before it."""
    return (digits.text, digits.decimals) == ("10", 0) and _starts_power(rest)


def _starts_power(text: str) -> bool:
    return text.startswith(("^", "**")) or (text[:1] != "" and text[0] in _SUPERSCRIPTS)


def _power(text: str) -> tuple[int, str]:
    """Read `^-3`, `^(-3)`, `**-3` or `⁻³`."""
    if text[0] in _SUPERSCRIPTS:
        raised, tail = taken(text, _SUPERSCRIPTS)
        sign, exponent = _sign(raised.translate(_FROM_SUPERSCRIPT))
    else:
        opened = text.removeprefix("^").removeprefix("**").lstrip(" (")
        sign, unsigned = _sign(opened)
        exponent, tail = taken(unsigned, DIGITS)
        tail = tail.removeprefix(")")
    if not exponent.isdigit():
        raise NotANumber(SEVERAL)
    return int(sign + exponent), tail


def _sign(text: str) -> tuple[str, str]:
    return (text[0], text[1:]) if text[:1] in {"+", "-"} else ("", text)


def _unit(tail: str) -> str:
    """Return what stands behind the number, unless it shows that this is not one number."""
    unit = tail.strip(" ")
    if not unit:
        return ""
    if unit[0] in _EXPONENT_LETTERS and unit[1:2] in _ENDS_OF_POWER:  # not typed to its end, or two
        raise NotANumber(SEVERAL)
    if unit.split("/")[0].strip(" ").casefold() in _PI:
        raise NotANumber(SEVERAL)
    if not (unit[0].isalpha() or unit[0] in "%‰°℃º˚′″'\"\u00b5[(") or unit[0] in _CALCULATED:
        raise NotANumber(SEVERAL)
    if unit[0] in _TIMES and unit[1:].lstrip()[:1].isdigit():  # 12x13
        raise NotANumber(SEVERAL)
    before = ""
    for after in unit:
        if after == "±" or (after in DIGITS and not _may_precede_a_digit(before)):
            raise NotANumber(SEVERAL)
        before = after
    return unit


def _may_precede_a_digit(before: str) -> bool:
    """Whether a digit after this character is a power in a unit, as in `мм2`, `m/s^2`, `с-2`."""
    is_letter = before.isalpha() and before not in _DEGREE_SIGNS
    return is_letter or (before != "" and before in "^*-" + DIGITS)
