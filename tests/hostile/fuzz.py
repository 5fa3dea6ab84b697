"""Read mutated workbooks: `python tests/hostile/fuzz.py FIRST COUNT`, or `make fuzz`.

Who fails is written into `failed.txt` with its number: the tests read those first, for ever.
"""

import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Final

from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.table import visible_sheets
from gripcourse.submission.raw import RawWorkbook

if __name__ == "__main__":  # as a program it does not know where the tests are
    sys.path.insert(0, str(Path(__file__).parents[1]))

from hostile.mutations import mutated
from hostile.provenance import invented
from hostile.reading import as_student, faults_of
from hostile.small_workbook import quantities

FAILED: Final = Path(__file__).parent / "failed.txt"
_AS_TABLE: Final = 8  # every one of so many is read as a table too


def failures(seeds: Iterable[int]) -> Iterator[tuple[int, str]]:
    """Yield the number of each mutated workbook that is not read as it should be, and why."""
    asked = quantities()
    for seed in seeds:
        data = mutated(seed)
        try:
            read = as_student(data, asked)
            wrong = faults_of(read)
            if isinstance(read.raw, RawWorkbook):
                wrong += invented(data, read.raw)
            if seed % _AS_TABLE == 0 and not isinstance(visible_sheets(data), tuple | WhyRefused):
                wrong.append("no table and no refusal")
        except Exception as fault:  # noqa: BLE001 (it is what is looked for)
            wrong = [repr(fault)]
        if wrong:
            yield seed, "; ".join(wrong)


def once_failed() -> tuple[int, ...]:
    """Return the numbers that are kept."""
    lines = FAILED.read_text(encoding="utf-8").splitlines()
    return tuple(int(line.split()[0]) for line in lines if not line.startswith("#"))


def main(first: int, count: int) -> int:
    """Read that many; the exit code tells whether any failed."""
    found = list(failures(range(first, first + count)))
    with FAILED.open("a", encoding="utf-8") as kept:
        for seed, why in found:
            if seed not in once_failed():
                kept.write(f"{seed} {' '.join(why.split())[:200]}\n")
    sys.stdout.write(f"{count} workbooks, {len(found)} failed\n")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3])))
