"""The list that goes round when assignments are handed out: who gets which sheet, and signs."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date

from gripcourse.course.model import Course
from gripcourse.documents.pdf import Document, render_pdf
from gripcourse.text.words import Words
from gripcourse.variants.model import Issued

TEMPLATE = "handout.html.j2"
STYLES = ("page.css", "handout.css")
_CONTROL_LETTERS = 12  # as on the sheet


@dataclass(frozen=True, slots=True)
class HandoutRow:
    """A student of the list: texts as they are printed."""

    name: str
    group: str
    variant: str
    control: str


def handout_list(entries: Sequence[Issued], course: Course, words: Words, day: date) -> bytes:
    """Make the list as a PDF file.

    Args:
        entries: of the register, in the order of the sheets.
        course: its title.
        words: the language of the list.
        day: that is printed.
    """
    document = handout_document(entries, course, words, day)
    return render_pdf(document, course.root / "templates", words)


def handout_document(
    entries: Sequence[Issued], course: Course, words: Words, day: date
) -> Document:
    """Return what the list is rendered from; see `handout_list`."""
    rows = [
        HandoutRow(
            one.student.name, one.student.group, one.variant.id, one.signature[:_CONTROL_LETTERS]
        )
        for one in entries
    ]
    values = {"course": course.title.of(words.language), "day": day, "rows": rows}
    return Document(TEMPLATE, STYLES, values)
