"""A batch at the desk: begun there or anywhere else, watched, and what it came to."""

import json
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any, Final

from gripcourse.usecases.grading.batch_tables import GRADES_JSON

if TYPE_CHECKING:
    from subprocess import Popen

_FINE: Final = frozenset({0, 1})  # exit codes of a batch that came to its end


class OwnBatch:
    """The batch that this server began last; safe between threads."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._process: Popen[bytes] | None = None

    @property
    def lock(self) -> threading.Lock:
        """Held by who begins a batch, so that two do not begin at once."""
        return self._lock

    def began(self, process: "Popen[bytes]") -> None:
        """Watch a process from now on."""
        self._process = process

    @property
    def runs(self) -> bool:
        """Whether it is still at work."""
        return self._process is not None and self._process.poll() is None

    @property
    def failed(self) -> bool:
        """Whether it ended without results."""
        process = self._process
        return (
            process is not None and process.poll() is not None and process.returncode not in _FINE
        )

    def close(self) -> None:
        """End it; what was graded up to now is kept, and is taken over when it is begun again."""
        if self._process is not None and self._process.poll() is None:
            self._process.terminate()
            self._process.wait()


@dataclass(frozen=True, slots=True)
class FoundFlag:
    """Something a person should look at.

    Attributes:
        code: why.
        message: a sentence, in the language of the batch.
        others: ids of other students whom it concerns.
        rests_on: ids of the quantities that are the evidence.
        in_languages: the sentence by language; empty in results of an earlier program.
    """

    code: str
    message: str
    others: tuple[str, ...]
    rests_on: tuple[str, ...]
    in_languages: Mapping[str, str]

    def said(self, language: str) -> str:
        """Return the sentence in a reader's language, else as the batch wrote it."""
        return self.in_languages.get(language, self.message)


@dataclass(frozen=True, slots=True)
class BatchWork:
    """A work as the last batch found it.

    Attributes:
        file: its name.
        student: id; empty where nobody could be told.
        flags: for the instructor.
        typed: what stands in the cells, by quantity.
    """

    file: str
    student: str
    flags: tuple[FoundFlag, ...]
    typed: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class LastBatch:
    """What was graded last, and when."""

    at: datetime
    works: tuple[BatchWork, ...]

    @property
    def flagged(self) -> tuple[BatchWork, ...]:
        """The works that somebody should look at."""
        return tuple(one for one in self.works if one.flags)

    def of(self, student: str) -> tuple[BatchWork, ...]:
        """Return the works of a student."""
        return tuple(one for one in self.works if one.student == student)


class BatchReader:
    """Reads the results of the last batch again only where they are others."""

    def __init__(self) -> None:
        self._last: tuple[tuple[int, int, int], LastBatch] | None = None

    def read(self, graded: Path | None) -> LastBatch | None:
        """Return what a folder of results says; None where there is none.

        Raises:
            OSError: it cannot be read.
        """
        path = None if graded is None else graded / GRADES_JSON
        if path is None or not path.is_file():
            return None
        known = path.stat()
        state = (known.st_mtime_ns, known.st_size, known.st_ino)
        last = self._last
        if last is not None and last[0] == state:
            return last[1]
        reports = json.loads(path.read_text(encoding="utf-8"))["reports"]
        batch = LastBatch(datetime.fromtimestamp(known.st_mtime, UTC), tuple(map(_work, reports)))
        self._last = (state, batch)
        return batch


def _work(report: Mapping[str, Any]) -> BatchWork:
    return BatchWork(
        file=PurePath(report["file"]).name,
        student=report["student"],
        flags=tuple(_flag(one) for one in report["flags"]),
        typed={one["quantity"]: one["typed"] for one in report["findings"]},
    )


def _flag(plain: Mapping[str, Any]) -> FoundFlag:
    # Results of an earlier program name nobody.
    others: Sequence[str] = plain.get("others", ())
    return FoundFlag(
        code=plain["code"],
        message=plain["message"],
        others=tuple(others),
        rests_on=tuple(plain.get("rests_on", ())),
        in_languages=plain.get("in_languages", {}),
    )
