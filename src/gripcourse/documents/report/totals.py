"""Sums that several documents print: points of sections, outcomes of quantities."""

import statistics
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.grading.model import Finding, Outcome, Report
from gripcourse.policy.model import Policy, Reveal
from gripcourse.text.amounts import percent_text
from gripcourse.text.words import Words, message

_CLASS = 8  # works, from which on quartiles say anything and nobody's share shows in them


@dataclass(frozen=True, slots=True)
class SectionTotal:
    """Points of one section of one report.

    Attributes:
        points: earned.
        max_points: possible, without what waits for a person, as in the report's score.
        open_points: of what waits for a person.
    """

    points: float
    max_points: float
    open_points: float


@dataclass(frozen=True, slots=True)
class QuantityTotal:
    """How a quantity was answered by everybody who was asked for it.

    Attributes:
        quantity, section: ids.
        outcomes: how often each outcome occurred.
    """

    quantity: str
    section: str
    outcomes: Mapping[Outcome, int]


@dataclass(frozen=True, slots=True)
class PointsSpread:
    """Summary of the scores of judged files, as shares of the possible points.

    Attributes:
        mean, median: None where nothing was judged.
        deviation: standard deviation of the sample; None below two files.
        lowest, highest: None where nothing was judged.
    """

    mean: float | None
    median: float | None
    deviation: float | None
    lowest: float | None
    highest: float | None


def section_totals(report: Report) -> dict[str, SectionTotal]:
    """Add up the points of each section of a report, in the order of its findings."""
    return totals_of(report.findings)


def totals_of(findings: Collection[Finding]) -> dict[str, SectionTotal]:
    """Add up the points of each section, in the order of the findings."""
    by_section: dict[str, list[Finding]] = {}
    for finding in findings:
        by_section.setdefault(finding.section, []).append(finding)
    totals: dict[str, SectionTotal] = {}
    for section, inside in by_section.items():
        waiting = [finding for finding in inside if finding.is_open]
        scored = [finding for finding in inside if not finding.is_open]
        totals[section] = SectionTotal(
            points=sum(finding.points for finding in scored),
            max_points=sum(finding.max_points for finding in scored),
            open_points=sum(finding.max_points for finding in waiting),
        )
    return totals


def is_blank(finding: Finding) -> bool:
    """Whether an answer was asked for and the cell is empty."""
    return finding.outcome.traits.missing and not finding.outcome.traits.typed


def empty_sections(report: Report) -> frozenset[str]:
    """Return the sections in which every answer that was asked for is missing."""
    asked = [one for one in report.findings if not one.outcome.traits.by_rubric]
    return frozenset(one.section for one in asked) - frozenset(
        one.section for one in asked if not is_blank(one)
    )


def counting(reports: Sequence[Report]) -> list[Report]:
    """Return the reports on which statistics rest: of a student's attempts the one that counts.

    Where a policy says nothing of attempts, every file counts.
    """
    return [report for report in reports if is_counting(report)]


def is_counting(report: Report) -> bool:
    """Tell whether no other attempt of the student counts instead."""
    return report.timing is None or report.timing.counts


def shares(reports: Iterable[Report]) -> list[float]:
    """Return what counts of each judged report, after lateness, as a share of what is possible."""
    return [
        report.earned / report.max_score for report in reports if report.judged and report.max_score
    ]


def peer_quartiles(earned: Sequence[float], words: Words) -> str:
    """Say how a class did, without anybody in it: its quartiles; nothing of a few works.

    Args:
        earned: share of the points of each judged work.
        words: the reader's language.
    """
    if len(earned) < _CLASS:
        return ""
    lower, median, upper = statistics.quantiles(earned, n=4, method="inclusive")
    said = message(
        "Half of the judged works, {count} in all, earned from {lower} to {upper} of the points; "
        "the median is {median}.",
        count=len(earned),
        lower=percent_text(lower, words),
        upper=percent_text(upper, words),
        median=percent_text(median, words),
    )
    return words.say(said)


def peers_text(report: Report, policy: Policy, words: Words, earned: Sequence[float]) -> str:
    """Say in a student's report how the class did, once the policy publishes the solution."""
    told = policy.reveal is Reveal.REFERENCE and report.judged
    return peer_quartiles(earned, words) if told else ""


def section_shares(reports: Iterable[Report]) -> dict[str, list[float]]:
    """Return what each judged report earned in each section, as a share of what could be earned."""
    earned: dict[str, list[float]] = {}
    for report in reports:
        for section, total in section_totals(report).items() if report.judged else ():
            if total.max_points:
                earned.setdefault(section, []).append(total.points / total.max_points)
    return earned


def spread(scores: Sequence[float]) -> PointsSpread:
    """Summarise scores."""
    if not scores:
        return PointsSpread(None, None, None, None, None)
    return PointsSpread(
        mean=statistics.fmean(scores),
        median=statistics.median(scores),
        deviation=statistics.stdev(scores) if len(scores) > 1 else None,
        lowest=min(scores),
        highest=max(scores),
    )


def quantity_totals(reports: Sequence[Report]) -> tuple[QuantityTotal, ...]:
    """Count outcomes of each quantity over judged reports, in the order of the assignment."""
    findings: dict[str, list[Finding]] = {}
    for report in reports:
        if report.judged:
            for finding in report.findings:
                findings.setdefault(finding.quantity, []).append(finding)
    return tuple(_quantity_total(group) for group in findings.values())


def _quantity_total(findings: Sequence[Finding]) -> QuantityTotal:
    return QuantityTotal(
        quantity=findings[0].quantity,
        section=findings[0].section,
        outcomes=Counter(finding.outcome for finding in findings),
    )
