"""The printed substitution reads back to the number that is printed behind it.

Read back by rules of its own: nothing here uses the code that prints.
"""

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.model import Kind, Quantity
from gripcourse.documents.report.angles import in_radians
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.markup import text
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Call, Formula, names, walk
from gripcourse.formula.typeset import number_box, typeset
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Values
from gripcourse.text.number_text import format_number
from gripcourse.text.units import factor, read_unit, unit_text

if TYPE_CHECKING:
    from conftest import Composition, Reference

FULL = 15  # figures
_DIGITS = {"en": r"\d[\d,]*(?:\.\d+)?", "ru": r"\d[\d\u202f]*(?:,\d+)?"}
_POWER_OF_TEN = "(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?"
_LETTERS = r"[^\W\d_]+[²³⁴]?"
_BELOW = rf"{_LETTERS}|\({_LETTERS}(?:·{_LETTERS})*\)"
_UNIT = rf"(?:(°)| ({_LETTERS}(?:[·/](?:{_BELOW}))*|%))?"
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_WORDS = {
    "√": "sqrt",
    "∛": "cbrt",
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "arctg": "atan",
    "tg": "tan",
    "ln": "log",
    "Hertz": "hertz_crossed",
}
_SIGNS = {"·": "*", "−": "-", "^": "**", "≤": "<=", "≥": ">=", "π": "pi"}


def read_back(printed: str, language: str) -> float:
    """Compute a printed formula whose names are all numbers, in SI."""

    def number(found: re.Match[str]) -> str:
        digits, power, degree, unit = found.groups()
        plain = digits.replace(",", "") if language == "en" else digits.replace(",", ".")
        plain = plain.replace("\u202f", "")
        if power:
            plain = f"({plain}*10**({power.translate(_RAISED)}))"
        spelled = read_unit(degree or unit or "")
        assert spelled is not None, f"{unit} in {printed}"
        return f"({plain}*{factor(spelled)!r})" if spelled else plain

    rewritten = re.sub(f"({_DIGITS[language]}){_POWER_OF_TEN}{_UNIT}", number, printed)
    rewritten = re.sub(
        "[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda found: f"**({found[0].translate(_RAISED)})", rewritten
    )
    for word, name in _WORDS.items():
        rewritten = re.sub(rf"(?<![A-Za-z]){word}(?=\()", name, rewritten)
    for sign, plain in _SIGNS.items():
        rewritten = rewritten.replace(sign, plain)
    rewritten = separated(rewritten)
    return float(evaluate(Formula(rewritten, parse(rewritten), {}), "", {}, {}))


def separated(line: str) -> str:
    """Write `and` between conditions, and a comma between the arguments of a function."""
    parts, depth = [""], 0
    for sign in line:
        depth += (sign == "(") - (sign == ")")
        if sign == ";" and depth == 0:
            parts.append("")
        else:
            parts[-1] += "," if sign == ";" else sign
    return " and ".join(part.strip() for part in parts)


def printed(one: Quantity, formula: Formula, plan: Plan, values: Values, language: str) -> str:
    """Print a formula with numbers instead of names, all their figures and their units."""
    counted = in_radians(one, formula, plan.quantities)
    boxes = {}
    for name in names(formula.tree):
        unit = formula.units.get(name, "rad" if name in counted else plan.quantities[name].unit)
        shown = "" if formula.units else unit_text(unit, language)
        number = format_number(float(values[name]) / factor(unit), language, FULL)
        boxes[name] = number_box(number, shown)
    return text(typeset(formula.tree, boxes, language))


def reads_a_table(formula: Formula) -> bool:
    return any(isinstance(node, Call) and node.column is not None for node in walk(formula.tree))


def printable(plan: Plan) -> Iterator[tuple[Quantity, Formula]]:
    """Yield what can be read back without a catalogue: all but choices and picks by table."""
    for one in plan.quantities.values():
        formula = plan.reference_formula(one.id)
        if formula is not None and not reads_a_table(formula):
            yield one, formula


def difference(
    one: Quantity, formula: Formula, plan: Plan, reference: "Reference", language: str
) -> float:
    """Return by which share the printed line differs from the computed value."""
    line = printed(one, formula, plan, reference.values, language)
    size = factor(one.unit) if formula.units else 1.0  # of an empirical one, in its own unit
    found = read_back(line, language) * size
    right = float(evaluate(formula, one.unit, reference.values, plan.columns))
    return abs(found - right) / max(abs(right), 1e-9)


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("convention", ["composition", "printed_composition"])
def test_a_printed_line_reads_back_to_its_value(
    request: pytest.FixtureRequest, composition_key: object, convention: str, language: str
) -> None:
    assert composition_key
    composed: Composition = request.getfixturevalue(convention)
    plan = composed.plan
    faults = [
        f"{reference.name}: {one.id}: {printed(one, formula, plan, reference.values, language)}"
        for reference in composed.references[:2]
        for one, formula in printable(plan)
        if difference(one, formula, plan, reference, language) > 1e-6
    ]
    assert faults == []


def test_every_formula_quantity_is_printed_without_a_table(composition: "Composition") -> None:
    read = {one.id for one, _ in printable(composition.plan)}
    left = {one.id for one in composition.plan.answered if one.kind is Kind.FORMULA} - read
    assert left == set()


@pytest.mark.parametrize(
    ("line", "language", "value"),
    [
        ("1.3 · 900 N/(2 · 0.15)", "en", 3900),
        ("1,3 · 900 Н/(2 · 0,15)", "ru", 3900),
        ("√((4 · 22\u202f941,2 Н)/(π · 10 МПа · 0,8091))", "ru", 0.0600844),
        ("arcsin((90 мм)/(150 мм))", "ru", 0.6435011),
        ("51 mm · (36.8699° − 0°)", "en", 0.0328186),
        ("51 мм · (0,643501 рад − 0 рад)", "ru", 0.0328186),
        ("3,5 Вт/(11 Вт/(м²·К) · 48,5 см²)", "ru", 65.60450),
        ("60 кг · (10 м/с² + 5 м/с²)", "ru", 900),
        ("0,418² · 2·10⁻⁵ м", "ru", 3.494480e-6),
        ("max(5,2; 5,9)", "ru", 5.9),
        ("20,3 МПа ≤ 80 МПа", "ru", 1),
        ("2 ≤ max(1; 3); 7 ≤ 5", "ru", 0),
        ("585 N·m", "en", 585),
    ],
)
def test_the_reader_understands_what_is_printed(line: str, language: str, value: float) -> None:
    assert read_back(line, language) == pytest.approx(value, rel=1e-5)


def test_an_angle_that_counts_as_a_number_is_put_in_in_radians(composition: "Composition") -> None:
    """Else a pocket calculator gives another number for the printed line than stands behind it."""
    plan, faults = composition.plan, []
    for one, formula in printable(plan):
        line = printed(one, formula, plan, composition.example.values, "en")
        degrees = re.sub(
            r"(sin|cos|tan)[²³]? ?\((?:[^()]|\([^()]*\))*\)|(sin|cos|tan)[²³]? [\d.]+°", "", line
        )
        if "°" in degrees and one.unit not in {"deg", "rad"} and one.kind is not Kind.VERDICT:
            faults.append(f"{one.id}: {line}")
    assert faults == []


def test_a_printed_line_that_lost_its_brackets_would_be_noticed() -> None:
    right = read_back("1.3 · 900 N/(2 · 0.15)", "en")
    wrong = read_back("1.3 · 900 N/2 · 0.15", "en")
    assert not np.isclose(right, wrong, rtol=1e-6)
