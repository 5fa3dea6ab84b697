"""Deadlines: of everybody, of a group, of one student, in the course's time zone."""

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, date, datetime, time
from pathlib import Path
from typing import Final
from zoneinfo import ZoneInfo

from gripcourse.errors import Problem, TableError
from gripcourse.issuing.same_person import letters_of
from gripcourse.machine.content import Readable
from gripcourse.machine.resources import deadlines_path
from gripcourse.policy.time_rules import LateRule, zone_of
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message
from gripcourse.variants.headings import by_ids, words_vocabulary
from gripcourse.variants.model import Issued, Student
from gripcourse.variants.sheet import Sheet, SheetRow, cell_place, read_sheet

_COLUMNS = ("group", "student", "deadline")
_WRITTEN = re.compile(
    r"(\d{4}-\d{2}-\d{2})(?:[ T](\d{1,2}):(\d{2})(?::(\d{2}))?(?: ?([+-]\d{2}):?(\d{2}))?)?",
    re.ASCII,
)
_OFFICE = re.compile(r"(\d{1,2})\.(\d{1,2})\.(\d{4})(?=[ T]|$)")  # as offices write days here
END_OF_DAY: Final = time(23, 59, 59)
"""The last second of a day, which still counts."""


@dataclass(frozen=True, slots=True)
class Deadline:
    """A row: for a student, else for a group, else for everybody."""

    group: str
    student: str
    at: datetime


def course_deadlines(
    root: Path, rule: LateRule | None, people: Collection[Student] = ()
) -> tuple[Deadline, ...]:
    """Read a course's own table of deadlines; empty where it has none or lateness costs nothing.

    A table that cannot be used is refused there too: who writes it should hear so now, not when
    lateness begins to cost something.

    Args:
        root: of the course.
        rule: of lateness; None where it costs nothing.
        people: see `read_deadlines`.

    Raises:
        TableError: the table cannot be used.
    """
    path = deadlines_path(root)
    rows = read_deadlines(path, zone_of(rule), people) if path.is_file() else ()
    return () if rule is None else rows


def deadline_by_rule(
    issued: Issued | None, rows: tuple[Deadline, ...], rule: LateRule | None
) -> datetime | None:
    """Return the deadline of a student; None where there is none, or where lateness is free."""
    if issued is None or rule is None:
        return None
    return deadline_of(issued, rows, rule.time_zone)


def deadline_of(issued: Issued, rows: tuple[Deadline, ...], zone: ZoneInfo) -> datetime | None:
    """Return the deadline of a student: the nearest row, else the day that was issued with.

    Who is listed under several ids, in several groups perhaps, has the latest of their deadlines.
    """
    day = issued.deadline
    issued_with = None if day is None else last_of(datetime.combine(day, END_OF_DAY, zone))
    found = (_nearest(one, rows) or issued_with for one in (issued.student, *issued.joined))
    return max((at for at in found if at is not None), default=None, key=datetime.timestamp)


def _nearest(student: Student, rows: tuple[Deadline, ...]) -> datetime | None:
    group = _one_group(student.group)
    by_whom = {_whom(row): row.at for row in rows}
    for whom in ((group, student.id), ("", student.id), (group, ""), ("", "")):
        if whom in by_whom:
            return by_whom[whom]
    return None


def last_of(deadline: datetime) -> datetime:
    """Return the last moment that a deadline may mean, where clocks show an hour twice."""
    return max(deadline, deadline.replace(fold=1), key=datetime.timestamp)


def read_deadlines(
    source: Readable, zone: ZoneInfo, people: Collection[Student] = ()
) -> tuple[Deadline, ...]:
    """Read a table of deadlines with the columns `group`, `student` and `deadline`.

    Args:
        source: the table, with headings in any language. A deadline is a day, whose last second
            counts, or a day with a time.
        zone: of the course.
        people: everybody whom a deadline may concern; where given, a row for nobody of them is a
            problem.

    Raises:
        TableError: with all problems, by row and column.
    """
    vocabulary = words_vocabulary("deadlines")
    sheet, called = by_ids(read_sheet(source, vocabulary.is_heading), vocabulary)
    problems = list(_heading_problems(sheet))
    if problems:
        raise TableError(problems)
    groups = {one.id: one.group for one in people}
    found: dict[tuple[str, str], Deadline] = {}
    for row in sheet.rows:
        one = _row(sheet, row, zone, called, problems)
        if one is None:
            continue
        if _whom(one) in found:
            what = message("There is a second deadline for the same people.")
            place = cell_place(row.number, called["deadline"])
            problems.append(Problem(sheet.file, place, what, message("Leave one of them.")))
        found[_whom(one)] = one
        problems += _nobody(sheet.file, row, one, called, groups)
    if problems:
        raise TableError(problems)
    return tuple(found.values())


def moment_of(written: str, zone: ZoneInfo) -> datetime | None:
    """Read a day, whose last second is meant, or a day with a time; None where it is neither.

    A time may say how far it is from UTC (`2026-10-25 03:30+02:00`): clocks may show it twice.
    """
    found = _parts_of(written)
    if found is None:
        return None
    try:
        day = date.fromisoformat(found[1])
        hours, minutes, seconds = (int(one or 0) for one in found.groups()[1:4])
        at = time(hours, minutes, seconds) if found[2] else END_OF_DAY
        if not found[5]:
            return datetime.combine(day, at, zone)
        return datetime.fromisoformat(f"{day}T{at}{found[5]}:{found[6]}").astimezone(zone)
    except (ValueError, OverflowError):
        return None


def last_moment_of(written: str, zone: ZoneInfo) -> datetime | None:
    """Read a deadline as above: of a day that ends twice the last second."""
    at, found = moment_of(written, zone), _parts_of(written)
    return at if at is None or found is None or found[5] else last_of(at)


def doubt_about(written: str, zone: ZoneInfo) -> tuple[Message, Message] | None:
    """Say what is doubtful about a moment, and how to write it; None for nothing.

    Where clocks are set back they show an hour twice; where they are set forward, one never.
    """
    at, found = moment_of(written, zone), _parts_of(written)
    if at is None or found is None or not found[2] or found[5]:
        return None
    first, second = at.replace(fold=0), at.replace(fold=1)
    if first.utcoffset() == second.utcoffset():
        return None
    if first.timestamp() < second.timestamp():
        what = message("Clocks show {moment} twice: they are set back.", moment=_shown(at))
        both = (one.isoformat(" ", "minutes") for one in (first, second))
    else:
        what = message("Clocks never show {moment}: they are set forward.", moment=_shown(at))
        both = (_shown(one.astimezone(UTC).astimezone(zone)) for one in (second, first))
    earlier, later = both
    return what, message("Write {earlier} or {later}.", earlier=earlier, later=later)


def _shown(moment: datetime) -> str:
    return f"{moment:%Y-%m-%d %H:%M}"


def _parts_of(written: str) -> re.Match[str] | None:
    iso = _OFFICE.sub(lambda day: f"{day[3]}-{day[2]:0>2}-{day[1]:0>2}", written.strip(), count=1)
    return _WRITTEN.fullmatch(iso)


def _nobody(
    file: str,
    row: SheetRow,
    deadline: Deadline,
    called: Mapping[str, str],
    groups: Mapping[str, str],
) -> Iterator[Problem]:
    """Say whom of those that a deadline names nobody knows: it would be nobody's, silently."""
    if not groups:
        return
    group, student = deadline.group, deadline.student
    if student and student not in groups:
        what = message("The register has no student '{student}'.", student=student)
        place = cell_place(row.number, called["student"])
        yield Problem(file, place, what, did_you_mean(student, groups))
    elif student and group and _one_group(groups[student]) != _one_group(group):
        what = message("{student} is not in group '{group}'.", student=student, group=group)
        place = cell_place(row.number, called["group"])
        yield Problem(file, place, what, message("Leave the group or the student out."))
    elif group and not student and _one_group(group) not in map(_one_group, groups.values()):
        what = message("Nobody is in group '{group}'.", group=group)
        place = cell_place(row.number, called["group"])
        yield Problem(file, place, what, did_you_mean(group, {*groups.values()} - {""}))


def _whom(deadline: Deadline) -> tuple[str, str]:
    """Return whom a row is for, as it is looked up."""
    return _one_group(deadline.group), deadline.student


def _one_group(written: str) -> str:
    """Return by what a group is the same however it is written; what has no letter is itself."""
    return letters_of(written) or written


def _row(
    sheet: Sheet,
    row: SheetRow,
    zone: ZoneInfo,
    called: Mapping[str, str],
    problems: list[Problem],
) -> Deadline | None:
    cells = dict(zip(sheet.header, row.cells, strict=True))
    written = cells["deadline"]
    at, doubt = last_moment_of(written, zone), doubt_about(written, zone)
    if at is not None and doubt is None:
        return Deadline(cells.get("group", ""), cells.get("student", ""), at)
    said = doubt or (
        message("'{text}' is no day.", text=written),
        message("Write 2026-12-01, or 2026-12-01 18:00."),
    )
    place = cell_place(row.number, called["deadline"])
    problems.append(Problem(sheet.file, place, *said))
    return None


def _heading_problems(sheet: Sheet) -> Iterator[Problem]:
    if "deadline" not in sheet.header:
        what = message("The column '{name}' is missing.", name="deadline")
        remedy = message("Write its name into the first row.")
        yield Problem(sheet.file, cell_place(sheet.heading_row, "deadline"), what, remedy)
    for position, name in enumerate(sheet.header):
        if name not in _COLUMNS:
            what = message("There is no column '{name}' in a table of deadlines.", name=name)
            place = cell_place(sheet.heading_row, name)
            yield Problem(sheet.file, place, what, did_you_mean(name, _COLUMNS))
        elif sheet.header.count(name) > 1 and sheet.header.index(name) == position:
            what = message("Two columns are called '{name}'.", name=name)
            place = cell_place(sheet.heading_row, name)
            yield Problem(sheet.file, place, what, message("Leave one of them."))
