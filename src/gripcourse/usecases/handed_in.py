"""When works were handed in: as a person says, else by the file's own time."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path, PurePath
from zoneinfo import ZoneInfo

from gripcourse.errors import Problem, UsageError
from gripcourse.gradebook.deadlines import moment_of
from gripcourse.machine.content import Readable, shown_name
from gripcourse.text.shown import shown
from gripcourse.text.words import message


@dataclass(frozen=True, slots=True)
class HandingTime:
    """When a file was handed in, and whether a person says so."""

    at: datetime
    said: bool


def handed_in_times(
    written: Iterable[str], files: Sequence[Readable], zone: ZoneInfo
) -> Mapping[str, HandingTime]:
    """Return when each file was handed in, by its name; of bytes without a word nobody knows.

    Args:
        written: what a person says: `TIME` for all files, or `file=TIME`, where a file is named by
            the end of its path; the last one of a file counts.
        files: of the batch.
        zone: of the course.

    Raises:
        UsageError: with everything that cannot be used.
    """
    times = {
        shown(str(one)): HandingTime(datetime.fromtimestamp(one.stat().st_mtime, UTC), said=False)
        for one in files
        if isinstance(one, Path) and one.exists()
    }
    problems: list[Problem] = []
    for one in written:
        name, _, moment = (part.strip() for part in one.rpartition("="))
        at = moment_of(moment, zone)
        named = [file for file in map(shown_name, files) if not name or _ends_so(file, name)]
        if at is None:
            what = message("'{text}' is no day.", text=moment)
        elif not named:
            what = message("No file of the batch is called '{file}'.", file=name)
        else:
            times |= {shown(file): HandingTime(at, said=True) for file in named}
            continue
        remedy = message("Write 2026-12-01 18:00, or file=2026-12-01 18:00 for one file.")
        problems.append(Problem("", "", what, remedy, parameter="handed_in"))
    if problems:
        raise UsageError(problems)
    return times


def _ends_so(name: str, end: str) -> bool:
    parts, last = PurePath(name).parts, PurePath(end).parts
    return name == end or parts[-len(last) :] == last
