"""What points are called by the scales of a course, and which of them wait for a person."""

from collections.abc import Mapping

from gripcourse.course.quantity import Quantity
from gripcourse.grading.model import Report
from gripcourse.policy.scales import Scale, Standing, grade_text
from gripcourse.text.amounts import points_text
from gripcourse.text.words import Words, message


def standing_of(report: Report) -> Standing:
    """Return the points of a report, with those that wait for a person."""
    return Standing(
        earned=report.score,
        possible=report.max_score + report.open_points,
        waiting=report.open_points,
    )


def grades_of(report: Report, scales: tuple[Scale, ...], words: Words) -> list[tuple[str, str]]:
    """Return title and grade of each scale; none for a file that was not judged."""
    if not report.judged:
        return []
    standing = standing_of(report)
    return [
        (scale.title.of(words.language), grade_text(scale, standing, words)) for scale in scales
    ]


def waiting_text(report: Report, quantities: Mapping[str, Quantity], words: Words) -> str:
    """Say how many points wait for a person, and for which items; nothing where none do.

    Args:
        report: of a judged file.
        quantities: of its plan, by id.
        words: the reader's language.
    """
    if not report.judged or not report.open_points:
        return ""
    names = [
        quantities[one.quantity].title.of(words.language)
        if one.quantity in quantities
        else one.quantity
        for one in report.findings
        if one.is_open
    ]
    said = message(
        "{points} of {total} points wait for a person: {names}.",
        points=points_text(report.open_points, words),
        total=points_text(report.max_score + report.open_points, words),
        names="; ".join(names),
    )
    return words.say(said)
