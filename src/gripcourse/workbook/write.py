"""The answer workbook of one student: given data, cells to fill in, and nothing of the reference.

The same inputs give the same bytes, so that a workbook can be made again and compared.
"""

import io
from datetime import datetime, time
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.course.model import Course
from gripcourse.machine.files import write_bytes
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words
from gripcourse.variants.model import Issued
from gripcourse.workbook import names
from gripcourse.workbook.cover import write_cover
from gripcourse.workbook.layout import WorkbookLayout, layout
from gripcourse.workbook.section import write_section
from gripcourse.workbook.series import write_series
from gripcourse.workbook.style import make_styles, new_book

if TYPE_CHECKING:
    from xlsxwriter import Workbook


def write_answer_workbook(
    path: Path, plan: Plan, issued: Issued, course: Course, words: Words
) -> None:
    """Write the workbook that a student fills in.

    Args:
        path: of the .xlsx file to make or to replace; only its owner may read it.
        plan: of the variant's scheme and options.
        issued: the student, the frozen values and the signature.
        course: its title.
        words: the student's language.

    Raises:
        OSError: the file cannot be written.
    """
    write_bytes(path, answer_workbook(plan, issued, course, words), private=True)


def answer_workbook(plan: Plan, issued: Issued, course: Course, words: Words) -> bytes:
    """Return the content of the workbook that a student fills in; see `write_answer_workbook`."""
    placed = layout(plan, words)
    stream = io.BytesIO()
    book = new_book(stream)
    styles = make_styles(book)
    write_cover(book, placed, plan, issued, words, styles)
    for sheet in placed.sheets:
        write_section(book, sheet, issued, course, words, styles)
    write_series(book, placed, plan, issued.student.name, words, styles)
    _write_identity(book, placed, issued)
    _set_properties(book, issued, course, words)
    book.close()
    return stream.getvalue()


def _write_identity(book: "Workbook", placed: WorkbookLayout, issued: Issued) -> None:
    """Say whose workbook it is: on a hidden sheet and in the document's properties."""
    fields = {
        names.STUDENT: issued.student.id,
        names.VARIANT: issued.variant.id,
        names.SCHEME: issued.variant.scheme,
        names.OPTIONS: names.options_text(issued.variant.options),
        names.SIGNATURE: issued.signature,
    }
    sheet = book.add_worksheet(names.HIDDEN_SHEET)
    for field, place in placed.meta.items():
        sheet.write_string(place.row, 0, field)
        sheet.write_string(place.row, place.column, fields[field])
        book.define_name(names.cell_name(names.META, field), f"={place.reference}")
        book.set_custom_property(names.cell_name(names.PROPERTY, field), fields[field], "text")
    sheet.protect()
    sheet.very_hidden()


def _set_properties(book: "Workbook", issued: Issued, course: Course, words: Words) -> None:
    """Name the document, with the day of issue as its date: nothing depends on the clock."""
    book.set_properties(
        {
            "title": course.title.of(words.language),
            "subject": issued.variant.id,
            "author": names.AUTHOR,
            "created": datetime.combine(issued.issued_on, time()),
        }
    )
