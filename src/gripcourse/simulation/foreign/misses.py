"""Every work of the second generator that the grader treats wrongly, as a table for a developer."""

import csv
import io
from collections.abc import Sequence

from gripcourse.simulation.foreign.model import JudgedForeign

PAID = "paid"
"""A miss: a wrong number was accepted."""

HEADS = (
    "miss", "student", "scheme", "writing", "keeps", "pi", "gravity", "mistake", "root", "number",
    "reaches", "quantity", "outcome", "named", "typed", "reference", "expected", "points", "of",
)  # fmt: skip


def foreign_misses_csv(misses: Sequence[tuple[str, JudgedForeign]]) -> str:
    """Write the answers that lost points in works with a miss as CSV, a row for each.

    Of a work in which a wrong number was accepted, the answers that its mistake is in.
    """
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(HEADS)
    for what, one in misses:
        how, done = one.work.habits, one.work.done
        mistake = ("", "", "") if done is None else (done.kind, done.root, done.number)
        reaches = " ".join(sorted(one.work.reaches))
        work = (one.work.student, one.report.scheme, how.writing, how.keeps, how.pi, how.gravity)
        for found in one.report.findings:
            told = found.points < found.max_points
            told |= what == PAID and found.quantity in one.work.reaches
            if told and found.quantity in one.work.cells:
                said = (found.quantity, found.outcome, found.slip, found.typed, found.reference)
                points = (found.expected, found.points, found.max_points)
                writer.writerow((what, *work, *mistake, reaches, *said, *points))
    return stream.getvalue()
