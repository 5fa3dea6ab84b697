"""Reading a printed substitution back: by rules of its own, not by the code that prints."""

import re
from typing import Final

from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.fault import FormulaFault
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.text.units import factor, read_unit

_DIGITS: Final = {
    "en": r"\d[\d\u202f]*(?:\.\d+)?",
    "ru": r"\d[\d\u202f]*(?:,\d+)?",
    "uk": r"\d[\d\u202f]*(?:,\d+)?",
}
_POWER_OF_TEN: Final = "(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?"
_LETTERS: Final = r"[^\W\d_]+[²³⁴]?"
_BELOW: Final = rf"{_LETTERS}|\({_LETTERS}(?:·{_LETTERS})*\)"
_UNIT: Final = rf"(?:(°)(?!C)| (°C|1/(?:{_BELOW})|{_LETTERS}(?:[·/](?:{_BELOW}))*|%))?"
_RAISED: Final = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_WORDS: Final = {
    "√": "sqrt",
    "∛": "cbrt",
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "arctg": "atan",
    "tg": "tan",
    "ln": "log",
    "превышает": "exceeds",
    "перевищує": "exceeds",
    "Hertz": "hertz_crossed",
}
_SIGNS: Final = {"·": "*", "−": "-", "^": "**", "≤": "<=", "≥": ">=", "π": "pi"}


def read_back(printed: str, language: str) -> float:
    """Compute a printed formula whose names are all numbers, in SI.

    Raises:
        ValueError: it cannot be read.
    """

    def number(found: re.Match[str]) -> str:
        digits, power, degree, unit = found.groups()
        plain = digits.replace(",", ".")
        plain = plain.replace("\u202f", "")
        if power:
            plain = f"({plain}*10**({power.translate(_RAISED)}))"
        spelled = read_unit(degree or unit or "")
        if spelled is None:
            raise ValueError(unit)
        return f"({plain}*{factor(spelled)!r})" if spelled else plain

    rewritten = re.sub(f"({_DIGITS[language]}){_POWER_OF_TEN}{_UNIT}", number, printed)
    rewritten = re.sub(
        "[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda found: f"**({found[0].translate(_RAISED)})", rewritten
    )
    for word, name in _WORDS.items():
        rewritten = re.sub(rf"(?<![^\W\d_]){word}(?=\()", name, rewritten)
    for sign, plain in _SIGNS.items():
        rewritten = rewritten.replace(sign, plain)
    rewritten = _separated(rewritten)
    try:
        return float(evaluate(Formula(rewritten, parse(rewritten), {}), "", {}, {}))
    except FormulaFault as fault:
        raise ValueError(str(fault.what)) from fault


def _separated(line: str) -> str:
    """Write `and` between conditions, and a comma between the arguments of a function."""
    parts, depth = [""], 0
    for sign in line:
        depth += (sign == "(") - (sign == ")")
        if sign == ";" and depth == 0:
            parts.append("")
        else:
            parts[-1] += "," if sign == ";" else sign
    return " and ".join(part.strip() for part in parts)
