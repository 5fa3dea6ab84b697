"""What the largest tables that an instructor may hand in take, and those just beyond.

    python benchmarks/tables.py

Each is read in a process of its own, as every command reads it. For spreadsheets there are two: the
one that asks, and the worker that opens the file.
"""

import csv
import io
import os
import resource
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path

import xlsxwriter

from gripcourse.errors import TableError
from gripcourse.machine.jobs.limits import peak_memory
from gripcourse.machine.table_bounds import MOST_CELLS, MOST_OF_WORKBOOK
from gripcourse.variants.sheet import read_sheet

COLUMNS = 12
Cell = Callable[[int], str | float]


def main() -> None:
    """Make the tables and read each, or read the one that is asked for."""
    if sys.argv[1:2] == ["--one"]:
        read(Path(sys.argv[2]))
        return
    with tempfile.TemporaryDirectory() as name:
        for path in tables(Path(name)):
            command = [sys.executable, __file__, "--one", str(path)]
            done = subprocess.run(command, check=True, capture_output=True, text=True)  # noqa: S603 (this file)
            print(done.stdout.strip())


def tables(folder: Path) -> Iterable[Path]:
    """Make the tables, one after the other."""
    kinds: dict[str, Cell] = {
        "names": lambda number: f"С{number}",
        "numbers": lambda number: number * 1.25,
    }
    for kind, cell in kinds.items():
        for size, more in (("largest", 0), ("larger", COLUMNS)):
            yield workbook(folder / f"{size}, {kind}.xlsx", MOST_OF_WORKBOOK // COLUMNS, more, cell)
            yield text(folder / f"{size}, {kind}.csv", MOST_CELLS // COLUMNS, more, cell)


def workbook(path: Path, rows: int, more: int, cell: Cell) -> Path:
    """Write a spreadsheet as spreadsheet programs do, with shared texts."""
    with xlsxwriter.Workbook(str(path)) as book:
        sheet = book.add_worksheet()
        for row in range(rows + more):
            sheet.write_row(row, 0, [cell(row * COLUMNS + one) for one in range(COLUMNS)])
    return path


def text(path: Path, rows: int, more: int, cell: Cell) -> Path:
    """Write a table of text."""
    stream = io.StringIO(newline="")
    writer = csv.writer(stream)
    for row in range(rows + more):
        writer.writerow([cell(row * COLUMNS + one) for one in range(COLUMNS)])
    path.write_text(stream.getvalue(), encoding="utf-8")
    return path


def read(path: Path) -> None:
    """Read a table and print what it took here and in the worker."""
    begun = resource.getrusage(resource.RUSAGE_SELF)
    try:
        said = f"{len(read_sheet(path).rows)} rows read"
    except TableError:
        said = "refused"
    done = resource.getrusage(resource.RUSAGE_SELF)
    seconds = done.ru_utime + done.ru_stime - begun.ru_utime - begun.ru_stime
    worker = ""
    if path.suffix == ".xlsx":
        [number] = children()
        spent = sum(map(float, Path(f"/proc/{number}/stat").read_text().split()[13:15]))
        ticks = os.sysconf("SC_CLK_TCK")
        peak = peak_memory(number) / 1e6
        worker = f"; worker {spent / ticks:.2f} s, {peak:.0f} MB"
    print(f"{path.name:21s} {said:18s} {seconds:.2f} s, {peak_memory() / 1e6:.0f} MB{worker}")


def children() -> list[int]:
    """Return the numbers of the processes that this one has started."""
    me = os.getpid()
    found = Path(f"/proc/{me}/task").glob("*/children")
    return [int(one) for task in found for one in task.read_text().split()]


if __name__ == "__main__":
    main()
