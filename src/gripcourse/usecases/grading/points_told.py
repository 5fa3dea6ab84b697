"""Whether a printed report says what the grades say: grades may be renewed without the reports."""

from pathlib import Path

from gripcourse.exports.make_report_result import report_result
from gripcourse.exports.report_result import ReportResult
from gripcourse.grading.model import Report
from gripcourse.text.words import Words
from gripcourse.usecases.grading.unchanged import points_noted
from gripcourse.usecases.grading.versions import digest_of_texts


def points_told(report: Report, words: Words) -> str:
    """Return a digest of all points that a report tells."""
    return _digest(report_result(report, words))


def says_other_points(path: Path, result: ReportResult) -> bool:
    """Tell whether a printed report is known to tell other points than the grades.

    Args:
        path: of the report, among the results of its grading.
        result: of the same work, as the grades have it.
    """
    noted = points_noted(path)
    return noted != "" and noted != _digest(result)


def _digest(result: ReportResult) -> str:
    whole = (result.score, result.earned, result.max_score, result.open_points)
    answers = (f"{one.quantity} {_told(one.points)}" for one in result.findings)
    return digest_of_texts((result.digest, *map(_told, whole), *answers))


def _told(points: float | None) -> str:
    # 0 and 0.0 are one number, before and after it was written into a file.
    return "" if points is None else f"{points:.4f}"
