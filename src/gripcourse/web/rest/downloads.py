"""What an instructor's program takes home: all hand-ins, and what was graded last."""

from collections.abc import Sequence
from typing import Final

from gripcourse.machine.packing import ToPack
from gripcourse.usecases.grading.batch_tables import FILES_CSV, GRADES_CSV
from gripcourse.usecases.grading.grade import COHORT_PDF
from gripcourse.usecases.publishing.downloads import (
    HAND_INS_ZIP,
    REPORTS_ZIP,
    TABLES,
    graded_table,
    hand_ins_to_pack,
    reports_to_pack,
)
from gripcourse.web.downloads import ZIP
from gripcourse.web.refusals import NOT_FOUND, WebRefusal
from gripcourse.web.rest.declare import ApiOperation, DeskCall, SentFile, SentZip, TokenRole


def all_hand_ins(call: DeskCall) -> SentZip | WebRefusal:
    """Every file that was handed in, in one zip."""
    return _packed(HAND_INS_ZIP, hand_ins_to_pack(call.site.context))


def graded_reports(call: DeskCall) -> SentZip | WebRefusal:
    """The reports of everybody as they were printed last, published or not, in one zip."""
    return _packed(REPORTS_ZIP, reports_to_pack(call.site.graded))


def graded_grades(call: DeskCall) -> SentFile | WebRefusal:
    """The table of grades of the last batch, published or not."""
    return _table(call, GRADES_CSV)


def graded_files(call: DeskCall) -> SentFile | WebRefusal:
    """What became of each file of the last batch."""
    return _table(call, FILES_CSV)


def graded_cohort(call: DeskCall) -> SentFile | WebRefusal:
    """The report on the group as it was printed last, published or not."""
    return _table(call, COHORT_PDF)


def _packed(name: str, files: Sequence[ToPack]) -> SentZip | WebRefusal:
    return SentZip(tuple(files), name) if files else NOT_FOUND


def _table(call: DeskCall, name: str) -> SentFile | WebRefusal:
    path = graded_table(call.site.graded, name)
    return NOT_FOUND if path is None else SentFile(path, path.name)


_DESK: Final = TokenRole.INSTRUCTOR
_ZIPS: Final = {
    HAND_INS_ZIP: all_hand_ins,
    f"graded/{REPORTS_ZIP}": graded_reports,
}
_TABLES: Final = {
    GRADES_CSV: graded_grades,
    FILES_CSV: graded_files,
    COHORT_PDF: graded_cohort,
}
DOWNLOAD_OPERATIONS: Final = (
    *(
        ApiOperation("GET", f"/desk/{path}", _DESK, answer, SentZip, media=ZIP)
        for path, answer in _ZIPS.items()
    ),
    *(
        ApiOperation("GET", f"/desk/graded/{name}", _DESK, answer, SentFile, media=TABLES[name])
        for name, answer in _TABLES.items()
    ),
)
