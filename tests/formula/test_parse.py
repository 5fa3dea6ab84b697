import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula.fault import FormulaFault, caret
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import (
    Call,
    Formula,
    Name,
    Negation,
    Node,
    Number,
    Operation,
    names,
    walk,
)

A, B, C = Name("a"), Name("b"), Name("c")
ONE, TWO = Number(1.0, "1"), Number(2.0, "2")


def _fault(text: str) -> FormulaFault:
    with pytest.raises(FormulaFault) as caught:
        parse(text)
    return caught.value


@pytest.mark.parametrize(
    ("text", "tree"),
    [
        ("a", A),
        ("2", TWO),
        ("a+b*c", Operation("+", A, Operation("*", B, C))),
        ("(a+b)*c", Operation("*", Operation("+", A, B), C)),
        ("a-b-c", Operation("-", Operation("-", A, B), C)),
        ("a/b/c", Operation("/", Operation("/", A, B), C)),
        ("a**b**c", Operation("**", A, Operation("**", B, C))),
        ("-a**2", Negation(Operation("**", A, TWO))),
        ("(-a)**2", Operation("**", Negation(A), TWO)),
        ("a**-b", Operation("**", A, Negation(B))),
        ("-a*b", Operation("*", Negation(A), B)),
        ("sqrt(a)", Call("sqrt", (A,))),
        ("max(a, b, c)", Call("max", (A, B, C))),
        ("a <= b", Operation("<=", A, B)),
        (
            "a < b and b >= c and a == c",
            Operation(
                "and",
                Operation("and", Operation("<", A, B), Operation(">=", B, C)),
                Operation("==", A, C),
            ),
        ),
        ('at_least("bores.size", a)', Call("at_least", (A,), "bores.size")),
        ("at_least('bores.size', a)", Call("at_least", (A,), "bores.size")),
    ],
)
def test_a_formula_means_what_python_would_mean(text: str, tree: object) -> None:
    assert parse(text) == tree


@pytest.mark.parametrize("text", ["a +\n  b", "\n  a + b\n", "a\t+ b", "a\u00a0+\r\nb"])
def test_line_breaks_and_other_spaces_are_spaces(text: str) -> None:
    assert parse(text) == Operation("+", A, B)


@pytest.mark.parametrize(
    ("text", "value"), [("1", 1.0), ("0.50", 0.5), ("1e-3", 0.001), (".5", 0.5)]
)
def test_a_number_keeps_how_it_was_typed(text: str, value: float) -> None:
    node = parse(f"a * {text}")
    assert isinstance(node, Operation)
    assert isinstance(node.right, Number)
    assert (node.right.value, node.right.text) == (value, text)


def test_spans_are_characters_of_the_text_as_written() -> None:
    text = "  first +\n  sqrt(second)*2"
    for node in walk(parse(text)):
        if isinstance(node, Name):
            assert text[slice(*node.span)] == node.id
        if isinstance(node, Call):
            assert text[slice(*node.span)] == "sqrt(second)"


def test_spans_count_characters_also_after_letters_of_several_bytes() -> None:
    text = 'lookup("серия.d", a) + sqr(b)'
    # the column is refused first: it must be caught where it stands
    fault = _fault(text)
    assert text[slice(*fault.span)] == '"серия.d"'


def test_pi_is_no_quantity() -> None:
    assert names(parse("pi*a/b + a")) == ("a", "b")


@pytest.mark.parametrize(
    ("text", "what", "place"),
    [
        ("", "empty", ""),
        ("   \n ", "empty", "   \n "),
        ("2*a+", "missing or too much", "+"),
        ("a b", "missing or too much", "a"),
        ("* a", "missing or too much", "*"),
        ("(a+b", "never closed", "("),
        ("((a)", "never closed", "("),
        ("a+b)", "closes nothing", ")"),
        (")a(", "closes nothing", ")"),
        ("a^2", "power is written **", "^"),
        ("a·b", "product is written *", "·"),
        ("a − b", "minus is written", "−"),
        ("0,5*a", "decimal point", ","),
        ("(0,5)*a", "decimal point", "(0,5)"),
        ("a = b", "written ==", "="),
        ("a != b", "sign ! has no meaning", "!"),
        ("a ≤ b", "written with <, <=", "≤"),
        ("a < b < c", "a < b and b < c", "a < b < c"),
        ("(a < b)*2", "cannot be part of an expression", "a < b"),
        ("sqrt(a < b)", "cannot be part of an expression", "a < b"),
        ("a and b", "Only comparisons can be joined", "a"),
        ("a < b or b < c", "know only 'and'", "a < b or b < c"),
        ("not a", "know only 'and'", "not a"),
        ("a in b", "written with <, <=", "a in b"),
        ("a % b", "sign % has no meaning", "%"),
        ("a // b", "not part of the formula language", "a // b"),
        ("+a", "nothing before this plus", "+a"),
        ("a if b else c", "not part of the formula language", "a if b else c"),
        ("a.b", "point stands only in numbers", "."),
        ("a[0]", "Only round brackets", "["),
        ("a # note", "sign # has no meaning", "#"),
        ("сила*2", "Latin letters", "с"),
        ("forcе", "Latin letters", "е"),  # the last letter is Cyrillic
        ("2j", "not a number", "2j"),
        ("0x10", "not a number", "0x10"),
        ("1_000", "not a number", "1"),
        ("1e999", "too large", "1e999"),
        ("2*1.5e-999", "taken as 0", "1.5e-999"),
        ("007", "missing or too much", "0"),
        ("True", "not part of the formula language", "True"),
        ("'a'", "only name a catalogue's column", "'a'"),
        ("f'a'", "not part of the formula language", "f'a'"),
        ("sqrt + 1", "needs its arguments in brackets", "sqrt"),
        ("sqr(a)", "did you mean sqrt?", "sqr"),
        ("frobnicate(a)", "Functions are sqrt, cbrt", "frobnicate"),
        ("pi()", "no function pi", "pi"),
        ("sqrt()", "takes 1 values, and here are 0", "sqrt()"),
        ("sqrt(a, b)", "takes 1 values, and here are 2", "sqrt(a, b)"),
        ("max(a)", "takes 2…20 values", "max(a)"),
        ("max(*a)", "takes 2…20 values", "max(*a)"),
        ("max(a, *b)", "not part of the formula language", "*b"),
        ("sqrt(x=1)", "written ==", "="),
        ("at_least(a)", "needs a catalogue", "a"),
        ("at_least()", "needs a catalogue", "at_least()"),
        ('at_least("bores", a)', "needs a catalogue", '"bores"'),
        ('at_least("bores.size")', "takes 1 values, and here are 0", 'at_least("bores.size")'),
        ('sqrt("a.b")', "only name a catalogue's column", '"a.b"'),
        ('at_least("bores.size, a)', "Quotation marks only name", '"'),
        ("m(g + a)", "a product needs its sign *", "m"),
        ("(a)(b)", "a product needs its sign *", "a"),
    ],
)
def test_what_is_no_formula_is_refused_where_it_goes_wrong(
    text: str, what: str, place: str
) -> None:
    fault = _fault(text)
    assert what in str(fault.what)
    assert text[slice(*fault.span)] == place
    assert "^" in caret(text, fault.span)


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os').system('true')",
        "lambda: 1",
        "[a for a in b]",
        "(a for a in b)",
        "{a: b}",
        "(yield a)",
        "(a := 2)",
        "`a`",
        "a @ b",
        "a & b",
        "~a",
        "a\\\nb",
        "print(1)",
        "...",
        "None",
        "b'a'",
        "a; b",
        "\x00",
    ],
)
def test_nothing_of_python_but_arithmetic_gets_through(text: str) -> None:
    assert isinstance(_fault(text), FormulaFault)


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("(" * 61 + "a" + ")" * 61, "nested too deeply"),
        ("-" * 1999 + "a", "nested too deeply"),
        ("+".join("a" * 150), "nested too deeply"),
        ("**".join("a" * 500), "nested too deeply"),
        ("a+" * 1500 + "a", "longer than 2000"),
    ],
)
def test_a_formula_that_could_exhaust_the_machine_is_refused(text: str, what: str) -> None:
    assert what in str(_fault(text).what)


def test_a_long_sum_is_no_fault() -> None:
    assert len(names(parse(" + ".join(f"part_{i}" for i in range(80))))) == 80


def _read(text: str) -> Node | FormulaFault:
    try:
        return parse(text)
    except FormulaFault as fault:
        return fault


@given(st.text(max_size=40) | st.text(alphabet="ab12 .+-*/()<=,e\"'", max_size=30))
def test_any_text_is_a_formula_or_a_fault_inside_it(text: str) -> None:
    found = _read(text)
    if isinstance(found, FormulaFault):
        start, end = found.span
        assert 0 <= start <= end <= max(len(text), start + 1)
        assert caret(text, found.span)
    else:
        assert all(text[slice(*node.span)].strip() for node in walk(found))


def test_a_formula_that_was_sent_away_knows_its_names_without_a_walk() -> None:
    formula = Formula("a+b*a", parse("a+b*a"), {"a": "mm"})
    formula.made["here"] = len
    sent = pickle.loads(pickle.dumps(formula))  # noqa: S301 (packed here)
    assert sent == formula
    assert sent.names == formula.names == ("a", "b")
    assert sent.made == {}
    # A state of one's own is forgotten by Python before 3.11.4: Debian 12 has such a one.
    make, parts = formula.__reduce__()
    assert make(*parts) == formula


def test_a_function_is_told_by_the_name_that_books_give_it() -> None:
    for name, meant in {"ln": "log", "tg": "tan", "arctg": "atan"}.items():
        with pytest.raises(FormulaFault, match=f"did you mean {meant}"):
            parse(f"{name}(force)")
