"""Grading what was handed in, begun by a server: the command of the command line, by itself."""

import shutil
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.policy.time_rules import zone_of
from gripcourse.text.words import message
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import CollectedFile, collect_hand_ins
from gripcourse.usecases.serving.taken import hand_ins_by_person

# Hidden: no backup carries what was only collected.
_WORK: Final = ".grading"
_LOG: Final = "grading.log"


def begin_grading(
    context: DeskContext, graded: Path, workers: int, by: str, why: str = ""
) -> "subprocess.Popen[bytes]":
    """Collect the workbooks of everybody that may count, and begin to grade them.

    Args:
        context: of the course.
        graded: folder of the results; what an earlier run found out there is taken over.
        workers: processes that open the workbooks.
        by: who has them graded.
        why: in a few words; may be empty.

    Raises:
        UsageError: nobody has handed in a workbook.
        OSError: something cannot be written.
    """
    work = context.private / _WORK
    shutil.rmtree(work, ignore_errors=True)
    collected = collect_hand_ins(context, work)
    if not collected:
        what = message("Nobody has handed in a workbook yet.")
        raise UsageError([Problem("", "", what, message("There is nothing to grade."))])
    command = [
        *(sys.executable, "-P", "-m", "gripcourse", "grade", str(work), "--quiet"),
        *("--course", str(context.course.root), "--out", str(graded)),
        *("--workers", str(workers), f"--by={by}", f"--why={why}"),
    ]
    # Who handed a file in is known by the link that it came by, whatever the file says.
    command += [f"--whose={path}={one.student}" for path, one in collected.items()]
    command += _handed_in_again(context, collected)
    with (context.private / _LOG).open("wb") as log:
        return subprocess.Popen(  # noqa: S603 (ourselves, and paths of our own)
            command, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT
        )


def _handed_in_again(
    context: DeskContext, collected: Mapping[Path, CollectedFile]
) -> Iterator[str]:
    """Say when those works came of which the student had handed in the same bytes before.

    The gradebook knows them by their bytes, from when they were graded first: what was handed in
    between would count as the last one.
    """
    first: dict[tuple[str, str], tuple[str, int]] = {}
    for student, files in hand_ins_by_person(context.desk, context.joins()).items():
        for one in files:
            first.setdefault((student, one.digest), (one.student, one.number))
    zone = zone_of(context.policy.late)
    for path, work in collected.items():
        one = work.hand_in
        if (one.student, one.number) != first[work.student, one.digest]:
            yield f"--handed-in={path}={one.at.astimezone(zone):%Y-%m-%d %H:%M:%S%z}"
