"""What a machine has to give: two gradings at once that share nothing, beside one alone."""

import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

APART = 150  # works of each of them


def machine_ratio(base: Path) -> float:
    """Return how many times as fast as one are two gradings that share nothing.

    No more can be had of two processes: programs take turns at the memory, and a processor that
    works alone may be faster.

    Args:
        base: folder with a `course` and the `works` of its students; some are copied, for a while.
    """
    with TemporaryDirectory(dir=base) as folder:
        return _ratio(Path(folder), base)


def _ratio(folder: Path, base: Path) -> float:
    shutil.copytree(base / "course", folder / "course")
    (folder / "apart").mkdir()
    for file in sorted((base / "works").iterdir())[:APART]:
        shutil.copy(file, folder / "apart")
    start = perf_counter()
    wait_for([grading_apart(folder, 0)])
    alone = perf_counter() - start
    start = perf_counter()
    wait_for([grading_apart(folder, number) for number in (1, 2)])
    return 2 * alone / (perf_counter() - start)


def grading_apart(base: Path, number: int) -> "subprocess.Popen[bytes]":
    """Start to grade some works in one process, with results and attempts of its own."""
    call = [sys.executable, "-m", "gripcourse", "grade", "apart", "--course", "course", "--quiet"]
    own = ["--out", f"apart{number}", "--gradebook", f"apart{number}.sqlite", "--workers", "0"]
    return subprocess.Popen([*call, *own, "--grades-only"], cwd=base)  # noqa: S603 (ours)


def wait_for(programs: Sequence["subprocess.Popen[bytes]"]) -> None:
    """Wait until all of some programs have ended.

    Raises:
        RuntimeError: one of them failed.
    """
    if {one.wait() for one in programs} - {0, 1}:
        raise RuntimeError("a grading apart failed")
