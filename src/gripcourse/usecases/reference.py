"""Writing the formula reference: a folder of pages that need nothing but a browser."""

from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.documents.reference.pages import pages
from gripcourse.machine.files import write_text
from gripcourse.text.words import Words


def write_reference(course: Course, out: Path, words: Words) -> list[Path]:
    """Write every page of a course's reference into a folder and return what was written.

    Raises:
        OSError: a page cannot be written.
    """
    written = []
    for name, page in sorted(pages(course, words).items()):
        written.append(out / name)
        write_text(written[-1], page)
    return written
