"""Gradescope's `results.json`: one test for each section of the assignment."""

from collections.abc import Iterator
from typing import Any, Final

from gripcourse.course.model import Course, Section
from gripcourse.exports.platforms.comment import late_lines, titles_of
from gripcourse.exports.report_result import FindingResult, ReportResult
from gripcourse.text.words import Words, message

_HIDDEN: Final = "hidden"
_AFTER_PUBLICATION: Final = "after_published"
_VISIBLE: Final = "visible"


def gradescope_results(
    report: ReportResult, course: Course, words: Words, *, published: bool
) -> dict[str, Any]:
    """Return what Gradescope reads, for JSON.

    Args:
        report: of one submission.
        course: its sections.
        words: the language of what is added to the report's own sentences.
        published: whether students see it at once; else when the instructor publishes the grades.
    """
    visibility = _VISIBLE if published else _AFTER_PUBLICATION
    if not report.judged:
        # It must have a score, and none was earned: nobody but the instructor sees it.
        flags = "\n".join(one.message for one in report.flags)
        return {
            "score": 0.0,
            "output": flags,
            "output_format": "text",
            "visibility": _HIDDEN,
            "stdout_visibility": _HIDDEN,
        }
    remarks = [
        *late_lines(report, words),
        *report.remarks,
        *(cause.message for cause in report.causes),
    ]
    late = report.earned is not None and report.earned < (report.score or 0.0)
    return {
        # What lateness takes off belongs to no section.
        **({"score": round(report.earned or 0.0, 4)} if late else {}),
        "output": "\n".join(remarks),
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "visibility": visibility,
        "stdout_visibility": _HIDDEN,
        "tests": list(_tests(report, course, words, visibility)),
        "extra_data": {"student": report.student, "variant": report.variant},
    }


def _tests(
    report: ReportResult, course: Course, words: Words, visibility: str
) -> Iterator[dict[str, Any]]:
    titles = titles_of(report, course, words)
    for number, section in enumerate(course.sections, start=1):
        inside = [one for one in report.findings if one.section == section.id]
        if inside:
            lines = [
                f"{titles[one.quantity]}: {one.message}"
                for one in inside
                if one.points < one.max_points
            ]
            test = _test(section, inside, lines, words, visibility)
            yield {"number": str(number), **test}


def _test(
    section: Section,
    findings: list[FindingResult],
    lines: list[str],
    words: Words,
    visibility: str,
) -> dict[str, Any]:
    waiting = [one for one in findings if one.outcome.traits.waits and one.decision is None]
    score = sum(one.points for one in findings if one not in waiting)
    most = sum(one.max_points for one in findings)
    if waiting:
        lines.append(words.say(message("A part of this section waits for a person.")))
    return {
        "name": section.title.of(words.language),
        "score": round(score, 4),
        "max_score": round(most, 4),
        "output": "\n".join(lines),
        "output_format": "text",
        "tags": [section.id],
        "visibility": _HIDDEN if len(waiting) == len(findings) else visibility,
    }
