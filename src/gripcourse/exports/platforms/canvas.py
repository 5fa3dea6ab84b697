"""Canvas' gradebook: the smallest table that its import takes, made from an exported one.

Ids, sections and the row of possible points come from the export; only one assignment's points are
filled in. Totals and other assignments are left out, so that nothing else can change.
"""

import csv
import io
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.exports.csv_text import text_cell
from gripcourse.exports.platforms.matching import match
from gripcourse.exports.platforms.raw_table import RawTable, read_raw_table
from gripcourse.exports.platforms.works import GradedWork, PlatformRow
from gripcourse.machine.content import Readable
from gripcourse.text.words import Message, message

_PERSON: Final = ("Student", "LastName", "FirstName", "ID")
_KNOWN: Final = frozenset({*_PERSON, "SIS User ID", "SIS Login ID", "Integration ID", "Section"})
_LAST: Final = "Section"
_ASSIGNMENT: Final = re.compile(r"(?P<title>.*) \((?P<id>\d+)\)")
_POSSIBLE: Final = "Points Possible"
_READ_ONLY: Final = "read only"
_EXCUSED: Final = {"EX", "Excused"}
_BYTE_ORDER: Final = ("utf-8-sig", "utf-8")


@dataclass(frozen=True, slots=True)
class FilledGradebook:
    """A table for Canvas.

    Attributes:
        content: the file.
        filled: how many rows have new points.
        notes: works without a row, each with the reason, and what Canvas will not take.
    """

    content: bytes
    filled: int
    notes: tuple[Message, ...]


def fill_gradebook(
    source: Readable,
    works: Sequence[GradedWork],
    assignment: str,
    people: Mapping[str, str] = MappingProxyType({}),
) -> FilledGradebook:
    """Make the table that Canvas imports.

    Args:
        source: the gradebook as Canvas exported it.
        works: that count.
        assignment: title or number of the assignment; empty where there is only one.
        people: the name of everybody in the register, by id.

    Raises:
        UsageError: the table is none of Canvas', or it is not clear which assignment is meant.
        OSError: it cannot be read.
    """
    table = read_raw_table(source, lambda header: len(_KNOWN & {cell.strip() for cell in header}))
    kept = _kept_columns(table)
    column = _assignment_column(table, kept[-1], assignment)
    places = {cell.strip(): place for place, cell in enumerate(table.header)}
    listed = tuple(_people(table, places))
    matching = match(works, [row for _, row in listed], table.file, people)
    possible = _possible(table, column)
    about = tuple(_locked(table, column)) or tuple(_without_points(table, column, possible))
    notes = [*about, *matching.notes]
    rows: list[list[str]] = []
    filled = 0
    for place, cells in enumerate(table.rows):
        is_header = place == 0 or (cells and _POSSIBLE in cells[0])
        row = next((row for at, row in listed if at == place), None)
        if not is_header and row is None:
            continue
        cell = cells[column]
        work = None if row is None else matching.works.get(row.line)
        if work is not None and cell.strip() in _EXCUSED:
            notes.append(_excused(work))
        elif work is not None:
            cell, filled = f"{work.share * (possible or work.total):.2f}", filled + 1
        rows.append([*(text_cell(cells[at]) for at in kept), cell])
    return FilledGradebook(_written(rows, table), filled, tuple(notes))


def _kept_columns(table: RawTable) -> list[int]:
    places = {cell.strip(): place for place, cell in enumerate(table.header)}
    halves = ["LastName", "FirstName"]
    is_split = "Student" not in places and any(one in places for one in halves)
    first = halves if is_split else ["Student"]
    missing = [one for one in (*first, "ID", _LAST) if one not in places]
    if missing:
        what = message(
            "No heading is {missing}. The headings are: {found}.",
            missing=", ".join(missing),
            found=", ".join(table.header),
        )
        remedy = message("Export the gradebook from Canvas and name that file.")
        raise UsageError([Problem(table.file, "", what, remedy)])
    # Canvas knows the ids of another system only where the login stands among them.
    others = ["SIS User ID", "SIS Login ID"] if "SIS Login ID" in places else []
    kept = [*first, "ID", *others, _LAST]
    return [places[one] for one in kept if one in places]


def _assignment_column(table: RawTable, after: int, wanted: str) -> int:
    found = {
        place: cell
        for place, cell in enumerate(table.header)
        if place > after and (part := _ASSIGNMENT.fullmatch(cell.strip()))
        if wanted in {"", cell.strip(), part["title"], part["id"]}
    }
    if len(found) == 1:
        return next(iter(found))
    everything = ", ".join(
        cell for cell in table.header[after + 1 :] if _ASSIGNMENT.fullmatch(cell)
    )
    what = message("It is not clear which assignment is meant: {found}.", found=everything or "—")
    remedy = message("Name one of them by its title or its number.")
    raise UsageError([Problem(table.file, "", what, remedy, parameter="assignment")])


def _people(table: RawTable, places: dict[str, int]) -> Iterator[tuple[int, PlatformRow]]:
    identifier = places["ID"]
    names = [places[one] for one in ("LastName", "FirstName", "Student") if one in places]
    keys = [
        places[one] for one in ("SIS User ID", "SIS Login ID", "Integration ID") if one in places
    ]
    for place, cells in enumerate(table.rows[1:], start=1):
        if cells and cells[identifier].strip().isdecimal():
            name = " ".join(cells[at] for at in names)
            other = tuple(cells[at] for at in keys)
            yield place, PlatformRow(place + 1, cells[identifier].strip(), other, name)


def _possible(table: RawTable, column: int) -> float | None:
    """Return the points that the assignment has there; the last separator is the decimal one."""
    for cells in table.rows:
        if cells and _POSSIBLE in cells[0]:
            whole, point, rest = cells[column].strip().replace(",", ".").rpartition(".")
            try:
                possible = float(f"{whole.replace('.', '')}{point}{rest}")
            except ValueError:
                return None
            return possible if math.isfinite(possible) else None
    return None


def _locked(table: RawTable, column: int) -> Iterator[Message]:
    """Say where Canvas leaves the whole column alone without a word."""
    if any(cells and _POSSIBLE in cells[0] and _READ_ONLY in cells[column] for cells in table.rows):
        yield message(
            "Canvas takes no points for {assignment}: it says that this column is read only.",
            assignment=table.header[column].strip(),
        )


def _without_points(table: RawTable, column: int, possible: float | None) -> Iterator[Message]:
    """Say that points are written as ours where Canvas has none for the assignment."""
    if not possible:
        yield message(
            "Canvas has no possible points for {assignment}: its points were written as they are"
            " here.",
            assignment=table.header[column].strip(),
        )


def _excused(work: GradedWork) -> Message:
    return message(
        "{student} is excused in Canvas; this was left as it is.",
        student=work.said,
    )


def _written(rows: Sequence[Sequence[str]], table: RawTable) -> bytes:
    stream = io.StringIO(newline="")
    csv.writer(stream, delimiter=table.separator, lineterminator="\n").writerows(rows)
    # Canvas knows the heading LastName only where no byte order mark stands before it.
    marked, plain = _BYTE_ORDER
    encoding = plain if table.encoding == marked else table.encoding
    return stream.getvalue().encode(encoding, errors="replace")
