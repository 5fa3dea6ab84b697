"""The calculation at the student's own numbers."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Evaluation, evaluate, to_si
from gripcourse.submission.model import Answer, Reading


@dataclass(frozen=True, slots=True)
class Own:
    """What follows from a student's own numbers, in SI.

    Attributes:
        evaluation: every quantity at the student's numbers where they are carried, else computed
            from what is upstream.
        not_carried: ids of answers that were read and are not carried on, because they fail their
            guard or are physically unthinkable.
        bridged: ids that could not be computed from the student's numbers; the reference stands in
            for them downstream.
    """

    evaluation: Evaluation
    not_carried: frozenset[str]
    bridged: frozenset[str]


def follow(
    plan: Plan,
    given: Mapping[str, float],
    answers: Mapping[str, Answer],
    reference: Mapping[str, float],
) -> Own:
    """Evaluate a plan at a student's own numbers.

    Args:
        plan: what is computed.
        given: the issued values, in declared units.
        answers: what the student wrote.
        reference: the reference values in SI, to stand in where the student's numbers lead nowhere.

    Returns:
        The evaluation; a blank or unreadable answer is computed from what is upstream.
    """
    inputs = to_si(plan, given)
    carried = to_si(
        plan,
        {
            name: answer.value
            for name, answer in answers.items()
            if answer.value is not None and _is_thinkable(plan, answer)
        },
    )
    first = evaluate(plan, inputs | carried)
    refused = {name for name in carried if not _guard_holds(plan, name, first)}
    kept = {name: value for name, value in carried.items() if name not in refused}
    evaluation, bridged = _bridge(plan, inputs | kept, reference)
    read = {name for name, answer in answers.items() if answer.reading is Reading.READ}
    return Own(evaluation, frozenset(read - set(kept)), bridged)


def _is_thinkable(plan: Plan, answer: Answer) -> bool:
    low, high = plan.quantities[answer.quantity].bounds
    readable = answer.reading is Reading.READ and answer.unit_fits
    return readable and answer.value is not None and low <= answer.value <= high


def _guard_holds(plan: Plan, name: str, evaluation: Evaluation) -> bool:
    guard = plan.quantities[name].valid
    if guard is None:
        return True
    return bool(evaluate_formula(guard, "", evaluation.values, plan.columns) == 1.0)


def _bridge(
    plan: Plan, known: Mapping[str, float], reference: Mapping[str, float]
) -> tuple[Evaluation, frozenset[str]]:
    """Let the reference stand in for what the student's numbers leave without a value.

    A bore that no catalogue holds has no rod; what follows must not be lost for that.
    """
    stand_in: dict[str, float] = {}
    while True:
        evaluation = evaluate(plan, {**known, **stand_in})
        lost = [
            name
            for name, value in evaluation.values.items()
            if np.isnan(value) and name not in stand_in and np.isfinite(reference.get(name, np.nan))
        ]
        if not lost:
            return evaluation, frozenset(stand_in)
        # Only the first is at the root: what follows it may be computed once it has a value.
        stand_in[lost[0]] = reference[lost[0]]
