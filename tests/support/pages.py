"""Sheets and reports that nobody reads: laying out each takes a second or two."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from html import unescape

import pytest

LAYOUT = "gripcourse.documents.pdf.pdf_from_html"
LAID_OUT = (
    "gripcourse.usecases.issuing.handout.assignment_sheet",
    "gripcourse.documents.report.student.student_report",
    "gripcourse.documents.report.cohort.cohort_report",
)


SIGNATURE = b"%PDF-1.7\n"


@contextmanager
def not_laid_out() -> Iterator[None]:
    """Write as a document the HTML that it is laid out from, in this process.

    Equal content is laid out to equal bytes: that is looked at in tests/documents/test_pdf.py and
    of whole documents in tests/documents/report/test_solution.py.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(LAYOUT, lambda html, *_: SIGNATURE + html.encode())
        yield


def text_of_page(made: bytes) -> str:
    """Return the text of a document that was not laid out, every run of spaces as one space."""
    page = made.removeprefix(SIGNATURE).decode()
    text = unescape(re.sub(r"<[^>]*>", " ", page[page.index("<body") :]))
    return " ".join(text.replace("\u2060", "").split())


@contextmanager
def no_pages() -> Iterator[None]:
    """Write an empty page for each document of a term, in this process."""
    with pytest.MonkeyPatch.context() as patch:
        for name in LAID_OUT:
            patch.setattr(name, lambda *_, **__: SIGNATURE)
        yield
