"""Deadlines: of everybody, of a group, of one student, in the course's time zone."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date, datetime, time
from pathlib import Path
from zoneinfo import ZoneInfo

from gripcourse.errors import Problem, TableError
from gripcourse.machine.content import Readable
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message
from gripcourse.variants.model import Issued
from gripcourse.variants.sheet import Sheet, SheetRow, cell_place, read_sheet

_COLUMNS = ("group", "student", "deadline")
_WRITTEN = re.compile(r"(\d{4}-\d{2}-\d{2})(?:[ T](\d{1,2}:\d{2})(?::\d{2})?)?")
_OFFICE = re.compile(r"(\d{1,2})\.(\d{1,2})\.(\d{4})(?=[ T]|$)")  # as offices write days here
_END_OF_DAY = time(23, 59, 59)


@dataclass(frozen=True, slots=True)
class Deadline:
    """A row: for a student, else for a group, else for everybody."""

    group: str
    student: str
    at: datetime


def deadlines_path(root: Path) -> Path:
    """Where a course keeps its deadlines, if it has any besides those that it issued with."""
    return root / "variants" / "deadlines.csv"


def deadline_of(issued: Issued, rows: tuple[Deadline, ...], zone: ZoneInfo) -> datetime | None:
    """Return the deadline of a student: the nearest row, else the day that was issued with."""
    student = issued.student
    wanted = ((student.group, student.id), ("", student.id), (student.group, ""), ("", ""))
    for group, name in wanted:
        for row in rows:
            if (row.group, row.student) == (group, name):
                return row.at
    if issued.deadline is None:
        return None
    return datetime.combine(issued.deadline, _END_OF_DAY, zone)


def read_deadlines(source: Readable, zone: ZoneInfo) -> tuple[Deadline, ...]:
    """Read a table of deadlines with the columns `group`, `student` and `deadline`.

    Args:
        source: the table. A deadline is a day, whose last second counts, or a day with a time.
        zone: of the course.

    Raises:
        TableError: with all problems, by row and column.
    """
    sheet = read_sheet(source, lambda text: text in _COLUMNS)
    problems = list(_heading_problems(sheet))
    if problems:
        raise TableError(problems)
    rows = [_row(sheet, row, zone, problems) for row in sheet.rows]
    seen: set[tuple[str, str]] = set()
    for row, one in zip(sheet.rows, rows, strict=True):
        if one is not None and (one.group, one.student) in seen:
            what = message("There is a second deadline for the same people.")
            remedy = message("Leave one of them.")
            problems.append(Problem(sheet.file, cell_place(row.number, "deadline"), what, remedy))
        if one is not None:
            seen.add((one.group, one.student))
    if problems:
        raise TableError(problems)
    return tuple(one for one in rows if one is not None)


def moment_of(written: str, zone: ZoneInfo) -> datetime | None:
    """Read a day, whose last second is meant, or a day with a time; None where it is neither."""
    iso = _OFFICE.sub(lambda day: f"{day[3]}-{day[2]:0>2}-{day[1]:0>2}", written.strip(), count=1)
    found = _WRITTEN.fullmatch(iso)
    if found is None:
        return None
    try:
        day = date.fromisoformat(found[1])
        at = time.fromisoformat(found[2].zfill(5)) if found[2] else _END_OF_DAY
    except ValueError:
        return None
    return datetime.combine(day, at, zone)


def _row(sheet: Sheet, row: SheetRow, zone: ZoneInfo, problems: list[Problem]) -> Deadline | None:
    cells = dict(zip(sheet.header, row.cells, strict=True))
    at = moment_of(cells["deadline"], zone)
    if at is None:
        what = message("'{text}' is no day.", text=cells["deadline"])
        remedy = message("Write 2026-12-01, or 2026-12-01 18:00.")
        problems.append(Problem(sheet.file, cell_place(row.number, "deadline"), what, remedy))
        return None
    return Deadline(cells.get("group", ""), cells.get("student", ""), at)


def _heading_problems(sheet: Sheet) -> Iterator[Problem]:
    if "deadline" not in sheet.header:
        what = message("The column '{name}' is missing.", name="deadline")
        remedy = message("Write its name into the first row.")
        yield Problem(sheet.file, cell_place(1, "deadline"), what, remedy)
    for name in sheet.header:
        if name not in _COLUMNS:
            what = message("There is no column '{name}' in a table of deadlines.", name=name)
            yield Problem(sheet.file, cell_place(1, name), what, did_you_mean(name, _COLUMNS))
