"""Naming a slip: which wrong method explains an answer, and how certain that is.

A wrong number is near some wrong method's result by chance more often than one thinks. So each
method is weighed: how common it is, how well it meets the number as typed (half a unit of the last
digit, widened only by what the rounding of the inputs can move), against all others and against a
wrong number that nothing explains, which may be anywhere.
"""

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

from gripcourse.formula.tree import Call
from gripcourse.grading.comparison import Comparison, ExpectedRange
from gripcourse.grading.rounding import typed_half_unit, without_zeros
from gripcourse.grading.shortened import with_shortened
from gripcourse.policy.slips import OF_WRITING, SlipKind, SlipPolicy
from gripcourse.slips.model import Candidate
from gripcourse.text.units import factor

# The last digits of a number differ by the route: 3.14159 for pi.
_FINEST: Final = 5e-6
# Zeros that a cell has lost go on for three more digits at least.
_SHORTEST: Final = 1e-3
# Methods whose results agree so far cannot be told apart by any number.
_ALIKE: Final = 1e-6
# Shares of the people who round, and of those who cut digits off where the policy thinks of them.
_ROUNDED, _CUT_OFF = 0.9, 0.1
# A short number in a cell may have lost zeros of three figures, or of as many as the calculator
# has, or may have been typed so coarsely.
_ZEROS_LOST, _EXACT, _COARSE = 0.67, 0.3, 0.03
# Few round large whole numbers to the figures that are asked.
_ROUND_NUMBERS = 0.2
# People compute from their own numbers; few take one of somebody else's that is right.
_FROM_OWN, _FROM_REFERENCE = 0.9, 0.1
# Some carry on the typed number, some the one in the calculator.
_CARRIED_TYPED, _CARRIED_EXACT = 0.5, 0.5
_LATER: Final = 4  # answers that are asked
_TWO: Final = 2
_MOST_NAMED: Final = 3  # methods: more tell a student nothing
FROM_HABIT: Final = 0.2
"""Few shorten a constant so much that the result shows it."""

_SLACK: Final = 1e-9  # relative: what floating point leaves of equal numbers
# Spreads: farther off a log-normal density would be 0, and no other explanation could be weighed.
_FARTHEST: Final = 10.0
_HABITS_MOVE: Final = 0.1  # the share by which a shortened constant may change a result


@dataclass(frozen=True, slots=True)
class Weighed:
    """A wrong method, of which quantity it is, its result here in the declared unit, its weight."""

    of: str
    candidate: Candidate
    value: float
    weight: float


@dataclass(frozen=True, slots=True)
class Explanation:
    """What explains a wrong answer.

    Attributes:
        likeliest: the wrong method.
        tied: others that may explain the answer too, likeliest first.
    """

    likeliest: Weighed
    tied: tuple[Weighed, ...]


def weigh(comparison: Comparison, candidates: Sequence[Candidate]) -> list[Weighed]:
    """Weigh wrong methods of the answer's own formula against what was typed.

    Returns:
        Those that meet it, in the order of the candidates.
    """
    furthest, own = _furthest(comparison), comparison.own_inputs
    weighed = (_weigh(comparison, one, furthest, own) for one in candidates)
    return [one for one in weighed if one.weight > 0]


def _weigh(
    comparison: Comparison, candidate: Candidate, furthest: float, own: Collection[str]
) -> Weighed:
    follow_through = comparison.near_own(candidate.formula, furthest)
    met = _FROM_OWN * _met(comparison, follow_through)
    if any(name in own for name in candidate.formula.names):
        reference = comparison.at_reference(candidate.formula)
        met += _FROM_REFERENCE * _met(comparison, ExpectedRange(reference, reference, reference))
    else:
        met += _FROM_REFERENCE / _FROM_OWN * met
    if met == 0 and abs(comparison.value - follow_through.value) <= _HABITS_MOVE * abs(
        follow_through.value
    ):
        met = FROM_HABIT * max(
            (
                _met(comparison, comparison.near_own(one.formula, furthest))
                for one in with_shortened(candidate.formula, comparison.policy.habits)
            ),
            default=0.0,
        )
    return Weighed(comparison.quantity.id, candidate, follow_through.value, candidate.prior * met)


def _furthest(comparison: Comparison) -> float:
    """Return how far from a result a typed number can be that it still speaks for."""
    half_units = (
        comparison.answer.half_unit,
        typed_half_unit(comparison.answer, comparison.policy),
        without_zeros(comparison.answer, comparison.policy),
        _FINEST * abs(comparison.value),
    )
    return max(half_units) * max(1.0, 2 * comparison.policy.last_digit) + _SLACK * abs(
        comparison.value
    )


def with_later_answers(found: Weighed, later: Sequence[Comparison]) -> Weighed:
    """Let what was computed on from an answer speak for a method or against it.

    Who carries on the number in the calculator shows its digits in the next answers, and they tell
    methods apart that the typed number cannot.
    """
    weight = found.weight
    for comparison in later[:_LATER]:
        typed = (
            density(comparison, comparison.follows) if math.isfinite(comparison.expected) else 0.0
        )
        if typed > 0:
            exact = density(comparison, comparison.following(found.of, found.value))
            weight *= _CARRIED_TYPED + _CARRIED_EXACT * exact / typed
    return replace(found, weight=weight)


def _met(comparison: Comparison, result: ExpectedRange) -> float:
    return density(comparison, result) if math.isfinite(result.value) else 0.0


def conclude(
    comparison: Comparison, weighed: Sequence[Weighed], rival: float = 0.0
) -> Explanation | None:
    """Name the wrong method behind an answer.

    Args:
        comparison: of the answer, which is wrong.
        weighed: all the methods that were thought of.
        rival: weight of what is no method and explains the answer too.

    Returns:
        The method, or the few of which one explains it certainly; None where it is not explained.
    """
    policy = comparison.policy.slips
    met = [one for one in weighed if one.weight > 0]
    if not met:
        return None
    total = rival + _weight_of(met) + _by_no_method(comparison) * policy.unexplained
    groups = sorted(_alike(met), key=_weight_of, reverse=True)
    if _weight_of(groups[0]) / total >= policy.certain:
        return _named(comparison, groups[0])
    for count in range(_TWO, _MOST_NAMED + 1):
        some = [_what_holds(group, policy) for group in groups[:count]]
        together = sum(map(_weight_of, groups[:count])) / total >= policy.certain
        # Three in steps of their own would be too long a sentence to help anybody.
        few = count == _TWO or len({one.of for one in some}) == 1
        if together and few and len(some) == count:
            return Explanation(some[0], tuple(some[1:]))
    return None


def density(comparison: Comparison, result: ExpectedRange) -> float:
    """Return how densely typed numbers lie at an answer, for people who compute this result."""
    if comparison.value == 0:
        return 0.0  # it has no last digit, and says nothing about where it comes from
    rounded = without_zeros(comparison.answer, comparison.policy)
    as_typed = _as_typed(comparison, result)
    if rounded == 0:
        return as_typed
    # Zeros end a number by rounding, or by chance: each with one in ten.
    by_chance = (1 - _ROUND_NUMBERS) * comparison.answer.half_unit / rounded
    share = _ROUND_NUMBERS / (_ROUND_NUMBERS + by_chance)
    return share * _density(comparison, result, rounded) + (1 - share) * as_typed


def _as_typed(comparison: Comparison, result: ExpectedRange) -> float:
    value = comparison.value
    finest = _FINEST * abs(value)
    fine = max(typed_half_unit(comparison.answer, comparison.policy), finest)
    coarse = max(comparison.answer.half_unit, finest)
    if coarse <= fine:
        return _density(comparison, result, fine)
    return (
        _ZEROS_LOST * _density(comparison, result, fine)
        + _EXACT * _density(comparison, result, max(finest, _SHORTEST * coarse))
        + _COARSE * _density(comparison, result, coarse)
    )


def _density(comparison: Comparison, result: ExpectedRange, half_unit: float) -> float:
    nearest = result.nearest(comparison.value)
    distance = abs(comparison.value - nearest)
    width = result.high - result.low
    cut = 2 * half_unit * comparison.policy.last_digit
    slack = _SLACK * abs(comparison.value)
    if distance <= half_unit + slack:
        return _ROUNDED / (width + 2 * half_unit)
    # What is cut off is written nearer to zero than it is.
    if distance <= cut + slack and abs(comparison.value) < abs(nearest):
        return _CUT_OFF / (width + 2 * cut)
    return 0.0


def unexplained(comparison: Comparison) -> float:
    """Return how densely wrong numbers that nothing explains lie at an answer.

    They scatter log-normally about the right one, and none is impossible; either sign may be wrong
    too.
    """
    size = abs(comparison.value)
    right = abs(
        comparison.reference if math.isfinite(comparison.reference) else comparison.expected
    )
    if size == 0 or right == 0 or not math.isfinite(right):
        return 1.0 / (size or 1.0)
    spread = comparison.policy.slips.spread
    away = min(abs(math.log(size / right) / spread), _FARTHEST)
    return math.exp(-away * away / 2) / (2 * size * spread * math.sqrt(2 * math.pi))


def _by_no_method(comparison: Comparison) -> float:
    """Return how densely numbers lie at an answer that come of no wrong method.

    Some may be anywhere. Where a table is read between its rows, as many again are read at a wrong
    place: they are any of the numbers between its entries, and often one of the entries.
    """
    anywhere, formula = unexplained(comparison), comparison.quantity.formula
    match None if formula is None else formula.tree:
        case Call("interpolate", _, str(column)):
            entries = comparison.plan.columns[column].values / factor(comparison.quantity.unit)
            least, most = float(entries.min()), float(entries.max())
            if least <= comparison.value <= most and least < most:
                return anywhere + 1 / (most - least)
    return anywhere


def density_alone(
    comparison: Comparison, met: Sequence[Weighed], candidates: Sequence[Candidate]
) -> float:
    """Return how densely numbers lie at an answer that is wrong by itself, for whatever reason.

    Args:
        comparison: of the answer.
        met: the wrong methods that meet it.
        candidates: all that were thought of.
    """
    nothing = comparison.policy.slips.unexplained
    weight = _weight_of(met) + nothing * unexplained(comparison)
    return weight / (nothing + sum(one.prior for one in candidates))


def _alike(weighed: Sequence[Weighed]) -> list[list[Weighed]]:
    """Group methods whose results no number can tell apart, the likeliest first in each."""
    groups: list[list[Weighed]] = []
    for one in sorted(weighed, key=lambda found: found.weight, reverse=True):
        for group in groups:
            if math.isclose(one.value, group[0].value, rel_tol=_ALIKE):
                group.append(one)
                break
        else:
            groups.append([one])
    return groups


def _weight_of(group: Sequence[Weighed]) -> float:
    return sum(one.weight for one in group)


def _named(comparison: Comparison, group: Sequence[Weighed]) -> Explanation:
    """Name the likeliest of methods with one result, or what holds whichever it was."""
    policy = comparison.policy.slips
    first = _what_holds(group, policy)
    if first.candidate.kind == SlipKind.UNIT:
        return Explanation(first, tuple(_through_an_input(comparison, group))[:1])
    tied = [one for one in group if one is not first and first.weight < policy.tie * one.weight]
    return Explanation(first, tuple(tied[:1]) if first is group[0] else ())


def _through_an_input(comparison: Comparison, group: Sequence[Weighed]) -> Iterator[Weighed]:
    """Yield what led to another unit where the result is not as many times too large as the input.

    A torque in N·m over a stress in MPa is cm³, so that its root comes out in cm: true, and no help
    to somebody who never thought of centimetres.
    """
    for one in group:
        if one.candidate.kind == SlipKind.INPUT_UNIT:
            times = float(one.candidate.id.detail.split(",")[1])
            if not math.isclose(one.value, times * comparison.expected, rel_tol=_SHORTEST):
                yield one


def _what_holds(group: Sequence[Weighed], policy: SlipPolicy) -> Weighed:
    """Return a method that says of the result what is true whichever method led to it.

    A result is a tenth of the right one whether this input or that was a tenth of what it is.
    """
    first = group[0]
    if first.candidate.kind != SlipKind.INPUT_UNIT:
        return first
    if first.weight >= policy.certain * _weight_of(group):
        return first
    of_writing = (one for one in group if one.candidate.kind in OF_WRITING)
    return next(of_writing, first)
