"""One wrong number behind several wrong answers: the mass read wrongly, a friction from elsewhere.

Answers that follow from no formula at the student's numbers may all follow at another value of one
of their inputs. Two explanations are weighed against each other: that one number was taken for
another, and that each of the answers is wrong by itself, by a known slip or for no known reason.
The first has one freedom, the number; the second has one for each answer.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from gripcourse.course.quantity import Kind
from gripcourse.grading.comparison import Comparison, Judgement
from gripcourse.grading.explain import FROM_HABIT, unexplained
from gripcourse.grading.misreading import ANYTHING, misreadings, neighbours
from gripcourse.grading.roots import Array, overlaps, reach, spans
from gripcourse.grading.same_number import same_numbers
from gripcourse.grading.shortened import shortenings
from gripcourse.grading.submission_case import GradingCase, JudgedAnswer
from gripcourse.grading.unwritten import carried_here, unwritten_before
from gripcourse.text.units import factor

# How often a number is taken for another, and how often an answer is wrong by itself.
_TAKEN_WRONGLY, _MISTAKEN = 0.005, 0.03
# From even odds on, the doubt is the student's gain: it costs once. Only a certain number is named.
_LEAST_ODDS: Final = 1.0
_LEAST_ANSWERS: Final = 2
# Who takes a number for another takes it so everywhere, but for one time in five.
_ELSEWHERE_RIGHT: Final = 0.2
_MOST_RIGHT: Final = 3  # such answers that count
# How likely a size or a verdict comes out so by chance, where it is wrong.
_BY_CHANCE: Final[Mapping[Kind, float]] = {Kind.CHOICE: 0.15, Kind.VERDICT: 0.5}
# A zero has no last digit, and comes out by many mistakes.
_ZERO = 0.2
_SAME: Final = 1e-6
_SLACK: Final = 1e-9


@dataclass(frozen=True, slots=True)
class Substitution:
    """A number that several wrong answers have in common.

    Attributes:
        quantity: id of the input that it was used for.
        value: what was used, in the declared unit; NaN where several numbers may have been.
        explains: ids of the answers that follow from it; the first is the one that it costs.
        odds: of it against each answer being wrong by itself.
        tied: another input whose number explains the same answers as well; empty for none.
        named: whether it is certain that it was this input, or the tied one.
    """

    quantity: str
    value: float
    explains: tuple[str, ...]
    odds: float
    tied: str
    named: bool = True


@dataclass(frozen=True, slots=True)
class _Wrong:
    """A wrong answer.

    Attributes:
        comparison: of the answer.
        alone: how densely numbers lie at it if it is wrong by itself.
        habits: what people shorten the constants to that lead to it, SI, by name.
        is_far: whether rounding may have done it too, so that it is no evidence without another.
    """

    comparison: Comparison
    alone: float
    habits: tuple[Mapping[str, float], ...]
    is_far: bool

    @property
    def name(self) -> str:
        """Id of the quantity."""
        return self.comparison.quantity.id

    @property
    def is_range(self) -> bool:
        """Whether it was typed with a last digit, and stands for all numbers that round to it."""
        return self.comparison.quantity.kind not in _BY_CHANCE and self.comparison.value != 0


@dataclass(frozen=True, slots=True)
class _Trial:
    """A number, SI, that may have been used, its share of the wrong ones, and what it explains."""

    value: float
    share: float
    explains: tuple[str, ...]
    likelihood: float


def substitutions(case: GradingCase, judged: Sequence[JudgedAnswer]) -> tuple[Substitution, ...]:
    """Find the numbers that explain several wrong answers each, the most certain first.

    Args:
        case: the submission.
        judged: every answer, those with a known slip too.

    Returns:
        Substitutions that share no answer.
    """
    # What only repeats a number is no evidence of its own for where that comes from.
    repeated = same_numbers(case, judged)
    wrong = [one for one in _wrong(case, judged) if one.name not in repeated]
    if len(wrong) < _LEAST_ANSWERS:
        return ()
    right = [
        one.comparison
        for one in judged
        if one.comparison is not None and one.judgement.outcome.traits.right
    ]
    found = sorted(_all(case, wrong, right), key=lambda one: -one.odds)
    taken: set[str] = set()
    kept: list[Substitution] = []
    for one in found:
        if taken.isdisjoint(one.explains):
            taken |= set(one.explains)
            kept.append(_with_repeated(_certain(one, found, case), repeated))
    return tuple(kept)


def _with_repeated(found: Substitution, repeated: Mapping[str, str]) -> Substitution:
    again = (name for name, first in repeated.items() if first in found.explains)
    return replace(found, explains=(*found.explains, *again))


def _wrong(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[_Wrong]:
    """Return the wrong answers that something may be told from, in order of calculation."""
    found = {}
    for one in judged:
        comparison = one.comparison
        if comparison is None or not case.is_own or not comparison.answer.unit_fits:
            continue
        is_far = _is_far(one.judgement)
        if not (one.judgement.outcome.traits.mistake or is_far):
            continue
        alone = one.judgement.alone
        if math.isnan(alone):
            alone = unexplained(comparison)
        alone = _ZERO if comparison.value == 0 else alone
        alone = _BY_CHANCE.get(one.quantity.kind, alone)
        found[one.quantity.id] = _Wrong(comparison, alone, tuple(_habits(comparison)), is_far)
    return [found[name] for name in case.plan.quantities if name in found]


def _is_far(judgement: Judgement) -> bool:
    """Tell whether an answer may be rounded so far that it earns nothing; or it is another one."""
    return judgement.outcome.traits.coarse and not judgement.credit


def _habits(comparison: Comparison) -> Iterator[Mapping[str, float]]:
    """Yield what people shorten the constants of an answer to, and of blank steps before it."""
    steps = (*unwritten_before(comparison), comparison.quantity.id)
    return shortenings(comparison.plan, steps, comparison.policy.habits)


def _all(
    case: GradingCase, wrong: Sequence[_Wrong], right: Sequence[Comparison]
) -> Iterator[Substitution]:
    users: dict[str, list[_Wrong]] = {}
    for one in wrong:
        before = list(unwritten_before(one.comparison))
        inputs = (case.plan.inputs[name] for name in (one.name, *before))
        for name in dict.fromkeys(name for names in inputs for name in names):
            users.setdefault(name, []).append(one)
    for name, using in users.items():
        if len(using) >= _LEAST_ANSWERS and case.plan.quantities[name].kind is not Kind.VERDICT:
            yield from _of_input(case, name, using, right)


def _of_input(
    case: GradingCase, name: str, using: Sequence[_Wrong], right: Sequence[Comparison]
) -> Iterator[Substitution]:
    """Yield the best explanation by another number for an input, if it is likely enough."""
    number = float(case.follow_through.evaluation.values[name])
    if not math.isfinite(number) or number == 0:
        return
    sets: dict[tuple[str, ...], list[_Trial]] = {}
    evident = {one.name for one in using if not one.is_far}
    for one in _trials(case, name, using, number):
        if len(one.explains) >= _LEAST_ANSWERS and not evident.isdisjoint(one.explains):
            sets.setdefault(one.explains, []).append(one)
    if not sets:
        return
    explains, trials = max(sets.items(), key=lambda pair: _weight(pair[1]))
    best = max(trials, key=lambda one: one.share * one.likelihood)
    odds = _TAKEN_WRONGLY / _MISTAKEN ** len(explains) * _weight(trials)
    odds *= _ELSEWHERE_RIGHT ** min(_MOST_RIGHT, _contradicting(name, best.value, right))
    if odds < _LEAST_ODDS:
        return
    certain = case.policy.slips.certain
    is_told = best.share * best.likelihood >= certain * _weight(
        [one for one in trials if not math.isclose(one.value, best.value, rel_tol=1e-3)] + [best]
    )
    value = best.value / factor(case.plan.quantities[name].unit) if is_told else math.nan
    yield Substitution(name, value, explains, odds, "")


def _weight(trials: Sequence[_Trial]) -> float:
    return sum(one.share * one.likelihood for one in trials)


def _trials(
    case: GradingCase, name: str, using: Sequence[_Wrong], right: float
) -> Iterator[_Trial]:
    """Yield numbers that may have been used: what a number is taken for, then any that fits."""
    unit = factor(case.plan.quantities[name].unit)
    numbers = [(one * unit, share) for one, share in _misread(case, name).items()]
    found = [span for one in using if one.is_range for span in spans(one.comparison, name)]
    spread = case.policy.slips.spread
    numbers += [
        (value, ANYTHING * _scatter(value, right, spread) * width)
        for value, width in overlaps(found)
        if value * right > 0 and not math.isclose(value, right, rel_tol=1e-3)
    ]
    if numbers:
        yield from _tried(name, using, numbers)


def _misread(case: GradingCase, name: str) -> dict[float, float]:
    """Return what the number of an input may have been taken for, in its unit."""
    plan = case.plan
    quantity = plan.quantities[name]
    if quantity.kind is Kind.GIVEN:
        givens = {one.id: (case.given[one.id], one.unit) for one in plan.givens}
        return misreadings(case.given[name], *neighbours(givens, name))
    if quantity.value is not None:
        return misreadings(quantity.value)
    answers = {
        one.id: (answer.value, one.unit)
        for one in plan.answered
        if (answer := case.answers.get(one.id)) is not None and answer.value is not None
    }
    if name not in answers:
        return {}
    return misreadings(answers[name][0], *neighbours(answers, name))


def _tried(
    name: str, using: Sequence[_Wrong], numbers: Sequence[tuple[float, float]]
) -> Iterator[_Trial]:
    values = np.asarray([value for value, _ in numbers])
    likelihoods = [_likelihoods(one, name, values) for one in using]
    for place, (value, share) in enumerate(numbers):
        met = [
            (one.name, float(each[place]))
            for one, each in zip(using, likelihoods, strict=True)
            if each[place] > 0
        ]
        likelihood = math.prod(ratio for _, ratio in met)
        yield _Trial(value, share, tuple(name for name, _ in met), likelihood)


def _likelihoods(wrong: _Wrong, name: str, values: Array) -> Array:
    """Return how much better each number explains an answer than that it is wrong by itself."""
    comparison = wrong.comparison
    with np.errstate(all="ignore"):
        here = carried_here(comparison, name, values) / factor(comparison.quantity.unit)
    if not wrong.is_range:
        scale = abs(comparison.reference) if math.isfinite(comparison.reference) else 0.0
        met = np.isclose(here, comparison.value, rtol=_SAME, atol=_SLACK * scale)
        return np.where(met, 1 / wrong.alone, 0.0)
    half = reach(comparison)
    weight = np.where(np.abs(here - comparison.value) <= half, 1.0, 0.0)
    for constants in wrong.habits:
        with np.errstate(all="ignore"):
            shortened = carried_here(comparison, name, values, constants)
        off = np.abs(shortened / factor(comparison.quantity.unit) - comparison.value)
        weight = np.maximum(weight, np.where(off <= half, FROM_HABIT, 0.0))
    return np.asarray(weight / (2 * half) / wrong.alone)


def _contradicting(name: str, value: float, right: Sequence[Comparison]) -> int:
    """Count the right answers that would be others with this number."""
    users = [one for one in right if name in one.plan.inputs[one.quantity.id]]
    number = np.asarray([value])
    here = ((one, carried_here(one, name, number) / factor(one.quantity.unit)) for one in users)
    return sum(not one.fits(float(result[0])) for one, result in here)


def _scatter(value: float, right: float, spread: float) -> float:
    away = math.log(value / right) / spread
    return math.exp(-away * away / 2) / (abs(value) * spread * math.sqrt(2 * math.pi))


def _certain(best: Substitution, found: Sequence[Substitution], case: GradingCase) -> Substitution:
    """Name an input, or two, only where no other could be it."""
    policy = case.policy.slips
    rivals = [
        one
        for one in found
        if one.quantity != best.quantity and not set(best.explains).isdisjoint(one.explains)
    ]
    total = 1.0 + best.odds + sum(one.odds for one in rivals)
    if best.odds >= policy.certain * total:
        return best
    same = [one for one in rivals if one.explains == best.explains]
    if same and best.odds + same[0].odds >= policy.certain * total:
        return replace(best, tied=same[0].quantity)
    return replace(best, value=math.nan, named=False)


def by_answer(found: Sequence[Substitution]) -> Mapping[str, Substitution]:
    """Return the substitution of each explained answer, by id."""
    return {name: one for one in found for name in one.explains}
