"""The report on a cohort, for the instructor: what to look at, slips, fairness, every quantity."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from pathlib import PurePath

from gripcourse.course.compose import compose
from gripcourse.course.model import Course, Quantity, Section
from gripcourse.course.policy import Policy
from gripcourse.grading.model import Outcome, Report
from gripcourse.pdf import Document, percent_text, picture, points_text, render_pdf
from gripcourse.report.fairness import extent_text, fairness_rows
from gripcourse.report.figures import Bar, Box, box_plot, facility_plot, score_plot
from gripcourse.report.items import FEWEST, Item, ItemView, item_statistics
from gripcourse.report.marked import decision_rows, marked_tables
from gripcourse.report.mistakes import kind_rows, slip_rows
from gripcourse.report.totals import (
    QuantityTotal,
    quantity_totals,
    section_shares,
    section_totals,
    shares,
    spread,
)
from gripcourse.report.verdicts import OUTCOME_WORDS, SIGNS
from gripcourse.words import Message, Words, message

TEMPLATE = "cohort.html.j2"
STYLES = ("page.css", "formula.css", "cohort.css")

COUNTED = (
    Outcome.CORRECT,
    Outcome.CARRIED,
    Outcome.SLIP,
    Outcome.WRONG,
    Outcome.BLANK,
    Outcome.UNREADABLE,
    Outcome.NOT_JUDGED,
)

_PLOTTED = 54  # bars that fit on one page; many schemes together have more quantities


@dataclass(frozen=True, slots=True)
class StudentRow:
    """A student's line: texts in the order of the columns; `flags` counts what to look at."""

    name: str
    variant: str
    score: str
    sections: tuple[str, ...]
    open_points: str
    flags: str


@dataclass(frozen=True, slots=True)
class QuantityRow:
    """A quantity's line: how often each outcome of `COUNTED` occurred, and its statistics.

    Attributes:
        symbol, title: of the quantity.
        counts: in the order of `COUNTED`.
        facility, discrimination: each with consequences of earlier mistakes and without.
    """

    symbol: str
    title: str
    counts: tuple[str, ...]
    facility: tuple[str, str]
    discrimination: tuple[str, str]


@dataclass(frozen=True, slots=True)
class SectionRow:
    """A section's line: its number, title and points, and how scores in it are spread."""

    number: int
    title: str
    points: float
    mean: str
    median: str
    deviation: str
    extent: str


@dataclass(frozen=True, slots=True)
class FlaggedFile:
    """A file that somebody should look at, and why."""

    name: str
    file: str
    sentences: tuple[str, ...]


def cohort_report(
    reports: Sequence[Report], policy: Policy, course: Course, words: Words, graded_on: date
) -> bytes:
    """Make the report on a cohort as a PDF file.

    Args:
        reports: one for each file, judged or rejected, in the order of the table.
        policy: points of the sections.
        course: titles, declarations and the folder with the templates.
        words: the language of the report.
        graded_on: the day that is printed.
    """
    values = cohort_values(reports, policy, course, words) | {"graded_on": graded_on}
    return render_pdf(Document(TEMPLATE, STYLES, values), course.root / "templates", words)


def cohort_values(
    reports: Sequence[Report], policy: Policy, course: Course, words: Words
) -> dict[str, object]:
    """Return what the template needs but the date; see `cohort_report` for the arguments."""
    declared, totals, scores = _declared(reports, course), quantity_totals(reports), shares(reports)
    items = item_statistics(reports)
    sections = [section for section in course.sections if section.id in policy.section_points]
    rows = [_section(reports, section, number, policy, words)
            for number, section in enumerate(sections, start=1)]  # fmt: skip
    return {
        "course": course.title.of(words.language),
        "summary": list(_summary(reports, scores, words)),
        "sections": rows,
        "students": [_student(one, [section.id for section in sections], words) for one in reports],
        "score_plot": picture(score_plot(scores, words)) if scores else "",
        "section_plot": _section_plot(reports, sections, words),
        "facility_plots": [
            picture(facility_plot(part, words))
            for part in _pages(list(_bars(totals, items, declared, words)))
        ],
        "slips": slip_rows(reports, declared, words),
        "kinds": kind_rows(reports, policy.slips, words),
        "fairness": fairness_rows(reports, course, words),
        "fewest": FEWEST,
        "outcomes": [(SIGNS[outcome], words.say(OUTCOME_WORDS[outcome])) for outcome in COUNTED],
        "quantities": [
            _quantity(total, items.get(total.quantity), declared, words)
            for total in totals
            if any(total.outcomes.get(outcome) for outcome in COUNTED)
        ],
        "marked": marked_tables(reports, declared, policy, words),
        "decided": decision_rows(reports, declared, words),
        "flagged": [_flagged(report, words) for report in reports if report.flags],
    }


def _declared(reports: Sequence[Report], course: Course) -> dict[str, Quantity]:
    """Return the declaration of every quantity that occurs, by id; the first scheme's counts."""
    declared: dict[str, Quantity] = {}
    seen: set[tuple[str, frozenset[tuple[str, str]]]] = set()
    for report in reports:
        kind = (report.scheme, frozenset(report.options.items()))
        if kind in seen or report.scheme not in course.schemes:
            continue
        seen.add(kind)
        declared = compose(course, course.schemes[report.scheme], report.options) | declared
    return declared


def _summary(
    reports: Sequence[Report], scores: Sequence[float], words: Words
) -> Iterator[tuple[str, str]]:
    judged = sum(report.judged for report in reports)
    found = spread(scores)
    numbers: tuple[tuple[Message, str], ...] = (
        (message("Files"), str(len(reports))),
        (message("Judged"), str(judged)),
        (message("Not judged"), str(len(reports) - judged)),
        (message("To look at"), str(sum(bool(report.flags) for report in reports))),
        (message("Mean"), _share(found.mean, words)),
        (message("Median"), _share(found.median, words)),
        (message("Standard deviation"), _share(found.deviation, words)),
        (message("Lowest and highest"), extent_text(found.lowest, found.highest, words)),
    )
    for label, value in numbers:
        yield words.say(label), value


def _share(share: float | None, words: Words) -> str:
    return "—" if share is None else percent_text(share, words)


def _section(
    reports: Sequence[Report], section: Section, number: int, policy: Policy, words: Words
) -> SectionRow:
    found = spread(section_shares(reports, section.id))
    return SectionRow(
        number=number,
        title=section.title.of(words.language),
        points=policy.section_points[section.id],
        mean=_share(found.mean, words),
        median=_share(found.median, words),
        deviation=_share(found.deviation, words),
        extent=extent_text(found.lowest, found.highest, words),
    )


def _section_plot(reports: Sequence[Report], sections: Sequence[Section], words: Words) -> str:
    boxes = [
        Box(section.title.of(words.language), found)
        for section in sections
        if (found := section_shares(reports, section.id))
    ]
    return picture(box_plot(boxes, words)) if boxes else ""


def _bars(
    totals: Sequence[QuantityTotal],
    items: Mapping[str, Item],
    declared: Mapping[str, Quantity],
    words: Words,
) -> Iterator[Bar]:
    for total in totals:
        item = items.get(total.quantity)
        if item is not None:
            yield Bar(
                _title(total, declared, words),
                item.without.facility,
                item.with_consequences.facility,
            )


def _student(report: Report, sections: Sequence[str], words: Words) -> StudentRow:
    totals = section_totals(report) if report.judged else {}
    return StudentRow(
        name=report.name or report.student or PurePath(report.file).name,
        variant=report.variant or "—",
        score=points_text(report.score, words) if report.judged else "—",
        sections=tuple(
            points_text(totals[section].points, words) if section in totals else "—"
            for section in sections
        ),
        open_points=points_text(report.open_points, words) if report.open_points else "",
        flags=str(len(report.flags)) if report.flags else "",
    )


def _quantity(
    total: QuantityTotal, item: Item | None, declared: Mapping[str, Quantity], words: Words
) -> QuantityRow:
    quantity = declared.get(total.quantity)
    views = (item.with_consequences, item.without) if item else (None, None)
    first, second = views
    return QuantityRow(
        symbol=quantity.symbol.of(words.language) if quantity else "",
        title=_title(total, declared, words),
        counts=tuple(str(total.outcomes.get(outcome, 0) or "") for outcome in COUNTED),
        facility=(_facility(first, words), _facility(second, words)),
        discrimination=(_discrimination(first, words), _discrimination(second, words)),
    )


def _facility(view: ItemView | None, words: Words) -> str:
    return "—" if view is None else percent_text(view.facility, words)


def _discrimination(view: ItemView | None, words: Words) -> str:
    if view is None or view.discrimination is None:
        return "—"
    return words.number(round(view.discrimination, 2), 3).replace("-", "−")


def _title(total: QuantityTotal, declared: Mapping[str, Quantity], words: Words) -> str:
    quantity = declared.get(total.quantity)
    return quantity.title.of(words.language) if quantity else total.quantity


def _flagged(report: Report, words: Words) -> FlaggedFile:
    return FlaggedFile(
        name=report.name or report.student or "—",
        file=PurePath(report.file).name,
        sentences=tuple(words.say(flag.message) for flag in report.flags),
    )


def _pages(bars: Sequence[Bar]) -> Iterator[Sequence[Bar]]:
    """Share bars evenly among as few plots as fit on a page each."""
    each = math.ceil(len(bars) / max(1, math.ceil(len(bars) / _PLOTTED)))
    for start in range(0, len(bars), each or 1):
        yield bars[start : start + each]
