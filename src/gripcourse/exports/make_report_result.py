"""Putting reports into words for other programs."""

import math
from collections.abc import Sequence
from typing import Final

from gripcourse.documents.report.standing import earned_percent_of, percent_of, standing_of
from gripcourse.exports.files import FileAccount, graded_account, reason_of
from gripcourse.exports.report_result import (
    CauseResult,
    FileResult,
    FindingResult,
    FlagResult,
    GradesResult,
    MissingResult,
    ReportResult,
)
from gripcourse.grading.model import Finding, Flag, FlagCode, Report
from gripcourse.policy.scales import Scale, certain_grade
from gripcourse.text.words import LANGUAGES, Message, Words
from gripcourse.variants.model import Student

_FIGURES: Final = 12  # of a computed number


def grades_result(
    reports: Sequence[Report],
    words: Words,
    incidents: Sequence[str] = (),
    others: Sequence[FileAccount] = (),
    scales: Sequence[Scale] = (),
    missing: Sequence[Student] = (),
) -> GradesResult:
    """Put the reports of a batch into words for another program.

    Args:
        reports: of the files that were read.
        words: their language.
        incidents: what failed on our side.
        others: files that were found and not looked at.
        scales: of the policy.
        missing: students of whom there is nothing.
    """
    accounts = (*map(graded_account, reports), *others)
    return GradesResult(
        reports=tuple(report_result(report, words, scales) for report in reports),
        needs_person=any(one.needs_person for one in accounts),
        incidents=tuple(incidents),
        files=tuple(file_result(one, words) for one in accounts),
        missing=tuple(map(missing_result, missing)),
    )


def file_result(account: FileAccount, words: Words) -> FileResult:
    """Put into words what became of a file."""
    reason = reason_of(account, words)
    return FileResult(account.file, account.fate, account.student, account.why, reason)


def missing_result(student: Student) -> MissingResult:
    """Return what is said of a student of whom there is nothing."""
    return MissingResult(student.id, student.name, student.group, student.email)


def report_result(report: Report, words: Words, scales: Sequence[Scale] = ()) -> ReportResult:
    """Put a report into words for another program; scales are those of the policy."""
    standing = standing_of(report)
    called = {one.id: certain_grade(one, standing, words) for one in scales}
    return ReportResult(
        file=report.file,
        student=report.student,
        name=report.name,
        variant=report.variant,
        scheme=report.scheme,
        options=dict(report.options),
        judged=report.judged,
        score=_points(report.score) if report.judged else None,
        max_score=_points(report.max_score) if report.judged else None,
        open_points=_points(report.open_points),
        flags=tuple(_flag_result(one, words) for one in report.flags),
        remarks=_said(report.remarks, words),
        causes=tuple(
            CauseResult(one.quantity, one.explains, words.say(one.message)) for one in report.causes
        ),
        findings=tuple(finding_result(one, words) for one in report.findings),
        digest=report.digest,
        known_by=report.known_by,
        earned=_points(report.earned) if report.judged else None,
        days_late=_days_late(report),
        counts=_counts(report),
        percent=percent_of(report) if report.judged else None,
        scales=called if report.judged else {},
        earned_percent=earned_percent_of(report) if report.judged else None,
    )


def _days_late(report: Report) -> int | None:
    """Return the days that cost something; None where nobody knows when the work came."""
    if report.timing is None:
        return 0
    return None if report.timing.is_unknown else report.timing.days_late


def _counts(report: Report) -> bool | None:
    """Tell whether a work counts; None where nobody has decided which of several does."""
    if any(one.code is FlagCode.SEVERAL_FILES for one in report.flags):
        return None
    return report.timing is None or report.timing.counts


def _points(value: float) -> float:
    return round(value, 6)  # what adding up in another order changes is not said


def _computed(value: float | None) -> float | None:
    """Return a number without the last digits, which processors compute differently."""
    known = finite(value)
    return None if known is None else float(f"{known:.{_FIGURES}g}")


def finite(value: float | None) -> float | None:
    """Return a number that JSON can hold, None for none."""
    return value if value is not None and math.isfinite(value) else None


def _flag_result(flag: Flag, words: Words) -> FlagResult:
    in_languages = {language: Words(language).say(flag.message) for language in LANGUAGES}
    said = words.say(flag.message)
    return FlagResult(flag.code, said, flag.others, flag.rests_on, in_languages)


def finding_result(finding: Finding, words: Words) -> FindingResult:
    """Put a finding into words for another program."""
    return FindingResult(
        quantity=finding.quantity,
        section=finding.section,
        outcome=finding.outcome,
        against=finding.against,
        given=finite(finding.given),
        typed=finding.typed,
        cell=finding.cell,
        reference=_computed(finding.reference),
        expected=_computed(finding.expected),
        band=_computed(finding.band),
        points=_points(finding.points),
        max_points=_points(finding.max_points),
        slip="" if finding.slip is None else str(finding.slip),
        tied=tuple(map(str, finding.tied)),
        roots=finding.roots,
        message=words.say(finding.message),
        remarks=_said(finding.remarks, words),
        decision=finding.decision,
    )


def _said(sentences: Sequence[Message], words: Words) -> tuple[str, ...]:
    return tuple(words.say(one) for one in sentences)
