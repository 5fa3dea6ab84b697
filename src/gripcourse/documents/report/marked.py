"""What persons decided, in words: below an answer of a student, and as tables of a cohort.

The texts of a rubric are looked up when a report is made; a line that the rubric has no longer
keeps its id, and its points still count.
"""

import math
import statistics
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from gripcourse.course.quantity import Quantity
from gripcourse.grading.model import Decision, Finding, Report
from gripcourse.policy.model import Policy
from gripcourse.policy.rubric import Rubric, RubricLine
from gripcourse.text.amounts import NO_BREAK_SPACE, day_text, percent_text, points_text
from gripcourse.text.words import Words, message

_SAME = 1e-6  # points that are typed with a few decimals, and a sum of lines


@dataclass(frozen=True, slots=True)
class MarkedLine:
    """A line of a rubric: what was asked, the level that was reached (or none), `3 / 6`."""

    text: str
    level: str
    points: str


@dataclass(frozen=True, slots=True)
class MarkedItem:
    """What stands below an answer that a person decided about.

    Attributes:
        said: who decided and when, and what the program had found.
        lines: of the rubric, in its order; none without a rubric.
        notes: the marker's comment, and what else the points need.
    """

    said: str
    lines: tuple[MarkedLine, ...]
    notes: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class MarkedRow:
    """A student's line in a table of marked items.

    Attributes:
        name: of the student.
        item: the item's title.
        lines: share of its points that each line earned, in the order of the rubric.
        points: `12 / 15`.
        marker: who decided; with a word where somebody should look again.
        note: the comment, and for a decision what the program had found.
    """

    name: str
    item: str
    lines: tuple[str, ...]
    points: str
    marker: str
    note: str


@dataclass(frozen=True, slots=True)
class MarkedTable:
    """All marks of one rubric in a cohort.

    Attributes:
        title: of the rubric.
        lines: their texts, numbered from 1 in the table.
        rows: one for each marked item.
        means: mean share of each line, and of the points.
    """

    title: str
    lines: tuple[str, ...]
    rows: tuple[MarkedRow, ...]
    means: tuple[str, ...]


def marked_item(
    finding: Finding, quantity: Quantity, policy: Policy, words: Words
) -> MarkedItem | None:
    """Put a person's decision about an item into words; None where there is none."""
    decision = finding.decision
    if decision is None:
        return None
    rubric = policy.rubrics.get(quantity.rubric)
    return MarkedItem(
        said=_said(decision, words),
        lines=tuple(_line(name, finding, rubric, words) for name in _order(decision, rubric)),
        notes=tuple(_notes(finding, decision, rubric, words)),
    )


def marked_tables(
    reports: Sequence[Report], declared: Mapping[str, Quantity], policy: Policy, words: Words
) -> list[MarkedTable]:
    """Return a table for each rubric that somebody was marked by, in the order of the assignment.

    Args:
        reports: of the cohort.
        declared: the quantities by id.
        policy: with the rubrics.
        words: the reader's language.
    """
    found: dict[str, list[tuple[Report, Finding]]] = {}
    for report, finding in _decided(reports):
        quantity = declared.get(finding.quantity)
        if _has_rubric(finding) and quantity is not None and quantity.rubric in policy.rubrics:
            found.setdefault(quantity.rubric, []).append((report, finding))
    return [_table(policy.rubrics[name], group, words) for name, group in found.items()]


def decision_rows(
    reports: Sequence[Report], declared: Mapping[str, Quantity], words: Words
) -> list[MarkedRow]:
    """Return what persons decided without a rubric: answers of ours, and overruled results."""
    rows = []
    for report, finding in _decided(reports):
        if not _has_rubric(finding):
            quantity = declared.get(finding.quantity)
            title = quantity.title.of(words.language) if quantity else finding.quantity
            rows.append(_row(report, finding, title, (), words))
    return rows


def _decided(reports: Sequence[Report]) -> list[tuple[Report, Finding]]:
    return [(one, each) for one in reports for each in one.findings if each.decision is not None]


def _has_rubric(finding: Finding) -> bool:
    return finding.decision is not None and finding.decision.automatic.traits.by_rubric


def _said(decision: Decision, words: Words) -> str:
    day = day_text(decision.decided_at.date(), words)
    if decision.automatic.traits.by_rubric:
        return words.say(message("Marked by {marker}, {day}.", marker=decision.marker, day=day))
    return words.say(
        message(
            "Decided by {marker}, {day}. The automatic verdict was: {verdict}.",
            marker=decision.marker,
            day=day,
            verdict=decision.automatic.traits.word,
        )
    )


def _order(decision: Decision, rubric: Rubric | None) -> list[str]:
    """Return the marked lines in the order of the rubric, those that it lost at the end."""
    known = [line.id for line in rubric.lines] if rubric else []
    kept = [name for name in known if name in decision.lines]
    return kept + [name for name in decision.lines if name not in known]


def _line(name: str, finding: Finding, rubric: Rubric | None, words: Words) -> MarkedLine:
    credit = finding.decision.lines[name] if finding.decision else 0.0
    line = rubric.by_id.get(name) if rubric else None
    if line is None:
        return MarkedLine(name, "", percent_text(credit, words))
    possible = line.share * finding.max_points
    return MarkedLine(
        text=line.text.of(words.language),
        level=_level(line, credit, words),
        points=_fraction(credit * possible, possible, words),
    )


def _level(line: RubricLine, credit: float, words: Words) -> str:
    for level in line.levels:
        if math.isclose(level.credit, credit, abs_tol=_SAME):
            return level.text.of(words.language)
    return ""


def _notes(finding: Finding, decision: Decision, rubric: Rubric | None, words: Words) -> list[str]:
    notes = []
    if rubric is not None and decision.lines.keys() == rubric.by_id.keys():
        together = rubric.credit(decision.lines) * finding.max_points
        if not math.isclose(together, finding.points, abs_tol=0.01):
            said = message(
                "The lines add up to {sum}; {points} points were given.",
                sum=points_text(together, words),
                points=points_text(finding.points, words),
            )
            notes.append(words.say(said))
    if decision.comment:
        notes.append(decision.comment)
    return notes


def _table(rubric: Rubric, group: Sequence[tuple[Report, Finding]], words: Words) -> MarkedTable:
    title = rubric.title.of(words.language)
    lines = [line.id for line in rubric.lines]
    credits_given = [one.decision.lines for _, one in group if one.decision is not None]
    means = [
        _mean([given[line] for given in credits_given if line in given], words) for line in lines
    ]
    shares = [one.points / one.max_points for _, one in group if one.max_points]
    return MarkedTable(
        title=title,
        lines=tuple(
            f"{line.text.of(words.language)} ({percent_text(line.share, words)})"
            for line in rubric.lines
        ),
        rows=tuple(_row(report, one, title, lines, words) for report, one in group),
        means=(*means, _mean(shares, words)),
    )


def _row(
    report: Report, finding: Finding, item: str, lines: Sequence[str], words: Words
) -> MarkedRow:
    decision = finding.decision
    if decision is None:
        raise ValueError(f"nobody decided about {finding.quantity}")
    again = words.say(message("look again"))
    automatic = words.say(decision.automatic.traits.word)
    notes = [] if decision.automatic.traits.by_rubric else [automatic]
    return MarkedRow(
        name=report.name or report.student,
        item=item,
        lines=tuple(
            percent_text(decision.lines[line], words) if line in decision.lines else "—"
            for line in lines
        ),
        points=_fraction(finding.points, finding.max_points, words),
        marker=f"{decision.marker} ({again})" if decision.outdated else decision.marker,
        note=": ".join([*notes, *filter(None, [decision.comment])]),
    )


def _mean(shares: Sequence[float], words: Words) -> str:
    return percent_text(statistics.fmean(shares), words) if shares else "—"


def _fraction(points: float, possible: float, words: Words) -> str:
    slash = f"{NO_BREAK_SPACE}/{NO_BREAK_SPACE}"
    return f"{points_text(points, words)}{slash}{points_text(possible, words)}"
