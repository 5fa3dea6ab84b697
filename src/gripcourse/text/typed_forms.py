"""Forms of a number that people type and that are more, or less, than digits and a unit.

Degrees with minutes and seconds, simple fractions, a word or a sign before the number, a standard
or a formula in brackets behind it, quotation marks round it. What could mean two things is left as
it is, for a person to be asked.
"""

import math
import re
from dataclasses import dataclass
from typing import Final

from gripcourse.text.words import Message, message

# Digits and signs of other keyboards: wide ones, and those of Arabic and of Persian.
_OTHER_DIGITS: Final = str.maketrans(
    "０１２３４５６７８９，．٠١٢٣٤٥٦٧٨٩٫٬۰۱۲۳۴۵۶۷۸۹",
    "0123456789,.0123456789,'0123456789",
)
_QUOTES: Final = (('"', '"'), ("«", "»"), ("“", "”"), ("„", "“"), ("'", "'"))
_UNIT: Final = r"(?:\s*(?P<unit>[^\W\d_]{1,12})\.?)?"
_NUMBER: Final = r"\d{1,3}(?:[.,]\d{1,9})?"
_DEGREES: Final = re.compile(
    rf"""(?P<sign>[-+]?)\s*(?P<degrees>\d{{1,3}})\s*(?:°|º|˚|град(?:\.|ус\w{{0,3}})?|гр\.?|deg(?:\.|rees?)?)
    \s*(?P<minutes>{_NUMBER})\s*(?:'|′|’|ʹ|мин(?:\.|ут\w?)?|хв(?:\.|илин\w?)?|min(?:\.|utes?)?)
    (?:\s*(?P<seconds>{_NUMBER})\s*(?:"|″|”|''|′′|’’|сек(?:\.|унд\w?)?|sec(?:\.|onds?)?|с|s))?""",
    re.VERBOSE | re.IGNORECASE,
)
_FRACTION: Final = re.compile(
    rf"(?P<sign>-?)(?:(?P<whole>\d{{1,4}})\s+)?(?P<over>\d)/(?P<under>\d{{1,2}}){_UNIT}"
)
_SIGNS: Final = {"½": 0.5, "¼": 0.25, "¾": 0.75, "⅓": 1 / 3, "⅔": 2 / 3, "⅛": 0.125}
_SIGNED: Final = re.compile(
    rf"(?P<sign>-?)(?P<whole>\d{{0,4}})\s*(?P<part>[{''.join(_SIGNS)}]){_UNIT}"
)
_ABOUT: Final = re.compile(
    r"(?:ок|около|прибл|приблизительно|примерно|порядка|приблизно|близько|approx|approximately"
    r"|about|ca|circa)\b\.?\s*(?=[-+\d.,])",
    re.IGNORECASE,
)
_DIAMETER: Final = re.compile(r"[ØøΦφФф⌀∅]\s*(?=\d)")
_STANDARD: Final = re.compile(
    r"\s*[(\[](?:(?:по|за|из|з|см\.|див\.|to|by|from|see)\s+)?"
    r"(?:гост|дсту|ост|исо|iso|din|en|ряд\w{0,2}|табл\w{0,5}|стандарт|row|table"
    r"|формул\w{0,3}|ф-л\w|уравн\w{0,5}|рівнян\w{0,4}|рис\w{0,5}|formula|eq|equation|fig|figure)"
    r"\b[^()\[\]]*[)\]]$",
    re.IGNORECASE,
)
_APOSTROPHES: Final = re.compile(r"[-+]?\d{1,3}(?:['’]\d{3})+(?:[.,]\d+)?(?![\d'’])")
# A letter O for a zero, an I or l for a one, a З for a three: inside digits, or at their end.
_LETTERS: Final = re.compile(
    r"\d[.,]?(?:[oOоО]+(?:\d|$|[.,]\d|\s)|[lI|]+\d|[бЗзZSB]+(?:[.,]?\d)|[бЗзZS]+$)"
    r"|\d\s[oOоО]{3}\b"  # a group of three
)
# Minutes and seconds without degrees, feet and inches: a mark says which only to who wrote it.
_MARKED: Final = re.compile(r"""\d\s*(?:['"″′’ʹ]|'')$""")
_GONS: Final = "ᵍ"
_THOUSANDS: Final = re.compile(
    r"\d\s*(?:тыс(?:яч\w?)?|тис(?:яч\w?)?|млн|миллион\w{0,2}|мільйон\w{0,2}|thousand|million)\b",
    re.IGNORECASE,
)
# A comma or a semicolon between a number and what stands behind it: `12,5, мм`.
_BEFORE_WORD: Final = re.compile(r"(?<=\d)[,;]\s+(?=[^\W\d])")

_WORD_LEFT_OUT: Final = message("The word before the number was left out; type the number alone.")
_SIGN_LEFT_OUT: Final = message("The sign before the number was left out; type the number alone.")
_NOTE_LEFT_OUT: Final = message("What stands in brackets was left out; type the number alone.")
AMONG_DIGITS: Final = message("A letter stands among the digits; nothing was guessed. Type digits.")
MARKED: Final = message(
    "The mark behind the number can mean minutes, seconds, feet or inches; write the unit out."
)
ALL_DIGITS: Final = message("Type the number with all its digits, without a word for thousands.")


@dataclass(frozen=True, slots=True)
class TypedForm:
    """A number in a form of its own.

    Attributes:
        value: in the unit.
        half_unit: half a unit of its last digit; 0 where it is exact.
        unit: as typed behind a plain number; empty for none.
    """

    value: float
    half_unit: float
    unit: str


def tidied(text: str) -> tuple[str, tuple[Message, ...]]:
    """Take away what people write round a number, and say so.

    Args:
        text: plain, without spaces at its ends.
    """
    remarks: list[Message] = []
    bare = _BEFORE_WORD.sub(" ", _unquoted(text.translate(_OTHER_DIGITS)), count=1)
    for pattern, said in (
        (_STANDARD, _NOTE_LEFT_OUT),
        (_ABOUT, _WORD_LEFT_OUT),
        (_DIAMETER, _SIGN_LEFT_OUT),
    ):
        found = pattern.search(bare) if pattern is _STANDARD else pattern.match(bare)
        if found:
            bare = (bare[: found.start()] + bare[found.end() :]).strip()
            remarks.append(said)
    if bare.endswith(_GONS):
        bare = f"{bare.removesuffix(_GONS)} gon"
    if grouped := _APOSTROPHES.match(bare):
        whole = grouped.group().replace("'", "").replace("’", "")
        bare = whole + bare[grouped.end() :]
    return bare, tuple(remarks)


def special_form(text: str) -> TypedForm | None:
    """Read degrees with minutes, or a fraction; None for everything else."""
    return _degrees(text) or _fraction(text)


def refusal(text: str) -> Message | None:
    """Say why a text that looks like a number must not be read as one; None for no reason."""
    if _LETTERS.search(text):
        return AMONG_DIGITS
    if _MARKED.search(text):
        return MARKED
    return ALL_DIGITS if _THOUSANDS.search(text) else None


def _unquoted(text: str) -> str:
    for opening, closing in _QUOTES:
        if len(text) > 1 and text.startswith(opening) and text.endswith(closing):
            return text[1:-1].strip()
    return text


def _degrees(text: str) -> TypedForm | None:
    found = _DEGREES.fullmatch(text)
    if found is None:
        return None
    minutes, seconds = (
        float((found[name] or "0").replace(",", ".")) for name in ("minutes", "seconds")
    )
    sixty = 60.0
    if minutes >= sixty or seconds >= sixty:
        return None
    value = int(found["degrees"]) + minutes / sixty + seconds / sixty**2
    last = found["seconds"] or found["minutes"]
    decimals = len(last.replace(",", ".").partition(".")[2])
    half_unit = 0.5 * 10.0**-decimals / (sixty**2 if found["seconds"] else sixty)
    return TypedForm(-value if found["sign"] == "-" else value, half_unit, "°")


def _fraction(text: str) -> TypedForm | None:
    """Read `1/2` and `1½`; a quotient above one, such as 32/12, may be two sizes."""
    if found := _FRACTION.fullmatch(text):
        over, under = int(found["over"]), int(found["under"])
        if not 0 < over < under:
            return None
        size = int(found["whole"] or 0) + over / under
    elif found := _SIGNED.fullmatch(text):
        size = int(found["whole"] or 0) + _SIGNS[found["part"]]
    else:
        return None
    return TypedForm(math.copysign(size, -1.0 if found["sign"] else 1.0), 0.0, found["unit"] or "")
