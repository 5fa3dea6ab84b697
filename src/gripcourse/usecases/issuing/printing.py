"""The sheets of a whole group as one file for a printer that prints on both sides."""

import io
from collections.abc import Iterable, Sequence
from datetime import date
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.documents.handout_list import handout_list
from gripcourse.issuing.store import read_register
from gripcourse.machine.files import write_bytes
from gripcourse.text.spelling import alphabetical
from gripcourse.text.words import Words
from gripcourse.usecases.issuing.handout import Handout, sheet_path

_SIDES = 2


def print_sheets(
    handouts: Iterable[Handout], course: Course, out: Path, target: Path, day: date
) -> int:
    """Write a hand-out list and everybody's sheet into one file, group by group.

    Everybody begins on an odd page: what is printed on both sides can be dealt out.

    Args:
        handouts: what was issued; who has no sheet because it failed is left out.
        course: its language is that of the list.
        out: folder that the sheets were written to.
        target: file to write; with everybody's name in it only its owner may read it.
        day: that the list prints.

    Returns:
        How many students' sheets are in it.
    """
    register = read_register(course.root, course.id).by_student()
    sheets = {one.student: sheet_path(out, one.student) for one in handouts}
    entries = [register[student] for student, sheet in sheets.items() if sheet.is_file()]
    # Stable: within a group the order of the roster.
    entries.sort(key=lambda one: alphabetical(one.student.group))
    listed = handout_list(entries, course, Words(course.language), day)
    parts = [listed, *(sheets[one.student.id].read_bytes() for one in entries)]
    write_bytes(target, joined(parts), private=True)
    return len(entries)


def joined(parts: Sequence[bytes]) -> bytes:
    """Join PDF files so that each begins on an odd page.

    Args:
        parts: whole files, in order.
    """
    from pypdf import PdfReader, PdfWriter  # noqa: PLC0415 (only who prints needs it)

    writer = PdfWriter()
    for part in parts:
        for page in PdfReader(io.BytesIO(part)).pages:
            writer.add_page(page)
        if len(writer.pages) % _SIDES:
            writer.add_blank_page()
    # What every sheet brings, such as its fonts, is stored once.
    writer.compress_identical_objects()
    stream = io.BytesIO()
    writer.write(stream)
    return stream.getvalue()
