"""How hard each quantity was and how well it tells students apart, with and without consequences.

An early hard step must not make the later ones look hard. So each quantity is looked at twice: once
as the reference sees it, where an answer that follows from an earlier mistake is not right either,
and once with such an answer counted as right. What a mark says lies between the two, where the
policy puts it.
"""

import math
import statistics
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from gripcourse.grading.model import Finding, Report

# The standard error of a correlation of eight pairs is 0.38: fewer say nothing at all.
FEWEST: Final = 8

Share: TypeAlias = Callable[[Finding], float]
"""Gives the share of its points that an answer counts with, 0…1."""


@dataclass(frozen=True, slots=True)
class ItemView:
    """One way to look at a quantity.

    Attributes:
        facility: mean share of the points, 0…1.
        discrimination: correlation of that share with the share of all other points of the same
            student, −1…1; None for fewer than `FEWEST` students or where either does not vary.
    """

    facility: float
    discrimination: float | None


@dataclass(frozen=True, slots=True)
class ItemStatistics:
    """A quantity with consequences of earlier mistakes counted against it, and without."""

    with_consequences: ItemView
    without: ItemView


def item_statistics(reports: Sequence[Report]) -> Mapping[str, ItemStatistics]:
    """Return the statistics of every quantity that has points, by id.

    Args:
        reports: of a cohort; those that could not be judged say nothing.
    """
    judged = [report for report in reports if report.judged]
    counted, forgiven = _views(judged, _as_reference), _views(judged, _as_followed)
    return {name: ItemStatistics(view, forgiven[name]) for name, view in counted.items()}


def is_consequence(finding: Finding) -> bool:
    """Whether an answer is another than the reference only because an earlier one was wrong."""
    return finding.outcome.traits.follows and bool(finding.roots)


def _as_reference(finding: Finding) -> float:
    return 0.0 if is_consequence(finding) else finding.points / finding.max_points


def _as_followed(finding: Finding) -> float:
    carried = finding.outcome.traits.follows
    return 1.0 if carried else finding.points / finding.max_points


def _views(reports: Sequence[Report], share: Share) -> dict[str, ItemView]:
    """Compute facility and item-rest correlation of every quantity from the shares."""
    pairs: dict[str, list[tuple[float, float]]] = defaultdict(list)
    for report in reports:
        closed = [one for one in report.findings if not one.is_open and one.max_points]
        earned = sum(share(one) * one.max_points for one in closed)
        possible = sum(one.max_points for one in closed)
        for one in closed:
            others = possible - one.max_points
            rest = (earned - share(one) * one.max_points) / others if others else math.nan
            pairs[one.quantity].append((share(one), rest))
    return {
        name: ItemView(statistics.fmean(own for own, _ in found), _correlation(found))
        for name, found in pairs.items()
    }


def _correlation(pairs: Sequence[tuple[float, float]]) -> float | None:
    complete = [(own, rest) for own, rest in pairs if not math.isnan(rest)]
    if len(complete) < FEWEST:
        return None
    own, rest = zip(*complete, strict=True)
    if math.isclose(min(own), max(own)) or math.isclose(min(rest), max(rest)):
        return None
    return statistics.correlation(own, rest)
