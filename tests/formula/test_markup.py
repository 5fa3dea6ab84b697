import logging
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula.boxes import Fence, Fraction, Root, Row, Script, Text, Value
from gripcourse.formula.markup import html
from gripcourse.formula.parse import parse
from gripcourse.formula.typeset import Box, equation, number_box, symbol_box, typeset

STYLE = Path(__file__).parents[2] / "templates" / "style" / "formula.css"
SYMBOLS = {
    "m": symbol_box("m"),
    "g": symbol_box("g"),
    "f": symbol_box("μ"),
    "F": symbol_box("F_тр"),
}
NUMBERS = {
    "m": number_box("12 345", "кг"),
    "g": number_box("9,81", "м/с²"),
    "f": number_box("0,15", ""),
    "F": number_box("−3", "Н"),
}


class _Reader(HTMLParser):
    """Collects the text of a page in reading order and checks that its elements are closed."""

    def __init__(self) -> None:
        super().__init__()
        self.text = ""
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert {name for name, _ in attrs} <= {"class", "style"}  # what is wide is set smaller
        self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


def _read(box: Box) -> str:
    reader = _Reader()
    reader.feed(html(box))
    reader.close()
    assert not reader.open
    return reader.text.replace("\u00a0", " ").replace("\u202f", " ")


def test_a_symbol_is_italic_with_an_upright_index() -> None:
    written = html(symbol_box("F_тр"))
    assert written == '<span class="formula f-slanted">F<sub>тр</sub></span>'


def test_of_slanted_and_upright_runs_the_fewer_have_elements_of_their_own() -> None:
    written = html(typeset(parse("m + g"), SYMBOLS))
    assert written == '<span class="formula f-slanted">m<span> +\u00a0</span>g</span>'
    written = html(typeset(parse("2*m"), SYMBOLS))
    assert written == '<span class="formula">2 ·\u00a0<i>m</i></span>'


def test_slanted_letters_in_a_product_are_one_run() -> None:
    assert html(typeset(parse("2*(m*g*F)"), SYMBOLS)).count("<i>") == 1


def test_upright_runs_need_no_element_of_their_own() -> None:
    box = typeset(parse("g + g"), NUMBERS, "ru")
    assert html(box).count("<") == 2


def test_a_number_never_parts_from_its_unit_nor_from_its_own_digits() -> None:
    written = html(NUMBERS["m"])
    assert "12\u00a0345\u00a0кг" in written
    assert html(number_box("36,87", "°")) == '<span class="formula">36,87°</span>'


def test_a_line_breaks_before_a_sign_and_not_after_it() -> None:
    written = html(equation([SYMBOLS["m"], typeset(parse("m*2 + g"), NUMBERS, "ru")]))
    assert re.findall(r"[ \u00a0][=+·][ \u00a0]", written) == [" =\u00a0", " ·\u00a0", " +\u00a0"]


def test_whatever_stands_in_a_box_is_escaped() -> None:
    nasty = "<b>&\"'"
    for box in (
        Text("upright", nasty),
        Text("variable", nasty),
        Value(nasty, nasty),
        Script(Text("variable", nasty), Text("upright", nasty), None),
        Root(Text("number", nasty), nasty),
    ):
        assert "<b>" not in html(box)
        assert nasty in _read(box)


@pytest.mark.parametrize(
    ("formula", "read"),
    [
        ("m*g/(2*f)", "m g/2 · μ"),
        ("sqrt(m/g)", "√m/g"),
        ("cbrt(m)", "3√m"),
        ("m*(g + f)", "m (g + μ)"),
        ("(m/g)**2", "(m/g)2"),
        ("abs(m/g)", "|m/g|"),
        ("sin(f)**2", "sin2 μ"),
        ("hertz_crossed(f)", "Hertz(μ)"),
        ("sin(f*2)", "sin(μ · 2)"),
        ("exp(f)", "exp(μ)"),
        ("max(m, g)", "max(m; g)"),
        ("m <= g and m > f", "m ≤ g; m > μ"),
        ("F**2 + 1", "F2тр + 1"),
    ],
)
def test_a_formula_is_selected_in_reading_order(formula: str, read: str) -> None:
    assert _read(typeset(parse(formula), SYMBOLS, "ru")) == read


def test_brackets_round_something_tall_grow() -> None:
    tall = html(typeset(parse("m*(1 + m/g)"), SYMBOLS))
    flat = html(typeset(parse("m*(1 + m)"), SYMBOLS))
    assert "f-fence f-round" in tall
    assert "f-fence" not in flat


def test_a_superscript_after_something_tall_is_raised() -> None:
    assert "f-raised-1" in html(typeset(parse("(m/g)**2"), SYMBOLS))
    assert "f-raised-2" in html(typeset(parse("(m/g/g)**2"), SYMBOLS))
    assert "f-raised" not in html(typeset(parse("m**2"), SYMBOLS))


def test_the_bar_of_a_fraction_over_a_tall_one_stays_on_the_line() -> None:
    assert "f-deep-1" in html(typeset(parse("m/(1 + m/g)"), SYMBOLS))
    assert "f-deep" not in html(typeset(parse("(1 + m/g)/m"), SYMBOLS))


_texts = st.builds(Text, st.sampled_from(["number", "variable", "operator", "times"]), st.text())
_boxes = st.recursive(
    st.one_of(_texts, st.builds(Value, st.text(), st.text(max_size=3))),
    lambda inner: st.one_of(
        st.builds(Fraction, inner, inner),
        st.builds(Root, inner, st.sampled_from(["", "3"])),
        st.builds(Script, inner, st.none() | inner, st.none() | inner),
        st.builds(Fence, st.sampled_from("(|{"), inner, st.just(")")),
        st.builds(lambda items: Row(tuple(items)), st.lists(inner, min_size=1, max_size=3)),
    ),
    max_leaves=6,
)


@given(_boxes)
def test_any_box_is_well_formed_html(box: Box) -> None:
    assert isinstance(_read(box), str)


def test_every_class_that_is_written_has_a_style_and_every_style_is_written() -> None:
    formulas = [
        "((m/g/m)**2 + (m/g)**2 + (m/g/m/g)**2)/(1 + m/g)",
        "cbrt(F**2)/sqrt(m/(1 + m/g/m)/(1 + m/g/m/g))",
        "m/(1 + m/g/m) + m/(1 + m/g/m/g)",
        "abs(m/g)",
        'at_least("a.b", m/g)',
    ]
    pages = "".join(html(typeset(parse(formula), SYMBOLS)) for formula in formulas)
    written = set(re.findall(r"[\w-]+", " ".join(re.findall(r'class="([^"]*)"', pages))))
    styled = set(
        re.findall(
            r"\.([a-z][\w-]*)",
            re.sub(r"url\([^)]*\)|/\*.*?\*/", "", STYLE.read_text(), flags=re.DOTALL),
        )
    )
    assert written <= styled
    assert styled <= written


def test_a_page_of_formulas_prints_without_a_complaint_and_in_order(
    caplog: pytest.LogCaptureFixture, tmp_path: Path
) -> None:
    import pypdf  # noqa: PLC0415 - heavy
    import weasyprint  # noqa: PLC0415 - heavy

    parts = [SYMBOLS["F"], *(typeset(parse("m*(g + g)/f"), s, "ru") for s in (SYMBOLS, NUMBERS))]
    page = f"<style>{STYLE.read_text()}</style><p>{html(equation(parts))}"
    with caplog.at_level(logging.WARNING, "weasyprint"):
        weasyprint.HTML(string=page).write_pdf(tmp_path / "page.pdf")
    assert not caplog.records
    printed = pypdf.PdfReader(tmp_path / "page.pdf").pages[0].extract_text()
    squeezed = re.sub(r"\s", "", printed)
    assert squeezed == "Fтр=m(g+g)/μ=12345кг·(9,81м/с²+9,81м/с²)/0,15"
