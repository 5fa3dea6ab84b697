"""What Moodle is told of a work: points with a decimal point, or a word of its own scale."""

import math
from collections.abc import Sequence

from gripcourse.errors import Problem, UsageError
from gripcourse.exports.platforms.works import GradedWork, PlatformRow
from gripcourse.text.words import Message, message


def grade_of(work: GradedWork, scale: str, maximum: str, file: str, row: PlatformRow) -> str:
    """Return the grade of a work as Moodle counts: points, or a word of its scale.

    Args:
        work: whose.
        scale: the words of the assignment's scale, a line each; empty for points.
        maximum: the points of the assignment as the worksheet writes them; empty for our own.
        file: the worksheet.
        row: of the student.

    Returns:
        The grade; empty where the word waits for a person's points.

    Raises:
        UsageError: it cannot be said in what the assignment has there.
    """
    if scale:
        return _word(scale.splitlines(), work, file, row)
    most = _number(maximum) if maximum else work.total
    if most is None or not 0 < most < math.inf:
        what = message("The assignment has a scale of words there, no points.")
        raise UsageError([Problem(file, _row(row), what, _points_instead())])
    return f"{work.share * most:.2f}"


def is_other_grade(written: str, before: str) -> bool:
    """Tell whether a grade is another one than before: another number, or another word."""
    return _compared(written) != _compared(before)


def _word(words: Sequence[str], work: GradedWork, file: str, row: PlatformRow) -> str:
    """Return which word of the platform's scale one of the policy's scales calls a work."""
    known = {word.strip().casefold(): word.strip() for word in words}
    scales = work.report.scales
    found = {known[one.casefold()] for one in scales.values() if one and one.casefold() in known}
    if len(found) == 1:
        return found.pop()
    if not found and scales and work.report.open_points:
        return ""
    what = message(
        "The assignment has a scale of words there: {words}. The policy calls this work {found}.",
        words="; ".join(known.values()),
        found="; ".join(filter(None, scales.values())) or "—",
    )
    raise UsageError([Problem(file, _row(row), what, _points_instead())])


def _row(row: PlatformRow) -> Message:
    return message("row {row}", row=row.line)


def _points_instead() -> Message:
    return message(
        "Set the assignment to points in Moodle and export the worksheet again, or declare a scale"
        " with the same words in the policy."
    )


def _number(written: str) -> float | None:
    """Return a number as Moodle writes it in any language; None for none."""
    try:
        return float("".join(written.split()).replace(",", "."))
    except ValueError:
        return None


def _compared(written: str) -> float | str:
    """Return what tells whether a grade is another one: a number, or the word of a scale."""
    number = _number(written)
    return written.strip() if number is None else number
