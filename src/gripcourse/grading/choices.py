"""Design decisions judged as decisions: a set of sound values, not one number."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.quantity import Choice, Quantity, Rounding
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.formula.tree import Formula
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.size_condition import Satisfies, conditions_at_own
from gripcourse.slips.model import SlipId
from gripcourse.solver.condition_text import condition_text
from gripcourse.solver.numbers import PlainNumbers
from gripcourse.solver.plan import Plan
from gripcourse.solver.size_numbers import entry_number
from gripcourse.text.words import LANGUAGES, Message, Texts, counted, message

Array: TypeAlias = NDArray[np.float64]

# Series hold decimal numbers; a typed entry differs from them only in floating point.
_SAME = 1e-6
_SLACK = 1e-9


@dataclass(frozen=True, slots=True)
class ChoiceVerdict:
    """Whether a decision is sound, and what is wrong with it where it is not.

    Attributes:
        sound: whether it is.
        fault: for the student; None for none.
        slip: that this is; None where the fault has no name.
    """

    sound: bool
    fault: Message | None
    slip: SlipId | None = None


def judge_choice(
    plan: Plan,
    quantity: Quantity,
    chosen: float,
    required: float,
    satisfies: Satisfies,
) -> ChoiceVerdict:
    """Judge a decision against the rule of its quantity.

    Args:
        plan: for the catalogues.
        quantity: a choice.
        chosen: the student's value, SI.
        required: what the chosen entry must not be below, or be near to, SI.
        satisfies: tells of a size whether it satisfies the rule's condition.
    """
    choice = quantity.choice
    if choice is None or not math.isfinite(required):
        return ChoiceVerdict(sound=False, fault=None)
    if not _in_series(plan, choice, chosen):
        return ChoiceVerdict(sound=False, fault=message("This size is not in the series."))
    entries = plan.columns[choice.column].sizes
    fault = _FAULTS[choice.rounding](entries, choice, chosen, required, satisfies)
    if fault is not None:
        return ChoiceVerdict(sound=False, fault=fault)
    if not satisfies(chosen):
        slip = SlipId.not_stepped_up(quantity.id) if quantity.steps_up else None
        return ChoiceVerdict(sound=False, fault=_unsatisfied(plan, quantity), slip=slip)
    return ChoiceVerdict(sound=True, fault=None)


def _unsatisfied(plan: Plan, quantity: Quantity) -> Message:
    """Say that a size does not satisfy the condition, and what to do where the choice steps up."""
    if not quantity.steps_up:
        return message("The size does not satisfy the condition of the rule.")
    condition = {one: condition_text(quantity, plan, one) for one in LANGUAGES}
    return message(
        "The size is not below the required value, but it does not satisfy {condition}: step up to "
        "the next size that does.",
        condition=Texts(condition),
    )


def sound_sizes(comparison: Comparison, name: str) -> list[float]:
    """Return the sizes, SI, that a decision may sensibly take at a student's own numbers."""
    # A last digit of what is required may decide between two neighbours.
    margin = comparison.policy.tolerance.relative
    return sizes_at(comparison.plan, name, comparison.follow_through.numbers, margin)


def sizes_at(plan: Plan, name: str, numbers: PlainNumbers, margin: float = 0.0) -> list[float]:
    """Return the sizes, SI, that a decision may sensibly take; none where nobody decides.

    Args:
        plan: that the decision belongs to.
        name: of the decision.
        numbers: at which it is taken.
        margin: share by which what is required may be another.
    """
    formula = plan.reference_formula(name)
    return [] if formula is None else sizes_by(plan, name, formula, numbers, margin)


def sizes_by(
    plan: Plan, name: str, formula: Formula, numbers: PlainNumbers, margin: float = 0.0
) -> list[float]:
    """Do the same where a formula, the reference's or another reading's, says what is required."""
    quantity = plan.quantities[name]
    if quantity.choice is None:
        return []
    required = evaluate_number(formula, quantity.unit, numbers.values, plan.columns)
    columns = (quantity.choice.column, *quantity.choice.also)
    entries = np.unique(np.concatenate([plan.columns[one].sizes for one in columns]))
    satisfied = conditions_at_own(plan, quantity, numbers)
    ends = [required * (1 - margin)]
    if quantity.choice.rounding is Rounding.NEAREST:
        ends.append(required * (1 + margin))
    return [
        float(entry)
        for entry in entries
        if any(
            judge_choice(plan, quantity, float(entry), end, satisfies).sound
            for end in ends
            for satisfies in satisfied
        )
    ]


def printed_choice(plan: Plan, quantity: Quantity, required: float) -> float | None:
    """Return the entry that a source takes where it rounds in another way, SI."""
    choice = quantity.choice
    rounding = next((one.rounding for one in quantity.as_printed if one.rounding), None)
    if choice is None or rounding is None:
        return None
    return entry_number(plan, choice, Rounding(rounding), required)


def same_size(one: float, other: float) -> bool:
    """Tell whether two sizes are one entry of a series."""
    return math.isclose(one, other, rel_tol=_SAME)


def largest_size(plan: Plan, choice: Choice) -> float:
    """Return the largest size, SI, of all series that a decision may take one from."""
    series = (plan.columns[column].sizes for column in (choice.column, *choice.also))
    return max(float(sizes.max()) for sizes in series)


def _in_series(plan: Plan, choice: Choice, chosen: float) -> bool:
    entries = np.concatenate([plan.columns[name].sizes for name in (choice.column, *choice.also)])
    return bool(np.any(np.abs(entries - chosen) <= _SAME * abs(chosen)))


def _fault_up(
    series: Array, choice: Choice, chosen: float, required: float, satisfies: Satisfies
) -> Message | None:
    """Say what is wrong with a size that must not be below the required value."""
    if chosen < required * (1 - _SLACK):
        return message("The size is below the required value.")
    if choice.steps is None:
        return None
    first = int(np.searchsorted(series, required * (1 - _SLACK)))
    if choice.step_up:
        larger = range(first, len(series))
        first = next((place for place in larger if satisfies(float(series[place]))), first)
    largest = float(series[min(first + choice.steps, len(series) - 1)])
    if chosen <= largest * (1 + _SAME):
        return None
    return counted(
        "Wastefully large: more than {count} step above the smallest size that fits.",
        "Wastefully large: more than {count} steps above the smallest size that fits.",
        choice.steps,
    )


def _fault_nearest(
    series: Array, choice: Choice, chosen: float, required: float, _: Satisfies
) -> Message | None:
    """Say what is wrong with a size that must be near the required value, on either side of it."""
    distances = np.abs(series - required)
    steps, place = choice.steps or 0, int(np.argmin(distances))
    lowest, highest = series[max(place - steps, 0)], series[min(place + steps, len(series) - 1)]
    if lowest * (1 - _SAME) <= chosen <= highest * (1 + _SAME):
        return None
    # Between two entries, and in a series that is accepted too, several may be equally near.
    if abs(chosen - required) <= distances[place] + _SAME * abs(required):
        return None
    if not steps:
        return message("Not the nearest size: another one is nearer to the required value.")
    return counted(
        "Too far from what is required: more than {count} step from the nearest size.",
        "Too far from what is required: more than {count} steps from the nearest size.",
        steps,
    )


_Fault: TypeAlias = Callable[[Array, Choice, float, float, Satisfies], Message | None]
_FAULTS: Final[Mapping[Rounding, _Fault]] = {
    Rounding.UP: _fault_up,
    Rounding.NEAREST: _fault_nearest,
}
