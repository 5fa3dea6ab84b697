"""Templates of a course made into PDF files, the same bytes for the same content.

The look belongs to a designer: this module only knows the folder with the templates and the style
sheets. It offers to every template

    _("English sentence")    a sentence of the template in the reader's language
    say(message)             a message that was made in Python
    language                 the reader's language
    value | points           points with at most two decimals
    value | up_to            points as a limit: up to 25 points
    value | out_of           points that could be had: of 25 points
    value | percent          a share of one as a percentage
    value | day              a date written out
    text | symbol            a declared symbol as a formula writes it
    text | prose             a title or a sentence; symbols and powers in it look as in a formula
    text | below             the same for a browser, in the letters round it: `d_1` with a low 1
    text | lowered           likewise of a plain formula, with no sign in it that is not typed
    box | formula            a formula
    box | mathml             a formula for a browser; mathml(large=True) on a line of its own
    box | plain              a formula as one line of text
    box | aside              the same, empty where its MathML can be read without being drawn

in a sandbox, because a course may be a stranger's, and renders with what is expensive kept for the
whole process: compiled templates, fonts, and parsed style sheets. A value that a template does not
get is an error, never an empty place.
"""

from base64 import b64encode
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gripcourse.documents.prose import below, lowered, prose, seen
from gripcourse.documents.sharing.switch import shared_between_documents
from gripcourse.documents.template_faults import is_of_a_template, template_problem
from gripcourse.documents.two_columns import groups, two_columns
from gripcourse.errors import CourseError, NextStep, Problem, UsageError
from gripcourse.formula.boxes import Box
from gripcourse.formula.markup import html, text
from gripcourse.formula.mathml import mathml, reads_aloud
from gripcourse.formula.typeset import declared_symbol
from gripcourse.machine.fonts import FONT_PACKAGES, fonts_used
from gripcourse.machine.process_wide import (
    few_collections,
    libraries_by_full_name,
    without_strange_date,
)
from gripcourse.machine.resources import template_file, template_folders
from gripcourse.text.amounts import (
    day_text,
    percent_text,
    points_out_of,
    points_text,
    points_up_to,
)
from gripcourse.text.words import LANGUAGES, Words, message

# Jinja2, Babel and WeasyPrint cost 40, 60 and 450 ms to import: only who makes a document pays.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup


_VARIANT = "pdf/ua-1"


@dataclass(frozen=True, slots=True)
class Document:
    """One document to render.

    Attributes:
        template: name of the template in the folder, for example `student.html.j2`.
        styles: names of style sheets in its `style` folder, in order of precedence.
        values: what the template gets, by name.
    """

    template: str
    styles: tuple[str, ...]
    values: Mapping[str, object]


def render_pdf(document: Document, templates: Path, words: Words) -> bytes:
    """Render a document; tagged, with title and language, without any date of its own.

    Args:
        document: what to render.
        templates: the folder of the course with the templates and their `style` folder.
        words: the reader's language.

    Returns:
        The bytes of the PDF file; equal for equal content.

    Raises:
        CourseError: a template is missing, does not parse, or asks for a value it does not get.
        UsageError: this machine has no fonts.
        OSError: a style sheet cannot be read.
    """
    return pdf_from_html(render_html(document, templates, words), document.styles, templates)


def render_html(
    document: Document, templates: Path, words: Words, *, with_charts: bool = True
) -> str:
    """Fill the template of a document; see `render_pdf` for the arguments and the errors.

    Without charts their places stay empty.
    """
    from jinja2 import TemplateError

    try:
        environment = template_environment(templates, words.language, with_charts=with_charts)
        template = environment.get_template(document.template)
        return template.render(document.values)
    except (TemplateError, ArithmeticError) as error:
        raise CourseError([template_problem(error, document.template, templates)]) from error
    except (TypeError, ValueError, LookupError, AttributeError) as error:
        if not is_of_a_template(error, templates):
            raise
        raise CourseError([template_problem(error, document.template, templates)]) from error


def pdf_from_html(html: str, styles: tuple[str, ...], templates: Path) -> bytes:
    """Lay out HTML with the named style sheets; nothing is ever fetched from outside of it."""
    fonts = _fonts()
    with few_collections(), shared_between_documents(fonts):
        document = _laid_out(html, styles, templates)
        with without_strange_date():  # which is asked for where fonts are cut down
            return bytes(document.write_pdf(pdf_variant=_VARIANT, finisher=_scoped))


def _scoped(_document: object, pdf: Any) -> None:  # noqa: ANN401 - pydyf ships no types
    """Say of every heading of a table what it heads, a column or a row; WeasyPrint does not."""
    tagged: list[Any] = [one for one in pdf.objects if isinstance(one, dict) and "P" in one]
    elements: dict[bytes, Any] = {one.reference: one for one in tagged}
    for one in elements.values():
        if one.get("S") == "/TH":
            above: Any = one
            while above is not None and above["S"] not in {"/THead", "/TBody", "/Table"}:
                above = elements.get(above["P"])
            in_head = above is not None and above["S"] == "/THead"
            one["A"]["Scope"] = "/Column" if in_head else "/Row"


def _laid_out(html: str, styles: tuple[str, ...], templates: Path) -> Any:  # noqa: ANN401 - WeasyPrint ships no types
    with libraries_by_full_name():
        from weasyprint import HTML, URLFetcher

    sheets = [_style_sheet(path, path.stat().st_mtime_ns) for path in _paths(templates, styles)]
    source = HTML(string=html, url_fetcher=URLFetcher(allowed_protocols=("data",)))
    return source.render(stylesheets=sheets, font_config=_fonts(), pdf_variant=_VARIANT)


@dataclass(frozen=True, slots=True)
class Chart:
    """A chart that is drawn, as an SVG text, when a page shows it; who tries one need not."""

    draw: Callable[[], str]

    def __str__(self) -> str:
        """Return the address with which a page shows it."""
        return picture(self.draw())


def picture(svg: str) -> str:
    """Return an SVG text as an address that a page can show without fetching anything."""
    return f"data:image/svg+xml;base64,{b64encode(svg.encode()).decode()}"


def _paths(templates: Path, styles: tuple[str, ...]) -> tuple[Path, ...]:
    return tuple(template_file(templates, f"style/{name}") for name in styles)


def _markup(box: Box) -> "Markup":
    """Return the HTML of a formula; its text was escaped when it was made."""
    from markupsafe import Markup

    return Markup(html(box))  # noqa: S704 - see above


def _mathml(box: Box, *, large: bool = False) -> "Markup":
    """Return the MathML of a formula; its text was escaped when it was made."""
    from markupsafe import Markup

    return Markup(mathml(box, large=large))  # noqa: S704 - see above


def _without_charts(value: object) -> object:
    return "" if isinstance(value, Chart) else seen(value)


# One environment for each folder and language of a run.
@lru_cache(maxsize=4 * len(LANGUAGES))
def template_environment(
    templates: Path, language: str, *, with_charts: bool = True
) -> "Environment":
    """Return what every template of a folder gets whatever the document: see the list above."""
    from jinja2 import FileSystemLoader, StrictUndefined

    from gripcourse.documents.compiled import CompiledBefore
    from gripcourse.documents.sandbox import WIDENING_FILTERS, TemplateSandbox

    words = Words(language)
    environment = TemplateSandbox(
        loader=FileSystemLoader(template_folders(templates)),
        autoescape=True,
        undefined=StrictUndefined,
        finalize=seen if with_charts else _without_charts,
        trim_blocks=True,
        lstrip_blocks=True,
        bytecode_cache=CompiledBefore(),
    )
    for name in WIDENING_FILTERS:
        del environment.filters[name]
    del environment.globals["lipsum"]  # a hundred thousand paragraphs of nothing
    environment.globals.update({"_": words.translate, "say": words.say, "language": language})
    filters: Mapping[str, Callable[..., str]] = {
        "points": lambda value: points_text(value, words),
        "up_to": lambda value: points_up_to(value, words),
        "out_of": lambda value: points_out_of(value, words),
        "percent": lambda share: percent_text(share, words),
        "day": lambda day: day_text(day, words),
        "prose": prose,
        "below": below,
        "lowered": lowered,
        "symbol": lambda symbol: _markup(declared_symbol(symbol)) if symbol else "",
        "formula": _markup,
        "mathml": _mathml,
        "plain": text,
        "aside": lambda box: "" if reads_aloud(box) else text(box),
    }
    environment.filters.update(filters)
    environment.filters["two_columns"] = two_columns
    environment.filters["groups"] = groups
    return environment


@lru_cache(maxsize=1)
def _fonts() -> Any:  # noqa: ANN401 - WeasyPrint ships no types
    with libraries_by_full_name():
        from weasyprint.text.fonts import FontConfiguration

    # Without any font Pango does not say so: it takes the whole process down.
    if not any(fonts_used(FONT_PACKAGES).values()):
        what = message("This machine has no font, so that no page can be laid out.")
        remedy = message("Install one; a check of the machine names what is missing and how.")
        raise UsageError([Problem("", "", what, remedy, step=NextStep.CHECK_MACHINE)])
    return FontConfiguration()


@lru_cache(maxsize=32)
def _style_sheet(path: Path, _changed: int) -> Any:  # noqa: ANN401 - WeasyPrint ships no types
    """Parse a style sheet once for each time that the file was changed."""
    from weasyprint import CSS, URLFetcher

    return CSS(
        string=path.read_text(encoding="utf-8"),
        font_config=_fonts(),
        url_fetcher=URLFetcher(allowed_protocols=("data",)),
    )
