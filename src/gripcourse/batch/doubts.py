"""Files that only a name ties to a student who handed in a signed workbook: a person must say."""

from collections.abc import Sequence
from dataclasses import replace

from gripcourse.batch.graded import Changes, changed_where
from gripcourse.grading.known_by import KnownBy
from gripcourse.grading.model import Report
from gripcourse.grading.unjudged import disputed_report
from gripcourse.text.words import message


def in_doubt(reports: Sequence[Report]) -> Changes:
    """Judge no workbook by the name of its file where its student handed in a signed one.

    Anybody can give a file a name. Where it is all that there is, it counts and the missing
    signature is flagged; beside a student's own signed workbook it changes nothing.
    """
    named = {one.student for one in reports if _is_known_by(one, KnownBy.FILE_NAME)}
    if not named:
        return ()
    signed = {
        one.student: one.file
        for one in reports
        if _is_known_by(one, KnownBy.SIGNATURE) and one.student in named
    }
    return changed_where(
        reports,
        lambda one: (
            _disputed(one, signed[one.student])
            if _is_known_by(one, KnownBy.FILE_NAME) and one.student in signed
            else one
        ),
    )


def _is_known_by(report: Report, known_by: KnownBy) -> bool:
    return report.judged and report.known_by is known_by


def _disputed(report: Report, signed: str) -> Report:
    doubt = message(
        "Who handed this in? Only the name of the file says {student}, whose signed workbook is"
        " {signed}. It was not graded and nobody's mark changes.",
        student=report.student,
        signed=signed,
    )
    return replace(disputed_report(report.file, doubt, report.digest), remarks=report.remarks)
