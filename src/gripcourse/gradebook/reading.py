"""Attempts as they are read from their tables: with their results, or without."""

from collections.abc import Collection, Iterator
from dataclasses import replace
from datetime import datetime
from itertools import groupby
from operator import itemgetter
from typing import Any, Final

from sqlalchemy import Connection, Row, Select, Table, select

from gripcourse.gradebook import rows, schema
from gripcourse.gradebook.model import Attempt
from gripcourse.gradebook.results import Result
from gripcourse.machine.database.moments import in_utc
from gripcourse.machine.database.storable import in_code_order

_ASKED_AT_ONCE: Final = 50  # students in one question; databases bound how many
_AT_ONCE: Final = 500  # rows


def read_attempts(connection: Connection, students: Collection[str] | None) -> tuple[Attempt, ...]:
    """Return the attempts of students (all where None), oldest first for each."""
    found = [one for one, _ in read_heads(connection, students)]
    # After them: results of an attempt that is added in between belong to none of these.
    column = schema.results.c
    ordered = in_code_order(connection.engine, column.student, column.attempt, column.place)
    lines = answers(connection, _lines().order_by(*ordered), schema.results, students)
    results = {
        key: rows.results_of_rows(group) for key, group in groupby(lines, key=itemgetter(0, 1))
    }
    return tuple(replace(one, results=results.get((one.student, one.number), ())) for one in found)


def read_heads(
    connection: Connection, students: Collection[str] | None
) -> Iterator[tuple[Attempt, str]]:
    """Yield the attempts of students without their results, and the digest of these.

    The digest is empty for an attempt that was kept before there were digests.
    """
    column = schema.attempts.c
    ordered = in_code_order(connection.engine, column.student, column.number)
    question = select(schema.attempts).order_by(*ordered)
    for row in answers(connection, question, schema.attempts, students):
        yield rows.attempt_of_row(row, ()), row.results_digest or ""


def read_files(connection: Connection) -> Iterator[tuple[str, str, str]]:
    """Yield student, file and digest of every attempt, in the order in which they were graded."""
    column = schema.attempts.c
    question = select(column.student, column.file, column.digest).order_by(
        column.graded_at, column.student, column.number
    )
    for row in connection.execute(question):
        yield row.student, row.file, row.digest


def read_results(connection: Connection, attempt: Attempt) -> tuple[Result, ...]:
    """Return the results of one attempt."""
    column = schema.results.c
    question = (
        _lines()
        .where(column.student == attempt.student, column.attempt == attempt.number)
        .order_by(column.place)
    )
    return rows.results_of_rows(connection.execute(question))


def read_told(connection: Connection, students: Collection[str]) -> dict[tuple[str, int], datetime]:
    """Return by id and number of each attempt of ids when its student was told of it last."""
    one = schema.publications.c
    question = select(one.student, one.attempt, one.done_at).order_by(one.done_at)
    found = answers(connection, question, schema.publications, students)
    return {(row.student, row.attempt): in_utc(row.done_at) for row in found}


def answers(
    connection: Connection, question: Select[Any], table: Table, students: Collection[str] | None
) -> Iterator[Row[Any]]:
    """Ask in portions of students, in the order of their ids; all at once where None.

    Rows come as they are asked for: those of a whole cohort take more room than what they say.
    """
    if students is None:
        with connection.execute(question, execution_options={"yield_per": _AT_ONCE}) as streamed:
            yield from streamed
        return
    names = sorted(students)
    portions = [
        names[start : start + _ASKED_AT_ONCE] for start in range(0, len(names), _ASKED_AT_ONCE)
    ]
    for portion in portions:
        yield from connection.execute(question.where(table.c.student.in_(portion)))


def _lines() -> Select[Any]:
    # Not joined with attempts: their moments would be read once for each result.
    one = schema.results.c
    return select(one.student, one.attempt, one.quantity, one.outcome, one.points, one.max_points)
