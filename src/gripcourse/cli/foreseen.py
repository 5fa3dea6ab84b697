"""What workers of long commands import, named before a command knows what there is to do.

So one processor imports for the workers while another reads the course, and what all of them need
is imported once. Names, not imports: this module costs nothing.
"""

from collections.abc import Iterable
from typing import Final

_SHARING: Final = ("drawings", "drawn", "lines", "sizes", "styles")
_DOCUMENTS: Final = (
    *("gripcourse.documents.compiled", "gripcourse.documents.sandbox"),
    *(f"gripcourse.documents.sharing.{one}" for one in _SHARING),
    *("weasyprint", "babel.messages.mofile", "babel.messages.pofile", "babel.numbers"),
)

GRADING: Final = (
    *("gripcourse.batch.run", "gripcourse.batch.one_file"),
    # What is derived of findings where they are made, and how the register travels.
    *("gripcourse.exports.grades", "gripcourse.exports.report_json"),
    *("gripcourse.gradebook.results", "gripcourse.issuing.shelved"),
    # Not imported with it, since not every batch needs them.
    *("openpyxl", "babel.dates", "babel.messages.pofile", "numpy.random"),
)
"""To read works and judge them."""

REPORTS: Final = (
    "gripcourse.usecases.grading.student_reports",
    "gripcourse.documents.report.student",
    *_DOCUMENTS,
)
"""To lay out students' reports."""

HANDOUTS: Final = (
    "gripcourse.usecases.issuing.issue",
    "gripcourse.documents.assignment_sheet",
    *("gripcourse.drawing.paper.hatch", "gripcourse.drawing.paper.svg_entities"),
    *("gripcourse.workbook.write", "xlsxwriter", "segno"),
    *_DOCUMENTS,
)
"""To lay out what is issued to students."""


def foresee(modules: Iterable[str], workers: int, cluster: str | None = None) -> None:
    """Let the workers of this machine begin to import.

    Args:
        modules: that they will need.
        workers: how many; 0 for none.
        cluster: address of the cluster that does their work instead; None for none.
    """
    from gripcourse.machine.jobs.pools import foresee_processes  # noqa: PLC0415 (see above)

    if workers and cluster is None:
        foresee_processes(*modules)
