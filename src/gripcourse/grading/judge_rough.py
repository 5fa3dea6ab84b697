"""Judging a number that is right but rounded too far: whole millimetres where tenths matter."""

from gripcourse.course.quantity import Kind
from gripcourse.grading.comparison import Comparison, Judgement, conclude
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.rounding import figure_half_unit
from gripcourse.policy.bands import SLACK
from gripcourse.submission.model import Answer
from gripcourse.text.words import Message, message

# Beyond this share of the value a rounded number says too little to earn anything.
ROUGHEST = 0.05
_LOST_BY_ZEROS = 0.1  # share of the value


def judge_rough(comparison: Comparison) -> Judgement | None:
    """Conclude that a number is the expected one, rounded or cut off where it was typed to end.

    Args:
        comparison: of an answer that lies in no band.

    Returns:
        What is concluded from the reference or from the student's own numbers, whichever earns
        more; None where the last typed digit does not explain the difference, or the answer is one
        that is taken as it stands.
    """
    own = comparison.follows.nearest(comparison.value)
    best: Judgement | None = None
    for target, against in ((comparison.reference, Against.REFERENCE), (own, Against.OWN_INPUTS)):
        found = judge_rounded(comparison, target, against)
        if found is not None and (best is None or found.credit > best.credit):
            best = found
    return best


def judge_rounded(comparison: Comparison, target: float, against: Against) -> Judgement | None:
    """Conclude that a number is a certain one, rounded or cut off; None where it is not.

    Args:
        comparison: of the answer.
        target: the number, in the declared unit.
        against: where it comes from.
    """
    if not is_rounded_from(comparison, target):
        return None
    earns = abs(comparison.value - target) <= ROUGHEST * abs(target)
    if comparison.quantity.exact and not earns:
        return None  # nobody rounds a number of a table so far: it is that of another row
    credit = comparison.policy.rough_credit if earns else 0.0
    return conclude(comparison, Outcome.ROUGH, against, credit, _said(comparison, target))


def _said(comparison: Comparison, target: float) -> Message:
    if comparison.quantity.exact:
        return message("Right, but rounded: write a number of a table with all its figures.")
    return message(
        "Right, but rounded too far: give at least {figures} significant figures.",
        figures=_figures(comparison, target),
    )


def is_rounded_from(comparison: Comparison, target: float) -> bool:
    """Tell whether a number is another one, rounded or cut off where it was typed to end."""
    value, half_unit = comparison.value, comparison.answer.half_unit
    decided = comparison.quantity.exact and comparison.quantity.kind is not Kind.PICK
    if value == 0 or decided or comparison.quantity.integer:
        return False
    nearest = max(half_unit, _of_zeros(comparison.answer, target))
    cut = 2 * half_unit * comparison.policy.last_digit if abs(value) < abs(target) else 0.0
    away = abs(value - target)
    # Cutting off leaves a number below the next whole unit: 18 is 18.97, and not 19.
    return nearest > 0 and (away <= nearest * SLACK or away * SLACK < cut)


def _of_zeros(answer: Answer, target: float) -> float:
    """Return half a unit of the last digit before the zeros: 190 for 194, 40 for 38.

    Zeros may be the digits of another number, so little must be lost by them: 30 is no rounded 25.
    """
    if answer.value is None or answer.figures is None:
        return 0.0
    return min(figure_half_unit(answer.value, answer.figures), _LOST_BY_ZEROS * abs(target))


def _figures(comparison: Comparison, target: float) -> int:
    """Return how many significant figures keep a rounded number in its band."""
    figures = comparison.policy.figures
    while figure_half_unit(target, figures) > comparison.band_round(target):
        figures += 1
    return figures
