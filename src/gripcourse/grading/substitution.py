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
from gripcourse.grading.blank_methods import BlankMethod, methods_in_blank
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.misreading import ANYTHING, misreadings, neighbours
from gripcourse.grading.roots import overlaps, spans
from gripcourse.grading.same_number import same_numbers
from gripcourse.grading.submission_case import GradingCase, JudgedAnswer
from gripcourse.grading.unwritten import UNWRITTEN, carried_here, unwritten_before
from gripcourse.grading.wrong_answers import WrongAnswer, likelihoods, wrong_answers
from gripcourse.slips.model import Candidate
from gripcourse.text.units import factor

# How often a number is taken for another, and how often an answer is wrong by itself.
_TAKEN_WRONGLY, _MISTAKEN = 0.005, 0.03
# From even odds on, the doubt is the student's gain: it costs once. Only a certain number is named.
_LEAST_ODDS: Final = 1.0
_LEAST_ANSWERS: Final = 2
# Who takes a number for another takes it so everywhere, but for one time in five.
_ELSEWHERE_RIGHT: Final = 0.2
_MOST_RIGHT: Final = 3  # such answers that count


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
        is_slip: whether no number was used wrongly, but a wrong method in a step that was left
            blank, which has cost.
        methods: these, likeliest first; none where it is not certain which.
    """

    quantity: str
    value: float
    explains: tuple[str, ...]
    odds: float
    tied: str
    named: bool = True
    is_slip: bool = False
    methods: tuple[Candidate, ...] = ()


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
    wrong = [one for one in wrong_answers(case, judged) if one.name not in repeated]
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


def _all(
    case: GradingCase, wrong: Sequence[WrongAnswer], right: Sequence[Comparison]
) -> Iterator[Substitution]:
    users: dict[str, list[WrongAnswer]] = {}
    for one in wrong:
        before = list(unwritten_before(one.comparison))
        inputs = (case.plan.inputs[name] for name in (one.name, *before))
        for name in dict.fromkeys(name for names in inputs for name in names):
            users.setdefault(name, []).append(one)
    for name, using in users.items():
        if len(using) < _LEAST_ANSWERS or case.plan.quantities[name].kind is Kind.VERDICT:
            continue
        yield from _of_blank(case, name, using, right)
        costing = [one for one in using if not one.is_free]
        if len(costing) >= _LEAST_ANSWERS:
            yield from _of_input(case, name, costing, right)


def _of_blank(
    case: GradingCase, name: str, using: Sequence[WrongAnswer], right: Sequence[Comparison]
) -> Iterator[Substitution]:
    """Yield the best explanation by a wrong method in a step that was left blank."""
    found = methods_in_blank(case, name)
    if not found or all(one.is_free for one in using):
        return
    tried = list(_tried(name, using, [(one.value, one.share) for one in found]))
    pairs = [
        (trial, method)
        for trial, method in zip(tried, found, strict=True)
        if len(trial.explains) >= _LEAST_ANSWERS
    ]
    if not pairs:
        return
    best, _ = max(pairs, key=lambda pair: _weight([pair[0]]))
    alike = [pair for pair in pairs if pair[0].explains == best.explains]
    odds = UNWRITTEN * _MISTAKEN / _MISTAKEN ** len(best.explains)
    odds *= _weight([trial for trial, _ in alike])
    odds *= _ELSEWHERE_RIGHT ** min(_MOST_RIGHT, _contradicting(name, best.value, right))
    if odds >= _LEAST_ODDS:
        value = best.value / factor(case.plan.quantities[name].unit)
        methods = _told(alike, case)
        yield Substitution(name, value, best.explains, odds, "", is_slip=True, methods=methods)


def _told(found: Sequence[tuple[_Trial, BlankMethod]], case: GradingCase) -> tuple[Candidate, ...]:
    """Return the likeliest method, or two, if one of them is it certainly."""
    ordered = sorted(found, key=lambda pair: -_weight([pair[0]]))
    total = _weight([trial for trial, _ in found])
    for count in (1, 2):
        some = ordered[:count]
        if _weight([trial for trial, _ in some]) >= case.policy.slips.certain * total:
            return tuple(method.candidate for _, method in some)
    return ()


def _of_input(
    case: GradingCase, name: str, using: Sequence[WrongAnswer], right: Sequence[Comparison]
) -> Iterator[Substitution]:
    """Yield the best explanation by another number for an input, if it is likely enough."""
    number = float(case.follow_through.evaluation.values[name])
    if not math.isfinite(number):
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
    case: GradingCase, name: str, using: Sequence[WrongAnswer], right: float
) -> Iterator[_Trial]:
    """Yield numbers that may have been used: what a number is taken for, then any that fits."""
    unit = factor(case.plan.quantities[name].unit)
    numbers = [(one * unit, share) for one, share in _misread(case, name).items()]
    found = [
        span
        for one in using
        if one.is_range and right  # nobody knows how large what is wrong may be beside a zero
        for span in spans(one.comparison, name)
    ]
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
    name: str, using: Sequence[WrongAnswer], numbers: Sequence[tuple[float, float]]
) -> Iterator[_Trial]:
    values = np.asarray([value for value, _ in numbers])
    met_by = [likelihoods(one, name, values) for one in using]
    for place, (value, share) in enumerate(numbers):
        met = [
            (one.name, float(each[place]))
            for one, each in zip(using, met_by, strict=True)
            if each[place] > 0
        ]
        likelihood = math.prod(ratio for _, ratio in met)
        yield _Trial(value, share, tuple(name for name, _ in met), likelihood)


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
    if best.is_slip:
        return replace(best, methods=())
    same = [one for one in rivals if one.explains == best.explains]
    if same and best.odds + same[0].odds >= policy.certain * total:
        return replace(best, tied=same[0].quantity)
    return replace(best, value=math.nan, named=False)


def by_answer(found: Sequence[Substitution]) -> Mapping[str, Substitution]:
    """Return the substitution of each explained answer, by id."""
    return {name: one for one in found for name in one.explains}
