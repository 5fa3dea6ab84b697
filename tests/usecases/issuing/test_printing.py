"""One file for the printer: a list, then everybody's sheet on paper of their own."""

from datetime import date
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

from pypdf import PdfReader, PdfWriter

from gripcourse.documents.pdf import pdf_from_html
from gripcourse.machine.resources import course_root
from gripcourse.usecases.issuing.handout import Handout, sheet_path
from gripcourse.usecases.issuing.printing import joined, print_sheets

if TYPE_CHECKING:
    from support.classroom import Classroom


def blank(pages: int) -> bytes:
    writer, stream = PdfWriter(), BytesIO()
    for _ in range(pages):
        writer.add_blank_page(100 + pages, 200)
    writer.write(stream)
    return stream.getvalue()


def make_sheet(path: Path, name: str) -> None:
    """Print a sheet of one page."""
    pdf = pdf_from_html(
        f"<html lang='uk'><p>{name}</p></html>", ("page.css",), course_root() / "templates"
    )
    path.write_bytes(pdf)


def test_every_part_begins_on_an_odd_page() -> None:
    pages = PdfReader(BytesIO(joined([blank(1), blank(2), blank(3), blank(4)]))).pages
    widths = [round(page.mediabox.width) - 100 for page in pages]
    assert widths == [1, 1, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4]


def test_the_list_names_everybody_in_the_order_of_the_sheets(
    issued: "Classroom", tmp_path: Path
) -> None:
    for student, name in (
        ("s03", "Julia Carter"),
        ("s01", "Иванова Анна"),
        ("s02", "Шевченко Оксана"),
    ):
        make_sheet(sheet_path(issued.order.out, student), name)
    handouts = [Handout(one, (), ()) for one in ("s03", "s01", "s02", "lost")]
    target = tmp_path / "print.pdf"
    out = issued.order.out
    assert print_sheets(handouts, issued.course, out, target, date(2026, 9, 7)) == 3
    pages = [page.extract_text() for page in PdfReader(target).pages]
    names = ("Иванова Анна", "Шевченко Оксана", "Julia Carter")
    assert [pages[0].index(name) for name in names] == sorted(map(pages[0].index, names))
    first = [
        next(number for number, text in enumerate(pages) if number and name in text)
        for name in names
    ]
    assert first == sorted(first)
    assert {number % 2 for number in first} == {0}
