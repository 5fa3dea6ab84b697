"""Every quantity of a cohort: the hardest as a plot, all in a table, first what schemes share.

Sixteen schemes ask for hundreds of quantities, most of which nobody gets wrong. A row has only what
somebody answered wrongly or left out; the others are named, with how many answered them.
"""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.documents.report.charts import Bar
from gripcourse.documents.report.columns import aligned_rows
from gripcourse.documents.report.items import FEWEST, ItemStatistics, ItemView
from gripcourse.documents.report.totals import QuantityTotal, is_blank
from gripcourse.grading.model import Outcome, Report
from gripcourse.text.amounts import percent_text
from gripcourse.text.words import Words, message

COUNTED: Final = tuple(one for one in Outcome if one.traits.counted)

_RIGHT: Final = tuple(one for one in Outcome if one.traits.right)
# Who hands in an empty workbook leaves everything blank: that tells nothing about one quantity.
_TELLING: Final = tuple(one for one in COUNTED if one.traits.typed and not one.traits.right)
_HARDEST: Final = 16  # bars of the plot


@dataclass(frozen=True, slots=True)
class QuantityRow:
    """A quantity's line: how often each outcome of `COUNTED` occurred, and its statistics.

    Attributes:
        symbol, title: of the quantity.
        counts: in the order of `COUNTED`.
        facility, discrimination: each with consequences of earlier mistakes and without.
        bar: percentages of the width of the column: the facility with consequences, that without,
            and the first of the second.
    """

    symbol: str
    title: str
    counts: tuple[str, ...]
    facility: tuple[str, str]
    discrimination: tuple[str, str]
    bar: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Faultless:
    """A quantity that nobody got wrong: symbol, title where it has no symbol, right answers."""

    symbol: str
    title: str
    answers: int


@dataclass(frozen=True, slots=True)
class QuantityGroup:
    """Quantities of a section, or those that only one scheme has."""

    title: str
    rows: tuple[QuantityRow, ...]
    faultless: tuple[Faultless, ...]


@dataclass(frozen=True, slots=True)
class AskedQuantity:
    """What was asked in a cohort.

    Attributes:
        reports: that could be judged.
        totals: outcomes of the quantities, in the order of the assignments.
        items: statistics by quantity.
        declared: the quantities by id.
        course: titles of sections and schemes.
    """

    reports: Sequence[Report]
    totals: Sequence[QuantityTotal]
    items: Mapping[str, ItemStatistics]
    declared: Mapping[str, Quantity]
    course: Course


def hardest(asked: AskedQuantity, words: Words) -> list[Bar]:
    """Return the quantities that earned the smallest shares of their points, the hardest first."""
    found = [
        (item.without.facility, item.with_consequences.facility, total)
        for total in asked.totals
        if (item := asked.items.get(total.quantity)) is not None
        and sum(total.outcomes.values()) >= min(FEWEST, len(asked.reports))
        and item.with_consequences.facility < 1
    ]
    found.sort(key=lambda one: one[:2])
    return [
        Bar(_title(total, asked, words), share, dark, sum(total.outcomes.values()))
        for share, dark, total in found[:_HARDEST]
    ]


def quantity_groups(asked: AskedQuantity, words: Words) -> list[QuantityGroup]:
    """Return all quantities: those of several schemes by section, then those of each scheme."""
    schemes = _schemes(asked.reports)
    alone = len({report.scheme for report in asked.reports}) == 1
    titles = _titles(asked.course, words)
    groups: dict[str, list[QuantityTotal]] = {place: [] for place in titles}
    for total in asked.totals:
        if any(total.outcomes.get(outcome) for outcome in COUNTED):
            having = schemes[total.quantity]
            shared = alone or len(having) > 1
            groups.setdefault(total.section if shared else min(having), []).append(total)
    left_out = _left_out(asked.reports)
    return [
        _group(titles.get(place, place), totals, left_out, asked, words)
        for place, totals in groups.items()
        if totals
    ]


def _schemes(reports: Sequence[Report]) -> Mapping[str, set[str]]:
    """Return the schemes that ask for a quantity, by its id."""
    found: dict[str, set[str]] = defaultdict(set)
    for report in reports:
        for finding in report.findings:
            found[finding.quantity].add(report.scheme)
    return found


def _titles(course: Course, words: Words) -> dict[str, str]:
    """Return the title of every section, numbered, and of every scheme, by id."""
    sections = {
        section.id: f"{number}. {section.title.of(words.language)}"
        for number, section in enumerate(course.sections, start=1)
    }
    schemes = {
        id_: words.say(message("Only {scheme}", scheme=scheme.title))
        for id_, scheme in course.schemes.items()
    }
    return sections | schemes


def _left_out(reports: Sequence[Report]) -> set[str]:
    """Return what somebody left blank who answered something else."""
    found = set()
    for report in reports:
        if any(one.outcome.traits.typed for one in report.findings):
            found |= {one.quantity for one in report.findings if is_blank(one)}
    return found


def _group(
    title: str,
    totals: Sequence[QuantityTotal],
    left_out: set[str],
    asked: AskedQuantity,
    words: Words,
) -> QuantityGroup:
    faultless = [
        total
        for total in totals
        if total.quantity not in left_out
        and _right(total)
        and not any(total.outcomes.get(one) for one in _TELLING)
    ]
    rows = [_row(total, asked, words) for total in totals if total not in faultless]
    return QuantityGroup(
        title=title,
        rows=tuple(aligned_rows(rows, "facility", "discrimination")),
        faultless=tuple(
            Faultless(symbol, "" if symbol else _title(total, asked, words), _right(total))
            for total in faultless
            for symbol in [_symbol(total, asked, words)]
        ),
    )


def _right(total: QuantityTotal) -> int:
    return sum(total.outcomes.get(outcome, 0) for outcome in _RIGHT)


def _row(total: QuantityTotal, asked: AskedQuantity, words: Words) -> QuantityRow:
    item = asked.items.get(total.quantity)
    first, second = (item.with_consequences, item.without) if item else (None, None)
    return QuantityRow(
        symbol=_symbol(total, asked, words),
        title=_title(total, asked, words),
        counts=tuple(str(total.outcomes.get(outcome, 0) or "") for outcome in COUNTED),
        facility=(_facility(first, words), _facility(second, words)),
        discrimination=(_discrimination(first, words), _discrimination(second, words)),
        bar=_bar(item),
    )


def _bar(item: ItemStatistics | None) -> tuple[float, float, float]:
    if item is None or not item.without.facility:
        return 0.0, 0.0, 0.0
    first, second = item.with_consequences.facility, item.without.facility
    return round(100 * first, 1), round(100 * second, 1), round(100 * first / second, 1)


def _facility(view: ItemView | None, words: Words) -> str:
    return "—" if view is None else percent_text(view.facility, words)


def _discrimination(view: ItemView | None, words: Words) -> str:
    if view is None or view.discrimination is None:
        return "—"
    return words.number(round(view.discrimination, 2), 3).replace("-", "−")


def _symbol(total: QuantityTotal, asked: AskedQuantity, words: Words) -> str:
    quantity = asked.declared.get(total.quantity)
    return quantity.symbol.of(words.language) if quantity else ""


def _title(total: QuantityTotal, asked: AskedQuantity, words: Words) -> str:
    quantity = asked.declared.get(total.quantity)
    return quantity.title.of(words.language) if quantity else total.quantity
