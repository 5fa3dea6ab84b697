"""Sheets and reports that nobody reads: laying out each takes a second or two."""

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

LAID_OUT = (
    "gripcourse.usecases.handout.assignment_sheet",
    "gripcourse.documents.report.student.student_report",
    "gripcourse.documents.report.cohort.cohort_report",
)


@contextmanager
def no_pages() -> Iterator[None]:
    """Write an empty page for each document of a term, in this process."""
    with pytest.MonkeyPatch.context() as patch:
        for name in LAID_OUT:
            patch.setattr(name, lambda *_, **__: b"%PDF-1.7\n")
        yield
