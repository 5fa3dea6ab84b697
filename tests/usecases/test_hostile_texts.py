"""What a student writes is shown and never obeyed, wherever it goes."""

import csv
import io
import json
import re
import zipfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from jinja2 import Environment
from openpyxl import load_workbook

from gripcourse.cli.grading_text import grading_text
from gripcourse.cli.issuing_text import issuing_text, unissued_text
from gripcourse.course.load import load_course
from gripcourse.documents.handout_list import handout_document
from gripcourse.documents.kind import SampleDocument
from gripcourse.documents.kinds import assignment, cohort, student
from gripcourse.documents.pdf import Document, pdf_from_html, render_html, template_environment
from gripcourse.drawing.paper.document import dxf_bytes
from gripcourse.drawing.paper.svg import svg_text
from gripcourse.drawing.paper.title_block import TitleBlock
from gripcourse.drawing.view.general_view import general_view
from gripcourse.errors import Problem
from gripcourse.exports.grades import grades_text
from gripcourse.grading.model import Flag, FlagCode, Report
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Reveal
from gripcourse.solver.solve import solve_variant
from gripcourse.text.shown import one_line, shown
from gripcourse.text.words import Words, message
from gripcourse.usecases.authoring.samples import judged_sample, refused_sample, samples
from gripcourse.usecases.grading.batch_tables import json_text
from gripcourse.usecases.grading.grade import GradingOutcome
from gripcourse.usecases.issuing.handout import Handout
from gripcourse.usecases.issuing.issue import Issuing
from gripcourse.variants.model import Student
from gripcourse.workbook.write import answer_workbook
from support.tables import formulas_in

REPOSITORY = Path(__file__).parents[2]
TEMPLATES = REPOSITORY / "templates"
TEXTS = {
    "markup": "<script>alert(1)</script><img src=x onerror=y>",
    "quotes": '"\' onload="z" x=\'&amp;&#0;&#x1b;',
    "formula": "=cmd|'/C calc'!A0",
    "sum": "@SUM(1+1)*cmd",
    "minus": "-2+3+cmd|' /C calc'!A0",
    "hidden_formula": "\x00=1+1",
    "terminal": "\x1b[2J\x1b]0;owned\x07\x9b31m",
    "direction": "cod\u202exslx.exe\u2066",
    "entity": "]]>&x;<!ENTITY x SYSTEM 'file:///etc/passwd'>",
    "cad": "\\P%%d{\\H5;big}^J",
    "template": "{student}{{ 7 * 7 }}{% raw %}{0.__class__}",
    "half": "name\udcff\ufffe",
    "markdown": "[bold red]x[/bold red] :smile:",
    "attribute": '"><img src=x onerror=alert(1)>',
    "plus": "+1",
    "second_cell": "a;=cmd|'/C calc'!A0\tb\t@SUM(1)",
    "second_line": "Anna\n=1+1\r\nAll files were graded.\u2028Bcc: x@y.z",
    "wide_sign": "\uff1d1+1",
    "long": "\u0416" * 10_000,
}
OURS = "All files were graded."
UNSEEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
# What only a table or a terminal would obey needs no page of its own.
ON_PAGES = tuple(
    TEXTS[one]
    for one in (
        *("markup", "attribute", "quotes", "terminal", "direction", "entity", "cad", "template"),
        "half",
    )
)
ALL_ON_PAGES = " . ".join(ON_PAGES)
LAID_OUT = tuple(TEXTS[one] for one in ("terminal", "direction", "half"))


class Page(HTMLParser):
    """The words of a page, and the names of its elements and attributes."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.words: list[str] = []
        self.names: set[str] = set()
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.names |= {tag, *(name for name, _ in attrs)}

    def handle_data(self, data: str) -> None:
        self.words.append(data)


@pytest.fixture(scope="module")
def plain() -> SampleDocument:
    """Of the second course, whose pages are filled and works judged in less time."""
    course = load_course(REPOSITORY / "examples" / "belt_drive")
    return next(samples(course, load_policy(course), (), Words("en")))


@pytest.fixture(scope="module", params=TEXTS.values(), ids=TEXTS)
def text(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(scope="module")
def sample(plain: SampleDocument, text: str) -> SampleDocument:
    """A student of that name."""
    named = replace(plain.issued.student, name=text, group=text)
    issued = replace(plain.issued, student=named)
    judged = judged_sample(issued, plain.plan, plain.policy)
    return replace(plain, issued=issued, judged=judged, refused=refused_sample(issued))


@pytest.fixture(scope="module")
def report(sample: SampleDocument, text: str) -> Report:
    """A judged workbook with that text wherever a student can put one."""
    judged = sample.judged
    said = message("The student handed in more files: {files}.", files=text)
    findings = [replace(one, typed=text, remarks=(said,)) for one in judged.findings]
    return replace(
        judged,
        file=text,
        findings=tuple(findings),
        remarks=(said,),
        flags=(Flag(FlagCode.SEVERAL_FILES, said),),
    )


DOCUMENTS: Mapping[str, Callable[[SampleDocument, Report], Document]] = {
    "assignment": lambda sample, _: assignment.sheet(sample),
    "student": lambda sample, report: student.report_page(sample, report, Reveal.NOTHING),
    "student_revealed": lambda sample, report: student.report_page(
        sample, report, Reveal.REFERENCE
    ),
    "student_refused": lambda sample, _: student.report_page(
        sample, sample.refused, Reveal.NOTHING
    ),
    "cohort": lambda sample, report: cohort.summary(sample, [report, report]),
    "handout": lambda sample, _: handout_document(
        (sample.issued,), sample.course, sample.words, sample.day
    ),
}


@pytest.fixture(scope="module")
def usual(plain: SampleDocument) -> Callable[[str], set[str]]:
    """Name the elements and attributes of a page about somebody with a usual name."""

    @cache
    def names(kind: str) -> set[str]:
        return Page(render_html(DOCUMENTS[kind](plain, plain.judged), TEMPLATES, plain.words)).names

    return names


@pytest.mark.parametrize("text", [ALL_ON_PAGES], indirect=True, ids=["all"])
@pytest.mark.parametrize("kind", DOCUMENTS)
def test_a_page_shows_it_and_has_no_element_of_it(
    usual: Callable[[str], set[str]], sample: SampleDocument, report: Report, kind: str
) -> None:
    """One after the other in one text: a page takes a second to fill, and shows each as it is."""
    page = render_html(DOCUMENTS[kind](sample, report), TEMPLATES, sample.words)
    read = Page(page)
    assert read.names <= usual(kind) | {"q", "br"}
    words = "".join(read.words)
    assert [text for text in ON_PAGES if shown(text) not in words] == []
    assert not UNSEEN.search(page)


@pytest.mark.parametrize("kind", DOCUMENTS)
@pytest.mark.parametrize("text", [TEXTS["markup"]], indirect=True)
def test_a_page_that_escapes_nothing_is_noticed(
    sample: SampleDocument, report: Report, kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def unescaped(folder: Path, language: str, *, with_charts: bool) -> Environment:
        made = template_environment(folder, language, with_charts=with_charts)
        return made.overlay(autoescape=False, bytecode_cache=None)

    monkeypatch.setattr("gripcourse.documents.pdf.template_environment", unescaped)
    page = render_html(DOCUMENTS[kind](sample, report), TEMPLATES, sample.words, with_charts=False)
    assert "script" in Page(page).names


def test_no_template_turns_escaping_off() -> None:
    """What is marked as safe is markup of our own: a line break, a picture, a style sheet."""
    safe = {
        (path.name, found)
        for path in sorted(TEMPLATES.rglob("*.j2"))
        for found in re.findall(r"(\S+)\s*\|\s*safe|autoescape", path.read_text(encoding="utf-8"))
    }
    assert safe == {
        ("atlas.html.j2", '"<br>"'),
        ("reference_scheme.html.j2", "diagram"),
        ("reference_page.html.j2", "style"),
    }


@pytest.mark.parametrize("text", LAID_OUT, indirect=True)
def test_it_can_be_laid_out(sample: SampleDocument) -> None:
    document = student.report_page(sample, sample.refused, Reveal.NOTHING)
    pdf = pdf_from_html(render_html(document, TEMPLATES, sample.words), document.styles, TEMPLATES)
    assert pdf.startswith(b"%PDF")


ON_DRAWINGS = (*ON_PAGES, TEXTS["second_line"])


@pytest.mark.parametrize("texts", [ON_DRAWINGS[::2], ON_DRAWINGS[1::2]], ids=["some", "others"])
def test_a_drawing_stays_a_picture_that_xml_can_hold(
    plain: SampleDocument, texts: Sequence[str]
) -> None:
    """One in each cell of the title block; each is the title of the picture once."""
    view = plain.plan.scheme.view
    assert view is not None
    values = solve_variant(plain.plan, plain.issued.variant.given)
    drawn = general_view(plain.plan, view, values, TitleBlock(*texts), plain.words)
    sheet = drawn.arranged.sheet
    for text in texts:
        tree = ET.fromstring(svg_text(drawn.document, sheet.width, sheet.height, text))  # noqa: S314 (ours)
        kinds = {str(element.tag).rpartition("}")[2] for element in tree.iter()}
        assert kinds <= {"svg", "title", "rect", "g", "path", "text"}
        assert tree[0].text == shown(text)
    lines = dxf_bytes(drawn.document).decode().splitlines()
    assert all(code.strip().lstrip("-").isdecimal() for code in lines[::2])
    assert not any(UNSEEN.search(line) or line.startswith(OURS) for line in lines)


def test_a_table_for_a_spreadsheet_runs_nothing(report: Report, text: str) -> None:
    student = Student(report.student, report.name, group=text, email=text, language="", variant="")
    written = grades_text([replace(report, name=text)], {report.student: student})
    (row,) = csv.DictReader(io.StringIO(written, newline=""))
    assert not UNSEEN.search(written.replace("\r\n", "\n"))
    written.encode()
    for column in ("name", "group", "email", "file"):
        assert row[column].replace("'", "") == shown(text).replace("'", "")
    assert formulas_in(written) == []


@pytest.mark.parametrize("text", [*ON_PAGES, TEXTS["formula"], TEXTS["long"]], indirect=True)
def test_a_workbook_holds_it_as_text(sample: SampleDocument, text: str) -> None:
    made = answer_workbook(sample.plan, sample.issued, sample.course, sample.words)
    book = load_workbook(io.BytesIO(made))
    cells = [cell for sheet in book for row in sheet.iter_rows() for cell in row]
    mine = [cell for cell in cells if shown(text) in str(cell.value)]
    assert mine
    assert {cell.data_type for cell in mine} == {"s"}
    with zipfile.ZipFile(io.BytesIO(made)) as parts:
        for name in parts.namelist():
            if name.endswith((".xml", ".rels")):
                ET.fromstring(parts.read(name))  # noqa: S314 (ours)


def test_a_terminal_shows_it_and_obeys_nothing(report: Report, text: str, tmp_path: Path) -> None:
    outcome = GradingOutcome((replace(report, name=text, file=text),), {}, None, needs_person=True)
    lost = message(
        "The documents of {student} could not be made: {reason}", student="s", reason=text
    )
    problem = Problem(text, text, message("'{text}' is not a number.", text=text), lost, text[:5])
    issuing = Issuing((Handout(text, (), (lost,)),), (lost,))
    for said in (
        grading_text(outcome, tmp_path, Words("en")),
        issuing_text(issuing, tmp_path, Words("en")),
        unissued_text(issuing, Words("en")),
        problem.say(Words("en")),
    ):
        assert not UNSEEN.search(said)
        assert one_line(text)[:8] in said
        assert not any(line.startswith((OURS, "Bcc")) for line in said.splitlines())


def test_json_gives_it_back_as_it_was(report: Report, text: str) -> None:
    (read,) = json.loads(json_text([report], Words("en")))["reports"]
    assert read["file"] == text
    assert {finding["typed"] for finding in read["findings"]} == {text}
