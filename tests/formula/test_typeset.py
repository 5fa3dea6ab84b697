from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula.boxes import Fence, Fraction, Row, Script, Text, Value, boxes
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.markup import text
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Call, Formula, Name, Negation, Node, Number, Operation
from gripcourse.formula.typeset import (
    Box,
    declared_symbol,
    equation,
    number_box,
    symbol_box,
    typeset,
)
from gripcourse.text.number_text import format_number
from gripcourse.text.units import factor, unit_text

SYMBOLS: Mapping[str, Box] = MappingProxyType(
    {
        "m": symbol_box("m"),
        "g": symbol_box("g"),
        "a": symbol_box("a"),
        "f": symbol_box("μ"),
        "F": symbol_box("F_тр"),
        "D": symbol_box("D_max"),
        "t": symbol_box("θ"),
        "tau": symbol_box("[τ]"),
        "bores.size": symbol_box("D"),
    }
)
NUMBERS: Mapping[str, Box] = MappingProxyType(
    {
        "m": number_box("60", "кг"),
        "g": number_box("9,81", "м/с²"),
        "a": number_box("5", "м/с²"),
        "f": number_box("0,15", ""),
        "F": number_box("−3", "Н"),
        "D": number_box("0,2", "м"),
        "t": number_box("36,87", "°"),
        "tau": number_box("1,5·10⁻⁵", "МПа"),
    }
)


def _with_symbols(formula: str) -> str:
    return text(typeset(parse(formula), SYMBOLS, "ru"))


def _with_numbers(formula: str) -> str:
    return text(typeset(parse(formula), NUMBERS, "ru"))


@pytest.mark.parametrize(
    ("formula", "symbols", "numbers"),
    [
        ("m*(g+a)", "m·(g + a)", "60 кг · (9,81 м/с² + 5 м/с²)"),
        ("m*g/(2*f)", "m·g/(2 · μ)", "(60 кг · 9,81 м/с²)/(2 · 0,15)"),
        ("F**2", "F_тр²", "(−3 Н)²"),
        ("m**2", "m²", "(60 кг)²"),
        ("f**2", "μ²", "0,15²"),
        ("t**2", "θ²", "(36,87°)²"),
        ("tau**2", "([τ])²", "(1,5·10⁻⁵ МПа)²"),
        ("m*F", "m·F_тр", "60 кг · (−3 Н)"),
        ("F*m", "F_тр·m", "−3 Н · 60 кг"),
        ("m + F", "m + F_тр", "60 кг + (−3 Н)"),
        ("m - F", "m − F_тр", "60 кг − (−3 Н)"),
        ("-F", "−F_тр", "−(−3 Н)"),
        ("-m", "−m", "−60 кг"),
        ("m - (g - a)", "m − (g − a)", "60 кг − (9,81 м/с² − 5 м/с²)"),
        ("m - g - a", "m − g − a", "60 кг − 9,81 м/с² − 5 м/с²"),
        ("m*(-g)", "m·(−g)", "60 кг · (−9,81 м/с²)"),
        ("m*(g*a)", "m·(g·a)", "60 кг · (9,81 м/с² · 5 м/с²)"),
        ("m*(g/a)", "m·(g/a)", "60 кг · ((9,81 м/с²)/(5 м/с²))"),
        ("m/g/a", "m/g/a", "(60 кг)/(9,81 м/с²)/(5 м/с²)"),
        ("m/(g/a)", "m/(g/a)", "(60 кг)/((9,81 м/с²)/(5 м/с²))"),
        ("(m/g)**2", "(m/g)²", "((60 кг)/(9,81 м/с²))²"),
        ("(m**2)**3", "(m²)³", "((60 кг)²)³"),
        ("f**(1/3)", "μ^(1/3)", "0,15^(1/3)"),
        ("f**-2", "μ^(−2)", "0,15^(−2)"),
        ("f**(m/(g*a))", "μ^(m/(g·a))", "0,15^((60 кг)/(9,81 м/с² · 5 м/с²))"),
        ("sqrt(m/g)", "√(m/g)", "√((60 кг)/(9,81 м/с²))"),
        ("hertz_crossed(f)", "Hertz(μ)", "Hertz(0,15)"),
        ("cbrt(2*m)", "∛(2 · m)", "∛(2 · 60 кг)"),
        ("sqrt(m)**2", "(√(m))²", "(√(60 кг))²"),
        ("sin(t)", "sin(θ)", "sin(36,87°)"),
        ("sin(t)**2", "sin(θ)²", "sin(36,87°)²"),
        ("sin(t)**0.5", "(sin(θ))^(0,5)", "(sin(36,87°))^(0,5)"),
        ("tan(t) + atan(f)", "tg(θ) + arctg(μ)", "tg(36,87°) + arctg(0,15)"),
        ("asin(f)*m", "arcsin(μ) · m", "arcsin(0,15) · 60 кг"),
        ("log(f)", "ln(μ)", "ln(0,15)"),
        ("max(m, g, a)", "max(m; g; a)", "max(60 кг; 9,81 м/с²; 5 м/с²)"),
        ("max(m, g)**2", "(max(m; g))²", "(max(60 кг; 9,81 м/с²))²"),
        ("abs(F)*2", "abs(F_тр) · 2", "abs(−3 Н) · 2"),
        ("hypot(F, m)", "√(F_тр² + m²)", "√((−3 Н)² + (60 кг)²)"),
        ("2*pi*m", "2 · π·m", "2 · π · 60 кг"),
        ("m*pi*2", "m·π · 2", "60 кг · π · 2"),
        ("0.5*m", "0,5 · m", "0,5 · 60 кг"),
        ("1e-7*m", "1·10⁻⁷ · m", "1·10⁻⁷ · 60 кг"),
        ("1e-7**2", "(1·10⁻⁷)²", "(1·10⁻⁷)²"),
        ("m >= g and a < f", "m ≥ g; a < μ", "60 кг ≥ 9,81 м/с²; 5 м/с² < 0,15"),
        ("m == g", "m = g", "60 кг = 9,81 м/с²"),
        ('at_least("bores.size", D)', "min{D ≥ D_max}", "min{≥ 0,2 м}"),
        ('nearest("bores.size", D)', "{D ≈ D_max}", "{≈ 0,2 м}"),
        ('lookup("bores.size", D)', "D(D_max)", "(0,2 м)"),
    ],
)
def test_a_formula_is_printed_with_the_brackets_it_needs_and_no_more(
    formula: str, symbols: str, numbers: str
) -> None:
    assert _with_symbols(formula) == symbols
    assert _with_numbers(formula) == numbers


def test_numbers_and_names_of_functions_are_printed_in_the_readers_language() -> None:
    tree = parse("0.5*tan(t)")
    assert text(typeset(tree, SYMBOLS, "en")) == "0.5 · tan(θ)"
    assert text(typeset(tree, SYMBOLS, "uk")) == "0,5 · tg(θ)"


def test_a_quotient_is_a_fraction_but_in_an_exponent_it_stays_on_the_line() -> None:
    box = typeset(parse("(m/g)**(1/3)"), SYMBOLS)
    assert sum(isinstance(part, Fraction) for part in boxes(box)) == 1
    assert isinstance(box, Script)
    assert isinstance(box.sup, Row)


def test_symbols_stand_side_by_side_and_numbers_have_a_sign_between() -> None:
    def signs(box: Box) -> list[str]:
        found = (part for part in boxes(box) if isinstance(part, Text))
        return [part.text for part in found if part.kind == "times"]

    assert signs(typeset(parse("m*g*(a+g)"), SYMBOLS)) == ["", ""]
    assert signs(typeset(parse("2*m*g"), SYMBOLS)) == ["·", ""]
    assert signs(typeset(parse("m*g"), NUMBERS)) == ["·"]
    assert signs(typeset(parse("m/g*(a/g)"), SYMBOLS)) == ["·"]


@pytest.mark.parametrize(
    ("symbol", "box"),
    [
        ("m", Text("variable", "m")),
        ("θ", Text("variable", "θ")),
        ("Δ", Text("upright", "Δ")),
        ("Re", Text("upright", "Re")),
        ("Р", Text("upright", "Р")),  # a Cyrillic letter
        ("F_П", Script(Text("variable", "F"), Text("upright", "П"), None)),
        ("K_Fβ", Script(Text("variable", "K"), Text("upright", "Fβ"), None)),
        (
            "[σ]_b",
            Script(
                Row((Text("upright", "["), Text("variable", "σ"), Text("upright", "]"))),
                Text("upright", "b"),
                None,
            ),
        ),
        (
            "[σ_F]",
            Row(
                (
                    Text("upright", "["),
                    Script(Text("variable", "σ"), Text("upright", "F"), None),
                    Text("upright", "]"),
                )
            ),
        ),
        ("Δl", Row((Text("upright", "Δ"), Text("variable", "l")))),
    ],
)
def test_single_latin_and_small_greek_letters_are_italic(symbol: str, box: Box) -> None:
    assert symbol_box(symbol) == box


def test_the_square_of_an_indexed_symbol_carries_both() -> None:
    box = typeset(parse("F**2"), SYMBOLS)
    assert box == Script(Text("variable", "F"), Text("upright", "тр"), Text("number", "2"))


def test_an_equation_joins_its_parts_by_signs_of_equality() -> None:
    parts = [symbol_box("F"), typeset(parse("m*g"), SYMBOLS), Value("588,6", "Н")]
    assert text(equation(parts)) == "F = m·g = 588,6 Н"
    assert text(equation(parts[:1])) == "F"


def test_brackets_are_round() -> None:
    box = typeset(parse("m*(g+a)"), SYMBOLS)
    assert [(p.left, p.right) for p in boxes(box) if isinstance(p, Fence)] == [("(", ")")]


# What is printed must say what is computed: random formulas, printed and read back.

UNITS = MappingProxyType({"a": "mm", "b": "N", "c": "deg", "d": "", "e": "m/s**2"})

_typed = st.sampled_from(["0.5", "2", "3", "17", "0.15", "1000", "12345", "2.5"])
_literals = st.builds(lambda t: Number(float(t), t), _typed)
_leaves = st.one_of(_literals, st.sampled_from([Name("pi"), *map(Name, UNITS)]))


def _grown(inner: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
    small = st.builds(lambda n: Number(float(n), str(n)), st.integers(2, 4))
    one = st.sampled_from(
        ["sqrt", "cbrt", "sin", "cos", "tan", "asin", "acos", "atan", "abs", "exp", "log"]
    )
    two = st.sampled_from(["min", "max", "atan2"])
    sign = st.sampled_from(["+", "-", "*", "/"])
    return st.one_of(
        st.builds(Operation, sign, inner, inner),
        st.builds(Operation, st.just("**"), inner, st.one_of(small, inner)),
        st.builds(Negation, inner),
        st.builds(lambda name, x: Call(name, (x,)), one, inner),
        st.builds(lambda name, x, y: Call(name, (x, y)), two, inner, inner),
    )


_trees = st.recursive(_leaves, _grown, max_leaves=9)
_numbers = st.decimals(-999, 999, places=2).map(float)


@given(_trees, st.fixed_dictionaries(dict.fromkeys(UNITS, _numbers)))
def test_a_printed_substitution_reads_back_and_gives_the_same_value(
    value_from_print: Callable[[str], float], tree: Node, given_values: Mapping[str, float]
) -> None:
    shown = {
        name: number_box(format_number(value, "ru", 12), unit_text(UNITS[name], "ru"))
        for name, value in given_values.items()
    }
    in_si = {name: np.asarray(v * factor(UNITS[name])) for name, v in given_values.items()}
    expected = float(evaluate(Formula("", tree, {}), "", in_si, {}))
    printed = text(typeset(tree, shown, "ru"))
    np.testing.assert_equal(value_from_print(printed), expected, err_msg=printed)


@given(_trees)
def test_a_printed_formula_reads_back_as_the_same_formula(
    formula_from_print: Callable[[str], str], tree: Node
) -> None:
    symbols = {name: symbol_box(name) for name in UNITS}
    printed = text(typeset(tree, symbols, "ru"))
    values = {name: np.asarray(0.3 + 0.1 * row) for row, name in enumerate(UNITS)}
    again = parse(formula_from_print(printed))
    np.testing.assert_equal(
        evaluate(Formula("", again, {}), "", values, {}),
        evaluate(Formula("", tree, {}), "", values, {}),
        err_msg=printed,
    )


def test_a_bar_behind_a_symbol_is_no_part_of_its_subscript() -> None:
    subscripts = [
        text(box.sub)
        for box in boxes(declared_symbol("|u − u_0| ≤ 0,04·u_0"))
        if isinstance(box, Script) and box.sub is not None
    ]
    assert subscripts == ["0", "0"]
