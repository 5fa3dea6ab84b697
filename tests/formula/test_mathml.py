import xml.etree.ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula.boxes import Fence, Fraction, Root, Row, Script, Text, Value
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.mathml import mathml, reads_aloud
from gripcourse.formula.parse import parse
from gripcourse.formula.typeset import Box, number_box, symbol_box, typeset

# Elements that need so many children, neither more nor fewer.
CHILDREN = {"mfrac": 2, "mroot": 2, "msub": 2, "msup": 2, "msubsup": 3}
TOKENS = {"mi", "mn", "mo", "mtext", "mspace"}
CONTAINERS = {"math", "mrow", "msqrt", *CHILDREN}
THIN = '<mspace width="0.17em"/>'
SYMBOLS = {
    "a": symbol_box("a"),
    "b": symbol_box("F_тр"),
    "c": number_box("−3", "м/с²"),
    "s": symbol_box("[σ]_b"),
}


def read(box: Box) -> ET.Element:
    """Read the MathML of a box as XML and check that it is valid."""
    root = ET.fromstring(mathml(box))  # noqa: S314 - made here
    assert root.tag == "math"
    for element in root.iter():
        assert element.tag in TOKENS | CONTAINERS
        if element.tag in TOKENS:
            assert len(element) == 0
        else:
            assert not (element.text or "").strip()
        if element.tag in CHILDREN:
            assert len(element) == CHILDREN[element.tag]
        assert not (element.tail or "").strip()
    return root


def laid_out(formula: str) -> str:
    """Write a formula's MathML without the outermost element."""
    return mathml(typeset(parse(formula), SYMBOLS)).removeprefix("<math>").removesuffix("</math>")


@pytest.mark.parametrize(
    ("formula", "written"),
    [
        ("a/b", "<mfrac><mi>a</mi><msub><mi>F</mi><mi>тр</mi></msub></mfrac>"),
        ("sqrt(a)", "<msqrt><mi>a</mi></msqrt>"),
        ("cbrt(a)", "<mroot><mi>a</mi><mn>3</mn></mroot>"),
        ("a**2", "<msup><mi>a</mi><mn>2</mn></msup>"),
        ("b**2", "<msubsup><mi>F</mi><mi>тр</mi><mn>2</mn></msubsup>"),
        ("-a", '<mo form="prefix">−</mo><mi>a</mi>'),
        ("2*a", "<mn>2</mn><mo>·</mo><mi>a</mi>"),
        ("pi*a", '<mi mathvariant="normal">π</mi><mo>\u2062</mo><mi>a</mi>'),
        ("a < 2", "<mi>a</mi><mo>&lt;</mo><mn>2</mn>"),
        (
            "sin(a)**2",
            '<msup><mi>sin</mi><mn>2</mn></msup><mo>\u2061</mo><mspace width="0.17em"/><mi>a</mi>',
        ),
        (
            "a*cos(a)",
            f"<mi>a</mi><mo>\u2062</mo>{THIN}<mi>cos</mi><mo>\u2061</mo>{THIN}<mi>a</mi>",
        ),
        ("c", "<mn>−3</mn><mtext>\u00a0м/с²</mtext>"),
    ],
)
def test_a_formula_has_the_elements_of_its_boxes(formula: str, written: str) -> None:
    assert laid_out(formula) == written


def test_brackets_grow_round_a_fraction_but_not_in_a_symbol() -> None:
    assert laid_out("(a/2)**2").startswith("<msup><mrow><mo>(</mo><mfrac>")
    assert '<mo stretchy="false">[</mo><mi>σ</mi><mo stretchy="false">]</mo>' in laid_out("s")


def test_a_formula_on_its_own_line_has_fractions_in_full_size() -> None:
    assert mathml(symbol_box("a"), large=True) == '<math displaystyle="true"><mi>a</mi></math>'


@pytest.mark.parametrize(
    ("formula", "aloud"),
    [("a > 0", True), ("a*sin(b) + 2", True), ("a/2", False), ("a**2", False), ("sqrt(a)", False)],
)
def test_only_what_is_not_drawn_is_lost(formula: str, *, aloud: bool) -> None:
    assert reads_aloud(typeset(parse(formula), SYMBOLS)) is aloud


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_function_can_be_printed(name: str) -> None:
    function = FUNCTIONS[name]
    arguments = ["a", "b/2"][: function.least] + ["c"] * (function.least - 2)
    if function.reads_column:
        arguments.insert(0, '"bores.size"')
    for formula in (f"{name}({', '.join(arguments)})", f"{name}({', '.join(arguments)})**2"):
        assert len(read(typeset(parse(formula), SYMBOLS))) > 0


texts = st.text(min_size=1, max_size=6).filter(lambda text: text.isprintable())
boxes = st.recursive(
    st.one_of(
        st.builds(Text, st.sampled_from(["number", "variable", "upright", "mark"]), texts),
        st.builds(Value, texts, st.one_of(st.just(""), texts)),
    ),
    lambda inside: st.one_of(
        st.builds(Row, st.lists(inside, min_size=2, max_size=3).map(tuple)),
        st.builds(Fraction, inside, inside),
        st.builds(Root, inside, st.sampled_from(["", "3"])),
        st.builds(Script, inside, st.none() | inside, st.none() | inside),
        st.builds(Fence, st.just("("), inside, st.just(")")),
    ),
    max_leaves=12,
)


@given(boxes)
def test_whatever_is_written_is_valid(box: Box) -> None:
    assert read(box).tag == "math"


def test_an_index_may_be_negative() -> None:
    assert ">−1<" in mathml(symbol_box("τ_-1"))
    assert "max-b" in mathml(symbol_box("a_max-b"))
