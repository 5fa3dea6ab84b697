"""The whole command that grades a folder of works, run in a process of its own and looked at.

What a machine gives changes from minute to minute, more than what is to be told apart: programs
that are compared run in turn, a second each, and the others are held meanwhile.
"""

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import TypeAlias

from batches.watch import descendants, seen, wait_for_end

SECONDS = 0.5  # between two looks at a command
TURN = 1.0  # seconds: a thousandth of it is lost at each end

Start: TypeAlias = Callable[[], "Grading"]
"""Starts a command."""


@dataclass(frozen=True, slots=True)
class Cost:
    """What commands cost: seconds, seconds of the processor, peaks in MB.

    Attributes:
        seconds: by the clock, but for those in which they were held.
        busy: of the processor, of the commands and all their workers, but for the last look's time.
        peak: of a command itself, as it was seen last.
        workers: of the largest of its workers.
    """

    seconds: float
    busy: float
    peak: float
    workers: float


@dataclass(slots=True)
class Grading:
    """A command that runs or has ended.

    Attributes:
        process: the command.
        said: file that it says all in.
        busy, own, of_workers: see `watch.Seen`, the most of what was seen.
    """

    process: "subprocess.Popen[bytes]"
    said: Path
    busy: float = 0.0
    own: int = 0
    of_workers: int = 0

    @classmethod
    def of(cls, folder: Path, words: Sequence[str]) -> "Grading":
        """Start to grade with the `course` of a folder, from that folder."""
        call = [sys.executable, "-m", "gripcourse", "grade", *words, "--course", "course"]
        said = folder / "said"
        with said.open("wb") as stream:
            process = subprocess.Popen(  # noqa: S603 (ours)
                [*call, "--quiet"], cwd=folder, stdout=stream, stderr=stream
            )
        return cls(process, said)

    def ends_within(self, seconds: float) -> bool:
        """Look at it, wait for its end no longer than this, and tell whether it came.

        Raises:
            RuntimeError: it failed.
        """
        if self.process.returncode is not None:
            return True
        # Not what the system says of it at its end: that begins with the peak of who started it.
        look = seen(self.process.pid)
        # Nothing of one that has just ended.
        self.own = max(self.own, look.own)
        self.of_workers = max(self.of_workers, look.of_workers)
        self.busy = max(self.busy, look.busy)
        wait_for_end(self.process.pid, seconds)
        ended, status, used = os.wait4(self.process.pid, os.WNOHANG)
        if not ended:
            return False
        self.busy = max(self.busy, used.ru_utime + used.ru_stime)
        self.process.returncode = os.waitstatus_to_exitcode(status)
        if self.process.returncode not in {0, 1}:
            raise RuntimeError(self.said.read_text(encoding="utf-8"))
        return True

    def told(self, what: signal.Signals) -> None:
        """Hold it and all that it started, or let them go on; who starts others first."""
        if self.process.returncode is None:
            self.process.send_signal(what)
            for one in descendants(self.process.pid):
                with suppress(ProcessLookupError):
                    os.kill(one, what)


@dataclass(slots=True)
class _Together:
    """Commands that run at the same time, and have turns together."""

    starts: Sequence[Start]
    running: Sequence[Grading] = ()
    seconds: float = 0.0

    def turn(self, seconds: float) -> bool:
        """Let them run for so long; tell whether all have ended."""
        begun = perf_counter()
        self._tell(signal.SIGCONT)
        self.running = self.running or [start() for start in self.starts]
        ended = False
        while not ended and (left := begun + seconds - perf_counter()) > 0:
            looks = [one.ends_within(min(left, SECONDS)) for one in self.running]
            ended = all(looks)
        if not ended:
            self._tell(signal.SIGSTOP)
        self.seconds += perf_counter() - begun
        return ended

    def _tell(self, what: signal.Signals) -> None:
        for one in self.running:
            one.told(what)

    def close(self) -> None:
        """Let none of them stay, whatever happened to the others."""
        for one in self.running:
            one.told(signal.SIGKILL)

    def cost(self) -> Cost:
        return Cost(
            self.seconds,
            sum(one.busy for one in self.running),
            max(one.own for one in self.running) / 1e6,
            max(one.of_workers for one in self.running) / 1e6,
        )


def in_turn(groups: Iterable[Sequence[Start]], seconds: float = TURN) -> list[Cost]:
    """Run commands in turn, those of a group at the same time, and return what each group cost.

    Args:
        groups: what starts them.
        seconds: of a turn.

    Raises:
        RuntimeError: one of them failed.
    """
    every = [_Together(starts) for starts in groups]
    left = every
    try:
        while left:
            left = [one for one in left if not one.turn(seconds)]
    finally:
        for one in every:
            one.close()
    return [one.cost() for one in every]


def alone(start: Start) -> Cost:
    """Run a command by itself, and return what it cost."""
    return in_turn([[start]], float("inf"))[0]


def own_folder(base: Path, name: str) -> Path:
    """Make a folder with the course as it was when works were handed in, for one command.

    Args:
        base: folder with the `course` and the `works`; what the command knows of is beside them.
        name: of the folder.
    """
    folder = base / name
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(base / "course", folder / "course")
    return folder
