"""Jobs for tests; other processes find them by their names."""

import ctypes
import os
import resource
import signal
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from gripcourse.batch.context import GradingContext
from gripcourse.batch.one_file import grade_file
from gripcourse.grading.model import Report
from gripcourse.machine.content import Readable
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.warm import do_apart
from gripcourse.machine.jobs.workers import in_order, run_each
from gripcourse.machine.shelf import Shelved
from gripcourse.usecases.grading.student_reports import Printing, student_pdf


class Luggage:
    """What jobs share; each unpacking leaves a line in a file."""

    def __init__(self, diary: Path) -> None:
        self.diary = diary

    def __setstate__(self, state: tuple[None, dict[str, Path]] | dict[str, Path]) -> None:
        self.diary = state["diary"] if isinstance(state, dict) else state[1]["diary"]
        with self.diary.open("a", encoding="ascii") as diary:
            diary.write(f"{os.getpid()}\n")


class Unwrappable:
    """What cannot be unpacked where it arrives."""

    def __reduce__(self) -> tuple[object, tuple[str]]:
        return (_refuse, ("lost on the way",))


def environment(name: str, _: None) -> str | None:
    return os.environ.get(name)


def _refuse(said: str) -> None:
    raise RuntimeError(said)


def leave(item: int, _: object) -> int:
    """End the program where a number is odd, as a library does that has nothing else to say."""
    if item % 2:
        raise SystemExit(item)
    return item


def who_does(_item: int, _: None) -> int:
    return os.getpid()


def double(item: int, add: int) -> int:
    time.sleep(0.02 if item == 0 else 0)
    return 2 * item + add


def end_at_negative(item: int, _: object) -> int:
    """End the process where a number is negative."""
    if item < 0:
        os._exit(3)
    return item


def rest(seconds: float, _: object) -> float:
    time.sleep(seconds)
    return seconds


def leave_note(path: str, *_: object) -> None:
    Path(path).write_text(str(os.getpid()), encoding="ascii")


def stop_at_odd(item: int, _: object) -> int:
    if item % 2:
        raise ValueError(f"{item} is odd")
    return item


def carry(item: int, luggage: Luggage) -> int:
    del luggage
    return item


def deaf(item: str, _: object) -> str:
    """Sleep without giving Python's lock away, as a library that hangs; no alarm is heard."""
    if item == "deaf":
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGALRM})
        ctypes.PyDLL(None).sleep(60)
    return item


def memory(_: object, __: object) -> tuple[int, int]:
    return resource.getrlimit(resource.RLIMIT_AS)


def report_and_sleep(folder: Path, _: object) -> None:
    (folder / str(os.getpid())).touch()
    time.sleep(60)


def who(_: object, __: object) -> int:
    return os.getpid()


def spin(seconds: float, _: object) -> float:
    until = time.process_time() + seconds
    while time.process_time() < until:
        pass
    return seconds


def nap(seconds: float, _: object) -> float:
    time.sleep(seconds)
    return seconds


def write(path: Path, _: object) -> int:
    return path.write_bytes(b"1")


def grow(size: int, _: object) -> int:
    assert len(b"1" * size) == size
    return os.getpid()


def vanish(_: object, __: object) -> None:
    os._exit(9)


def obey(order: str, _: object) -> str:
    """Do to a worker what hostile files do."""
    if order == "hang":
        time.sleep(60)
    if order == "vanish":
        os._exit(9)
    if order == "grow":
        assert len(b"1" * (1 << 40))
    return deaf(order, None)


def slowly(file: Readable, context: GradingContext) -> Report:
    """Grade, so that what happens meanwhile happens in the middle."""
    time.sleep(0.1)
    return grade_file(file, context)


def page(report: Report, printing: Printing) -> bytes:
    """Lay out one real page, which takes longest; the others at once."""
    if report.student == "s02":
        return student_pdf(report, printing)
    return f"%PDF-1.7 {printing.graded_on} {report!r}".encode()


if __name__ == "__main__":
    place = Path(sys.argv[1])
    if sys.argv[2:] == ["warm"]:
        from errands import report_and_sleep  # it is found by its name

        do_apart(report_and_sleep, place, None, limits=Limits(), seconds=60)
    else:
        in_order(run_each(report_and_sleep, [place, place], None, workers=2, seconds=60))


def put_more(item: int, shelved: Sequence[int]) -> tuple[int, ...]:
    """Return what lies on a shelf, with something more that this worker puts there."""
    assert isinstance(shelved, Shelved)
    return tuple(shelved.with_changes([(0, item)]))


def hears_interrupts(_: int, __: None) -> bool:
    """Tell whether Ctrl-C ends what this process does."""
    try:
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(5)
    except KeyboardInterrupt:
        return True
    return False
