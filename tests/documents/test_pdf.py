"""Documents are tagged, self-contained, and the same bytes for the same content."""

import gc
import io
import logging
import re
from collections.abc import Callable
from datetime import date
from pathlib import Path

import pytest
from pypdf import PdfReader

from gripcourse.course.model import Course
from gripcourse.documents.pdf import Document, pdf_from_html, render_html, render_pdf
from gripcourse.errors import CourseError
from gripcourse.formula.markup import html
from gripcourse.formula.parse import parse
from gripcourse.formula.typeset import symbol_box, typeset
from gripcourse.text.amounts import amount_text, day_text, percent_text, points_text
from gripcourse.text.words import Words, message

TEMPLATE = """<html lang="{{ language }}"><title>Отчёт</title>
<p>{{ name }} {{ _("Variant") }} {{ say(sentence) }} {{ 2.5 | points }} {{ 0.125 | percent }}
{{ "D_тр" | symbol }}</p>"""


@pytest.fixture
def templates(tmp_path: Path) -> Path:
    (tmp_path / "style").mkdir()
    (tmp_path / "style" / "plain.css").write_text("p { font: 10pt 'PT Sans' }", encoding="utf-8")
    (tmp_path / "plain.html.j2").write_text(TEMPLATE, encoding="utf-8")
    return tmp_path


@pytest.fixture
def document() -> Document:
    values = {"name": "Иван", "sentence": message("{n} cells", n=1.5)}
    return Document("plain.html.j2", ("plain.css",), values)


@pytest.mark.parametrize(
    ("title", "shown"),
    [
        ("speed v_1 of the belt", "speed v1 of the belt"),
        ("коэффициент K_тр", "коэффициент Kтр"),
        ("file a_b_c.csv, key no_value", "file a_b_c.csv, key no_value"),
        ("a < b", "a &lt;\u00a0b"),
    ],
)
def test_a_symbol_in_a_title_looks_as_in_a_formula(templates: Path, title: str, shown: str) -> None:
    (templates / "title.html.j2").write_text("{{ title | prose }}", encoding="utf-8")
    page = render_html(Document("title.html.j2", (), {"title": title}), templates, Words("en"))
    assert re.sub(r"<[^>]*>", "", page) == shown
    assert ("<sub>" in page) is ("_" in title and "_" not in shown)


def test_a_power_of_a_symbol_stands_above_its_subscript(templates: Path) -> None:
    (templates / "title.html.j2").write_text("{{ title | prose }}", encoding="utf-8")
    page = render_html(Document("title.html.j2", (), {"title": "k_d²·A"}), templates, Words("en"))
    assert "<sub>d</sub></span>²·A" in page


@pytest.mark.parametrize("look", ["prose", "below"])
@pytest.mark.parametrize(
    ("title", "shown"),
    [
        ("Nu = 0.023·Re^(0,8)", "Nu = 0.023·Re<sup>0,8</sup>"),
        ("v^−0.09 below 10^4", "v<sup>−0.09</sup> below 10<sup>4</sup>"),
        ("e^(f·α) < 2", "e<sup>f·α</sup> &lt; 2"),
        ("a caret ^ alone", "a caret ^ alone"),
    ],
)
def test_a_power_in_a_sentence_is_raised(
    templates: Path, title: str, shown: str, look: str
) -> None:
    (templates / "title.html.j2").write_text("{{ title | " + look + " }}", encoding="utf-8")
    page = render_html(Document("title.html.j2", (), {"title": title}), templates, Words("en"))
    assert page.replace("\u00a0", " ") == shown


def test_no_line_ends_between_a_number_and_its_unit(templates: Path) -> None:
    (templates / "title.html.j2").write_text("{{ title | prose }}", encoding="utf-8")
    title = "off by 4 % at 5 мм, 20 kN·m and 3 ways"
    page = render_html(Document("title.html.j2", (), {"title": title}), templates, Words("en"))
    assert page == "off by 4\u00a0% at 5\u00a0мм, 20\u00a0kN·m and 3 ways"


def test_no_line_ends_inside_the_name_of_a_standard(templates: Path) -> None:
    (templates / "title.html.j2").write_text("{{ title | prose }}", encoding="utf-8")
    title = "belts (ISO 5292), ГОСТ 1284.1, in 3 parts"
    page = render_html(Document("title.html.j2", (), {"title": title}), templates, Words("en"))
    assert page == "belts (ISO\u00a05292), ГОСТ\u00a01284.1, in 3 parts"


@pytest.mark.parametrize(
    ("title", "together"),
    [
        ("not less than h_V/3", ["hV/3"]),
        ("else √(σ_b/[σ]_b) & more", ["√(σb/[σ]b)"]),
        ("ratio P/F, or b/d", ["P/\u2060F,", "b/\u2060d"]),
        ("a & b/d", ["b/\u2060d"]),
        ("6·G·e/l² at its end", ["6·G·e/\u2060l²"]),
        ("flow, л/мин; m/s² and kg/m³", ["л/\u2060мин;", "m/\u2060s²", "kg/\u2060m³"]),
        ("formulas (12–14)", ["(12–\u206014)"]),
        ("jaw/drive, and/or, 1999/ISO", []),
    ],
)
def test_no_line_ends_inside_a_short_formula_or_a_range(
    templates: Path, title: str, together: list[str]
) -> None:
    (templates / "title.html.j2").write_text("{{ title | prose }}", encoding="utf-8")
    page = render_html(Document("title.html.j2", (), {"title": title}), templates, Words("en"))
    found = re.findall(r'<span class="unbroken">.*</span>|\S*\u2060\S*', page)
    assert [re.sub(r"<[^>]*>", "", one) for one in found] == together


def test_a_line_is_filled_before_what_must_not_be_broken(templates: Path) -> None:
    title = "height of the beam: by its strength, and not less than 1/50 of its length"
    (templates / "title.html.j2").write_text(
        '<html lang="en"><style>@page { size: {{ wide }}mm 60mm; margin: 0 }'
        'body { margin: 0; font: 9pt "DejaVu Sans" }</style>{{ title | prose }}',
        encoding="utf-8",
    )
    for tenths in range(830, 880, 3):
        values = {"title": title, "wide": tenths / 10}
        printed = render_pdf(Document("title.html.j2", (), values), templates, Words("en"))
        first = PdfReader(io.BytesIO(printed)).pages[0].extract_text().splitlines()[0]
        assert len(first) > len(title) / 2, tenths


def test_no_line_ends_at_a_minus(templates: Path) -> None:
    (templates / "title.html.j2").write_text("{{ title | prose }}", encoding="utf-8")
    title = "near u·(1 − ε) — or not"
    page = render_html(Document("title.html.j2", (), {"title": title}), templates, Words("en"))
    assert page == "near u·(1\u00a0−\u00a0ε) — or not"


def test_no_line_ends_between_a_function_and_what_it_is_of_nor_behind_a_relation(
    templates: Path,
) -> None:
    (templates / "title.html.j2").write_text("{{ title | prose }}", encoding="utf-8")
    title = "grows as cos χ/2, a tan of 3 and tg 20°: L = a + b ≥ 5"
    page = render_html(Document("title.html.j2", (), {"title": title}), templates, Words("en"))
    assert page == "grows as cos~χ/^2, a tan of 3 and tg~20°: L =~a + b ≥~5".translate(
        {ord("~"): "\u00a0", ord("^"): "\u2060"}
    )


def test_the_same_content_gives_the_same_bytes(templates: Path, document: Document) -> None:
    first = render_pdf(document, templates, Words("en"))
    assert first == render_pdf(document, templates, Words("en"))


def test_a_document_has_a_title_a_language_and_tags(templates: Path, document: Document) -> None:
    reader = PdfReader(io.BytesIO(render_pdf(document, templates, Words("ru"))))
    catalogue = reader.trailer["/Root"]
    assert reader.metadata is not None
    assert reader.metadata.title == "Отчёт"
    assert catalogue["/Lang"] == "ru"
    assert catalogue["/MarkInfo"]["/Marked"]
    assert "/StructTreeRoot" in catalogue


def test_headings_of_a_table_say_what_they_head(templates: Path) -> None:
    head = "<thead><tr><th>size</th></tr></thead>"
    table = f"<table>{head}<tbody><tr><th>bore</th><td>50</td></tr></tbody></table>"
    page = f'<html lang="en"><title>Sizes</title><body>{table}'
    reader = PdfReader(io.BytesIO(pdf_from_html(page, (), templates)))
    every = (reader.get_object(number) for number in range(1, int(reader.trailer["/Size"])))
    headings = [one for one in every if isinstance(one, dict) and one.get("/S") == "/TH"]
    assert [one["/A"]["/Scope"] for one in headings] == ["/Column", "/Row"]


def test_a_document_says_nothing_about_the_time(templates: Path, document: Document) -> None:
    reader = PdfReader(io.BytesIO(render_pdf(document, templates, Words("ru"))))
    assert reader.metadata is not None
    assert reader.metadata.creation_date is None
    assert reader.metadata.modification_date is None


def test_fonts_are_in_the_file(
    templates: Path, document: Document, embedded_fonts: Callable[[bytes], dict[str, bool]]
) -> None:
    fonts = embedded_fonts(render_pdf(document, templates, Words("ru")))
    assert fonts
    assert all(fonts.values())
    assert any("PT-Sans" in name for name in fonts)


def test_values_are_escaped_and_formulas_are_not(templates: Path, document: Document) -> None:
    named = Document(document.template, (), {**document.values, "name": "<b>&"})
    html = render_html(named, templates, Words("en"))
    assert "&lt;b&gt;&amp;" in html
    assert '<span class="formula f-slanted">' in html


def test_numbers_are_written_for_the_reader(templates: Path, document: Document) -> None:
    assert "1.5 cells 2.5 12.5%" in render_html(document, templates, Words("en"))
    assert "2,5 12,5\u00a0%" in render_html(document, templates, Words("ru"))


def test_a_missing_value_is_an_error_and_no_empty_place(templates: Path) -> None:
    with pytest.raises(CourseError, match="'name' is undefined"):
        render_pdf(Document("plain.html.j2", (), {}), templates, Words("en"))


@pytest.mark.parametrize(
    ("source", "line", "what"),
    [
        ("<p>\n{{ name }", "line 2", "unexpected '}'"),
        ("<p>\n\n{% for x in name %}", "line 3", "'endfor'"),
        ("{{ name | shout }}", "line 1", "No filter named 'shout'"),
        ("\n{{ name.first.letter }}", "line 2", "has no attribute 'first'"),
        ("\n\n{% include 'gone.html.j2' %}", "line 3", "There is no template gone.html.j2"),
        ("\n{{ name - 1 }}", "line 2", "unsupported operand"),
        ("{% for x in range('9') %}{% endfor %}", "line 1", "cannot be interpreted as an integer"),
        ("{% for a, b in [name] %}{% endfor %}", "line 1", "too many values"),
    ],
)
def test_a_template_that_fails_is_named_with_the_line(
    templates: Path, source: str, line: str, what: str
) -> None:
    (templates / "broken.html.j2").write_text(source, encoding="utf-8")
    with pytest.raises(CourseError) as caught:
        render_html(Document("broken.html.j2", (), {"name": "Иван"}), templates, Words("en"))
    (problem,) = caught.value.problems
    assert problem.file == f"{templates.name}/broken.html.j2"
    assert problem.key == line
    assert what in str(problem.what)
    assert str(problem.remedy)


def test_a_part_that_fails_is_named_and_not_what_includes_it(templates: Path) -> None:
    (templates / "part.html.j2").write_text("\n{{ nobody }}", encoding="utf-8")
    (templates / "whole.html.j2").write_text("{% include 'part.html.j2' %}", encoding="utf-8")
    with pytest.raises(CourseError, match=r"part\.html\.j2: line 2: .*nobody"):
        render_html(Document("whole.html.j2", (), {}), templates, Words("en"))


def test_a_document_without_its_template_is_told(templates: Path) -> None:
    with pytest.raises(CourseError, match=r"There is no template gone\.html\.j2"):
        render_html(Document("gone.html.j2", (), {}), templates, Words("en"))


def test_a_changed_style_sheet_is_read_again(templates: Path, document: Document) -> None:
    before = render_pdf(document, templates, Words("en"))
    sheet = templates / "style" / "plain.css"
    sheet.write_text("p { font: 20pt 'PT Serif' }", encoding="utf-8")
    assert render_pdf(document, templates, Words("en")) != before


def test_nothing_is_fetched_from_outside(
    templates: Path, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(logging.getLogger("weasyprint"), "propagate", True)
    secret = templates / "secret.svg"
    secret.write_text("<svg xmlns='http://www.w3.org/2000/svg'/>", encoding="utf-8")
    html = f'<html lang="en"><title>x</title><img alt="secret" src="{secret.as_uri()}">'
    pdf_from_html(html, (), templates)
    assert "disallowed protocol" in caplog.text


def test_the_garbage_collector_is_left_as_it_was(templates: Path, document: Document) -> None:
    before = gc.get_threshold()
    render_pdf(document, templates, Words("en"))
    assert gc.get_threshold() == before


@pytest.mark.parametrize(
    ("value", "written"), [(0.0, "0"), (100.25, "100,25"), (2 / 3, "0,67"), (99.999, "100")]
)
def test_points_have_at_most_two_decimals(value: float, written: str) -> None:
    assert points_text(value, Words("ru")) == written


def test_a_percentage_is_written_as_the_language_writes_it() -> None:
    assert percent_text(0.785, Words("en")) == "78.5%"
    assert percent_text(0.785, Words("uk")) == "78,5\u00a0%"


def test_a_number_and_its_unit_stay_together() -> None:
    assert amount_text(60.08, "mm", Words("ru")) == "60,08\u00a0мм"
    assert amount_text(36.8699, "deg", Words("ru")) == "36,87°"
    assert amount_text(0.15, "", Words("ru")) == "0,15"


def test_a_day_is_written_with_its_month_in_words_and_never_broken() -> None:
    day = date(2025, 5, 9)
    written = [day_text(day, Words(language)) for language in ("en", "ru", "uk")]
    assert written == ["9\u00a0May\u00a02025", "9\u00a0мая\u00a02025", "9\u00a0травня\u00a02025"]


def test_what_is_drawn_after_an_unseen_sign_is_seen(course: Course) -> None:
    """The radical of a root alone in a denominator follows the stroke, which is text unseen."""
    tree = parse("a / sqrt(b)")
    fraction = html(typeset(tree, {name: symbol_box(name) for name in ("a", "b")}))
    page = f'<html lang="en"><title>x</title><p>{fraction}</p></html>'
    pdf = pdf_from_html(page, ("formula.css",), course.root / "templates")
    drawing = PdfReader(io.BytesIO(pdf)).pages[0].get_contents()
    assert drawing is not None
    opaque, seen = [True], []
    for line in drawing.get_data().decode("latin-1").splitlines():
        if line == "q":
            opaque.append(opaque[-1])
        elif line == "Q":
            opaque.pop()
        elif re.fullmatch(r"/a\S+ gs", line):
            opaque[-1] = float(line[2:-3]) == 1
        elif line.endswith(" Do"):
            seen.append(opaque[-1])
    assert seen == [True]
