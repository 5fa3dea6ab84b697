"""Units: their dimension, their size, and how people write them.

A unit is spelled by names of `units.csv` joined by `*`, `/` and `**`, for example `mm`, `N*m`,
`m/s**2`; the empty text is a plain number. A new unit is a row of `units.csv`, which holds its size
and what it is made of in SI.

Angles are plain numbers whose SI unit is the radian. A temperature in `degC` counts from 0 °C: its
differences are what is in `K`, and one from absolute zero has a constant of 273.15 K added.
"""

import csv
import math
import re
import unicodedata
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from importlib.resources import files
from typing import Final

from gripcourse.text.words import LANGUAGES


class UnitError(ValueError):
    """A unit that is not in the table."""

    def __init__(self, unit: str) -> None:
        self.unit = unit
        super().__init__(f"{unit!r} is not a unit of the table")


@dataclass(frozen=True, slots=True)
class Dimension:
    """What a quantity measures: exponents of the base dimensions, none of them zero, sorted.

    Attributes:
        exponents: pairs such as `("length", Fraction(1))`.
    """

    exponents: tuple[tuple[str, Fraction], ...] = ()

    @property
    def dimensionless(self) -> bool:
        """Whether it is a plain number."""
        return not self.exponents

    def __mul__(self, other: "Dimension") -> "Dimension":
        total = dict(self.exponents)
        for base, exponent in other.exponents:
            total[base] = total.get(base, Fraction(0)) + exponent
        return _dimension(total)

    def __truediv__(self, other: "Dimension") -> "Dimension":
        return self * other ** Fraction(-1)

    def __pow__(self, power: Fraction) -> "Dimension":
        return _dimension({base: exponent * power for base, exponent in self.exponents})


PLAIN: Final = Dimension()


@dataclass(frozen=True, slots=True)
class _Row:
    """A row of the table.

    Attributes:
        unit: our spelling.
        size: in the unit that `si` names, without pi.
        pi: how many times pi is a factor of its size.
        si: what it is made of: base units joined like any unit.
        texts: how it is written in each language.
        also: other accepted spellings.
    """

    unit: str
    size: Fraction
    pi: int
    si: str
    texts: Mapping[str, str]
    also: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Part:
    """One factor of a compound unit."""

    name: str
    power: int


# A power has two digits at most: more is no unit, and a number with a million digits is no power.
_OUR_FACTOR: Final = re.compile(r"([*/])([^\s*/\d()]+|1(?![\d*]))(?:\*\*(-?\d{1,2}))?(?!\d)")
_THEIR_FACTOR: Final = re.compile(r"([*/])([^\s*/\d()^-]+|1(?![\d^-]))(?:\^?(-?\d{1,2}))?(?!\d)")
_BASE_UNITS: Final = {
    "mass": "kg",
    "length": "m",
    "time": "s",
    "current": "A",
    "temperature": "K",
}
_SUPERSCRIPTS: Final = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_NO_UNIT: Final = frozenset({"", "-", "–", "—", "1", "б/р"})
# Capitals and small letters of two alphabets that look alike in print: a student who forgets to
# switch the keyboard types one for the other and cannot see it.
_LOOK_ALIKES: Final = str.maketrans("АВЕКМНОРСТХІУасеорхуі", "ABEKMHOPCTXIYaceopxyi")


@lru_cache(maxsize=1024)
def unit_names() -> tuple[str, ...]:
    """Return the units that have names, in our spelling; others are made of them."""
    return tuple(_table())


@lru_cache(maxsize=1024)
def known(unit: str) -> bool:
    """Tell whether a unit is spelled as the table and its compounds are."""
    parts = _split(unit, _OUR_FACTOR)
    atoms = {"1", *_table()}
    return unit in {"", *atoms} or (parts is not None and all(p.name in atoms for p in parts))


@lru_cache(maxsize=1024)
def factor(unit: str) -> float:
    """Return the size of a unit in SI: a value in `unit` times the factor is in SI.

    Raises:
        UnitError: the unit is unknown.
    """
    return _size(unit)[0]


@lru_cache(maxsize=1024)
def dimension(unit: str) -> Dimension:
    """Return what a unit measures.

    Raises:
        UnitError: the unit is unknown.
    """
    return _size(unit)[1]


@lru_cache(maxsize=1024)
def unit_text(unit: str, language: str) -> str:
    """Write a unit as people write it in `language` (en, ru or uk): `m/s**2` becomes `м/с²`.

    Raises:
        UnitError: the unit is unknown.
    """
    if unit in _table():
        return _table()[unit].texts[language]
    if unit == "":
        return ""
    if not known(unit):
        raise UnitError(unit)
    parts = _split(unit, _OUR_FACTOR) or ()
    above = [_part_text(part, language) for part in parts if part.power > 0 and part.name != "1"]
    below = [_part_text(part, language) for part in parts if part.power < 0]
    return _slash("·".join(above) or "1", below)


def stands_close(written: str) -> bool:
    """Tell whether a unit, as it is written, follows its number without a space: a degree sign."""
    return not written or (written.startswith("°") and not written.startswith("°C"))


@lru_cache(maxsize=1024)
def read_unit(text: str) -> str | None:
    """Return our spelling of a unit that a person typed, None where it is no unit we know.

    Any of the three languages, look-alike letters of the other alphabet, brackets round the unit,
    `м/с2`, `м/с^2`, `Н*м`, `Н·м` and `Н м` are understood. No text is a plain number: "".
    """
    plain = _plain(text)
    if plain in _NO_UNIT:
        return ""
    whole = _find(plain)
    if whole is not None:
        return whole
    parts = _split(plain.replace("**", "^").replace(" ", "*"), _THEIR_FACTOR)
    return None if parts is None else _compound(parts)


def dimension_text(measured: Dimension, language: str) -> str:
    """Name a dimension by a unit that people know: the first of the table, or a compound."""
    for unit in _table():
        if dimension(unit) == measured and not measured.dimensionless:
            return unit_text(unit, language)
    above = [_base_text(base, p, language) for base, p in measured.exponents if p > 0]
    below = [_base_text(base, -p, language) for base, p in measured.exponents if p < 0]
    return _slash("·".join(above) or "1", below)


def _dimension(exponents: Mapping[str, Fraction]) -> Dimension:
    return Dimension(tuple(sorted((base, power) for base, power in exponents.items() if power)))


def _size(unit: str) -> tuple[float, Dimension]:
    """Multiply the sizes of a unit's factors, and what they are made of."""
    if unit == "":
        return 1.0, PLAIN
    parts = _split(unit, _OUR_FACTOR)
    if unit in _table():
        parts = (_Part(unit, 1),)
    if parts is None or not known(unit):
        raise UnitError(unit)
    size, pi, measured = Fraction(1), 0, PLAIN
    for part in parts:
        if part.name != "1":
            row = _table()[part.name]
            size *= row.size**part.power
            pi += row.pi * part.power
            measured *= _made_of(row) ** Fraction(part.power)
    return float(size) * math.pi**pi, measured


def _made_of(row: _Row) -> Dimension:
    parts = _split(row.si, _OUR_FACTOR) or ()
    bases = {name: base for base, name in _BASE_UNITS.items()}
    return _dimension({bases[p.name]: Fraction(p.power) for p in parts if p.name != "1"})


@lru_cache(maxsize=1)
def _table() -> Mapping[str, _Row]:
    """Read `units.csv`: rows by our spelling, in the order of the file."""
    text = (files("gripcourse") / "text" / "units.csv").read_text(encoding="utf-8")
    rows = [
        _Row(
            unit=row["unit"],
            size=Fraction(row["size"].replace("pi/", "1/").removesuffix("*pi")),
            pi=row["size"].count("pi"),
            si=row["si"],
            texts={name: row[name] for name in LANGUAGES},
            also=tuple(row["also"].split()),
        )
        for row in csv.DictReader(text.splitlines())
    ]
    return {row.unit: row for row in rows}


def _split(text: str, pattern: re.Pattern[str]) -> tuple[_Part, ...] | None:
    """Split a compound unit into its factors; None where it is none."""
    rest, parts = f"*{text}", []
    while rest:
        found = pattern.match(rest)
        if found is None:
            return None
        sign = -1 if found[1] == "/" else 1
        parts.append(_Part(found[2], sign * int(found[3] or 1)))
        rest = rest[found.end() :]
    return tuple(parts)


def _part_text(part: _Part, language: str) -> str:
    power = abs(part.power)
    raised = "" if power == 1 else str(power).translate(_SUPERSCRIPTS)
    return _table()[part.name].texts[language] + raised


def _base_text(base: str, power: Fraction, language: str) -> str:
    """Write the SI unit of a base dimension to a power, which may be broken: `м^(1/2)`."""
    unit = _BASE_UNITS.get(base)
    name = base if unit is None else unit_text(unit, language)
    if power.denominator > 1:
        return f"{name}^({power})"
    return name if power == 1 else name + str(power).translate(_SUPERSCRIPTS)


def _slash(above: str, below: Iterable[str]) -> str:
    """Join what is above and below the slash, with brackets round several factors below."""
    factors = tuple(below)
    if not factors:
        return above
    joined = "·".join(factors)
    return f"{above}/({joined})" if len(factors) > 1 else f"{above}/{joined}"


def _plain(text: str) -> str:
    """Bring typed text into one form: no brackets, no spare dots, no superscripts."""
    # These two only look like a degree sign, and normalisation would make a letter of the first.
    degrees = text.replace("º", "°").replace("˚", "°")
    flat = unicodedata.normalize("NFKC", degrees).replace("−", "-")
    flat = re.sub(r"\s*[·⋅∙•×∗]\s*", "*", flat)
    # A dot within shortens a word, as in `мм рт. ст.`, or is one more sign for a product.
    flat = re.sub(r"\.(?=\s*\w)", " ", flat)
    flat = re.sub(r"\.?\s*([*/^])\s*", r"\1", " ".join(flat.split()))
    if flat[:1] + flat[-1:] in {"[]", "()"}:
        flat = flat[1:-1].strip()
    # Several factors below one slash: `кг/(м*с)` and `кг/(м с)` are `кг/м/с`.
    flat = re.sub(r"/\(([^()/]*)\)", lambda below: "/" + re.sub("[* ]", "/", below[1]), flat)
    return flat.removeprefix(",").strip().rstrip(".,;").strip()


def _as_seen(text: str) -> str:
    return text.translate(_LOOK_ALIKES)


def _small(text: str) -> str:
    return text.casefold().translate(_LOOK_ALIKES)


def _capital(text: str) -> str:
    return text.upper().translate(_LOOK_ALIKES)


# From strict to lenient: what is unlike only in look-alikes, then in small and capital letters.
_KEYS: Final[tuple[Callable[[str], str], ...]] = (_as_seen, _small, _capital)


# A square, as in `кв. мм`; a kilovolt has a capital letter.
_SQUARE: Final = frozenset({"кв", "Кв", "КВ"})


@lru_cache(maxsize=1)
def _spellings() -> tuple[Mapping[str, frozenset[str]], ...]:
    """Return for each key the units that a spelling can mean."""
    indices: list[dict[str, frozenset[str]]] = [{} for _ in _KEYS]
    for row in _table().values():
        for spelling in (row.unit.replace("**", "^"), *row.texts.values(), *row.also):
            for index, key in zip(indices, _KEYS, strict=True):
                written = key(_plain(spelling))
                index[written] = index.get(written, frozenset()) | {row.unit}
    return tuple(indices)


def _find(text: str) -> str | None:
    """Return the unit of the table that a text means, where it can mean only one."""
    if text in _SQUARE:
        return None
    for index, key in zip(_spellings(), _KEYS, strict=True):
        found = index.get(key(text), frozenset())
        if len(found) == 1:
            return next(iter(found))
    return None


def _compound(parts: Iterable[_Part]) -> str | None:
    """Spell a compound of units that the table knows; None where it does not know one of them."""
    above: list[str] = []
    below: list[str] = []
    for part in parts:
        name = "1" if part.name == "1" else _find(part.name.rstrip("."))
        if name is None:
            return None
        power = abs(part.power)
        spelled = name if power == 1 else f"{name}**{power}"
        (above if part.power > 0 else below).append(spelled)
    numerator = "*".join(name for name in above if name != "1") or "1"
    return "/".join((numerator, *below))
