"""Where somebody ends all numbers who writes few digits: at two figures, or whole millimetres."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from gripcourse.grading.rounding import figure_half_unit
from gripcourse.submission.model import Answer

_TEN: Final = 10.0  # below it who writes whole numbers writes a decimal
_TWO: Final = 2  # figures of what would be 0 with so few decimals
_EDGE: Final = 1e-6  # of a unit: what floating point leaves
_NEARLY_ALL: Final = 0.9  # share of the numbers that end where all do
_ENOUGH: Final = 3  # numbers: that all of them have lost their zeros is one case in a thousand


@dataclass(frozen=True, slots=True)
class LastDigit:
    """One rule of where numbers end.

    Attributes:
        figures: significant figures of every number; 0 where decimals are counted.
        decimals: of every number.
        whole_from: from this size on numbers are whole, whatever their decimals.
    """

    figures: int = 0
    decimals: int = 0
    whole_from: float = math.inf

    def half_unit(self, value: float) -> float:
        """Return half a unit of the last digit of a number; 0 of a zero."""
        if self.figures:
            return figure_half_unit(value, self.figures)
        half_unit = 0.5 if abs(value) >= self.whole_from else 0.5 * 10.0**-self.decimals
        return half_unit if abs(value) >= half_unit else figure_half_unit(value, _TWO)

    def written(self, value: float) -> float:
        """Return a value as it is written by this rule."""
        unit = 2 * self.half_unit(value)
        if not unit or not math.isfinite(unit):
            return value
        return math.copysign(math.floor(abs(value) / unit * (1 + _EDGE**2) + 0.5) * unit, value)

    def ends(self, answer: Answer) -> bool:
        """Tell whether a number as it was typed has no digit behind the last one."""
        if answer.value is None:
            return False
        unit = 2 * self.half_unit(answer.value)
        return not unit or abs(answer.value / unit - round(answer.value / unit)) <= _EDGE


# From the fewest digits on: who writes whole numbers writes no second decimal either.
_DECIMALS: Final = (
    LastDigit(decimals=1, whole_from=_TEN),
    LastDigit(decimals=1),
    LastDigit(decimals=2),
)


def rule_of(answers: Sequence[Answer], figures: int) -> LastDigit | None:
    """Return the rule by which a student ends numbers; None where it is none of few digits.

    Any number may end with zeros that a cell has lost, but not all do for which a rule leaves fewer
    figures than a careful student writes.

    Args:
        answers: numbers that were computed, as they were typed.
        figures: fewer significant figures are few.
    """
    few = (
        one.value is not None and one.half_unit > figure_half_unit(one.value, figures) * (1 + _EDGE)
        for one in answers
    )
    if sum(few) < _ENOUGH:
        return None
    rules = (*(LastDigit(figures=one) for one in range(_TWO, figures)), *_DECIMALS)
    holding = [one for one in rules if _holds(one, answers, figures)]
    return max(holding, key=lambda one: sum(map(one.ends, answers)), default=None)


def _holds(rule: LastDigit, answers: Sequence[Answer], figures: int) -> bool:
    short = [
        one
        for one in answers
        if one.value is not None
        and rule.half_unit(one.value) > (1 + _EDGE) * figure_half_unit(one.value, figures)
    ]
    return sum(map(rule.ends, short)) >= _ENOUGH and all(
        sum(map(rule.ends, some)) >= min(_NEARLY_ALL * len(some), len(some) - 1)
        for some in (short, answers)
    )
