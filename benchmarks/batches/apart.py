"""What a machine has to give: two gradings at once that share nothing, beside one alone.

No more can be had of two processes: programs take turns at the memory, and a processor that works
alone may be faster.
"""

import shutil
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from batches.grading import Cost, Grading, Start, own_folder

APART = 500  # works of each of them


def apart(base: Path) -> list[Sequence[Start]]:
    """Return what starts one grading in one process, and what starts two that share nothing.

    Args:
        base: folder with a `course` and the `works` of its students; some are copied beside them.
    """
    some = base / "apart"
    some.mkdir(exist_ok=True)
    for file in sorted((base / "works").iterdir())[:APART]:
        shutil.copy(file, some)
    folders = [own_folder(base, f"apart{number}") for number in range(3)]
    words = (str(some), "--out", "graded", "--workers", "0", "--grades-only")
    first, *two = (partial(Grading.of, folder, words) for folder in folders)
    return [[first], two]


def ratio_apart(one: Cost, two: Cost) -> float:
    """Return how many times as fast two of them are as one."""
    return 2 * one.seconds / two.seconds
