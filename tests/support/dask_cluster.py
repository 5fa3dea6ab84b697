"""A Dask cluster on this machine: a scheduler and workers, each a process of its own."""

import json
import os
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from support.processes import wait_for


@dataclass(frozen=True, slots=True)
class DaskCluster:
    """A scheduler and its workers."""

    address: str
    scheduler: "subprocess.Popen[bytes]"
    workers: "tuple[subprocess.Popen[bytes], ...]"


@contextmanager
def dask_cluster(folder: Path, paths: Sequence[Path], workers: int) -> Iterator[DaskCluster]:
    """Start a cluster on loopback; its workers have one thread each and find modules in `paths`."""
    place = folder / "scheduler.json"
    found = os.pathsep.join(map(str, (*paths, *sys.path)))
    environment = {**os.environ, "PYTHONPATH": found, "PYTHONWARNINGS": "ignore"}
    started: list[subprocess.Popen[bytes]] = []

    def start(module: str, *arguments: str) -> "subprocess.Popen[bytes]":
        command = [sys.executable, "-m", f"distributed.cli.{module}", "--no-dashboard"]
        with (folder / f"{len(started)}.log").open("wb") as log:
            process = subprocess.Popen(  # noqa: S603 (Dask's own program)
                [*command, "--scheduler-file", str(place), *arguments],
                cwd=folder,
                env=environment,
                stdout=log,
                stderr=log,
            )
        started.append(process)
        return process

    try:
        scheduler = start("dask_scheduler", "--host", "127.0.0.1", "--port", "0")
        hands = tuple(start("dask_worker", "--no-nanny", "--nthreads", "1") for _ in range(workers))
        wait_for(lambda: all(b"Registered to" in log_of(folder, one + 1) for one in range(workers)))
        address = json.loads(place.read_text(encoding="utf-8"))["address"]
        yield DaskCluster(address, scheduler, hands)
    finally:
        for process in reversed(started):
            process.kill()
            process.wait()


def log_of(folder: Path, number: int) -> bytes:
    """Return what a process of a cluster has written so far."""
    return (folder / f"{number}.log").read_bytes()
