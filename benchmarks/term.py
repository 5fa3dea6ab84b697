"""What a whole group costs: processor, time and memory, on every kind of workers and databases.

    python benchmarks/term.py --count 1000 10000 [--printed 200] [--only local ...] [--times 5]

For each number of works, without printing anything: one process and two, a second each in turn, as
often as `--times` says, and again with nothing changed; a Dask cluster of a scheduler and two
workers; PostgreSQL instead of SQLite (Debian's package, started here). Then as many as `--printed`
with all their reports.

Students are issued the variants of the course's table again and again; everybody answers rightly
but for a few numbers. Works are made by putting answers into the bytes of issued workbooks: opening
each of them with a library would take longer than grading. The whole command runs in a process of
its own. Each line is printed as soon as it is measured, and what fails takes nothing else along.
"""

import argparse
import sys
import tempfile
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from pathlib import Path
from statistics import median
from time import perf_counter

from batches.apart import apart, ratio_apart
from batches.grading import Cost, Grading, Start, alone, in_turn, own_folder
from batches.works import hand_in
from cluster import cluster

from gripcourse.machine.jobs.limits import peak_memory

WORKS = (1000, 10_000)
PRINTED = 200
WORKERS = 2


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
    """Grade with one process and with two in turn, and again what has not changed."""
    ratios, of_apart = list[float](), list[float]()
    for _ in range(times):
        starts = [start_of(own_folder(base, f"by{count}"), count, more) for count in (1, WORKERS)]
        one, two, first, others = in_turn([*([start] for start in starts), *apart(base)])
        say("1 process", one)
        say(f"{WORKERS} processes", two)
        ratios.append(one.seconds / two.seconds)
        print(f"  {'ratio':<24} {ratios[-1]:7.2f}", flush=True)
        # Beginning and end of a batch: what they take does not grow less with more processors.
        idle = WORKERS * two.seconds - two.busy
        print(f"  {'one processor waited':<24} {idle:7.1f} s of {two.seconds:.1f} s", flush=True)
        of_apart.append(ratio_apart(first, others))
        print(f"  {'of programs apart':<24} {of_apart[-1]:7.2f}", flush=True)
    if times > 1:
        middle = f"{median(ratios):7.2f} of {median(of_apart):.2f} of programs apart"
        print(f"  {f'median of {times} ratios':<24} {middle}", flush=True)
    again = told("again, nothing changed", starts[-1])
    print(f"  {'share of the first time':<24} {again.seconds / two.seconds:7.3f}", flush=True)


def on_a_cluster(base: Path, _: int) -> None:
    """Grade with a scheduler and two workers of a thread each, all of them on this machine."""
    with cluster(base, WORKERS) as (address, pids):
        more = ("--grades-only", f"--cluster={address}")
        told("Dask, 2 workers", start_of(own_folder(base, "cluster"), WORKERS, more))
        peaks = ", ".join(f"{peak(one):.0f}" for one in pids)
    print(f"  {'scheduler and workers':<24} peaks {peaks} MB", flush=True)


def in_postgresql(base: Path, _: int) -> None:
    """Grade with attempts in a server's database, which is started for that."""
    # A server of the tests, which start one already.
    sys.path.append(str(Path(__file__).parents[1] / "tests"))
    postgres = import_module("support.postgres")
    with postgres.running() as server, server.database() as place:
        more = ("--grades-only", f"--gradebook={place}")
        start = start_of(own_folder(base, "postgresql"), WORKERS, more)
        told("PostgreSQL, 2 processes", start)
        told("again, nothing changed", start)


def peak(process: int) -> float:
    """Return the peak of a process that runs, in MB."""
    return peak_memory(process) / 1e6


def told(title: str, start: Start) -> Cost:
    """Grade, and print what it costs."""
    cost = alone(start)
    say(title, cost)
    return cost


def say(title: str, cost: Cost) -> None:
    """Print what commands cost."""
    said = f"{cost.seconds:7.1f} s, processor {cost.busy:7.1f} s, peak {cost.peak:5.0f} MB"
    said += f", of a worker {cost.workers:.0f} MB" if cost.workers else ""
    print(f"  {title:<24} {said}", flush=True)


def start_of(folder: Path, workers: int, more: Sequence[str]) -> Start:
    """Return what starts to grade all works with the course of a folder."""
    words = (str(folder.parent / "works"), "--out", "graded", "--workers", str(workers), *more)
    return partial(Grading.of, folder, words)


PARTS = {"local": grades_only, "cluster": on_a_cluster, "postgresql": in_postgresql}
PRINTING = "printed"


if __name__ == "__main__":
    main()
