"""Wrong answers that something may be told from, and how well an input's number explains each."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from gripcourse.course.quantity import Kind
from gripcourse.grading.comparison import Comparison, Judgement
from gripcourse.grading.explain import FROM_HABIT
from gripcourse.grading.roots import Array, reach
from gripcourse.grading.shortened import shortenings
from gripcourse.grading.submission_case import GradingCase, JudgedAnswer
from gripcourse.grading.typed_density import unexplained
from gripcourse.grading.unwritten import carried_here, unwritten_before
from gripcourse.text.units import factor

# How likely a size or a verdict comes out so by chance, where it is wrong: of sizes the next one.
_BY_CHANCE: Final[Mapping[Kind, float]] = {Kind.CHOICE: 0.15, Kind.VERDICT: 0.5}
# A zero has no last digit, and comes out by many mistakes.
_ZERO = 0.2
_SAME: Final = 1e-6
_SLACK: Final = 1e-9


@dataclass(frozen=True, slots=True)
class WrongAnswer:
    """A wrong answer.

    Attributes:
        comparison: of the answer.
        alone: how densely numbers lie at it if it is wrong by itself.
        habits: what people shorten the constants to that lead to it, SI, by name.
        is_far: whether rounding may have done it too, so that it is no evidence without another.
        is_free: whether a slip in a blank step explains it by itself, so that it costs nothing.
    """

    comparison: Comparison
    alone: float
    habits: tuple[Mapping[str, float], ...]
    is_far: bool
    is_free: bool

    @property
    def name(self) -> str:
        """Id of the quantity."""
        return self.comparison.quantity.id

    @property
    def is_range(self) -> bool:
        """Whether it was typed with a last digit, and stands for all numbers that round to it."""
        return self.comparison.quantity.kind not in _BY_CHANCE and self.comparison.value != 0


def wrong_answers(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[WrongAnswer]:
    """Return the wrong answers that something may be told from, in order of calculation."""
    found = {}
    for one in judged:
        comparison = one.comparison
        if comparison is None or not case.is_own or not comparison.answer.unit_fits:
            continue
        is_far, is_free = _is_far(one.judgement), is_from_blank(one.judgement)
        if not (one.judgement.outcome.traits.mistake or is_far or is_free):
            continue
        alone = one.judgement.alone
        if math.isnan(alone):
            alone = unexplained(comparison)
        alone = _ZERO if comparison.value == 0 else alone
        alone = _BY_CHANCE.get(one.quantity.kind, alone) / _steps(comparison)
        habits = tuple(_habits(comparison))
        found[one.quantity.id] = WrongAnswer(comparison, alone, habits, is_far, is_free)
    return [found[name] for name in case.plan.quantities if name in found]


def _steps(comparison: Comparison) -> int:
    """Count how far a size lies from the right one in its series; 1 for the next, and elsewhere.

    A wrong size is often the next one; far ones come of something else that is wrong.
    """
    choice = comparison.quantity.choice
    if choice is None:
        return 1
    sizes = np.sort(comparison.plan.columns[choice.column].sizes)

    def place(size: float) -> int:
        return int(np.argmin(np.abs(sizes - size * factor(comparison.quantity.unit))))

    right = [one for one in (comparison.reference, comparison.expected) if math.isfinite(one)]
    apart = [abs(place(comparison.value) - place(one)) for one in right]
    return max(1, min(apart, default=1))


def _is_far(judgement: Judgement) -> bool:
    """Tell whether an answer may be rounded so far that it earns nothing; or it is another one."""
    return judgement.outcome.traits.coarse and not (judgement.credit or judgement.held)


def is_from_blank(judgement: Judgement) -> bool:
    """Tell whether an answer was explained by a slip in a step that was left blank."""
    return judgement.outcome.traits.follows and judgement.slip is not None


def _habits(comparison: Comparison) -> Iterator[Mapping[str, float]]:
    """Yield what people shorten the constants of an answer to, and of blank steps before it."""
    steps = (*unwritten_before(comparison), comparison.quantity.id)
    return shortenings(comparison.plan, steps, comparison.policy.habits)


def likelihoods(wrong: WrongAnswer, name: str, values: Array) -> Array:
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
