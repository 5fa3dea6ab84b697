"""Letting the marks of persons enter a report: pure, over what the program found by itself."""

from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import replace

from gripcourse.gradebook.model import GradebookEntry, is_outdated, latest_marks, results_of
from gripcourse.grading.flags import not_judged_flags
from gripcourse.grading.model import (
    Against,
    Decision,
    Finding,
    Flag,
    FlagCode,
    Outcome,
    Report,
    sums_of,
)
from gripcourse.text.words import message


def with_marks(report: Report, entries: Iterable[GradebookEntry]) -> Report:
    """Return the report with what persons decided.

    The latest mark of each item counts, whatever was graded since. Where the file or the automatic
    results are others than when it was entered, the report is flagged.

    Args:
        report: as the program judged it, without any mark.
        entries: all marks of the report's student, in any order.

    Returns:
        The report with decided items, and with score, open points and flags to match. A report that
        was not judged comes back as it is: it has no items.
    """
    entered = latest_marks(entries)
    if not report.judged or not entered:
        return report
    outdated = _outdated(report, entered)
    findings = tuple(_decided(one, entered.get(one.quantity), outdated) for one in report.findings)
    sums = sums_of(findings)
    return replace(
        report,
        score=sums.score,
        max_score=sums.max_score,
        open_points=sums.open_points,
        flags=(
            *(flag for flag in report.flags if flag.code is not FlagCode.NOT_JUDGED),
            *not_judged_flags(findings),
            *_flags(report, entered, outdated),
        ),
        findings=findings,
    )


def _outdated(report: Report, entered: Mapping[str, GradebookEntry]) -> set[str]:
    """Return the items whose file or automatic results are others than their marker saw."""
    results = results_of(report)
    return {name for name, entry in entered.items() if is_outdated(entry, report.digest, results)}


def _decided(finding: Finding, entry: GradebookEntry | None, outdated: Container[str]) -> Finding:
    """Return the finding with what a person entered; itself where nobody has."""
    if entry is None:
        return finding
    mark = entry.mark
    # A withdrawn mark, the only one without a credit, is not among the latest.
    credit = mark.credit or 0.0
    decision = Decision(
        automatic=finding.outcome,
        credit=credit,
        lines=mark.lines,
        marker=mark.marker,
        decided_at=mark.marked_at,
        comment=mark.comment,
        outdated=finding.quantity in outdated,
    )
    return replace(
        finding,
        outcome=Outcome.MANUAL,
        against=Against.NOTHING,
        points=credit * finding.max_points,
        message=message("The instructor decided about this item."),
        decision=decision,
    )


def _flags(
    report: Report, entered: Mapping[str, GradebookEntry], outdated: set[str]
) -> Iterator[Flag]:
    asked = {one.quantity for one in report.findings}
    if again := [one.quantity for one in report.findings if one.quantity in outdated]:
        yield Flag(
            FlagCode.MARK_OUTDATED,
            message(
                "Look again at {names}: the file or its other results have changed since the "
                "instructor marked. The marks count.",
                names=", ".join(again),
            ),
        )
    if lost := [name for name in entered if name not in asked]:
        yield Flag(
            FlagCode.MARK_OUTDATED,
            message(
                "The assignment no longer asks for {names}, which a person marked.",
                names=", ".join(lost),
            ),
        )
