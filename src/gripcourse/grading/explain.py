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

from gripcourse.formula.tree import Call, Formula, Name, Operation
from gripcourse.grading.comparison import Comparison, ExpectedRange
from gripcourse.grading.manner import CARRIED_TYPED
from gripcourse.grading.shortened import with_shortened
from gripcourse.grading.typed_density import density, furthest_met, unexplained
from gripcourse.policy.slips import OF_WRITING, SlipKind, SlipPolicy
from gripcourse.slips.model import Candidate
from gripcourse.slips.rewrite import scaled
from gripcourse.text.units import factor

# Methods whose results agree so far cannot be told apart by any number.
_ALIKE: Final = 1e-6
_OF_WEIGHT: Final = "kgf"  # the unit whose factor is the standard gravity
# People compute from their own numbers; few take one of somebody else's that is right.
_FROM_OWN, _FROM_REFERENCE = 0.9, 0.1
_LATER: Final = 4  # answers that are asked
_TWO: Final = 2
_MOST_NAMED: Final = 3  # methods: more tell a student nothing
FROM_HABIT: Final = 0.2
"""Few shorten a constant so much that the result shows it."""

_AS_MANY: Final = 1e-3  # relative: two numbers are as many times another one
_HABITS_MOVE: Final = 0.1  # the share by which a shortened constant may change a result


@dataclass(frozen=True, slots=True)
class Weighed:
    """A wrong method of a quantity, with what it comes to here and how it is weighed.

    Attributes:
        of: id of the quantity.
        candidate: the method.
        value: its result at the student's numbers, in the declared unit.
        weight: against others.
        is_sharp: whether what earlier numbers lost in typing moves the result by no more than a
            unit of the last typed digit: else nobody knows what the calculator held.
    """

    of: str
    candidate: Candidate
    value: float
    weight: float
    is_sharp: bool = True


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
    furthest, own = furthest_met(comparison), comparison.own_inputs
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
    if abs(comparison.value - follow_through.value) <= _HABITS_MOVE * abs(follow_through.value):
        met = _met_by_habit(comparison, candidate, furthest, met)
        met = met or _met_by_gravity(comparison, candidate, furthest)
    width = follow_through.high - follow_through.low
    return Weighed(
        of=comparison.quantity.id,
        candidate=candidate,
        value=follow_through.value,
        weight=candidate.prior * met,
        is_sharp=width <= 2 * comparison.answer.half_unit,
    )


def _met_by_habit(
    comparison: Comparison, candidate: Candidate, furthest: float, met: float
) -> float:
    """Return how well a method meets an answer, by somebody who may have shortened a constant.

    Args:
        comparison: of the answer.
        candidate: the method.
        furthest: see `furthest_met`.
        met: how well it meets the answer with the constants as they are.
    """
    own = comparison.manner.constants
    if met and not own:
        return met
    formula, met_so = candidate.formula, dict[bool, float]()
    for one in with_shortened(formula, comparison.policy.habits):
        is_own = own.get(one.name) == one.value
        found = _met(comparison, comparison.near_own(one.formula, furthest))
        met_so[is_own] = max(met_so.get(is_own, 0.0), found)
    # Who shortens a constant elsewhere does so here, and who does not, does not.
    if True in met_so:
        return max(met_so[True], FROM_HABIT * max(met, met_so.get(False, 0.0)))
    return met or FROM_HABIT * met_so.get(False, 0.0)


def _met_by_gravity(comparison: Comparison, candidate: Candidate, furthest: float) -> float:
    """Return how well a force meets an answer that was divided by the gravity of the course.

    A kilogram-force is the weight of a kilogram under the standard gravity; people compute with
    that of the course.
    """
    gravity = comparison.policy.slips.kinds.get(SlipKind.GRAVITY_LEFT_OUT)
    if candidate.kind != SlipKind.UNIT or gravity is None:
        return 0.0
    standard = factor(_OF_WEIGHT)
    decades = math.log10(factor(candidate.id.detail) / standard)
    if not math.isclose(decades, round(decades), abs_tol=_ALIKE):
        return 0.0
    by_weight = scaled(candidate.formula.tree, standard)
    found = [0.0]
    for name in gravity.names:
        if name in comparison.plan.quantities:
            tree = Operation("/", by_weight, Name(name))
            formula = Formula("", tree, candidate.formula.units)
            found.append(_met(comparison, comparison.near_own(formula, furthest)))
    return max(found)


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
            carries_typed = comparison.manner.carries_typed
            if not found.is_sharp:
                carries_typed = max(carries_typed, CARRIED_TYPED)
            weight *= carries_typed + (1 - carries_typed) * exact / typed
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
    # One of several inputs that would do says no more of a power of ten than that it is one.
    any_input = first.candidate.kind == SlipKind.POWER_OF_TEN and len(_inputs_of(group)) > 1
    tied = [
        one
        for one in group
        if one is not first
        and first.weight < policy.tie * one.weight
        and not (any_input and one.candidate.kind == SlipKind.INPUT_UNIT)
    ]
    return Explanation(first, tuple(tied[:1]) if first is group[0] else ())


def _inputs_of(group: Sequence[Weighed]) -> frozenset[str]:
    """Return the inputs one of which may have been in another unit."""
    details = (one.candidate.id for one in group if one.candidate.kind == SlipKind.INPUT_UNIT)
    return frozenset(one.detail.split(",")[0] for one in details)


def _through_an_input(comparison: Comparison, group: Sequence[Weighed]) -> Iterator[Weighed]:
    """Yield what led to another unit where the result is not as many times too large as the input.

    A torque in N·m over a stress in MPa is cm³, so that its root comes out in cm: true, and no help
    to somebody who never thought of centimetres.
    """
    for one in group:
        if one.candidate.kind == SlipKind.INPUT_UNIT:
            times = float(one.candidate.id.detail.split(",")[1])
            if not math.isclose(one.value, times * comparison.expected, rel_tol=_AS_MANY):
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
