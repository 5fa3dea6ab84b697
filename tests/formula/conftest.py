"""What the tests of formulas share."""

import re
from collections.abc import Callable

import pytest

from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.text.units import factor, read_unit

_NUMBER_WITH_UNIT = re.compile(
    r"(\d[\d\u202f]*(?:,\d+)?)[ \u00a0]?((?:°|[A-Za-zА-Яа-яµ]+[²³]?)(?:[·/][A-Za-zА-Яа-я]+[²³]?)*)"
)
_WORDS = {
    "√": "sqrt",
    "∛": "cbrt",
    "arcsin": "asin",
    "arccos": "acos",
    "arctg": "atan",
    "tg": "tan",
    "ln": "log",
    "Hertz": "hertz_crossed",
}
_SIGNS = {"·": "*", "−": "-", "^": "**", ";": ";", "≤": "<=", "≥": ">=", "π": "pi", "\u202f": ""}
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@pytest.fixture(scope="session")
def formula_of() -> Callable[..., Formula]:
    """Make a formula from its text, and the units of an empirical one."""

    def make(text: str, **units: str) -> Formula:
        return Formula(text, parse(text), units)

    return make


@pytest.fixture(scope="session")
def formula_from_print() -> Callable[[str], str]:
    """Turn a printed formula in Russian back into the formula language, in SI."""

    def with_unit(found: re.Match[str]) -> str:
        unit = read_unit(found[2])
        assert unit is not None, found[2]
        return f"({found[1]}*{factor(unit)!r})"

    def rewrite(printed: str) -> str:
        text = _NUMBER_WITH_UNIT.sub(with_unit, printed)
        text = re.sub(r"[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda m: f"**({m[0].translate(_RAISED)})", text)
        for word, name in _WORDS.items():
            text = re.sub(rf"(?<![a-z]){word}(?=\()", name, text)
        for sign, plain in _SIGNS.items():
            text = text.replace(sign, plain)
        return re.sub(r"(\d),(\d)", r"\1.\2", text).replace(";", ",")

    return rewrite


@pytest.fixture(scope="session")
def value_from_print(formula_from_print: Callable[[str], str]) -> Callable[[str], float]:
    """Compute a printed formula in Russian, all names of which are numbers with units, in SI."""

    def compute(printed: str) -> float:
        text = formula_from_print(printed)
        return float(evaluate(Formula(text, parse(text), {}), "", {}, {}))

    return compute
