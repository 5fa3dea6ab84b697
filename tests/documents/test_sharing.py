"""What documents share changes no byte of any of them, never grows, and leaves WeasyPrint alone."""

import logging
from collections.abc import Callable, Sequence
from contextlib import suppress
from importlib.metadata import version
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from weasyprint.css.properties import INITIAL_VALUES
from weasyprint.formatting_structure.boxes import BlockBox
from weasyprint.layout import inline
from weasyprint.layout.percent import resolve_percentages
from weasyprint.text.fonts import FontConfiguration
from weasyprint.text.line_break import split_first_line, strut

from gripcourse.course.model import Course
from gripcourse.documents.pdf import pdf_from_html, render_html
from gripcourse.documents.sharing import lines, sizes, switch
from gripcourse.documents.sharing.bounded import Bounded
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.samples import printed_samples, samples
from gripcourse.variants.space import load_spaces

REPOSITORY = Path(__file__).parents[2]
PINNED = "weasyprint==" + version("weasyprint")
known = pytest.mark.skipif(
    PINNED not in (REPOSITORY / "constraints.txt").read_text(encoding="utf-8").split(),
    reason="another WeasyPrint shares nothing",
)

STUDENTS = ("student", "student_revealed", "student_refused")
"""A report, all that there can be in it, and one of a work that could not be judged."""

# What no document of ours has, but a course's own template may.
ODD_STYLE = """
@page { size: A6; margin: 2cm; @footnote { border-top: 1px solid } }
:root { --far: 3em; font: 10pt "PT Serif"; hyphens: auto }
h1 { font-size: SIZE; margin-left: var(--far); bookmark-label: content() }
p { text-align: justify; width: calc(100% - 1em); padding-left: 5% }
p::first-line { font-size: 1.3em; color: navy }
p::first-letter { font-size: 2em }
u { text-decoration: underline overline; text-underline-offset: 20% }
.cut { text-align: left; width: 3cm; overflow: hidden }
.cut { text-overflow: ellipsis; white-space: nowrap }
.clamped { text-align: left; max-lines: 2; block-ellipsis: auto; continue: discard }
.note { float: footnote }
.far { letter-spacing: .2em; word-spacing: 1em; white-space: pre-wrap; tab-size: 3 }
.grid { display: grid; grid-template-columns: 1fr 2fr }
.flex { display: flex }
.small { font-size: .7em }
.narrow { width: 1cm; overflow-wrap: anywhere }
.half { width: 50%; padding: 3% 0 }
a::after { content: " (" target-counter(attr(href), page) ")" }
b::before { content: "*"; -weasy-anchor: "star" }
table { border-collapse: collapse; padding: 3px } td { border: 1px solid; border-left-width: 3px }
ul { list-style: square outside } svg { width: 5cm }
"""
ODD_BODY = """<h1 id="top">Fifty per cent</h1>
<p>Handing unbelievably complicated characteristics over<span class="note">As
a <i>note</i></span> to somebody, <u>underlined</u>,
shy\N{SOFT HYPHEN}ness and AV\N{SUPERSCRIPT TWO}.</p>
<p dir="rtl">\N{HEBREW LETTER ALEF}\N{HEBREW LETTER BET} abc \N{HEBREW LETTER GIMEL}</p>
<p class="cut">A line that is cut off where it ends</p>
<p class="clamped">One two three four five six
seven eight nine ten eleven twelve thirteen fourteen fifteen</p><pre class="far">a\tb  c
d</pre><div class="grid"><span>AV</span><span>AV <b class="small">AV</b></span></div>
<div class="half">In a line of its own
<div class="half">In a line of its own</div></div>
<div class="flex"><span>x</span><p>y</p></div><p class="narrow">unbreakable</p>
<p>\N{TAGBANWA LETTER A} \N{LINEAR B SYLLABLE B008 A} \N{ZERO WIDTH JOINER}</p>
<ul style="color: red"><li>one<li style="width: 20%">two</ul><a href="#top">top</a>
<table><tr><td>1<td rowspan=2 style="border: 2px dashed">2<tr><td>3</table>
<svg viewBox="0 0 100 20"><text x="5 9" y="9" font-size="9">AV</text></svg>"""
ODD = f'<html lang="en"><title>Odd</title><body>{ODD_BODY}{ODD_BODY.replace("top", "next")}'


@pytest.fixture
def alone(monkeypatch: pytest.MonkeyPatch) -> Callable[..., bytes]:
    """Lay out a document as WeasyPrint does it by itself."""

    def laid_out(*asked: Any) -> bytes:  # noqa: ANN401 (as the function)
        with monkeypatch.context() as changed:
            changed.setattr(switch, "is_known", lambda: False)
            return pdf_from_html(*asked)

    return laid_out


@known
@pytest.mark.parametrize(
    ("language", "schemes", "kinds"),
    [("ru", 1, None), ("en", 2, STUDENTS), ("uk", 2, STUDENTS)],
)
def test_every_document_is_the_same_bytes(
    course: Course,
    policy: Policy,
    alone: Callable[..., bytes],
    language: str,
    schemes: int,
    kinds: Sequence[str] | None,
) -> None:
    words, templates = Words(language), course.root / "templates"
    tried = list(samples(course, policy, load_spaces(course), words))[-schemes:]
    for sample in tried:
        for kind, make in printed_samples(sample).items():
            if kinds is None or kind in kinds:
                document = make()
                asked = (render_html(document, templates, words), document.styles, templates)
                assert pdf_from_html(*asked) == alone(*asked), (sample.plan.scheme.id, kind)


@known
@pytest.mark.parametrize("size", ["2em", "6vw"])
def test_what_is_odd_is_the_same_bytes(
    tmp_path: Path, alone: Callable[..., bytes], caplog: pytest.LogCaptureFixture, size: str
) -> None:
    (tmp_path / "style").mkdir()
    (tmp_path / "style" / "odd.css").write_text(ODD_STYLE.replace("SIZE", size), encoding="utf-8")
    caplog.set_level(logging.CRITICAL)
    asked = (ODD, ("odd.css",), tmp_path)
    expected = alone(*asked)
    assert [pdf_from_html(*asked) == expected for _ in range(2)] == [True, True]


@known
def test_the_pinned_weasyprint_is_known() -> None:
    assert switch.is_known()


@known
def test_weasyprint_has_its_own_functions_but_for_our_documents() -> None:
    own = inline.split_first_line
    with suppress(ZeroDivisionError), switch.shared_between_documents(object()):
        inside = inline.split_first_line
        raise ZeroDivisionError
    assert inside is not own
    assert inline.split_first_line is own


def test_another_weasyprint_shares_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(switch, "is_known", lambda: False)
    own = inline.split_first_line
    with switch.shared_between_documents(object()):
        assert inline.split_first_line is own


def test_a_weasyprint_without_what_was_read_is_not_known(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(switch, "_SOURCES", ("no_such_file.py",))
    assert not switch.digest_of_sources()


class _Noted(dict[str, Any]):
    """A style that notes what is read of it."""

    def __init__(self, values: dict[str, Any], fonts: object) -> None:
        super().__init__(values)
        self.font_config = fonts
        self.cache: dict[str, Any] = {}
        self.read: set[str] = set()

    def __getitem__(self, key: str) -> Any:  # noqa: ANN401 (as WeasyPrint's)
        self.read.add(key)
        return super().__getitem__(key)


@pytest.fixture
def style() -> _Noted:
    named = {"lang": "en", "hyphens": "auto", "font_family": ("PT Serif",), "font_size": 16.0}
    return _Noted(INITIAL_VALUES | named, FontConfiguration())


@known
@pytest.mark.parametrize(
    "text", ["a", "tab\tand unbelievably long words", "shy\N{SOFT HYPHEN}ness\nx"]
)
def test_all_that_breaks_a_line_tells_one_style_from_another(style: _Noted, text: str) -> None:

    context = SimpleNamespace(dictionaries={})
    for wrap in ("normal", "anywhere"):
        style["overflow_wrap"] = wrap
        for width in (None, 0.0, 30.0, 1e4):
            layout, *_ = split_first_line(text, style, context, width, 0)
            layout.reactivate(style)
    assert {"white_space", "hyphens", "lang"} < style.read <= set(lines.READ)
    strut(style)
    style.read.clear()
    strut(style)  # remembered by WeasyPrint itself
    assert style.read == set(sizes.STRUT_READ)


@known
def test_all_that_a_size_depends_on_tells_one_box_from_another(style: _Noted) -> None:

    box = BlockBox("p", style, None, [])
    before = set(vars(box))
    resolve_percentages(box, (100.0, "auto"))
    assert style.read <= set(sizes.READ)
    assert set(vars(box)) - before == set(sizes.SET)


def test_a_memory_keeps_what_is_asked_for_and_never_grows() -> None:
    memory = Bounded[int, str](10)
    memory.put(-1, "asked for")
    for number in range(100):
        memory.put(number, "never asked for")
        assert memory.get(-1) == "asked for"
        assert len(memory) <= 10
    assert memory.get(0) is None
