"""Attempts and marks as rows of the tables, and back again."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, TypeAlias

from sqlalchemy import Row as SqlRow

from gripcourse.gradebook.model import Attempt, Fingerprints, Mark
from gripcourse.gradebook.results import Result, digest_of_results, result_of
from gripcourse.grading.outcome import outcome_named
from gripcourse.machine.database.moments import in_utc, stored

Row: TypeAlias = dict[str, object]
"""Values by column, as they are inserted."""
RowOfTable: TypeAlias = SqlRow[Any]


def attempt_row(attempt: Attempt) -> Row:
    """Return the row of an attempt, without its results."""
    student, number = attempt.key
    return {
        "student": student,
        "number": number,
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
        "results_digest": digest_of_results(attempt.results),
    }


def result_rows(attempt: Attempt) -> Iterator[Row]:
    """Yield the rows of an attempt's results."""
    student, number = attempt.key
    for place, result in enumerate(attempt.results, start=1):
        yield {
            "student": student,
            "attempt": number,
            "place": place,
            "quantity": result.quantity,
            "outcome": result.outcome.value,
            "points": result.points,
            "max_points": result.max_points,
        }


def mark_row(mark: Mark) -> Row:
    """Return the row of a mark, without its lines."""
    return {
        "student": mark.kept_under,
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
            "student": mark.kept_under,
            "quantity": mark.quantity,
            "mark": mark.number,
            "line": line,
            "credit": credit,
        }


def results_of_rows(rows: Iterable[RowOfTable]) -> tuple[Result, ...]:
    """Return the results of one attempt.

    Args:
        rows: of each its attempt's student and number, quantity, outcome and both points.
    """
    return tuple(
        result_of(quantity, outcome_named(outcome), points, most)
        for _, _, quantity, outcome, points, most in map(tuple, rows)
    )


def attempt_of_row(row: RowOfTable, results: tuple[Result, ...]) -> Attempt:
    """Put an attempt together from its row and its results."""
    return Attempt(
        student=row.student,
        number=row.number,
        variant=row.variant,
        scheme=row.scheme,
        file=row.file,
        digest=row.digest,
        graded_at=in_utc(row.graded_at),
        fingerprints=Fingerprints(row.course, row.policy, row.engine or ""),
        judged=row.judged,
        results=results,
        regrade=row.regrade,
        handed_in=None if row.handed_in is None else in_utc(row.handed_in),
        handed_in_said=bool(row.handed_in_said),
        version=row.version or 1,
        either_version=bool(row.either_version),
    )


def mark_of_rows(rows: Sequence[RowOfTable]) -> Mark:
    """Put a mark together from its row, joined with the row of each line (or with none)."""
    first = rows[0]
    return Mark(
        student=first.student,
        quantity=first.quantity,
        number=first.number,
        attempt=first.attempt,
        credit=first.credit,
        lines={row.line: row.line_credit for row in rows if row.line is not None},
        marker=first.marker,
        marked_at=in_utc(first.marked_at),
        comment=first.comment,
    )
