"""When works were handed in: as a person or a platform says, else by the file's own time."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path, PurePath
from zoneinfo import ZoneInfo

from gripcourse.errors import Problem, UsageError
from gripcourse.exports.platforms.moodle_worksheet import handed_in_moments, read_worksheet
from gripcourse.gradebook.deadlines import doubt_about, moment_of
from gripcourse.grading.platforms import platform_part
from gripcourse.machine.content import Readable, shown_name
from gripcourse.text.shown import shown
from gripcourse.text.words import Message, message
from gripcourse.usecases.marks.batch_wish import is_table


@dataclass(frozen=True, slots=True)
class HandingTime:
    """When a file was handed in.

    Attributes:
        at: the moment; of two that a platform's table may mean the earlier one.
        said: whether a person says so.
        later: the other one; None where there is no doubt.
        doubt: what is doubtful, and how a person writes which of both it is.
    """

    at: datetime
    said: bool
    later: datetime | None = None
    doubt: tuple[Message, Message] | None = None


def handed_in_times(
    written: Iterable[str], files: Sequence[Readable], zone: ZoneInfo
) -> Mapping[str, HandingTime]:
    """Return when each file was handed in, by its name; of bytes without a word nobody knows.

    Args:
        written: what a person says: `TIME` for all files, or `file=TIME`, where a file is named by
            the end of its path; or a platform's grading worksheet. The last one of a file counts.
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
        if is_table(one):
            times |= _of_worksheet(Path(one), files, zone, problems)
            continue
        name, _, moment = (part.strip() for part in one.rpartition("="))
        at = moment_of(moment, zone)
        named = [file for file in map(shown_name, files) if not name or _ends_so(file, name)]
        if (doubt := doubt_about(moment, zone)) is not None:
            problems.append(Problem("", "", *doubt, parameter="handed_in"))
            continue
        if at is None:
            what = message("'{text}' is no day.", text=moment)
        elif not named:
            what = message("No file of the batch is called '{file}'.", file=name)
        else:
            times |= {shown(file): HandingTime(at, said=True) for file in named}
            continue
        remedy = message(
            "Write 2026-12-01 18:00, or file=2026-12-01 18:00 for one file, or the name of a"
            " grading worksheet."
        )
        problems.append(Problem("", "", what, remedy, parameter="handed_in"))
    if problems:
        raise UsageError(problems)
    return times


def _of_worksheet(
    path: Path, files: Sequence[Readable], zone: ZoneInfo, problems: list[Problem]
) -> dict[str, HandingTime]:
    """Return the times of the files that a platform handed out together with its worksheet."""
    moments = handed_in_moments(read_worksheet(path))
    found = dict(_matched(moments, files, zone))
    if not found:
        what = message("No file of the batch has the number and the name of a row.")
        remedy = message("Grade the zip that the platform handed out together with this worksheet.")
        problems.append(Problem(str(path), "", what, remedy, parameter="handed_in"))
    return found


def _matched(
    moments: Mapping[str, tuple[str, str]], files: Sequence[Readable], zone: ZoneInfo
) -> Iterator[tuple[str, HandingTime]]:
    for file in map(shown_name, files):
        part = platform_part(file)
        if part is None or part.identifier not in moments:
            continue
        name, written = moments[part.identifier]
        at = moment_of(written, zone)
        if part.stands_for(name) and at is not None:
            yield shown(file), _of_platform(at, doubt_about(written, zone))


def _of_platform(at: datetime, doubt: tuple[Message, Message] | None) -> HandingTime:
    """Return the earlier moment that a platform's clock may mean: it costs the student nothing."""
    if doubt is None:
        return HandingTime(at, said=True)
    earlier, later = sorted(at.replace(fold=one).astimezone(UTC) for one in (0, 1))
    return HandingTime(earlier, said=True, later=later, doubt=doubt)


def _ends_so(name: str, end: str) -> bool:
    parts, last = PurePath(name).parts, PurePath(end).parts
    return name == end or parts[-len(last) :] == last
