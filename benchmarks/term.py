"""What a whole group costs: processor, time and memory, on every kind of workers and databases.

    python benchmarks/term.py --count 1000 10000 [--printed 200] [--only local ...] [--times 5]

For each number of works, without printing anything: one process and two, as often in turn as
`--times` says, and again with nothing changed; a Dask cluster of a scheduler and two workers;
PostgreSQL instead of SQLite (Debian's package, started here). Then as many as `--printed` with all
their reports.

Students are issued the variants of the course's table again and again; everybody answers rightly
but for a few numbers. Works are made by putting answers into the bytes of issued workbooks: opening
each of them with a library would take longer than grading. The whole command runs in a process of
its own. Each line is printed as soon as it is measured, and what fails takes nothing else along.
"""

import argparse
import io
import os
import random
import re
import secrets
import shutil
import subprocess
import sys
import tempfile
import traceback
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from datetime import date
from importlib import import_module
from pathlib import Path
from statistics import median
from time import perf_counter
from xml.sax.saxutils import escape

from batches.apart import machine_ratio
from batches.watch import seen, wait_for_end
from cluster import cluster

from gripcourse.cli.demo.students import correct
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.issuing.allotment import Terms, extend
from gripcourse.issuing.signature import KEY_BYTES, key_path, read_key
from gripcourse.issuing.store import extend_register
from gripcourse.machine.jobs.limits import peak_memory
from gripcourse.machine.resources import course_root
from gripcourse.simulation.write import Typed
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.init import init_course
from gripcourse.variants.model import Issued, Student
from gripcourse.variants.table import read_table
from gripcourse.workbook.names import ANSWER, cell_name
from gripcourse.workbook.write import answer_workbook

WORKS = (1000, 10_000)
PRINTED = 200
WORKERS = 2
WRONG = 3  # answers of each student
SECONDS = 0.5  # between two looks at a command
SEED = 26063
_SHEET = re.compile(r'<sheet name="([^"]*)"[^>]*r:id="rId(\d+)"')
_NAME = re.compile(r'<definedName name="([^"]*)">([^<]*)</definedName>')


def main() -> None:
    """Make works, and grade them in every way that is asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", nargs="*", type=int, default=WORKS)
    parser.add_argument("--printed", type=int, default=PRINTED)
    parser.add_argument("--only", nargs="*", choices=(*PARTS, PRINTING), default=(*PARTS, PRINTING))
    parser.add_argument("--times", type=int, default=1, help="pairs of one process and two")
    arguments = parser.parse_args()
    times = arguments.times
    failed = False
    for works in arguments.count:
        with made(works) as base:
            for name, measure in PARTS.items():
                if name in arguments.only:
                    failed |= not went_well(name, measure, base, times)
    if PRINTING in arguments.only and arguments.printed:
        with made(arguments.printed) as base:
            print("  with all reports", flush=True)
            failed |= not went_well(PRINTING, printing, base, times)
    sys.exit(failed)


def went_well(name: str, measure: Callable[[Path, int], None], base: Path, times: int) -> bool:
    """Measure one part; a failure is said and takes no other part along."""
    try:
        measure(base, times)
    except Exception:  # noqa: BLE001 (an hour of measuring is not lost for it)
        print(f"  {name} failed:\n{traceback.format_exc()}", flush=True)
        return False
    return True


@contextmanager
def made(works: int) -> Iterator[Path]:
    """Make a course and works for a while; the folder with both is given."""
    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder)
        start = perf_counter()
        hand_in(base, works)
        print(f"{works} works, made in {perf_counter() - start:.0f} s", flush=True)
        yield base


def grades_only(base: Path, times: int) -> None:
    """Grade on this machine without printing anything."""
    locally(base, ("--grades-only",), times)


def printing(base: Path, times: int) -> None:
    """Grade on this machine and print all reports."""
    locally(base, (), times)


def locally(base: Path, more: Sequence[str], times: int) -> None:
    """Grade with one process and with two, as often in turn, and again what has not changed."""
    ratios, apart = list[float](), list[float]()
    for _ in range(times):
        one, two = (
            told(f"{count} process{'es' if count > 1 else ''}", base, f"graded{count}", count, more)
            for count in (1, WORKERS)
        )
        ratios.append(one.seconds / two.seconds)
        print(f"  {'ratio':<24} {ratios[-1]:7.2f}", flush=True)
        # Beginning and end of a batch: what they take does not grow less with more processors.
        idle = WORKERS * two.seconds - two.busy
        print(f"  {'one processor waited':<24} {idle:7.1f} s of {two.seconds:.1f} s", flush=True)
        apart.append(machine_ratio(base))
        print(f"  {'of programs apart':<24} {apart[-1]:7.2f}", flush=True)
    if times > 1:
        middle = f"{median(ratios):7.2f} of {median(apart):.2f} of programs apart"
        print(f"  {f'median of {times} ratios':<24} {middle}", flush=True)
    again = told("again, nothing changed", base, f"graded{WORKERS}", WORKERS, more, afresh=False)
    print(f"  {'share of the first time':<24} {again.seconds / two.seconds:7.3f}", flush=True)


def on_a_cluster(base: Path, _: int) -> None:
    """Grade with a scheduler and two workers of a thread each, all of them on this machine."""
    with cluster(base, WORKERS) as (address, pids):
        more = ("--grades-only", f"--cluster={address}")
        told("Dask, 2 workers", base, "cluster", WORKERS, more)
        peaks = ", ".join(f"{peak(one):.0f}" for one in pids)
    print(f"  {'scheduler and workers':<24} peaks {peaks} MB", flush=True)


def in_postgresql(base: Path, _: int) -> None:
    """Grade with attempts in a server's database, which is started for that."""
    # A server of the tests, which start one already.
    sys.path.append(str(Path(__file__).parents[1] / "tests"))
    postgres = import_module("support.postgres")
    with postgres.running() as server, server.database() as place:
        more = ("--grades-only", f"--gradebook={place}")
        told("PostgreSQL, 2 processes", base, "postgresql", WORKERS, more)
        told("again, nothing changed", base, "postgresql", WORKERS, more, afresh=False)


def peak(process: int) -> float:
    """Return the peak of a process that runs, in MB."""
    return peak_memory(process) / 1e6


def hand_in(base: Path, works: int) -> None:
    """Issue a course to as many students, and let all of them answer."""
    init_course(base / "course", secrets.token_bytes(KEY_BYTES), Words("en"))
    course = load_course(base / "course")
    drawn = read_table(course_root() / "variants" / "tables" / "main.csv", course)
    variants = [replace(drawn[n % len(drawn)], id=f"v{n:05}") for n in range(works)]
    students = [Student(f"u{n:05}", f"Student {n:05}", "A", "", "en", "") for n in range(works)]
    key = read_key(key_path(course.root))
    terms = Terms(key, date(2026, 9, 1), None, fingerprints(course.root).course)
    issued = extend_register(
        course.root, course.id, lambda register: extend(register, students, variants, terms)
    )
    private = base / "course" / "private" / "gradebook.sqlite"
    (base / "issued.sqlite").write_bytes(private.read_bytes())
    entries = issued.register.entries
    blanks = [Blank.of(entry, course) for entry in entries[: len(drawn)]]
    (base / "works").mkdir()
    chance = random.Random(SEED)  # noqa: S311 (not for secrets)
    for number, entry in enumerate(entries):
        work = blanks[number % len(blanks)].filled(entry, chance)
        (base / "works" / f"{entry.student.id}.xlsx").write_bytes(work)


@dataclass(frozen=True, slots=True)
class Blank:
    """An issued workbook, taken apart: its members, where answers go, and the right ones."""

    entry: Issued
    members: Mapping[str, str]
    places: Mapping[str, tuple[str, str]]
    answers: Typed

    @classmethod
    def of(cls, entry: Issued, course: Course) -> "Blank":
        """Make it for a student."""
        plan = plan_of(course, entry.variant.composition)
        with zipfile.ZipFile(io.BytesIO(answer_workbook(plan, entry, course, Words("en")))) as file:
            members = {name: file.read(name).decode() for name in file.namelist()}
        book = members["xl/workbook.xml"]
        sheets = {name: f"xl/worksheets/sheet{number}.xml" for name, number in _SHEET.findall(book)}
        named = dict(_NAME.findall(book))
        answers = correct(plan, entry)
        places = {}
        for quantity in answers:
            sheet, _, cell = named[cell_name(ANSWER, quantity)].rpartition("!")
            places[quantity] = sheets[sheet.strip("'")], cell.replace("$", "")
        return cls(entry, members, places, answers)

    def filled(self, entry: Issued, chance: random.Random) -> bytes:
        """Return the workbook of another student of the same numbers, filled in."""
        numbers = [name for name, value in self.answers.items() if not isinstance(value, str)]
        wrong = {name: chance.uniform(1.2, 9.0) for name in chance.sample(numbers, WRONG)}
        members = dict(self.members)
        for quantity, value in self.answers.items():
            member, cell = self.places[quantity]
            typed = value if isinstance(value, str) else float(value) * wrong.get(quantity, 1.0)
            members[member] = _typed(members[member], cell, typed)
        swaps = (
            (self.entry.student.id, entry.student.id),
            (self.entry.student.name, entry.student.name),
            (self.entry.variant.id, entry.variant.id),
            (self.entry.signature, entry.signature),
        )
        stream = io.BytesIO()
        with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as file:
            for name, text in members.items():
                for mine, theirs in swaps:
                    text = text.replace(mine, theirs)  # noqa: PLW2901 (one swap after the other)
                file.writestr(name, text)
        return stream.getvalue()


def _typed(sheet: str, cell: str, value: float | str) -> str:
    """Put an answer into a blank cell of a sheet."""
    begin = sheet.index(f'<c r="{cell}"')
    end = sheet.index("/>", begin)
    if isinstance(value, str):
        content = f' t="inlineStr"><is><t>{escape(value)}</t></is></c>'
    else:
        content = f"><v>{value:.15g}</v></c>"
    return sheet[:begin] + sheet[begin:end] + content + sheet[end + 2 :]


@dataclass(frozen=True, slots=True)
class Cost:
    """What a command cost: seconds, seconds of the processor, peaks in MB.

    Attributes:
        seconds: by the clock.
        busy: of the processor, of the command and all its workers, but for the last look's time.
        peak: of the command itself, as it was seen last.
        workers: of the largest of its workers.
    """

    seconds: float
    busy: float
    peak: float
    workers: float


def told(
    title: str, base: Path, out: str, workers: int, more: Sequence[str], *, afresh: bool = True
) -> Cost:
    """Grade, and print what it costs; a gradebook of works that were kept before is another one."""
    if afresh:
        private = base / "course" / "private" / "gradebook.sqlite"
        private.write_bytes((base / "issued.sqlite").read_bytes())
        shutil.rmtree(base / out, ignore_errors=True)
    cost = graded(base, ["works", "--out", out, "--workers", str(workers), *more])
    said = f"{cost.seconds:7.1f} s, processor {cost.busy:7.1f} s, peak {cost.peak:5.0f} MB"
    said += f", of a worker {cost.workers:.0f} MB" if cost.workers else ""
    print(f"  {title:<24} {said}", flush=True)
    return cost


def graded(base: Path, words: Sequence[str]) -> Cost:
    """Return what the command costs."""
    call = [sys.executable, "-m", "gripcourse", "grade", *words, "--course", "course"]
    start = perf_counter()
    with (base / "said").open("wb") as said:
        process = subprocess.Popen([*call, "--quiet"], cwd=base, stdout=said, stderr=said)  # noqa: S603 (ours)
        # Not what the system says of it at its end: that begins with the peak of who started it.
        own, of_workers, busy, ended = 0, 0, 0.0, 0
        while not ended:
            look = seen(process.pid)
            # Nothing of one that has just ended.
            own, of_workers = max(own, look.own), max(of_workers, look.of_workers)
            busy = max(busy, look.busy)
            wait_for_end(process.pid, SECONDS)
            ended, status, used = os.wait4(process.pid, os.WNOHANG)
    seconds = perf_counter() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in {0, 1}:
        raise RuntimeError((base / "said").read_text(encoding="utf-8"))
    busy = max(busy, used.ru_utime + used.ru_stime)
    return Cost(seconds, busy, own / 1e6, of_workers / 1e6)


PARTS = {"local": grades_only, "cluster": on_a_cluster, "postgresql": in_postgresql}
PRINTING = "printed"


if __name__ == "__main__":
    main()
