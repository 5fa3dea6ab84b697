"""Every answer that the grader says something wrong about, as a table for a developer."""

import csv
import io
from collections.abc import Sequence

from gripcourse.simulation.confusion import AnswerVerdict

HEADS = (
    "student", "scheme", "conduct", "figures", "rounding", "carrying", "style", "quantity",
    "done", "slip", "kind", "said", "outcome", "named", "tied", "typed", "right", "reference",
    "expected", "low", "high", "band",
)  # fmt: skip


def misses_csv(misses: Sequence[AnswerVerdict], schemes: dict[str, str]) -> str:
    """Write the misses as CSV, a row for each.

    Args:
        misses: as `confusion.evaluate` finds them.
        schemes: of the students.
    """
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(HEADS)
    writer.writerows(_row(one, schemes[one.work.student]) for one in misses)
    return stream.getvalue()


def _row(one: AnswerVerdict, scheme: str) -> tuple[object, ...]:
    how, action, found = one.work.behaviour, one.action, one.finding
    return (
        one.work.student, scheme, how.conduct, how.figures, how.rounding, how.carrying, how.style,
        action.quantity, action.done, action.slip, action.kind, one.said, found.outcome, found.slip,
        " ".join(map(str, found.tied)), action.typed, action.right, found.reference, found.expected,
        found.low, found.high, found.band,
    )  # fmt: skip
