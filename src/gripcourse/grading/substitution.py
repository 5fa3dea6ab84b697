"""One wrong number behind several wrong answers: the mass read wrongly, a friction from elsewhere.

Answers that follow from no formula at the student's numbers may all follow at another value of one
of their inputs. Each answer, at the precision it was typed with, leaves that value a narrow range;
where the ranges of several answers have a part in common, chance is an unlikely explanation.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Kind
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.explain import unexplained
from gripcourse.grading.rounding import typed_half_unit
from gripcourse.text.units import factor

# A wrong number is looked for between a tenth and ten times the right one.
_SPAN: Final = np.geomspace(0.1, 10.0, 1601)
# Some common wrong input is as likely as this, against each of its answers being wrong by itself.
_PRIOR: Final = 0.2
_LEAST_ANSWERS: Final = 2
_FINEST: Final = 5e-6
# Rounded inputs that move a result further leave nothing to tell it by.
_MOST_SPREAD: Final = 0.02


@dataclass(frozen=True, slots=True)
class Substitution:
    """A number that several wrong answers have in common.

    Attributes:
        quantity: id of the input that it was used for.
        value: what was used, in the declared unit.
        explains: ids of the answers that follow from it; the first is the one that it costs.
        odds: of it against chance.
        tied: another input whose number explains the same answers as well; empty for none.
    """

    quantity: str
    value: float
    explains: tuple[str, ...]
    odds: float
    tied: str


@dataclass(frozen=True, slots=True)
class _Span:
    """What one answer leaves of an input: from … to, SI."""

    comparison: Comparison
    low: float
    high: float


def substitutions(wrong: Sequence[Comparison]) -> tuple[Substitution, ...]:
    """Find the numbers that explain several wrong answers each, the most certain first.

    Args:
        wrong: the answers that nothing else explains, in order of calculation.

    Returns:
        Substitutions that share no answer.
    """
    # A zero has no last digit: it would leave an input no range, and fit any by chance.
    open_views = [
        comparison
        for comparison in wrong
        if comparison.quantity.kind is Kind.FORMULA and comparison.value
    ]
    if len(open_views) < _LEAST_ANSWERS:
        return ()
    found = sorted(_all(open_views), key=lambda one: (-len(one.explains), -one.odds))
    taken: set[str] = set()
    kept: list[Substitution] = []
    for one in found:
        if taken.isdisjoint(one.explains):
            taken |= set(one.explains)
            kept.append(_with_tie(one, found, open_views[0].policy.slips.tie))
    return tuple(kept)


def _with_tie(best: Substitution, found: Sequence[Substitution], tie: float) -> Substitution:
    others = (o for o in found if o.quantity != best.quantity and o.explains == best.explains)
    rival = next((o for o in others if tie * o.odds > best.odds), None)
    if rival is None:
        return best
    return Substitution(best.quantity, best.value, best.explains, best.odds, rival.quantity)


def _all(views: Sequence[Comparison]) -> Iterator[Substitution]:
    names = dict.fromkeys(
        name for comparison in views for name in comparison.plan.inputs[comparison.quantity.id]
    )
    for name in names:
        spans = [span for comparison in views for span in _spans(comparison, name)]
        found = _common(name, spans, _PRIOR / len(names))
        if found is not None:
            yield found


def _spans(comparison: Comparison, name: str) -> Iterator[_Span]:
    """Yield the ranges of an input in which an answer's formula gives the answer as typed."""
    right = float(comparison.follow_through.evaluation.values[name])
    formula = comparison.plan.reference_formula(comparison.quantity.id)
    if formula is None or name not in comparison.plan.inputs[comparison.quantity.id] or right == 0:
        return
    if not math.isfinite(right) or comparison.plan.quantities[name].kind is Kind.VERDICT:
        return
    tried = right * _SPAN
    values = {**comparison.follow_through.evaluation.values, name: tried}
    results = evaluate_formula(formula, comparison.quantity.unit, values, comparison.plan.columns)
    size = factor(comparison.quantity.unit)
    typed = comparison.value * size
    half = _reach(comparison) * size
    away = np.broadcast_to(results, tried.shape) - typed
    for place in np.flatnonzero(np.sign(away[:-1]) * np.sign(away[1:]) < 0).tolist():
        yield _between(comparison, tried, away, place, half)


def _reach(comparison: Comparison) -> float:
    """Return how far a typed number may be from what the formula gives at the right input.

    Digits may be cut off, and the other inputs stand for more digits than were typed.
    """
    answer, policy, follows = comparison.answer, comparison.policy, comparison.follows
    half_unit = max(typed_half_unit(answer, policy), _FINEST * abs(comparison.value))
    spread = (follows.high - follows.low) / 2
    if not (math.isfinite(spread) and follows.value):
        return 2 * policy.last_digit * half_unit
    share = min(spread / abs(follows.value), _MOST_SPREAD)
    return 2 * policy.last_digit * half_unit + share * abs(comparison.value)


def _between(
    comparison: Comparison,
    tried: NDArray[np.float64],
    away: NDArray[np.float64],
    place: int,
    half: float,
) -> _Span:
    """Return the range round a crossing, on the straight line between two tried values."""
    first, second = float(tried[place]), float(tried[place + 1])
    before, after = float(away[place]), float(away[place + 1])
    slope = (after - before) / (second - first)
    root = first - before / slope
    # The line bends between tried values; its sagitta is far below their distance.
    reach = abs(half / slope) + 1e-4 * (second - first)
    return _Span(comparison, root - reach, root + reach)


def _common(name: str, spans: Sequence[_Span], prior: float) -> Substitution | None:
    """Return the value at which most answers' ranges overlap, if chance is unlikely enough."""
    best: Substitution | None = None
    for start in spans:
        inside = {
            span.comparison.quantity.id: span
            for span in spans
            if span.low <= start.low <= span.high
        }
        if len(inside) < _LEAST_ANSWERS or (best and len(inside) < len(best.explains)):
            continue
        found = _substitution(name, list(inside.values()), prior)
        if found is not None and (best is None or found.odds > best.odds):
            best = found
    return best


def _substitution(name: str, spans: Sequence[_Span], prior: float) -> Substitution | None:
    comparison = spans[0].comparison
    low = max(span.low for span in spans)
    high = min(span.high for span in spans)
    right = abs(float(comparison.follow_through.evaluation.values[name]))
    value = (low + high) / 2
    if value * right <= 0:
        return None
    odds = prior * _scatter(value, right, comparison.policy.slips.spread) * (high - low)
    for span in spans:
        odds *= 1 / (2 * _reach(span.comparison)) / (unexplained(span.comparison) or math.inf)
    certain = comparison.policy.slips.certain
    if odds < certain / (1 - certain) or math.isclose(value, right, rel_tol=1e-3):
        return None
    unit = factor(comparison.plan.quantities[name].unit)
    order = list(comparison.plan.quantities)
    explains = sorted((span.comparison.quantity.id for span in spans), key=order.index)
    return Substitution(name, value / unit, tuple(explains), odds, "")


def _scatter(value: float, right: float, spread: float) -> float:
    away = math.log(value / right) / spread
    return math.exp(-away * away / 2) / (value * spread * math.sqrt(2 * math.pi))


def by_answer(found: Sequence[Substitution]) -> Mapping[str, Substitution]:
    """Return the substitution of each explained answer, by id."""
    return {name: one for one in found for name in one.explains}
