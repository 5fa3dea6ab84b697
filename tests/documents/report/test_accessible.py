"""Every kind of PDF document can be read aloud, searched and printed, as another reader sees it.

The rules are those of PDF/UA-1 (ISO 14289-1): clauses 5 and 7.
"""

import io
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

import pytest
from pypdf import PdfReader
from pypdf.generic import ContentStream, DictionaryObject

from gripcourse.course.model import Course
from gripcourse.documents.kind import SampleDocument
from gripcourse.documents.pdf import render_pdf
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.samples import printed_samples, samples
from gripcourse.variants.space import load_spaces
from support.printed import pages_of

REPOSITORY = Path(__file__).parents[3]
KINDS = (
    *("assignment", "student", "student_revealed", "student_refused", "cohort", "solution"),
    *("certificate", "atlas_lever_arms", "handout"),
)
LANGUAGE = "uk"
SCHEME = "rack_parallelogram"
A4 = (595, 842)
SHOWING = {b"Tj", b"TJ", b"'", b'"', b"f", b"F", b"f*", b"B", b"B*", b"b", b"b*", b"S", b"s", b"Do"}
EMBEDDED = ("/FontFile", "/FontFile2", "/FontFile3")
# Pictures, by what they must tell: plots stand in for tables, diagrams have their own sentence.
PICTURES = {"assignment": 2, "cohort": 2, "solution": 2, "certificate": 1, "atlas_lever_arms": 1}


@dataclass(frozen=True, slots=True)
class Element:
    """An element of the structure tree with those inside it."""

    kind: str
    made: DictionaryObject
    inside: tuple["Element", ...]

    def all(self) -> Iterator["Element"]:
        yield self
        for one in self.inside:
            yield from one.all()


@pytest.fixture(scope="module")
def sample(course: Course, policy: Policy) -> SampleDocument:
    spaces = load_spaces(course)
    first = dict(sorted(course.schemes.items(), key=lambda one: one[0] != SCHEME))
    found = samples(
        replace(course, schemes=first), policy, spaces, Words(LANGUAGE), name="Оксана Їжакевич"
    )
    return replace(next(found), course=course)


@pytest.fixture(scope="module", params=KINDS)
def kind(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(scope="module")
def made(kind: str, sample: SampleDocument) -> bytes:
    document = printed_samples(sample)[kind]()
    return render_pdf(document, REPOSITORY / "templates", sample.words)


@pytest.fixture(scope="module")
def reader(made: bytes) -> PdfReader:
    return PdfReader(io.BytesIO(made))


def tree(reader: PdfReader) -> Element:
    return _element(reader.trailer["/Root"]["/StructTreeRoot"].get_object())


def _element(made: DictionaryObject) -> Element:
    inside = made.get("/K", [])
    kids = [one.get_object() for one in (inside if isinstance(inside, list) else [inside])]
    elements = tuple(_element(one) for one in kids if isinstance(one, dict))
    return Element(str(made.get("/S", "")), made, elements)


def marks_and_shown(reader: PdfReader) -> Iterator[tuple[int, str | int | None]]:
    """Yield for everything that is painted the page and its mark: a number, a name, or None."""
    for number, page in enumerate(reader.pages):
        open_marks: list[str | int] = []
        for operands, operator in ContentStream(page.get_contents(), reader).operations:
            if operator == b"BMC":
                open_marks.append(str(operands[0]))
            elif operator == b"BDC":
                open_marks.append(int(operands[1].get("/MCID", -1)))
            elif operator == b"EMC":
                open_marks.pop()
            elif operator in SHOWING:
                yield number, open_marks[-1] if open_marks else None


def test_every_kind_that_is_printed_is_tried(sample: SampleDocument) -> None:
    assert set(printed_samples(sample)) == set(KINDS)


def test_a_document_says_what_it_is(reader: PdfReader) -> None:
    root = reader.trailer["/Root"]
    metadata = root["/Metadata"].get_data().decode()
    assert 'pdfuaid:part="1"' in metadata
    assert root["/MarkInfo"]["/Marked"]
    assert root["/Lang"] == LANGUAGE
    assert root["/ViewerPreferences"]["/DisplayDocTitle"]
    assert reader.metadata is not None
    assert reader.metadata.title
    assert reader.metadata.title in metadata


def test_everything_that_is_painted_is_in_the_tree_or_an_artefact(reader: PdfReader) -> None:
    numbers = reader.trailer["/Root"]["/StructTreeRoot"]["/ParentTree"]["/Nums"]
    batched = zip(numbers[::2], numbers[1::2], strict=True)
    owners = {int(page): list(kids.get_object()) for page, kids in batched}
    painted = list(marks_and_shown(reader))
    assert painted
    for page, mark in painted:
        if mark == "/Artifact":
            continue
        assert isinstance(mark, int), f"page {page + 1} paints something without a mark"
        owner = owners[int(reader.pages[page]["/StructParents"])][mark].get_object()
        assert owner["/Type"] == "/StructElem"


def test_headings_follow_each_other_without_a_gap(reader: PdfReader) -> None:
    levels = [
        int(one.kind[2])
        for one in tree(reader).all()
        if one.kind[:2] == "/H" and one.kind[2:].isdigit()
    ]
    assert levels.count(1) == 1
    assert levels[0] == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))


def test_every_cell_of_a_table_names_its_headers(reader: PdfReader) -> None:
    """Headers and IDs, which PDF/UA-1 7.5 takes instead of a scope."""
    for table in (one for one in tree(reader).all() if one.kind == "/Table"):
        ids = {str(one.made["/ID"]) for one in table.all() if one.kind == "/TH"}
        cells = [one.made["/A"].get("/Headers", ()) for one in table.all() if one.kind == "/TD"]
        assert ids
        assert all(cells)
        assert {str(name) for headers in cells for name in headers} <= ids


def test_every_picture_has_a_text_of_its_own(kind: str, reader: PdfReader) -> None:
    texts = [str(one.made.get("/Alt", "")) for one in tree(reader).all() if one.kind == "/Figure"]
    assert len(texts) >= PICTURES.get(kind, 0)
    assert all(len(text) > 10 for text in texts)


def test_fonts_are_in_the_file_and_only_the_letters_that_are_used(reader: PdfReader) -> None:
    found: dict[str, Mapping[str, object]] = {}
    for page in reader.pages:
        for font in page["/Resources"]["/Font"].values():
            one = font.get_object()["/DescendantFonts"][0].get_object()
            found[str(one["/BaseFont"])] = one["/FontDescriptor"]
            assert "/ToUnicode" in font.get_object()
    assert found
    for name, descriptor in found.items():
        assert any(key in descriptor for key in EMBEDDED), name
        assert name[7] == "+", f"{name} is whole"


def test_pages_are_a4_and_only_a_drawing_lies_on_its_side(kind: str, reader: PdfReader) -> None:
    sizes = [tuple(round(float(side)) for side in page.mediabox[2:]) for page in reader.pages]
    lying = [number for number, size in enumerate(sizes) if size != A4]
    assert all(sizes[number] == A4[::-1] for number in lying)
    # The general view, which comes last, lies where its views are wider than high.
    assert set(lying) <= ({len(sizes) - 1} if kind == "solution" else set())


def test_numbers_and_formulas_can_be_searched_as_the_language_writes_them(
    kind: str, made: bytes, reader: PdfReader
) -> None:
    """Decimal commas, groups of three, a true minus: as text, in formulas too.

    The constraints of a space, such as `max(2.2*pin_diameter, ...)`, are quoted as declared.
    """
    text = "\n".join(pages_of(made))
    assert not re.search(r"\d\.\d+(?![\d*])", text)
    assert not re.search(r"[=(·] ?-\d", text)
    if kind == "solution":
        text = "\n".join(page.extract_text() for page in reader.pages)
        assert re.search(r"200\s000", text)  # readers differ in what they make of a thin space
        assert "−" in text
        assert "√" in text
        assert re.search(r"arcsin", text)
        assert re.search(r"90\smм|90\sмм", text)
