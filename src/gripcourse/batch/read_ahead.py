"""Works are read while the course is still being loaded: to read one takes no course.

Half of what judging a work takes is reading it. Whatever goes wrong meanwhile is nobody's concern:
what was not read then is read by who judges it.
"""

import pickle
import threading
from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from gripcourse.machine.content import Readable, shown_name
from gripcourse.machine.jobs.pools import FORKED
from gripcourse.machine.jobs.room import start_if_there_is_room
from gripcourse.machine.jobs.workers import run_each
from gripcourse.machine.shelf import Shelf, ShelfPlace, fetched

if TYPE_CHECKING:
    from gripcourse.submission.raw import RawWorkbook

# Where workers cannot be started, who judges will say why; Ctrl-C comes to workers too, and who was
# called answers for it.
_OTHERS_SAY: Final = (OSError, MemoryError, RuntimeError, KeyboardInterrupt)
# A real work takes 0.02 s. What takes longer has its own time when it is judged.
_SECONDS: Final = 2.0


@dataclass(frozen=True, slots=True)
class WorkRead:
    """A work of which nobody needs the file any more.

    Attributes:
        name: of the file, as problems and reports name it.
        packed: what was read, by a worker of this program.
    """

    name: str
    packed: bytes

    def workbook(self) -> "RawWorkbook":
        """Return what was read."""
        found: RawWorkbook = pickle.loads(self.packed)  # noqa: S301 (`_packed` wrote it)
        return found


@dataclass(frozen=True, slots=True)
class WorksAhead:
    """Works that were read so far.

    Attributes:
        files: of the batch.
        places: of what was read, by the number of the file; on a shelf, for it may be much.
        stop: is set when no more are to be begun.
        reading: the thread that gives them to workers.
    """

    files: Sequence[Readable]
    places: dict[int, bytes | ShelfPlace] = field(default_factory=dict)
    stop: threading.Event = field(default_factory=threading.Event)
    reading: list[threading.Thread] = field(default_factory=list)

    def ended(self) -> "WorksAhead":
        """Begin no more, wait for those that are being read, and return all that were."""
        self.stop.set()
        for thread in self.reading:
            if thread.ident is not None:
                thread.join()
        return self

    def work(self, number: int) -> Readable | WorkRead:
        """Return a work that was read, else its file."""
        file, place = self.files[number], self.places.get(number)
        return file if place is None else WorkRead(shown_name(file), fetched(place))


@contextmanager
def reading_ahead(files: Sequence[Readable], workers: int) -> Iterator[WorksAhead]:
    """Read works, in their order, until somebody wants to know how far it is.

    Where workers are no forks nothing is read: they begin when the course is there already.

    Args:
        files: of the batch.
        workers: how many processes will judge; all but one of them read, for one processor is busy
            with the course. 0 for nothing to be read ahead.
    """
    ahead = WorksAhead(files)
    if files and workers and FORKED:
        thread = threading.Thread(target=_read, args=(ahead, workers), daemon=True)
        ahead.reading.append(thread)
        start_if_there_is_room(thread)
    try:
        yield ahead
    finally:
        ahead.ended()


def _read(ahead: WorksAhead, workers: int) -> None:
    shelf = Shelf()
    count = min(max(1, workers - 1), len(ahead.files))
    jobs = run_each(_packed, ahead.files, None, workers=count, seconds=_SECONDS)
    with suppress(*_OTHERS_SAY), closing(jobs):
        for number, packed in jobs:
            if isinstance(packed, bytes) and packed:
                ahead.places[number] = shelf.put(packed) or packed
            if ahead.stop.is_set():
                return


def _packed(file: Readable, _: None) -> bytes:
    """Read a work; empty for what is refused, which who judges looks at for himself."""
    # For workers alone.
    from gripcourse.batch.one_file import read_file  # noqa: PLC0415
    from gripcourse.submission.model import Rejected  # noqa: PLC0415

    found = read_file(file)
    return b"" if isinstance(found, Rejected) else pickle.dumps(found, pickle.HIGHEST_PROTOCOL)
