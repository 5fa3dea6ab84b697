"""What an instructor takes home: everything that was handed in, and what was graded last."""

from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from gripcourse.machine.packing import ToPack, part_of_name
from gripcourse.usecases.grading.batch_tables import FILES_CSV, GRADES_CSV
from gripcourse.usecases.grading.grade import COHORT_PDF, REPORTS
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import kept_path, latest, name_in_folder
from gripcourse.usecases.serving.taken import hand_ins_by_person

HAND_INS_ZIP: Final = "hand-ins.zip"
REPORTS_ZIP: Final = "reports.zip"
TABLES: Final = {GRADES_CSV: "text/csv", FILES_CSV: "text/csv", COHORT_PDF: "application/pdf"}
"""What a batch is told in, with its media type."""


def hand_ins_to_pack(context: DeskContext) -> tuple[ToPack, ...]:
    """Return every file that was handed in, by student.

    The last workbook of everybody is called as `collect_hand_ins` calls it; what came before it,
    and drawings, stand in a folder of the student, numbered.

    Raises:
        OSError: a file is lost or cannot be read.
    """
    hand_ins = hand_ins_by_person(context.desk, context.joins())
    last = latest(context, hand_ins)
    found = tuple(
        ToPack(
            part_of_name(name_in_folder(one, student))
            if last.get(student) == one
            else f"{part_of_name(one.student)}/{one.number:03}-{part_of_name(one.name)}",
            kept_path(context, one.digest),
            one.at,
        )
        for student, files in hand_ins.items()
        for one in files
    )
    for one in found:
        one.path.stat()
    return found


def reports_to_pack(graded: Path | None) -> tuple[ToPack, ...]:
    """Return the students' reports of the last batch; nothing where there are none."""
    if graded is None:
        return ()
    return tuple(
        ToPack(part_of_name(one.name), one, datetime.fromtimestamp(one.stat().st_mtime, UTC))
        for one in sorted((graded / REPORTS).glob("*.pdf"))
        if _is_own(one)
    )


def graded_table(graded: Path | None, name: str) -> Path | None:
    """Return one of `TABLES` as the last batch wrote it, published or not; None for no such."""
    if graded is None or name not in TABLES:
        return None
    path = graded / name
    return path if _is_own(path) else None


def _is_own(path: Path) -> bool:
    """Tell whether a file lies there itself, and no link to one of somebody else's."""
    return path.is_file() and not path.is_symlink()
