"""What grading again costs where nothing has changed, as a share of the first time; and memory.

`python benchmarks/again.py [works]` runs the whole command each time, with all reports.
"""

import pickle
import secrets
import subprocess
import sys
import tempfile
import tracemalloc
from collections.abc import Sequence
from dataclasses import replace
from datetime import date
from pathlib import Path
from time import perf_counter

from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.course.load import load_course
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.simulation.write import fill
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.init import init_course
from gripcourse.usecases.issuing.handout import Handout, IssuingContext
from gripcourse.usecases.issuing.issue import Order, issue_order
from gripcourse.usecases.marks.opening import open_grading
from gripcourse.variants.model import Issued
from gripcourse.variants.table import read_table, write_table
from gripcourse.workbook.write import write_answer_workbook

WORKS = 200
COPIES = 50  # of one report, to weigh it


def main() -> None:
    """Grade a folder, again, again with one work changed, and all afresh."""
    works = int(sys.argv[1]) if len(sys.argv) > 1 else WORKS
    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder)
        hand_in(base, works)
        first = seconds(base)
        print(f"{works} works, the first time                {first:7.1f} s")
        for name, change in (
            ("again, nothing changed", ()),
            ("again, one work replaced", ("u000.xlsx",)),
        ):
            for one in change:
                (base / "works" / one).write_bytes((base / "works" / "u001.xlsx").read_bytes())
            again = seconds(base)
            print(f"{name:<38} {again:7.1f} s, ratio {again / first:.3f}")
        weigh(base)


def hand_in(base: Path, works: int) -> None:
    """Issue a course to as many students, and let all of them answer rightly."""
    init_course(base / "course", secrets.token_bytes(32), Words("en"))
    course = load_course(base / "course")
    roster = base / "roster.csv"
    lines = ["student,name,group,email,language,variant"]
    lines += [f"u{number:03},Student {number:03},A,,en," for number in range(works)]
    roster.write_text("\n".join(lines), encoding="utf-8")
    drawn = read_table(course_root() / "variants" / "tables" / "main.csv", course)
    table = base / "table.csv"
    repeated = [replace(drawn[n % len(drawn)], id=f"{n:03}") for n in range(works)]
    write_table(table, repeated, course)
    order = Order(roster, table, base / "works", date(2026, 9, 1), None)
    issue_order(course, load_policy(course), order, 0, lambda _: None, issue_one=answered)


def answered(context: IssuingContext, entry: Issued) -> Handout:
    """Write the workbook of a student and fill it in."""
    plan = context.plan(entry.variant.composition)
    file = context.out / f"{entry.student.id}.xlsx"
    write_answer_workbook(file, plan, entry, context.course, Words("en"))
    fill(file, correct(plan, entry), file)
    return Handout(entry.student.id, (file,), ())


def seconds(base: Path, more: Sequence[str] = ()) -> float:
    """Return how long the command takes."""
    call = [sys.executable, "-m", "gripcourse", "grade", "works", "--out", "graded"]
    call += ["--course", "course", "--quiet", *more]
    start = perf_counter()
    done = subprocess.run(call, cwd=base, check=False, capture_output=True, text=True)  # noqa: S603
    if done.returncode not in {0, 1}:
        raise RuntimeError(done.stderr)
    return perf_counter() - start


def weigh(base: Path) -> None:
    """Print what the reports of a batch take in the main process, which holds all of them."""
    context = open_grading(base / "course")
    packed = pickle.dumps(grade_file(base / "works" / "u002.xlsx", context))
    tracemalloc.start()
    kept = [pickle.loads(packed) for _ in range(COPIES)]  # noqa: S301 (ours)
    each = tracemalloc.get_traced_memory()[0] / len(kept)
    for count in (300, 1500):
        print(f"reports of {count} works in memory: {count * each / 1e6:.0f} MB")
    print(f"one report kept on disk: {len(packed) / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
