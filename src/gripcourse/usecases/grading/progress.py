"""How far a batch is that is being graded: one small file among the results, for whoever watches.

A desk shows it, whoever began the batch. It is gone when the batch has ended; one that stays behind
is of a program that was killed, and its time tells.
"""

import json
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from enum import StrEnum
from pathlib import Path
from typing import Final, TypeAlias

from gripcourse.machine.files import write_bytes

Step: TypeAlias = Callable[[str, int | None], Callable[[], None]]
"""Begins a step by its name and how many there are; what it returns is called after each."""

_NAME: Final = "progress.json"
_SECONDS: Final = 0.5  # between two writings
_SILENT_MINUTES: Final = 5


class BatchPhase(StrEnum):
    """What is being done, in this order."""

    GRADING = "grading"
    REPORTS = "reports"


@dataclass(frozen=True, slots=True)
class BatchProgress:
    """How far a batch is.

    Attributes:
        phase: what is being done.
        done, total: files of this phase.
        began: when the batch began.
        at: when something was done last.
    """

    phase: BatchPhase
    done: int
    total: int
    began: datetime
    at: datetime

    def is_silent(self, now: datetime) -> bool:
        """Tell whether nothing was done for so long that the program may have ended."""
        return (now - self.at).total_seconds() > _SILENT_MINUTES * 60


@contextmanager
def progress_noted(out: Path, step: Step) -> Iterator[Step]:
    """Let every step of a batch be noted among its results too.

    Args:
        out: folder of the results; it is there.
        step: that shows it otherwise.
    """
    path, phases, began = out / _NAME, iter(BatchPhase), datetime.now(UTC)

    def noted(name: str, total: int | None) -> Callable[[], None]:
        tick, phase = step(name, total), next(phases)
        done, written = 0, time.monotonic()
        _write(path, BatchProgress(phase, 0, total or 0, began, datetime.now(UTC)))

        def ticked() -> None:
            nonlocal done, written
            tick()
            done += 1
            if time.monotonic() - written >= _SECONDS:
                written = time.monotonic()
                _write(path, BatchProgress(phase, done, total or 0, began, datetime.now(UTC)))

        return ticked

    try:
        yield noted
    finally:
        path.unlink(missing_ok=True)


def batch_progress(out: Path) -> BatchProgress | None:
    """Return how far a batch is that writes its results into a folder; None where there is none."""
    try:
        found = json.loads((out / _NAME).read_text(encoding="utf-8"))
        return BatchProgress(
            phase=BatchPhase(found["phase"]),
            done=int(found["done"]),
            total=int(found["total"]),
            began=datetime.fromisoformat(found["began"]),
            at=datetime.fromisoformat(found["at"]),
        )
    except FileNotFoundError:
        return None


def _write(path: Path, progress: BatchProgress) -> None:
    plain = {
        "phase": progress.phase.value,
        "done": progress.done,
        "total": progress.total,
        "began": progress.began.isoformat(),
        "at": progress.at.isoformat(),
    }
    # Twice a second: nobody needs it once the machine has lost its power.
    write_bytes(path, json.dumps(plain).encode(), private=True, lasting=False)
