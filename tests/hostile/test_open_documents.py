"""An OpenDocument spreadsheet is looked through before LibreOffice opens it."""

import io
import zipfile
from collections.abc import Mapping

import pytest
from openpyxl import Workbook

from gripcourse.machine.content import NamedBytes
from gripcourse.machine.spreadsheet.preflight import refusal
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.submission.model import Rejected
from gripcourse.submission.second import read_again

SPACES = " ".join(
    f'xmlns:{one}="urn:oasis:names:tc:opendocument:xmlns:{one}:1.0"'
    for one in ("office", "table", "text")
)
KIND = b"application/vnd.oasis.opendocument.spreadsheet"
NUMBER = (
    '<table:table-cell office:value-type="{kind}" {value}><text:p>5</text:p></table:table-cell>'
)
GOOD = NUMBER.format(kind="float", value='office:value="5.5"')


def document(rows: str, before: str = "", others: Mapping[str, bytes] | None = None) -> bytes:
    content = (
        f"{before}<office:document-content {SPACES}><office:body><office:spreadsheet>"
        f'<table:table table:name="S">{rows}</table:table>'
        "</office:spreadsheet></office:body></office:document-content>"
    )
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in {
            "mimetype": KIND,
            "content.xml": content.encode(),
            **(others or {}),
        }.items():
            archive.writestr(name, data)
    return stream.getvalue()


def row(cells: str, times: str = "1") -> str:
    return f'<table:table-row table:number-rows-repeated="{times}">{cells}</table:table-row>'


def repeated(cell: str, times: str) -> str:
    return cell.replace(" ", f' table:number-columns-repeated="{times}" ', 1)


@pytest.mark.parametrize(
    "rows",
    [
        row(GOOD) + row('<table:table-cell table:number-columns-repeated="16384"/>', "1048575"),
        row(repeated(GOOD, "16384")),
        row(GOOD, "200000"),
        row(NUMBER.format(kind="percentage", value='office:value="-1.5E-3"')),
        row('<table:table-cell office:value-type="string"><text:p>5,5</text:p></table:table-cell>'),
    ],
    ids=["blank to the end", "a row to the end", "many rows", "a percentage", "a text"],
)
def test_what_programs_write_is_left_to_libreoffice(rows: str) -> None:
    assert refusal("a.ods", document(rows)) is WhyRefused.OPEN_DOCUMENT


@pytest.mark.parametrize(
    "rows",
    [
        row(GOOD, "1048576"),
        row(repeated(GOOD, "16384"), "16"),
        row(repeated(GOOD, "16384")) * 16,
        row("<table:table-cell><text:p>5</text:p></table:table-cell>", "1048576"),
        row(GOOD, "99999999999999999999"),
        row(GOOD, "-1"),
    ],
    ids=["rows", "rows and columns", "columns", "a text without a kind", "far too often", "less"],
)
def test_a_cell_that_is_there_too_often_is_too_much(rows: str) -> None:
    assert refusal("a.ods", document(rows)) is WhyRefused.TOO_LARGE


@pytest.mark.parametrize("kind", ["float", "percentage", "currency"])
@pytest.mark.parametrize("value", ["", "NaN", "1e999", "12,5", "1e-400", "0x10"])
def test_a_number_that_is_none_is_refused_where_libreoffice_would_make_one_of_it(
    kind: str, value: str
) -> None:
    """Seen: 0 of a value that is missing, is no number or is too large; 12 of 12,5."""
    stored = f'office:value="{value}"' if value else ""
    data = document(row(NUMBER.format(kind=kind, value=stored)))
    assert refusal("a.ods", data) is WhyRefused.FOREIGN_CONTENT


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (document(row(GOOD), '<!DOCTYPE x [<!ENTITY a "9">]>'), WhyRefused.FOREIGN_CONTENT),
        (document("<x>" * 200 + "</x>" * 200), WhyRefused.FOREIGN_CONTENT),
        (document("<x/>" * 200_001), WhyRefused.TOO_LARGE),
        (document(row("<table:table-cell>")), WhyRefused.INVALID_XML),
        (document(" " * 9_000_000), WhyRefused.TOO_LARGE),
        (document("", others={"styles.xml": b" " * 9_000_000}), WhyRefused.TOO_LARGE),
        (
            document("", others={"META-INF/manifest.xml": b"<m:encryption-data/>"}),
            WhyRefused.PASSWORD,
        ),
    ],
    ids=["entities", "depth", "elements", "no XML", "content", "styles", "a password"],
)
def test_what_must_not_be_opened_is_refused_for_what_it_is(data: bytes, why: WhyRefused) -> None:
    assert refusal("a.ods", data) is why


def test_a_document_that_lost_its_content_is_damaged_and_no_other_workbook() -> None:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        archive.writestr("mimetype", KIND)
    assert refusal("a.ods", stream.getvalue()) is WhyRefused.DAMAGED


def test_what_a_file_says_it_is_may_not_fill_the_memory() -> None:
    data = document(row(GOOD), others={"mimetype": KIND + b" " * 20_000_000})
    assert refusal("a.ods", data) is WhyRefused.OPEN_DOCUMENT


def test_a_document_of_something_else_is_told_so_and_not_how_to_save_it() -> None:
    """Saved as .xlsx it would be no other."""
    stream = io.BytesIO()
    Workbook().save(stream)
    found = read_again(NamedBytes("mine.ods", document(row(GOOD))), stream.getvalue())
    assert isinstance(found, Rejected)
    assert (found.file, found.code) == ("mine.ods", WhyRefused.FOREIGN)
