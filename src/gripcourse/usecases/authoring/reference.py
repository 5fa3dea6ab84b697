"""Writing the formula reference: a folder of pages that need nothing but a browser."""

from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.documents.reference.pages import pages
from gripcourse.machine.files import write_text
from gripcourse.text.words import Words


def write_reference(course: Course, out: Path, words: Words, home: str = "") -> list[Path]:
    """Write every page of a course's reference into a folder and return what was written.

    Args:
        course: whose declarations are printed.
        out: the folder; it is made if it is missing.
        words: the language of the pages.
        home: the address that leads out of the reference, seen from its pages; if any.

    Raises:
        OSError: a page cannot be written.
    """
    written = []
    for name, page in sorted(pages(course, words, home).items()):
        written.append(out / name)
        write_text(written[-1], page)
    return written
