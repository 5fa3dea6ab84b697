"""What is behind a result: the few roots that several answers follow from, and what those kept."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.grading.model import Cause, Finding, Report
from gripcourse.slips.model import SlipId
from gripcourse.solver.plan import Plan
from gripcourse.text.amounts import NO_BREAK_SPACE, points_text
from gripcourse.text.words import Words, message

_MOST = 5  # roots; what follows from a lesser one says so in its own row
_NAMED = 12  # answers of one root; each symbol costs boxes


@dataclass(frozen=True, slots=True)
class CauseRow:
    """A root and what follows from it.

    Attributes:
        symbol, title: of the quantity at the root.
        sign, verdict: of the answer at the root; empty where a number was used wrongly.
        said: what was used, in a sentence; empty for an answer.
        later: symbols, or titles, of the answers that follow from it.
        more: how many more there are, in words; empty for none.
        count: how many answers follow, written out for the column.
        kept: points that those earned, of those possible: `12 / 12`.
    """

    symbol: str
    title: str
    sign: str
    verdict: str
    said: str
    later: tuple[str, ...]
    more: str
    count: str
    kept: str


def cause_rows(report: Report, plan: Plan, words: Words) -> Iterator[CauseRow]:
    """Put the causes that explain most into words, the greatest first.

    A cause without a later answer is the answer itself and has no row.
    """
    findings = {finding.quantity: finding for finding in report.findings}
    shown = 0
    for cause in report.causes:
        later = [
            findings[name]
            for name in cause.explains
            if name in findings and findings[name].outcome.traits.follows
        ]
        if later and shown < _MOST:
            shown += 1
            yield _row(cause, findings, later, plan, words)


def first_affected(cause: Cause, report: Report) -> Finding | None:
    """Return the answer that a number used wrongly affected first; None for other causes."""
    return _first_affected(cause, report.findings)


def name_of(quantity: str, plan: Plan, words: Words) -> str:
    """Return the symbol of a quantity as it is declared; its title where it has none."""
    declared = plan.quantities[quantity]
    return declared.symbol.of(words.language) or declared.title.of(words.language)


def _first_affected(cause: Cause, findings: Iterable[Finding]) -> Finding | None:
    slip = SlipId.used(cause.quantity)
    found = (one for one in findings if one.slip == slip and one.quantity in cause.explains)
    return next(found, None)


def _row(
    cause: Cause,
    findings: Mapping[str, Finding],
    later: Sequence[Finding],
    plan: Plan,
    words: Words,
) -> CauseRow:
    quantity = plan.quantities[cause.quantity]
    root = None if _first_affected(cause, findings.values()) else findings.get(cause.quantity)
    more = len(later) - _NAMED
    return CauseRow(
        symbol=quantity.symbol.of(words.language),
        title=quantity.title.of(words.language),
        sign="" if root is None else root.outcome.traits.sign,
        verdict="" if root is None else words.say(root.outcome.traits.word),
        said=words.say(cause.message) if root is None else "",
        later=tuple(name_of(one.quantity, plan, words) for one in later[:_NAMED]),
        more=_more(more, words) if more > 0 else "",
        count=str(len(later)),
        kept=_fraction(
            sum(one.points for one in later), sum(one.max_points for one in later), words
        ),
    )


def _more(count: int, words: Words) -> str:
    return words.say(message("and {count} more", count=count)).replace(" ", NO_BREAK_SPACE)


def _fraction(points: float, possible: float, words: Words) -> str:
    slash = f"{NO_BREAK_SPACE}/{NO_BREAK_SPACE}"
    return f"{points_text(points, words)}{slash}{points_text(possible, words)}"
