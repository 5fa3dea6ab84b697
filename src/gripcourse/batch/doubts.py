"""Files that only a name ties to a student who handed in a signed workbook: a person must say."""

from collections.abc import Sequence
from dataclasses import replace

from gripcourse.grading.known_by import KnownBy
from gripcourse.grading.model import Report
from gripcourse.grading.unjudged import disputed_report
from gripcourse.text.words import message


def put_in_doubt(reports: Sequence[Report]) -> tuple[Report, ...]:
    """Judge no workbook by the name of its file where its student handed in a signed one.

    Anybody can give a file a name. Where it is all that there is, it counts and the missing
    signature is flagged; beside a student's own signed workbook it changes nothing.
    """
    signed = {
        report.student: report.file
        for report in reports
        if report.judged and report.known_by is KnownBy.SIGNATURE
    }
    return tuple(
        _disputed(report, signed[report.student])
        if report.judged and report.known_by is KnownBy.FILE_NAME and report.student in signed
        else report
        for report in reports
    )


def _disputed(report: Report, signed: str) -> Report:
    doubt = message(
        "Who handed this in? Only the name of the file says {student}, whose signed workbook is"
        " {signed}. It was not graded and nobody's mark changes.",
        student=report.student,
        signed=signed,
    )
    return replace(disputed_report(report.file, doubt, report.digest), remarks=report.remarks)
