"""From which size on a Dask cluster pays: works graded by processes here, and by its workers.

    python benchmarks/cluster.py [works] [--seed 26063] [--cohort FOLDER]

Virtual students hand in workbooks; no report is printed. Each kind of workers has a main process of
its own, whose memory is read; all figures are of one run. What a job costs is counted in seconds of
the processor, so that what else a machine does moves it little. A cluster's workers are on this
machine: more of them than cores grade no faster.
"""

import argparse
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from datetime import UTC, date, datetime
from pathlib import Path
from time import perf_counter, sleep
from typing import Any

from batches.watch import seen
from distributed import Client

from gripcourse.batch.context import GradingContext
from gripcourse.batch.run import compared, grade_files
from gripcourse.course.load import load_course
from gripcourse.issuing.register_file import read_register_file
from gripcourse.machine.jobs.cluster import open_workers
from gripcourse.machine.jobs.limits import peak_memory
from gripcourse.machine.jobs.pools import Pool
from gripcourse.machine.jobs.workers import in_order, run_each
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.simulation.on_disk import register_of
from gripcourse.usecases.grading.student_reports import Printing, student_pdf
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.measuring.virtual import Cohort, simulate

WORKS = 400
EMPTY_JOBS = 300
MILLION = 1_000_000
SIZES = (2, 8, 32)  # workers of a cluster, each with a core
LOCAL = 2  # cores of the machine beside it
MEGABYTE = 1e6


def main() -> None:
    """Make works, grade them by every kind of workers, and print what each costs."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("works", nargs="?", type=int, default=WORKS)
    parser.add_argument("--seed", type=int, default=26063)
    parser.add_argument("--cohort", type=Path, help="Folder that `simulate` wrote.")
    parser.add_argument("--measure", nargs=4, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.measure:
        folder, workers, address, processes = arguments.measure
        pids = [int(one) for one in processes.split(",") if one]
        found = measured(Path(folder), int(workers), address or None, pids, arguments.works)
        print(json.dumps(found))
        return
    with tempfile.TemporaryDirectory() as name:
        folder = arguments.cohort or Path(name) / "cohort"
        if arguments.cohort is None:
            course = load_course(course_root())
            cohort = Cohort(arguments.works, arguments.seed, None)
            simulate(course, load_policy(course), cohort, folder, LOCAL, lambda: None)
        report(list(all_measured(folder, Path(name), arguments.works)), arguments.works)


def all_measured(folder: Path, scratch: Path, works: int) -> Iterator[dict[str, Any]]:
    """Measure each kind of workers in a process of its own."""
    yield called("one process, half of the works", folder, 1, "", works // 2)
    yield called("one process", folder, 1, "", works)
    yield called("two processes", folder, 2, "", works)
    for workers in (1, 2):
        with cluster(scratch, workers) as (address, pids):
            yield called(f"Dask, {workers} of 1 thread", folder, 1, address, works, pids)


def called(
    title: str, folder: Path, workers: int, address: str, works: int, pids: Sequence[int] = ()
) -> dict[str, Any]:
    """Measure in a fresh process, whose memory is its own."""
    told = [str(folder), str(workers), address, ",".join(map(str, pids))]
    command = [sys.executable, __file__, str(works), "--measure", *told]
    done = subprocess.run(command, stdout=subprocess.PIPE, check=True)  # noqa: S603 (this file)
    return {"title": title, **json.loads(done.stdout)}


def measured(
    folder: Path, workers: int, address: str | None, pids: Sequence[int], works: int
) -> dict[str, float]:
    """Grade the first works of a folder; return seconds of each part, and bytes.

    Args:
        folder: that `simulate` wrote.
        workers: processes of this machine.
        address: of a cluster, None for none.
        pids: of its scheduler and its workers.
        works: how many.
    """
    course = load_course(course_root())
    register = read_register_file(register_of(folder), course.id).by_student()
    context = GradingContext(course, load_policy(course), register)
    files = sorted((folder / "submissions").glob("*.xlsx"))[:works]
    opened, own, children = perf_counter(), time.process_time(), of_children()
    before = [seen(one).busy for one in pids]
    done: list[float] = []
    with open_workers(workers, address) as (hands, pool):
        connected = time.process_time()
        graded = grade_files(
            files, context, hands, lambda _: done.append(perf_counter()), pool=pool
        )
        main, peak = time.process_time(), peak_memory()
        after = [seen(one).busy for one in pids]
        empty = empty_jobs(hands, pool, pids[0]) if pids else 0.0
    scheduler, *busy = [late - early for late, early in zip(after, before, strict=True)] or [0.0]
    start = time.process_time()
    compared(graded, context)
    likeness = time.process_time() - start
    start = time.process_time()
    keep(graded, context, str(folder / f"{os.getpid()}.sqlite"), datetime.now(UTC))
    kept = time.process_time() - start
    return {
        "seconds": done[-1] - opened,
        "main": main - connected - likeness,
        "connect": connected - own,
        "workers": of_children() - children + sum(busy),
        "scheduler": scheduler,
        "empty": empty,
        "likeness": likeness,
        "kept": kept,
        "peak": peak,
        "page": page_seconds(graded, context) if not address and workers == 1 else 0.0,
    }


def empty_jobs(workers: int, pool: Pool, scheduler: int) -> float:
    """Return what main process and scheduler spend on a job that does nothing."""

    def give(count: int) -> float:
        start = time.process_time() + seen(scheduler).busy
        in_order(run_each(nothing, range(count), None, workers=workers, seconds=9, pool=pool))
        return time.process_time() + seen(scheduler).busy - start

    give(1)
    return give(EMPTY_JOBS) / EMPTY_JOBS


def nothing(_: int, __: None) -> None:
    """Do a job that takes no time."""


def of_children() -> float:
    """Return the seconds of the processor of all that this process has started."""
    return seen(os.getpid()).busy - time.process_time()


def page_seconds(graded: Sequence[Any], context: GradingContext) -> float:
    """Return what one report costs, once the first one is there."""
    reports = [one.report for one in graded if one.report.judged][:3]
    printing = Printing(context.course, context.policy, date(2026, 12, 2))
    times = []
    for one in reports:
        start = time.process_time()
        student_pdf(one, printing)
        times.append(time.process_time() - start)
    return min(times)


@contextmanager
def cluster(folder: Path, workers: int) -> Iterator[tuple[str, list[int]]]:
    """Start a scheduler and workers of one thread on this machine."""
    place = folder / f"scheduler{workers}.json"
    started: list[subprocess.Popen[bytes]] = []
    shared = ["--no-dashboard", "--scheduler-file", str(place)]
    commands = [["dask_scheduler", "--host", "127.0.0.1", "--port", "0"]]
    commands += [["dask_worker", "--no-nanny", "--nthreads", "1"]] * workers
    try:
        for program, *options in commands:
            command = [sys.executable, "-m", f"distributed.cli.{program}", *shared, *options]
            started.append(
                subprocess.Popen(command, cwd=folder, stderr=subprocess.DEVNULL)  # noqa: S603 (Dask's own)
            )
        address = address_of(place, workers)
        yield address, [one.pid for one in started]
    finally:
        for one in reversed(started):
            one.send_signal(signal.SIGTERM)
            one.wait()


def address_of(place: Path, workers: int) -> str:
    """Return the address of a scheduler, as soon as all its workers are there."""
    while not place.exists():
        sleep(0.2)
    address = str(json.loads(place.read_text(encoding="utf-8"))["address"])
    with Client(address, timeout=60, set_as_default=False) as client:
        client.wait_for_workers(workers, timeout=120)
    return address


def report(found: Sequence[Mapping[str, Any]], works: int) -> None:
    """Print what was measured and what follows from it."""
    print(f"{'':32}  by the clock   processor: main   scheduler   workers   memory of the main one")
    for one in found:
        print(
            f"{one['title']:32}{one['seconds']:12.1f} s{one['connect'] + one['main']:15.1f} s"
            f"{one['scheduler']:10.1f} s{one['workers']:8.1f} s{one['peak'] / MEGABYTE:15.0f} MB"
        )
    half, one, two, dask_one, dask_two = found
    print(f"two processes: {one['seconds'] / two['seconds']:.2f} times as fast as one")
    ratio = dask_one["seconds"] / dask_two["seconds"]
    print(f"Dask with two workers: {ratio:.2f} times as fast as with one")
    growth = (one["peak"] - half["peak"]) / (works - works // 2)
    print(f"memory of the main process: {growth / 1e3:.0f} kB more with each work")
    job = (one["workers"] - half["workers"]) / (works - works // 2)
    serial = dask_one["empty"]
    extra = dask_one["connect"] + max(0.0, dask_one["workers"] - job * works)
    kept = one["kept"] / works
    print(
        f"a job: {job * 1e3:.1f} ms of a worker; on a cluster {serial * 1e3:.1f} ms of main process"
    )
    print(f"and scheduler together; {extra:.1f} s once to connect and to make workers ready")
    print(f"gradebook (SQLite): {kept * 1e3:.2f} ms a work; one report {one['page']:.2f} s")
    print(f"comparing works with each other: {half['likeness']:.2f} s, {one['likeness']:.2f} s")
    project(job, serial, extra, kept, one["page"])


def project(job: float, serial: float, extra: float, kept: float, page: float) -> None:
    """Print from which size on a cluster pays, and what a million works would take.

    A cluster is as fast as its workers, but never faster than its main process and its scheduler
    hand out jobs.
    """
    for workers in SIZES:
        rate, pages = max(job / workers, serial), max(page / workers, serial)
        hours = MILLION * (rate + kept) / 3600
        printed = since(extra, (job + page) / LOCAL - rate - pages)
        print(
            f"{workers:3} workers against {LOCAL} cores: pays"
            f" {since(extra, job / LOCAL - rate)}, with reports {printed};"
            f" a million works {hours:.1f} h, their reports {MILLION * pages / 3600:.0f} h more"
        )
    local = MILLION * (job / LOCAL + kept) / 3600
    print(f"{LOCAL} cores without a cluster: {local:.1f} h, {MILLION * page / LOCAL / 3600:.0f} h")


def since(extra: float, gain: float) -> str:
    """Say from how many works on the gain of each makes up for what is to be done once."""
    return f"from {math.ceil(extra / gain)} works on" if gain > 0 else "never"


if __name__ == "__main__":
    main()
