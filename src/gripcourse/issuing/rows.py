"""The register as rows of its tables, and back again."""

import json
import math
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import date
from typing import Any, Final, TypeAlias

from sqlalchemy import Connection, Select, and_, func, insert, select
from sqlalchemy import Row as SqlRow

from gripcourse.errors import Problem, RegisterError
from gripcourse.issuing import schema
from gripcourse.issuing.register import Register
from gripcourse.issuing.withdrawal import Withdrawal
from gripcourse.issuing.withdrawal_rows import as_withdrawn, fetch_withdrawals, withdrawal_row
from gripcourse.machine.enclosed import is_file_name
from gripcourse.text.words import message
from gripcourse.variants.given_numbers import SharedNames
from gripcourse.variants.model import Issued, Student, Variant

_Row: TypeAlias = dict[str, object]
RowOfTable: TypeAlias = SqlRow[Any]


_AT_ONCE: Final = 500  # rows


def fetch_rows(connection: Connection, course_id: str) -> Sequence[RowOfTable]:
    """Return the rows of a course as they stand now; equal where nothing of it has changed."""
    return connection.execute(_all_of(course_id)).all()


def read_rows(connection: Connection, course_id: str, place: str) -> Register:
    """Return what was issued in a course; see `register_of_rows`."""
    rows = fetch_rows(connection, course_id)
    return register_of_rows(rows, course_id, place, fetch_withdrawals(connection, course_id))


def stream_entries(connection: Connection, course_id: str, place: str) -> Iterator[Issued]:
    """Yield every version that was issued in a course, in this order; few rows are held at a time.

    Errors as for `register_of_rows`.
    """
    options = {"yield_per": _AT_ONCE}
    with connection.execute(_all_of(course_id), execution_options=options) as streamed:
        yield from _entries(streamed, place)


def register_of_rows(
    found: Iterable[RowOfTable],
    course_id: str,
    place: str,
    withdrawals: tuple[Withdrawal, ...] = (),
) -> Register:
    """Put a register together: of each student the last version counts.

    Args:
        found: the rows of the course.
        course_id: of the course.
        place: where the database is, for a person.
        withdrawals: of the course, oldest first.

    Raises:
        RegisterError: a row cannot be read.
    """
    entries: dict[str, Issued] = {}
    earlier: list[Issued] = []
    for entry in _entries(found, place):
        student = entry.student.id
        if student in entries:
            earlier.append(entries[student])
        entries[student] = entry
    return as_withdrawn(Register(course_id, tuple(entries.values()), tuple(earlier), withdrawals))


def _all_of(course_id: str) -> Select[Any]:
    """Ask for all that was issued in a course, each with what the last row of its person says.

    In one question: whoever is issued to meanwhile is in both tables, or in neither.
    """
    one, person, other = schema.issued, schema.persons, schema.persons.alias()
    last = select(func.max(other.c.number)).where(
        other.c.course == one.c.course, other.c.student == one.c.student
    )
    same = and_(
        person.c.course == one.c.course,
        person.c.student == one.c.student,
        person.c.number == last.scalar_subquery(),
    )
    known = (person.c.name, person.c.study_group, person.c.email, person.c.language)
    return (
        select(one, person.c.number.label("person"), *known, person.c.fixed_variant)
        .select_from(one.outerjoin(person, same))
        .where(one.c.course == course_id)
        .order_by(one.c.id)
    )


def _entries(rows: Iterable[RowOfTable], place: str) -> Iterator[Issued]:
    """Put the entries of rows together, one after the other."""
    shared = _CommonParts()
    for row in (one._asdict() for one in rows):
        student = row["student"]
        try:
            entry = _entry(row, shared)
        except (KeyError, TypeError, ValueError) as fault:
            key = message("student {student}", student=student)
            what = message("The entry is damaged: {fault}.", fault=repr(fault))
            remedy = message("Restore the register from a backup; do not edit it by hand.")
            raise RegisterError([Problem(place, key, what, remedy)]) from fault
        yield entry


def fetch_former_names(connection: Connection, course_id: str) -> dict[str, tuple[str, ...]]:
    """Return how persons were written before, by id; who has always been called so is not there."""
    one = schema.persons.c
    corrected = select(one.student).where(one.course == course_id, one.number > 1)
    question = (
        select(one.student, one.name)
        .where(one.course == course_id, one.student.in_(corrected))
        .order_by(one.student, one.number)
    )
    names: dict[str, list[str]] = {}
    for row in connection.execute(question):
        names.setdefault(row.student, []).append(row.name)
    former = {
        student: tuple(one for one in dict.fromkeys(all_) if one != all_[-1])
        for student, all_ in names.items()
    }
    return {student: all_ for student, all_ in former.items() if all_}


def other_courses(connection: Connection, course_id: str) -> tuple[str, ...]:
    """Return the ids of other courses that something was issued in."""
    course = schema.issued.c.course
    question = select(course).where(course != course_id).distinct()
    return tuple(sorted(connection.execute(question).scalars()))


def add_rows(connection: Connection, before: Register, after: Register) -> None:
    """Add what a register has more than before: versions, persons' other data, withdrawals."""
    known, course = before.by_student(), after.course_id
    fresh = [
        one
        for one in after.entries
        if one.student.id not in known or known[one.student.id].version < one.version
    ]
    last = select(func.max(schema.issued.c.id)).where(schema.issued.c.course == course)
    first = (connection.execute(last).scalar() or 0) + 1
    issued = [_issued_row(course, number, one) for number, one in enumerate(fresh, start=first)]
    numbers = _person_numbers(connection, course)
    persons = [
        _person_row(course, numbers.get(one.student.id, 0) + 1, one.student)
        for one in after.entries
        if one.student.id not in known or known[one.student.id].student != one.student
    ]
    withdrawn = [
        withdrawal_row(course, number, one)
        for number, one in enumerate(after.withdrawals, start=1)
        if number > len(before.withdrawals)
    ]
    parts = (schema.issued, issued), (schema.persons, persons), (schema.withdrawals, withdrawn)
    for table, rows in parts:
        if rows:
            connection.execute(insert(table), rows)


def _person_numbers(connection: Connection, course_id: str) -> dict[str, int]:
    one = schema.persons.c
    question = (
        select(one.student, func.max(one.number).label("number"))
        .where(one.course == course_id)
        .group_by(one.student)
    )
    return {row.student: row.number for row in connection.execute(question)}


def _issued_row(course: str, number: int, entry: Issued) -> _Row:
    variant = entry.variant
    # The later day of another id counts as long as the two are joined, and is of that id's row.
    deadline = entry.own_deadline or entry.deadline
    return {
        "course": course,
        "id": number,
        "student": entry.student.id,
        "version": entry.version,
        "variant": variant.id,
        "scheme": variant.scheme,
        "options": json.dumps(dict(variant.options), ensure_ascii=False),
        "given": json.dumps(dict(variant.given), allow_nan=False),
        "signature": entry.signature,
        "issued_on": entry.issued_on.isoformat(),
        "deadline": deadline.isoformat() if deadline else None,
        "declarations": entry.declarations or None,
        "issued_by": entry.issued_by or None,
        "why": entry.why or None,
    }


def _person_row(course: str, number: int, student: Student) -> _Row:
    return {
        "course": course,
        "student": student.id,
        "number": number,
        "name": student.name,
        "study_group": student.group,
        "email": student.email,
        "language": student.language,
        "fixed_variant": student.variant,
    }


@dataclass(frozen=True, slots=True)
class _CommonParts:
    """What many entries have in common, held once: a register may have ten thousand.

    Attributes:
        names: of given numbers.
        options: what variants choose, by its text.
        days: by their texts.
    """

    names: SharedNames = field(default_factory=SharedNames)
    options: dict[str, Mapping[str, str]] = field(default_factory=dict)
    days: dict[str, date] = field(default_factory=dict)

    def chosen(self, written: str) -> Mapping[str, str]:
        """Return options of their text."""
        if written not in self.options:
            pairs = _pairs(written)
            self.options[written] = {sys.intern(name): str(one) for name, one in pairs}
        return self.options[written]

    def day(self, written: str) -> date:
        """Return a day of its text."""
        if written not in self.days:
            self.days[written] = date.fromisoformat(written)
        return self.days[written]


def _entry(row: Mapping[str, Any], shared: _CommonParts) -> Issued:
    """Put an entry together.

    Raises:
        KeyError: there is no such person.
        TypeError, ValueError: a row is not as it was written.
    """
    if row["person"] is None:
        raise KeyError(row["student"])
    deadline = row["deadline"]
    for name in (row["student"], row["variant"]):
        if not is_file_name(name):
            raise ValueError(f"{name!r} cannot name a file")
    return Issued(
        student=Student(
            id=row["student"],
            name=row["name"],
            group=sys.intern(row["study_group"]),
            email=row["email"],
            language=sys.intern(row["language"]),
            variant=row["fixed_variant"],
        ),
        variant=Variant(
            id=row["variant"],
            scheme=sys.intern(row["scheme"]),
            options=shared.chosen(row["options"]),
            given=shared.names.numbers(
                (sys.intern(name), _finite(one)) for name, one in _pairs(row["given"])
            ),
        ),
        issued_on=shared.day(row["issued_on"]),
        deadline=None if deadline is None else shared.day(deadline),
        signature=row["signature"],
        version=row["version"],
        why=row["why"] or "",
        issued_by=row["issued_by"] or "",
        declarations=sys.intern(row["declarations"] or ""),
    )


def _finite(written: Any) -> float:  # noqa: ANN401 (whatever stands in the row)
    number = float(written)
    if not math.isfinite(number):
        raise ValueError(f"{written!r} is not a finite number")
    return number


def _pairs(written: str) -> Iterable[tuple[str, Any]]:
    found = json.loads(written)
    if not isinstance(found, dict):
        raise TypeError(f"{written!r} is not a table")
    return found.items()
