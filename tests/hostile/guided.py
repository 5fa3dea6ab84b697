"""Spoil workbooks where that leads to code that did not run before: `guided.py FIRST COUNT`.

A file is told by the numbers that each of its changes was drawn from. One that reaches a new step
of the reader, from one line to another, becomes a parent of others. Nothing of it is kept from one
call to the next but what fails, in `failed_guided.txt`.
"""

import math
import random
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import CodeType, FrameType
from typing import Any, Final, TypeAlias

from gripcourse import machine, submission
from gripcourse.machine.jobs.limits import peak_memory
from gripcourse.machine.spreadsheet.table import visible_sheets
from gripcourse.submission.raw import RawWorkbook

if __name__ == "__main__":  # as a program it does not know where the tests are
    sys.path.insert(0, str(Path(__file__).parents[1]))

from hostile.mutations import Line, descended
from hostile.provenance import invented
from hostile.reading import as_student, faults_of
from hostile.small_workbook import quantities

Step: TypeAlias = tuple[CodeType, int, int]
"""A function, and two of its lines that ran one after the other."""

FAILED: Final = Path(__file__).parent / "failed_guided.txt"
LONGEST: Final = 12  # changes of one file
SECONDS: Final = 2.0  # of processor time
MEGABYTES: Final = 256
_NEW: Final = 0.1  # of files begin with the sound workbook
_WATCHED: Final = tuple(
    str(folder)
    for folder in (Path(machine.__path__[0]) / "spreadsheet", Path(submission.__path__[0]))
)


def steps_of(do: Callable[[], object]) -> set[Step]:
    """Do something and return the steps of the reader that ran."""
    seen: set[Step] = set()

    def entered(frame: FrameType, _event: str, _argument: object) -> Any:  # noqa: ANN401 (of tracing)
        code = frame.f_code
        if not code.co_filename.startswith(_WATCHED):
            return None
        last = 0

        def passed(frame: FrameType, event: str, _argument: object) -> Any:  # noqa: ANN401 (of tracing)
            nonlocal last
            if event == "line":
                seen.add((code, last, frame.f_lineno))
                last = frame.f_lineno
            return passed

        return passed

    before = sys.gettrace()
    sys.settrace(entered)
    try:
        do()
    finally:
        sys.settrace(before)
    return seen


def faults(data: bytes, seconds: float = math.inf) -> list[str]:
    """Return what is wrong with how a file is read, as a student's and as a table.

    Args:
        data: the file.
        seconds: of processor time that it may take; a test sets none, as it may run anywhere.
    """
    started, before = time.process_time(), peak_memory()
    try:
        read = as_student(data, quantities())
        wrong = faults_of(read)
        if isinstance(read.raw, RawWorkbook):
            wrong += invented(data, read.raw)
        visible_sheets(data)
    except Exception as fault:  # noqa: BLE001 (it is what is looked for)
        wrong = [repr(fault)]
    # What the process grew by: what ran in it before is not this file's.
    taken, grown = time.process_time() - started, (peak_memory() - before) / 1e6
    wrong += [f"{taken:.1f} s"] * (taken > seconds)
    return wrong + [f"{grown:.0f} MB"] * (grown > MEGABYTES)


def explore(
    first: int, count: int, seconds: float = math.inf
) -> Iterator[tuple[Line, list[str], int]]:
    """Yield each file that is tried, what is wrong with it, and how many steps are known by then.

    Args:
        first: number that the first file is drawn from.
        count: of files.
        seconds: see `faults`.
    """
    parents: list[Line] = []
    known: set[Step] = set()
    for number in range(first, first + count):
        draw = random.Random(number)  # noqa: S311 (nothing secret)
        begun = () if not parents or draw.random() < _NEW else draw.choice(parents)
        line = (*begun[-LONGEST + 1 :], number)
        data, wrong = descended(line), list[str]()
        steps = steps_of(lambda: wrong.extend(faults(data, seconds)))  # noqa: B023 (done at once)
        if not steps <= known:
            known |= steps
            parents.append(line)
        yield line, wrong, len(known)


def once_failed() -> tuple[Line, ...]:
    """Return the files that are kept."""
    lines = FAILED.read_text(encoding="utf-8").splitlines()
    numbers = (one.partition(":")[0].split() for one in lines if not one.startswith("#"))
    return tuple(tuple(map(int, one)) for one in numbers)


def main(first: int, count: int) -> int:
    """Try that many; the exit code tells whether any failed."""
    failed, steps = 0, 0
    for line, wrong, known in explore(first, count, SECONDS):
        steps, failed = known, failed + bool(wrong)
        if wrong and line not in once_failed():
            with FAILED.open("a", encoding="utf-8") as kept:
                said = " ".join("; ".join(wrong).split())[:200]
                kept.write(f"{' '.join(map(str, line))}: {said}\n")
    sys.stdout.write(f"{count} workbooks by {steps} steps of the reader, {failed} failed\n")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3])))
