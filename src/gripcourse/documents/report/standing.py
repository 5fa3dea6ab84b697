"""Where a work stands: scales, points that wait for a person, attempts and lateness."""

from collections.abc import Mapping
from datetime import tzinfo

from gripcourse.course.quantity import Quantity
from gripcourse.grading.model import Report, Timing, after_lateness
from gripcourse.policy.scales import CountedPoints, Scale, grade_text
from gripcourse.text.amounts import percent_text, points_text
from gripcourse.text.moments import moment_text, zone_name
from gripcourse.text.words import Message, Words, message


def standing_of(report: Report) -> CountedPoints:
    """Return the points of a report, with those that wait for a person."""
    return CountedPoints(
        earned=report.earned,
        possible=report.max_score + report.open_points,
        waiting=after_lateness(report.open_points, report.timing),
    )


def percent_of(report: Report) -> float | None:
    """Return the score as a percentage of the points that wait for nobody; None without any."""
    return _percent(report.score, report)


def earned_percent_of(report: Report) -> float | None:
    """Return what lateness leaves of the score as a percentage, as `percent_of` does."""
    return _percent(report.earned, report)


def _percent(points: float, report: Report) -> float | None:
    return round(100 * points / report.max_score, 4) if report.max_score else None


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
        "Points that wait for a person: {points} of {total}; {names}.",
        points=points_text(report.open_points, words),
        total=points_text(report.max_score + report.open_points, words),
        names="; ".join(names),
    )
    return words.say(said)


def timing_texts(report: Report, words: Words) -> list[str]:
    """Say which attempt a work is, whether it counts, and what lateness costs."""
    timing = report.timing
    if timing is None or not report.judged:
        return []
    said: list[Message] = []
    if timing.days_late and timing.handed_in and timing.deadline:
        zone = timing.deadline.tzinfo
        said.append(
            message(
                "Handed in {when}, the deadline was {deadline}; days late: {days}. Lateness takes "
                "{share} off; points that count: {earned} of {score}.",
                when=moment_text(timing.handed_in, words, zone),
                deadline=_with_place(moment_text(timing.deadline, words, zone), zone),
                days=timing.days_late,
                share=percent_text(timing.deduction, words),
                earned=points_text(report.earned, words),
                score=points_text(report.score, words),
            )
        )
    if timing.is_unknown and not timing.waived:
        said.append(
            message("Nobody knows when this was handed in: nothing is taken off for lateness.")
        )
    if timing.waived:
        said.append(_waived(timing, words))
    attempt = attempt_text(report, words)
    return [*([attempt] if attempt else []), *(words.say(one) for one in said)]


def attempt_text(report: Report, words: Words) -> str:
    """Say which attempt a judged work is and whether it counts; nothing of an only one."""
    timing = report.timing
    if timing is None or not report.judged or timing.of == 1:
        return ""
    number, of = timing.number, timing.of
    if timing.counts:
        return words.say(
            message("Attempt {number} of {of}: this one counts.", number=number, of=of)
        )
    return words.say(message("Attempt {number} of {of}: another one counts.", number=number, of=of))


def _waived(timing: Timing, words: Words) -> Message:
    """Say why lateness is not counted, and until when: from then on days count, and cost."""
    if timing.waived_until is None:
        return message("Lateness was waived: {why}", why=timing.waived)
    zone = timing.deadline.tzinfo if timing.deadline else None
    until = moment_text(timing.waived_until, words, zone)
    return message("Lateness was waived until {until}: {why}", until=until, why=timing.waived)


def _with_place(moment: str, zone: tzinfo | None) -> str:
    """Say behind a moment by whose clock it is; once in a sentence is enough."""
    place = zone_name(zone)
    return f"{moment} ({place})" if place else moment
