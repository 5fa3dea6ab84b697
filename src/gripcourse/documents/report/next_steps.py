"""What a student should do next: what stands in the rows, gathered in the order of doing it.

Every step names the student's own cells; none needs a number that the student has not got.
"""

from collections.abc import Callable, Container, Iterable
from dataclasses import dataclass

from gripcourse.documents.report.answers import is_unreadable, shortened
from gripcourse.documents.report.root_causes import first_affected
from gripcourse.documents.report.standing import standing_of
from gripcourse.documents.report.totals import empty_sections, is_blank
from gripcourse.grading.model import Finding, Report
from gripcourse.solver.plan import Plan
from gripcourse.text.amounts import points_up_to
from gripcourse.text.words import Words

_TYPED_LETTERS = 48  # of an unreadable cell: enough to find it and to see what is wrong


@dataclass(frozen=True, slots=True)
class NamedStep:
    """A quantity: its symbol, empty for none, and its title."""

    symbol: str
    title: str


@dataclass(frozen=True, slots=True)
class Unread:
    """A cell that held no answer that could be judged: where, what it shows, what is wrong."""

    symbol: str
    title: str
    cell: str
    typed: str
    remarks: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class NextSteps:
    """What to do, in this order.

    Attributes:
        compare: given values that other numbers were used for.
        first: wrong answers that later ones follow from, and answers that another number was used
            for, in order of calculation.
        other: the other wrong answers.
        unreadable: cells that could not be read.
        empty: titles of sections without any answer.
        blank: cells without an answer in other sections.
        waiting: what a person decides about.
        waiting_points: how much that may bring.
    """

    compare: tuple[NamedStep, ...]
    first: tuple[NamedStep, ...]
    other: tuple[NamedStep, ...]
    unreadable: tuple[Unread, ...]
    empty: tuple[str, ...]
    blank: tuple[NamedStep, ...]
    waiting: tuple[NamedStep, ...]
    waiting_points: str

    @property
    def any(self) -> bool:
        """Whether there is anything to do or to wait for."""
        wrong = (self.compare, self.first, self.other, self.unreadable)
        return any((*wrong, self.empty, self.blank, self.waiting))


def next_steps(report: Report, plan: Plan, words: Words) -> NextSteps:
    """Gather what a student should do next."""
    faults = _faults(report, plan)
    empty = empty_sections(report)
    open_cells = [one for one in report.findings if is_unreadable(one)]
    return NextSteps(
        compare=_named(faults.compare, plan, words),
        first=_named(_ordered(faults.first, plan), plan, words),
        other=_named(_ordered(faults.other, plan), plan, words),
        unreadable=tuple(_unread(one, plan, words) for one in open_cells),
        empty=tuple(
            one.title.of(words.language) for one in plan.course.sections if one.id in empty
        ),
        blank=_named(
            _where(report, lambda one: is_blank(one) and one.section not in empty), plan, words
        ),
        waiting=_named(_where(report, lambda one: one.is_open), plan, words),
        waiting_points=points_up_to(standing_of(report).waiting, words),
    )


@dataclass(frozen=True, slots=True)
class _Faults:
    """Ids of quantities to go over; see `NextSteps`."""

    compare: tuple[str, ...]
    first: frozenset[str]
    other: frozenset[str]


def _faults(report: Report, plan: Plan) -> _Faults:
    """Sort what was done wrongly by when it is to be put right."""
    spoiled = {
        one.quantity: hit.quantity for one in report.causes if (hit := first_affected(one, report))
    }
    compare = [name for name in spoiled if not plan.quantities[name].kind.answered]
    # Where a number was used wrongly, the answer that it affected first is put right with it.
    wrong = set(_where(report, lambda one: one.outcome.traits.mistake)) - set(spoiled.values())
    roots = {root for one in report.findings if one.outcome.traits.follows for root in one.roots}
    first = (roots & wrong) | (spoiled.keys() - set(compare))
    return _Faults(tuple(compare), frozenset(first), frozenset(wrong - roots - first))


def _where(report: Report, holds: Callable[[Finding], bool]) -> list[str]:
    return [one.quantity for one in report.findings if holds(one)]


def _ordered(names: Container[str], plan: Plan) -> list[str]:
    return [name for name in plan.quantities if name in names]


def _named(quantities: Iterable[str], plan: Plan, words: Words) -> tuple[NamedStep, ...]:
    return tuple(
        NamedStep(
            plan.quantities[name].symbol.of(words.language),
            plan.quantities[name].title.of(words.language),
        )
        for name in quantities
    )


def _unread(finding: Finding, plan: Plan, words: Words) -> Unread:
    quantity = plan.quantities[finding.quantity]
    return Unread(
        symbol=quantity.symbol.of(words.language),
        title=quantity.title.of(words.language),
        cell=finding.cell,
        typed=shortened(finding.typed, _TYPED_LETTERS),
        remarks=tuple(words.say(remark) for remark in finding.remarks),
    )
