"""Letting the gradebook enter a report: marks of persons, and results that were published. Pure."""

from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import replace

from gripcourse.gradebook.model import (
    Attempt,
    GradebookEntry,
    is_outdated,
    latest_marks,
    share_given,
)
from gripcourse.gradebook.results import Result, results_of, same_results
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


def with_marks(
    report: Report, entries: Iterable[GradebookEntry], since: tuple[str, int] | None = None
) -> Report:
    """Return the report with what persons decided.

    The latest mark of each item counts, whatever was graded since. Where the file or what the
    program found about the item is another than when it was entered, the report is flagged.

    Args:
        report: as the program judged it, without any mark.
        entries: all marks of the report's student, in any order.
        since: key of the attempt by which the file was judged first; None where it comes new.

    Returns:
        The report with decided items, and with score, open points and flags to match. A report that
        was not judged comes back as it is: it has no items.
    """
    entered = latest_marks(entries)
    if not report.judged or not entered:
        return report
    outdated = _outdated(report, entered, since)
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


def as_it_stands(report: Report, attempt: Attempt) -> Report:
    """Return the report of a published work as the gradebook keeps it, where it says otherwise.

    The student was told a result. What today's course or policy would say instead is for a regrade
    to show; until it is applied, no document may say anything else than was told.

    Args:
        report: as the program judges the work today, without any mark.
        attempt: what stands for the same work.

    Returns:
        The report, where both say the same; else with the items that were asked for then, and a
        flag that names them.
    """
    kept, now = attempt.by_quantity, {one.quantity: one for one in results_of(report)}
    differ = [
        name
        for name in dict.fromkeys((*kept, *now))
        if name not in kept or name not in now or not same_results([kept[name]], [now[name]])
    ]
    if not differ:
        return report
    findings = tuple(
        _as_kept(one, kept[one.quantity]) if one.quantity in differ else one
        for one in report.findings
        if one.quantity in kept
    )
    sums = sums_of(findings)
    said = message(
        "By today's course and policy other results would come out for {names}. The work was "
        "published: what was told stands until a regrade is applied.",
        names=", ".join(differ),
    )
    return replace(
        report,
        score=sums.score,
        max_score=sums.max_score,
        open_points=sums.open_points,
        flags=(*report.flags, Flag(FlagCode.REGRADE_WAITS, said)),
        findings=findings,
        causes=(),
    )


def _as_kept(finding: Finding, kept: Result) -> Finding:
    return replace(
        finding,
        outcome=kept.outcome,
        against=Against.NOTHING,
        expected=None,
        points=kept.points,
        max_points=kept.max_points,
        slip=None,
        message=message(
            "Counts as it was published: {meaning}.", meaning=kept.outcome.traits.meaning
        ),
        remarks=(),
        tied=(),
        roots=(),
        low=None,
        high=None,
    )


def _outdated(
    report: Report, entered: Mapping[str, GradebookEntry], since: tuple[str, int] | None
) -> set[str]:
    """Return the items whose file or automatic result is another than their marker saw."""
    results, digest = results_of(report), report.digest
    return {name for name, one in entered.items() if is_outdated(one, digest, results, since)}


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
    disputed = {name for name, entry in entered.items() if entry.rivals}
    for finding in (one for one in report.findings if one.quantity in disputed):
        entry = entered[finding.quantity]
        yield Flag(
            FlagCode.MARK_OUTDATED,
            message(
                "{quantity} was marked under several ids of one person: {given}. Until somebody "
                "marks it again, the first of these counts.",
                quantity=finding.quantity,
                given=", ".join(map(share_given, (entry, *entry.rivals))),
            ),
        )
    changed = outdated - disputed
    if again := [one.quantity for one in report.findings if one.quantity in changed]:
        yield Flag(
            FlagCode.MARK_OUTDATED,
            message(
                "Look again at {names}: the file or what the program found about them has changed "
                "since the instructor marked. The marks count.",
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
