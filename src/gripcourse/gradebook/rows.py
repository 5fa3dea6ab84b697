"""Attempts and marks as rows of the tables, and back again."""

from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from sys import intern
from typing import TypeAlias

from sqlalchemy import RowMapping

from gripcourse.gradebook.model import Attempt, Fingerprints, Mark, Result
from gripcourse.grading.outcome import outcome_named

Row: TypeAlias = dict[str, object]
"""Values by column, as they are inserted."""


def attempt_row(attempt: Attempt) -> Row:
    """Return the row of an attempt, without its results."""
    return {
        "student": attempt.student,
        "number": attempt.number,
        "variant": attempt.variant,
        "scheme": attempt.scheme,
        "file": attempt.file,
        "digest": attempt.digest,
        "graded_at": stored(attempt.graded_at),
        "course": attempt.fingerprints.course,
        "policy": attempt.fingerprints.policy,
        "engine": attempt.fingerprints.engine or None,
        "regrade": attempt.regrade,
        "handed_in": None if attempt.handed_in is None else stored(attempt.handed_in),
        "handed_in_said": attempt.handed_in_said,
        "judged": attempt.judged,
        "version": attempt.version,
        "either_version": attempt.either_version,
    }


def result_rows(attempt: Attempt) -> Iterator[Row]:
    """Yield the rows of an attempt's results."""
    for place, result in enumerate(attempt.results, start=1):
        yield {
            "student": attempt.student,
            "attempt": attempt.number,
            "place": place,
            "quantity": result.quantity,
            "outcome": result.outcome.value,
            "points": result.points,
            "max_points": result.max_points,
        }


def mark_row(mark: Mark) -> Row:
    """Return the row of a mark, without its lines."""
    return {
        "student": mark.student,
        "quantity": mark.quantity,
        "number": mark.number,
        "supersedes": mark.supersedes,
        "attempt": mark.attempt,
        "credit": mark.credit,
        "marker": mark.marker,
        "marked_at": stored(mark.marked_at),
        "comment": mark.comment,
    }


def line_rows(mark: Mark) -> Iterator[Row]:
    """Yield the rows of a mark's lines."""
    for line, credit in mark.lines.items():
        yield {
            "student": mark.student,
            "quantity": mark.quantity,
            "mark": mark.number,
            "line": line,
            "credit": credit,
        }


def attempt_of_rows(rows: Sequence[RowMapping]) -> Attempt:
    """Put an attempt together from its row, joined with the row of each result (or with none)."""
    first = rows[0]
    return Attempt(
        student=first["student"],
        number=first["number"],
        variant=first["variant"],
        scheme=first["scheme"],
        file=first["file"],
        digest=first["digest"],
        graded_at=in_utc(first["graded_at"]),
        fingerprints=Fingerprints(first["course"], first["policy"], first["engine"] or ""),
        judged=first["judged"],
        results=tuple(
            Result(
                # One text for all attempts, of which a cohort has thousands.
                intern(row["quantity"]),
                outcome_named(row["outcome"]),
                row["points"],
                row["max_points"],
            )
            for row in rows
            if row["quantity"] is not None
        ),
        regrade=first["regrade"],
        handed_in=None if first["handed_in"] is None else in_utc(first["handed_in"]),
        handed_in_said=bool(first["handed_in_said"]),
        version=first["version"] or 1,
        either_version=bool(first["either_version"]),
    )


def mark_of_rows(rows: Sequence[RowMapping]) -> Mark:
    """Put a mark together from its row, joined with the row of each line (or with none)."""
    first = rows[0]
    return Mark(
        student=first["student"],
        quantity=first["quantity"],
        number=first["number"],
        attempt=first["attempt"],
        credit=first["credit"],
        lines={row["line"]: row["line_credit"] for row in rows if row["line"] is not None},
        marker=first["marker"],
        marked_at=in_utc(first["marked_at"]),
        comment=first["comment"],
    )


def stored(moment: datetime) -> datetime:
    """Return a moment in UTC without saying so: not every database keeps time zones."""
    return moment.astimezone(UTC).replace(tzinfo=None)


def in_utc(moment: datetime) -> datetime:
    """Return a stored moment with its time zone."""
    return moment.replace(tzinfo=UTC)
