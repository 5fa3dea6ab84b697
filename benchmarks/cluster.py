"""From which size on a Dask cluster pays: works graded by processes here, and by its workers.

    python benchmarks/cluster.py [works] [--seed 26063]

Virtual students hand in workbooks; no report is printed. Each kind of workers has a main process of
its own, whose memory is read; all figures are of one run. A cluster's workers are on this machine,
so that more of them than cores grade no faster: what is measured is what a job costs.
"""

import argparse
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from datetime import UTC, date, datetime
from pathlib import Path
from time import perf_counter, sleep
from typing import Any

from gripcourse.batch.one_file import GradingContext
from gripcourse.batch.run import compared, grade_files
from gripcourse.course.load import load_course
from gripcourse.issuing.register_file import read_register_file
from gripcourse.jobs.cluster import open_workers
from gripcourse.jobs.limits import peak_memory
from gripcourse.jobs.workers import in_order, run_each
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.simulation.on_disk import register_of
from gripcourse.usecases.gradebook import keep
from gripcourse.usecases.student_reports import Printing, student_pdf
from gripcourse.usecases.virtual import Cohort, simulate

WORKS = 400
IDLE_JOBS = 300
MILLION = 1_000_000
SIZES = (2, 8, 32)  # workers of a cluster, each with a core
LOCAL = 2  # cores of the machine beside it
MEGABYTE = 1e6


def main() -> None:
    """Make works, grade them by every kind of workers, and print what each costs."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("works", nargs="?", type=int, default=WORKS)
    parser.add_argument("--seed", type=int, default=26063)
    parser.add_argument("--measure", nargs=3, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.measure:
        folder, workers, address = arguments.measure
        print(json.dumps(measured(Path(folder), int(workers), address or None, arguments.works)))
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "cohort"
        course = load_course(course_root())
        cohort = Cohort(arguments.works, arguments.seed, None)
        start = perf_counter()
        simulate(course, load_policy(course), cohort, folder, LOCAL, lambda: None)
        print(f"{arguments.works} works made in {perf_counter() - start:.0f} s")
        report(list(all_measured(folder, arguments.works)), arguments.works)


def all_measured(folder: Path, works: int) -> Iterator[dict[str, Any]]:
    """Measure each kind of workers in a process of its own."""
    half = works // 2
    yield called("one process, half of the works", folder, 1, "", half)
    yield called("one process", folder, 1, "", works)
    yield called("two processes", folder, 2, "", works)
    for workers in (1, 2):
        with cluster(folder, workers) as address:
            yield called(f"Dask, {workers} of 1 thread", folder, 1, address, works)


def called(title: str, folder: Path, workers: int, address: str, works: int) -> dict[str, Any]:
    """Measure in a fresh process, whose memory is its own."""
    command = [sys.executable, __file__, str(works), "--measure", folder, str(workers), address]
    done = subprocess.run(command, stdout=subprocess.PIPE, check=True)  # noqa: S603 (this file)
    return {"title": title, **json.loads(done.stdout)}


def measured(folder: Path, workers: int, address: str | None, works: int) -> dict[str, float]:
    """Grade the first works of a folder; return seconds of each part, and bytes."""
    course = load_course(course_root())
    register = read_register_file(register_of(folder), course.id).by_student()
    context = GradingContext(course, load_policy(course), register)
    files = sorted((folder / "submissions").glob("*.xlsx"))[:works]
    before = peak_memory()
    opened = perf_counter()
    done: list[float] = []
    with open_workers(workers, address) as (hands, pool):
        connected = perf_counter()
        graded = grade_files(
            files, context, hands, lambda _: done.append(perf_counter()), pool=pool
        )
        jobs = perf_counter()
        peak = peak_memory()
        in_order(run_each(nothing, range(IDLE_JOBS), None, workers=hands, seconds=9, pool=pool))
        idle = perf_counter() - jobs
        in_order(run_each(nothing, range(1), None, workers=1, seconds=9, pool=pool))
        started = perf_counter() - jobs - idle
    start = perf_counter()
    compared(graded, context)
    likeness = perf_counter() - start
    start = perf_counter()
    keep(graded, context, str(folder / f"{os.getpid()}.sqlite"), datetime.now(UTC))
    kept = perf_counter() - start
    return {
        "start": connected - opened + done[0] - connected,
        "work": (done[-1] - done[0]) / max(1, len(done) - 1),
        "grading": done[-1] - opened,
        "idle": (idle - started) / IDLE_JOBS,
        "likeness": likeness,
        "kept": kept,
        "before": before,
        "peak": peak,
        "page": page_seconds(graded, context) if not address and workers == 1 else 0.0,
    }


def nothing(_: int, __: None) -> None:
    """Do a job that takes no time."""


def page_seconds(graded: Sequence[Any], context: GradingContext) -> float:
    """Return what one report costs, once the first one is there."""
    reports = [one.report for one in graded if one.report.judged][:3]
    printing = Printing(context.course, context.policy, date(2026, 12, 2))
    times = []
    for one in reports:
        start = perf_counter()
        student_pdf(one, printing)
        times.append(perf_counter() - start)
    return min(times)


@contextmanager
def cluster(folder: Path, workers: int) -> Iterator[str]:
    """Start a scheduler and workers of one thread on this machine."""
    place = folder / f"scheduler{workers}.json"
    started = []
    shared = ["--no-dashboard", "--scheduler-file", str(place)]
    commands = [["dask_scheduler", "--host", "127.0.0.1", "--port", "0"]]
    commands += [["dask_worker", "--no-nanny", "--nthreads", "1"]] * workers
    try:
        for program, *options in commands:
            command = [sys.executable, "-m", f"distributed.cli.{program}", *shared, *options]
            started.append(
                subprocess.Popen(command, cwd=folder, stderr=subprocess.DEVNULL)  # noqa: S603 (Dask's own)
            )
        sleep(10)  # for who waits longer the machine is too busy to be measured
        yield json.loads(place.read_text(encoding="utf-8"))["address"]
    finally:
        for one in reversed(started):
            one.send_signal(signal.SIGTERM)
            one.wait()


def report(found: Sequence[Mapping[str, Any]], works: int) -> None:
    """Print what was measured and what follows from it."""
    print(f"{'':32}   start   per work  per empty job  all graded  peak memory")
    for one in found:
        print(
            f"{one['title']:32}{one['start']:6.1f} s{one['work'] * 1e3:8.1f} ms"
            f"{one['idle'] * 1e3:12.2f} ms{one['grading']:10.1f} s{one['peak'] / MEGABYTE:10.0f} MB"
        )
    half, one, two, dask_one, dask_two = found
    print(f"two processes: {one['work'] / two['work']:.2f} times as fast as one")
    print(f"Dask with two workers: {dask_one['work'] / dask_two['work']:.2f} times as with one,")
    print(f"{two['work'] / dask_two['work']:.2f} times as fast as two processes of this machine")
    growth = (one["peak"] - half["peak"]) / (works - works // 2)
    print(f"memory of the main process: {growth / 1e3:.1f} kB a work above that of {works // 2}")
    print(f"comparing all works with each other: {half['likeness']:.2f} s, {one['likeness']:.2f} s")
    kept = one["kept"] / works
    print(f"gradebook (SQLite): {kept * 1e3:.2f} ms a work; one report {one['page']:.2f} s")
    project(one, two, dask_one, kept)


def project(
    one: Mapping[str, Any], two: Mapping[str, Any], dask: Mapping[str, Any], kept: float
) -> None:
    """Print from which size on a cluster pays, and what a million works would take."""
    overhead = max(dask["work"] - one["work"], dask["idle"])
    extra = dask["start"] - two["start"]
    for workers in SIZES:
        rate = max((one["work"] + overhead) / workers, dask["idle"])
        gain = one["work"] / LOCAL - rate
        pays = f"from {math.ceil(max(extra, 0) / gain)} works on" if gain > 0 else "never"
        page_gain = one["page"] / LOCAL - max(one["page"] / workers, dask["idle"]) + gain
        with_pages = f"from {math.ceil(max(extra, 0) / page_gain)}" if page_gain > 0 else "never"
        hours = MILLION * (rate + kept) / 3600
        pages = MILLION * max(one["page"] / workers, dask["idle"]) / 3600
        print(
            f"{workers:3} workers: pays {pays}, with reports {with_pages};"
            f" a million works {hours:.1f} h, their reports {pages:.0f} h more"
        )


if __name__ == "__main__":
    main()
