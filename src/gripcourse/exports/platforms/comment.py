"""What a grade was given for, in a few lines: points in all, by section, and what still waits."""

from collections.abc import Iterator, Mapping
from html import escape
from typing import Final

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.exports.platforms.works import GradedWork
from gripcourse.exports.report_result import FindingResult, ReportResult
from gripcourse.solver.plan import plan_of
from gripcourse.text.amounts import points_out_of, points_text
from gripcourse.text.words import Words, message

_NOTHING: Final = 1e-9  # points


def comment_lines(work: GradedWork, course: Course, words: Words) -> Iterator[str]:
    """Yield the lines: the sum first, then each section, then what waits for a person."""
    yield _of(work.points, work.total, words)
    yield from late_lines(work.report, words)
    for section in course.sections:
        inside = [one for one in work.report.findings if one.section == section.id]
        if inside:
            earned = sum(one.points for one in inside if not _waits(one))
            total = sum(one.max_points for one in inside)
            yield f"{section.title.of(words.language)}: {_of(earned, total, words)}"
    if work.report.open_points:
        said = message(
            "{points} of {total} wait for a person: {what}.",
            points=points_text(work.report.open_points, words),
            total=points_text(work.total, words),
            what=", ".join(_open_titles(work, course, words)),
        )
        yield words.say(said)


def late_lines(report: ReportResult, words: Words) -> Iterator[str]:
    """Say what lateness took off; nothing where it took nothing."""
    if report.points_lost > _NOTHING:
        said = message(
            "Handed in late (days: {days}): minus {points} points.",
            days=report.days_late or 0,  # whose time is unknown loses nothing
            points=points_text(report.points_lost, words),
        )
        yield words.say(said)


def comment_html(work: GradedWork, course: Course, words: Words) -> str:
    """Return the lines as a platform stores a paragraph: HTML, without a single line end."""
    return "<br>".join(map(escape, comment_lines(work, course, words)))


def _of(points: float, total: float, words: Words) -> str:
    return f"{points_text(points, words)} {points_out_of(total, words)}"


def _waits(finding: FindingResult) -> bool:
    return finding.outcome.traits.waits and finding.decision is None


def titles_of(report: ReportResult, course: Course, words: Words) -> Mapping[str, str]:
    """Return the titles of what a report judged, by id; of what is no more in the course its id."""
    quantities = plan_of(course, Composition.of(report.scheme, report.options)).quantities
    return {
        one.quantity: (
            quantities[one.quantity].title.of(words.language)
            if one.quantity in quantities
            else one.quantity
        )
        for one in report.findings
    }


def _open_titles(work: GradedWork, course: Course, words: Words) -> list[str]:
    titles = titles_of(work.report, course, words)
    return [titles[one.quantity] for one in work.report.findings if _waits(one)]
