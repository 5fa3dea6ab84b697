"""Grading what was handed in, begun by a server: the command of the command line, by itself."""

import shutil
import subprocess
import sys
from pathlib import Path
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.text.words import message
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import collect_hand_ins

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
        *(sys.executable, "-m", "gripcourse", "grade", str(work), "--quiet"),
        *("--course", str(context.course.root), "--out", str(graded)),
        *("--workers", str(workers), f"--by={by}", f"--why={why}"),
    ]
    # Who handed a file in is known by the link that it came by, whatever the file says.
    command += [f"--whose={path}={student}" for path, student in collected.items()]
    with (context.private / _LOG).open("wb") as log:
        return subprocess.Popen(  # noqa: S603 (ourselves, and paths of our own)
            command, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT
        )
