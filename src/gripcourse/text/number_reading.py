"""One number out of what a person typed: comma or point, groups, powers of ten, a unit behind it.

A text is cut to a bounded length first and then read once from left to right; no rule looks back.
Characters are mapped one by one, not by Unicode's compatibility forms, which turn `10³` into `103`.
"""

import math
from dataclasses import dataclass, replace

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
_DIGITS = "0123456789"
_SEPARATORS = ".,"
_GROUP = 3  # digits between two group signs
_ABOUT = "≈≃≅~∼"
_EXPONENT_LETTERS = "eEеЕ"  # Latin and Cyrillic
_TIMES = "*xXхХ"  # Latin and Cyrillic
_SUPERSCRIPTS = "⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_FROM_SUPERSCRIPT = str.maketrans(_SUPERSCRIPTS, "+-" + _DIGITS)
_LONGEST_SYMBOL = 20  # of `D_max = 12`
_CALCULATED = "πΠ√∞½¼¾⅓"  # behind a number they multiply it or add to it

_NO_NUMBER = message("The cell does not begin with a number.")
_SEVERAL = message("One number is needed, not a range, several numbers or a calculation.")
A_DATE = message("This looks like a date; one number is needed.")
_GROUPS = message("The points and commas do not make one number.")
_FORMULA = message(
    "A formula was typed into a cell that holds text. Set the cell's format to General and type "
    "the formula again."
)
_TOO_LONG = message("The text is too long to be a number.")
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
    """

    value: float
    half_unit: float
    unit: str
    remarks: tuple[Message, ...]
    figures: Figures | None


@dataclass(frozen=True, slots=True)
class Unreadable:
    """A text that is no single number, and why."""

    reason: Message


class _NotANumber(Exception):  # noqa: N818 - it never leaves this module
    def __init__(self, reason: Message) -> None:
        self.reason = reason
        super().__init__(reason)


@dataclass(frozen=True, slots=True)
class _Digits:
    """Digits without separators; `decimals` of them stand behind the decimal sign."""

    text: str
    decimals: int
    remarks: tuple[Message, ...]


def read_number(text: str) -> NumberRead | Unreadable:
    """Read one number, with whatever stands behind it as its unit.

    Args:
        text: what was typed, of any length and content.

    Returns:
        The number, or the reason why it is not one; never raises.
    """
    if len(text.strip()) > LONGEST:
        return Unreadable(_TOO_LONG)
    typed = text.translate(_PLAIN).strip()
    special = special_form(typed)
    if special is not None:
        return NumberRead(special.value, special.half_unit, special.unit, (), None)
    plain, remarks = tidied(typed)
    reason = refusal(plain)
    if reason is not None:
        return Unreadable(reason)
    try:
        read = _read(plain.removeprefix("'").strip().rstrip(" .,;"))
    except _NotANumber as fault:
        return Unreadable(fault.reason)
    return replace(read, remarks=(*remarks, *read.remarks))


def _read(plain: str) -> NumberRead:
    bare, remarks = _without_prefix(plain)
    try:
        read = _read_bare(bare)
    except _NotANumber:
        if plain.startswith("="):
            raise _NotANumber(_FORMULA) from None
        raise
    return replace(read, remarks=(*remarks, *read.remarks))


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
    body, rest = _take(unsigned.lstrip(), _DIGITS + _SEPARATORS + " ")
    digits = _digits(body.rstrip())
    exponent, tail = _exponent(digits, rest)
    exact = _stands_for_ten(digits, rest)
    mantissa = "1" if exact else digits.text
    last = exponent - digits.decimals
    value = float(f"{sign}{mantissa}e{last}") or 0.0  # a typed -0 is a plain zero
    half_unit = 0.0 if exact else float(f"5e{last - 1}")
    if math.isinf(value) or math.isinf(half_unit) or (value == 0 and mantissa.strip("0")):
        raise _NotANumber(_OUT_OF_RANGE)
    remarks = _about_separators(digits, value)
    return NumberRead(value, half_unit, _unit(tail), remarks, None if exact else _figures(digits))


def _figures(digits: _Digits) -> Figures | None:
    typed = digits.text.lstrip("0")
    certain = typed if digits.decimals else typed.rstrip("0")
    return Figures(len(certain), len(typed)) if typed else None


def _take(text: str, allowed: str) -> tuple[str, str]:
    """Split off the longest beginning that consists of allowed characters."""
    rest = text.lstrip(allowed)
    return text[: len(text) - len(rest)], rest


def _digits(body: str) -> _Digits:
    """Decide what the spaces, points and commas between digits mean."""
    if not body.strip(_SEPARATORS + " "):
        raise _NotANumber(_NO_NUMBER)
    joined = _without_group_spaces(body)
    found = [sign for sign in joined if sign in _SEPARATORS]
    if not found:
        return _Digits(joined, 0, ())
    if len(set(found)) == 1 and len(found) > 1:
        return _only_groups(joined, found[0])
    whole, _, decimals = joined.rpartition(found[-1])
    if len(found) > 1:
        if found[-1] in found[:-1]:
            raise _NotANumber(_GROUPS)
        whole = _join_groups(whole.split(found[0]), _GROUPS)
        return _Digits(whole + decimals, len(decimals), (_groups_remark(),))
    ambiguous = len(decimals) == _GROUP and 0 < len(whole) <= _GROUP and whole.strip("0")
    return _Digits(whole + decimals, len(decimals), (_decimal_remark(),) if ambiguous else ())


def _without_group_spaces(body: str) -> str:
    """Join `1 250 000,5`; anything else with a space inside is several numbers."""
    pieces = body.split(" ")
    if len(pieces) == 1:
        return body
    last, decimals = _take(pieces[-1], _DIGITS)
    return _join_groups([*pieces[:-1], last], _SEVERAL) + decimals


def _only_groups(joined: str, separator: str) -> _Digits:
    """Read `1.250.000`; two signs that do not part groups look like a date."""
    pieces = joined.split(separator)
    is_date = len(pieces) == _GROUP and all(pieces)
    digits = _join_groups(pieces, A_DATE if is_date else _SEVERAL)
    return _Digits(digits, 0, (_groups_remark(),))


def _join_groups(pieces: list[str], reason: Message) -> str:
    """Join groups of three digits; the first may be shorter."""
    first, *others = pieces
    regular = 0 < len(first) <= _GROUP and all(len(piece) == _GROUP for piece in others)
    if not regular or not all(piece.isdigit() for piece in pieces):
        raise _NotANumber(reason)
    return "".join(pieces)


def _groups_remark() -> Message:
    return message("The points or commas were read as signs between groups of three digits.")


def _decimal_remark() -> Message:
    return message("The single point or comma was read as the decimal sign.")


def _about_separators(digits: _Digits, value: float) -> tuple[Message, ...]:
    return tuple(
        message("{how} The number read is {number}.", how=remark, number=readable(value))
        for remark in digits.remarks
    )


def readable(value: float) -> int | float:
    """Make a whole number an integer, so that a sentence shows all of its digits."""
    exactly = 1e15
    return int(value) if value.is_integer() and abs(value) < exactly else value


def _exponent(digits: _Digits, rest: str) -> tuple[int, str]:
    """Read a power of ten and return it with what stands behind it."""
    if _stands_for_ten(digits, rest):
        return _power(rest)
    if rest[:1] and rest[0] in _EXPONENT_LETTERS:
        sign, unsigned = _sign(rest[1:])
        exponent, tail = _take(unsigned, _DIGITS)
        if exponent:
            return int(sign + exponent), tail
    if rest[:1] and rest[0] in _TIMES:
        ten = rest[1:].lstrip(" ")
        power = ten[2:].lstrip(" ")
        if ten.startswith("10") and _starts_power(power):
            return _power(power)
    return 0, rest


def _stands_for_ten(digits: _Digits, rest: str) -> bool:
    """Whether this is `10³` or `10^3`, a power of ten with nothing before it."""
    return (digits.text, digits.decimals) == ("10", 0) and _starts_power(rest)


def _starts_power(text: str) -> bool:
    return text.startswith(("^", "**")) or (text[:1] != "" and text[0] in _SUPERSCRIPTS)


def _power(text: str) -> tuple[int, str]:
    """Read `^-3`, `^(-3)`, `**-3` or `⁻³`."""
    if text[0] in _SUPERSCRIPTS:
        raised, tail = _take(text, _SUPERSCRIPTS)
        sign, exponent = _sign(raised.translate(_FROM_SUPERSCRIPT))
    else:
        opened = text.removeprefix("^").removeprefix("**").lstrip(" (")
        sign, unsigned = _sign(opened)
        exponent, tail = _take(unsigned, _DIGITS)
        tail = tail.removeprefix(")")
    if not exponent.isdigit():
        raise _NotANumber(_SEVERAL)
    return int(sign + exponent), tail


def _sign(text: str) -> tuple[str, str]:
    return (text[0], text[1:]) if text[:1] in {"+", "-"} else ("", text)


def _unit(tail: str) -> str:
    """Return what stands behind the number, unless it shows that this is not one number."""
    unit = tail.strip(" ")
    if not unit:
        return ""
    if not (unit[0].isalpha() or unit[0] in "%‰°º˚′″'\"\u00b5[(") or unit[0] in _CALCULATED:
        raise _NotANumber(_SEVERAL)
    if unit[0] in _TIMES and unit[1:].lstrip()[:1].isdigit():  # 12x13
        raise _NotANumber(_SEVERAL)
    before = ""
    for after in unit:
        if after == "±" or (after in _DIGITS and not _may_precede_a_digit(before)):
            raise _NotANumber(_SEVERAL)
        before = after
    return unit


def _may_precede_a_digit(before: str) -> bool:
    """Whether a digit after this character is a power in a unit, as in `мм2`, `m/s^2`, `с-2`."""
    return before.isalpha() or (before != "" and before in "^*-" + _DIGITS)
