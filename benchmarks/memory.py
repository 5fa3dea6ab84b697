"""What a batch costs the process that runs it: its peak memory with few works and with many.

    python benchmarks/memory.py 500 1500

Virtual students work and are judged first, once for all; then each batch runs in a process of its
own, in which the reports come one by one as they come from workers, and pages cost nothing.
"""

import hashlib
import pickle
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, date, datetime
from pathlib import Path

from gripcourse.batch.context import GradingContext
from gripcourse.batch.run import grade_files
from gripcourse.course.load import load_course
from gripcourse.grading.model import Report
from gripcourse.machine.content import NamedBytes, Readable, shown_name
from gripcourse.machine.jobs.limits import peak_memory
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.in_memory import judge_one
from gripcourse.simulation.mix import load_mix
from gripcourse.usecases.grading import cohort_print
from gripcourse.usecases.grading import grade as command
from gripcourse.usecases.grading.student_reports import Printing
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.variants.model import Issued

SEED = 11
MOVED = ("given", "reference", "expected", "low", "high", "band", "half_unit")
DIFFERENT = 24  # works that are judged; the others are the same under other names


def main() -> None:
    """Judge, then run a batch of each size that is named, or one that is asked for."""
    if sys.argv[1] == "--one":
        run(Path(sys.argv[2]), int(sys.argv[3]))
        return
    sizes = [int(one) for one in sys.argv[1:]]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        judge(folder, max(sizes))
        for size in sizes:
            command_line = [sys.executable, __file__, "--one", name, str(size)]
            print(subprocess.run(command_line, check=True, capture_output=True, text=True).stdout)  # noqa: S603 (this file)


def judge(folder: Path, most: int) -> None:
    """Let virtual students work and be judged; keep their reports, and what was issued to all."""
    course = load_course(course_root())
    room = make_classroom(course, load_policy(course), load_mix(course), DIFFERENT, SEED)
    for number, student in enumerate(room.behaviours):
        report = judge_one(student, room).report
        (folder / f"{number}.report").write_bytes(pickle.dumps(report))
    entries = list(room.context.register.values())
    register = {
        name: moved(entries[number % DIFFERENT], name)
        for number in range(most)
        for name in (f"s{number:05}",)
    }
    (folder / "register").write_bytes(pickle.dumps(register))


def moved(entry: Issued, name: str) -> Issued:
    """Return what is issued to another student."""
    given = {key: value * factor(name, key) ** 0.01 for key, value in entry.variant.given.items()}
    variant = replace(entry.variant, id=name, given=given)
    return replace(entry, student=replace(entry.student, id=name, name=name), variant=variant)


def factor(student: str, quantity: str) -> float:
    """Return by how much a number is larger, so that nobody has copied."""
    return 1 + hashlib.sha256(f"{student} {quantity}".encode()).digest()[0] / 256


def graded_report(source: Readable, _context: GradingContext) -> Report:
    """Return a report as if it came from a worker."""
    folder, number, student = shown_name(source).split("|")
    report: Report = pickle.loads((Path(folder) / f"{number}.report").read_bytes())  # noqa: S301 (ours)
    findings = tuple(
        replace(one, **{
            name: value and value * factor(student, one.quantity)
            for name in MOVED
            for value in (getattr(one, name),)
        })
        for one in report.findings
    )  # fmt: skip
    return replace(
        report,
        file=f"{student}.xlsx",
        student=student,
        name=student,
        digest=hashlib.sha256(student.encode()).hexdigest(),
        findings=findings,
    )


def page(_report: Report, _printing: Printing) -> bytes:
    """Print nothing."""
    return b"%PDF-1.7"


def cohort_page(_reports: Sequence[Report], _printing: Printing) -> bytes:
    """Print nothing."""
    return b"%PDF-1.7"


def peak() -> float:
    """Return the peak of this process in MB."""
    return peak_memory() / 1e6


def run(folder: Path, size: int) -> None:
    """Run a batch and print the peak after each part of it."""
    course = load_course(course_root())
    register = pickle.loads((folder / "register").read_bytes())  # noqa: S301 (ours)
    register = dict(list(register.items())[:size])
    context = GradingContext(course, load_policy(course), register)
    files = [
        NamedBytes(f"{folder}|{number % DIFFERENT}|{student}", b"")
        for number, student in enumerate(register)
    ]
    parts = [f"{size} works: {peak():.0f} MB before"]
    graded = grade_files(files, context, 0, grade_one=graded_report)
    parts.append(f"{peak():.0f} graded and compared")
    with tempfile.TemporaryDirectory() as name:
        graded = keep(graded, context, f"{name}/gradebook.sqlite", datetime.now(UTC))
        parts.append(f"{peak():.0f} in the gradebook")
        cohort_print.cohort_pdf = cohort_page  # type: ignore[assignment,attr-defined]
        day = date(2026, 12, 1)
        out = Path(name) / "out"
        command.write_results(graded, context, out, day, 0, lambda _: None, lay_out=page)
        parts.append(f"{peak():.0f} written")
    print(", ".join(parts))


if __name__ == "__main__":
    main()
