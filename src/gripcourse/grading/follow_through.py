"""The calculation at the student's own numbers.

People keep more digits in the calculator than they type, so a typed number stands for a range. What
follows from it is computed with every typed number moved to both ends of its range, one at a time:
the moves add up to the range in which an honest continuation may lie.
"""

import math
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.formula.evaluate import evaluate_number
from gripcourse.grading.rounding import reach_of
from gripcourse.policy.model import Policy
from gripcourse.solver.numbers import PlainNumbers, evaluate_numbers
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Evaluation, evaluate, to_si
from gripcourse.submission.model import Answer, Reading
from gripcourse.text.units import factor

_SAME: Final = 1e-9


@dataclass(frozen=True, slots=True)
class FollowThrough:
    """What follows from a student's own numbers, in SI.

    Attributes:
        known: what everything else is computed from: issued values, answers that are carried on,
            and what stands in.
        numbers: every quantity at the student's numbers where they are carried, else computed
            from what is upstream.
        evaluation: the same as arrays of shape ().
        moved: the same with the typed numbers moved, arrays of shape (1 + 2n,): as typed first,
            then for each of n typed numbers its lower and its upper end.
        ranges: the lowest and the highest value that each formula gives for the moved numbers.
        not_carried: ids of answers that were read and are not carried on, because they fail their
            guard or are physically unthinkable.
        bridged: ids that could not be computed from the student's numbers; the reference stands in
            for them downstream.
        own: ids of the quantities whose values are not those of the reference.
    """

    known: Mapping[str, float]
    numbers: PlainNumbers
    evaluation: Evaluation
    moved: Evaluation
    ranges: Mapping[str, tuple[float, float]]
    not_carried: frozenset[str]
    bridged: frozenset[str]
    own: frozenset[str]


def follow(
    plan: Plan,
    given: Mapping[str, float],
    answers: Mapping[str, Answer],
    reference: Mapping[str, float],
    policy: Policy,
    anyway: Collection[str] = (),
) -> FollowThrough:
    """Evaluate a plan at a student's own numbers.

    Args:
        plan: what is computed.
        given: the issued values, in declared units.
        answers: what the student wrote.
        reference: the reference values in SI, to stand in where the student's numbers lead nowhere.
        policy: how far a number may be from the typed one.
        anyway: answers that are carried on though they are physically unthinkable.

    Returns:
        The evaluation; a blank or unreadable answer is computed from what is upstream.
    """
    inputs, carried = to_si(plan, given), _thinkable(plan, answers, anyway)
    first = evaluate_numbers(plan, inputs | carried)
    refused = {
        name for name in carried if name not in anyway and not _guard_holds(plan, name, first)
    }
    kept = {name: value for name, value in carried.items() if name not in refused}
    numbers, stand_in = _bridge(plan, inputs | kept, reference, None if refused else first)
    evaluation = numbers.as_arrays()
    read = {name for name, answer in answers.items() if answer.reading is Reading.READ}
    known = inputs | kept | stand_in
    moved = _moved(plan, evaluation, known, _reaches(plan, answers, kept, policy))
    return FollowThrough(
        known=known,
        numbers=numbers,
        evaluation=evaluation,
        moved=moved,
        ranges=_ranges(moved.computed),
        not_carried=frozenset(read - set(kept)),
        bridged=frozenset(stand_in),
        own=frozenset(_differing(numbers.values, reference)),
    )


def _differing(values: Mapping[str, float], reference: Mapping[str, float]) -> Iterator[str]:
    for name, value in values.items():
        if not math.isclose(value, reference.get(name, math.nan), rel_tol=_SAME):
            yield name


def _thinkable(
    plan: Plan, answers: Mapping[str, Answer], anyway: Collection[str]
) -> dict[str, float]:
    """Return the answers that may be carried on, SI."""
    values = {
        name: answer.value
        for name, answer in answers.items()
        if answer.value is not None and (name in anyway or _is_thinkable(plan, answer))
    }
    return to_si(plan, values)


def _reaches(
    plan: Plan, answers: Mapping[str, Answer], kept: Iterable[str], policy: Policy
) -> dict[str, tuple[float, float]]:
    """Return how far each kept number may be from what was typed, below and above, SI."""
    found = {}
    for quantity in (plan.quantities[name] for name in kept):
        # What is taken as it stands has no digits that were not typed.
        if not quantity.exact and not quantity.integer:
            below, above = reach_of(answers[quantity.id], policy)
            found[quantity.id] = (below * factor(quantity.unit), above * factor(quantity.unit))
    return found


def range_of(moved: NDArray[np.float64]) -> tuple[float, float]:
    """Return the lowest and the highest value that the moved numbers lead to.

    Args:
        moved: of shape (1 + 2n,) as in `FollowThrough.moved`, or () where no typed number matters.

    Returns:
        The ends of the range, which holds the value as typed; NaN where that is NaN. An end of a
        typed number's range that leads outside a formula's domain does not count.
    """
    if moved.ndim == 0:
        return float(moved), float(moved)
    down, up = _moves(moved)
    base = float(moved[0])
    return base + float(down), base + float(up)


def _ranges(moved: Mapping[str, NDArray[np.float64]]) -> dict[str, tuple[float, float]]:
    """Return the same of many formulas, looked at together."""
    ranges = {name: range_of(one) for name, one in moved.items() if one.ndim == 0}
    names = [name for name in moved if name not in ranges]
    if names:
        table = np.stack([moved[name] for name in names])
        down, up = _moves(table)
        columns = (names, table[:, 0].tolist(), down.tolist(), up.tolist())
        for name, base, lower, upper in zip(*columns, strict=True):
            ranges[name] = (base + lower, base + upper)
    return ranges


def _moves(moved: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return how far down and up all moves together lead; they stand along the last axis."""
    moves = moved[..., 1:] - moved[..., :1]
    moves[np.isnan(moves)] = 0.0
    lower, upper = moves[..., 0::2], moves[..., 1::2]
    down = np.minimum(np.minimum(lower, upper), 0.0).sum(axis=-1)
    up = np.maximum(np.maximum(lower, upper), 0.0).sum(axis=-1)
    return down, up


def _moved(
    plan: Plan,
    evaluation: Evaluation,
    known: Mapping[str, float],
    reaches: Mapping[str, tuple[float, float]],
) -> Evaluation:
    """Evaluate the plan with each typed number at both ends of its range, one at a time."""
    moving = [name for name, reach in reaches.items() if max(reach) > 0]
    worlds: dict[str, float | NDArray[np.float64]] = dict(known)
    # A size that nobody wrote down is not moved to the next entry of the series by a last digit.
    worlds |= {
        name: float(evaluation.values[name])
        for name, quantity in plan.quantities.items()
        if quantity.exact and name not in known
    }
    for number, name in enumerate(moving):
        values = np.full(1 + 2 * len(moving), known[name])
        values[1 + 2 * number] -= reaches[name][0]
        values[2 + 2 * number] += reaches[name][1]
        worlds[name] = values
    return evaluate(plan, worlds)


def _is_thinkable(plan: Plan, answer: Answer) -> bool:
    low, high = plan.quantities[answer.quantity].bounds
    readable = answer.reading is Reading.READ and answer.unit_fits
    return readable and answer.value is not None and low <= answer.value <= high


def _guard_holds(plan: Plan, name: str, numbers: PlainNumbers) -> bool:
    guard = plan.quantities[name].valid
    if guard is None:
        return True
    return evaluate_number(guard, "", numbers.values, plan.columns) == 1.0


def _bridge(
    plan: Plan,
    known: Mapping[str, float],
    reference: Mapping[str, float],
    numbers: PlainNumbers | None,
) -> tuple[PlainNumbers, dict[str, float]]:
    """Let the reference stand in for what the student's numbers leave without a value.

    A size that no catalogue holds has nothing beside it in its row; what follows must not be lost
    for that. `numbers` are those at the known values, where they were computed already.
    """
    stand_in: dict[str, float] = {}
    while True:
        numbers = numbers or evaluate_numbers(plan, {**known, **stand_in})
        lost = [
            name
            for name, value in numbers.values.items()
            if math.isnan(value)
            and name not in stand_in
            and math.isfinite(reference.get(name, math.nan))
        ]
        if not lost:
            return numbers, stand_in
        # Only the first is at the root: what follows it may be computed once it has a value.
        stand_in[lost[0]] = reference[lost[0]]
        numbers = None
