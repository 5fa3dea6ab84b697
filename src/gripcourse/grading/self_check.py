"""What a student may see before the deadline.

How each answer was read, and whether the numbers fit each other. Never the reference, and nothing
that would tell it: an answer that rests on given values alone is not judged, because there
"consistent" would say "correct".
"""

import math
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from enum import StrEnum

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.follow_through import follow
from gripcourse.grading.judge_choice import judge_choice_answer
from gripcourse.grading.judge_value import judge_value
from gripcourse.grading.model import Against
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan
from gripcourse.submission.model import Answer, Reading, Submission
from gripcourse.text.words import Message, message


class State(StrEnum):
    """What a student learns about one answer."""

    BLANK = "blank"
    UNREADABLE = "unreadable"
    WRONG_UNIT = "wrong_unit"
    READ = "read"
    CONSISTENT = "consistent"
    INCONSISTENT = "inconsistent"


@dataclass(frozen=True, slots=True)
class AnswerCheck:
    """What is said about one answer: its state in a sentence, and remarks on how it was read."""

    quantity: str
    state: State
    answer: Answer
    message: Message
    remarks: tuple[Message, ...]


_SAID = {
    State.BLANK: message("No answer yet."),
    State.UNREADABLE: message("The answer could not be read."),
    State.WRONG_UNIT: message("The unit does not fit this quantity."),
    State.READ: message("Read."),
    State.CONSISTENT: message("Read; consistent with your own numbers."),
    State.INCONSISTENT: message("Read; does not follow from your own numbers."),
}


def self_check(submission: Submission, plan: Plan, policy: Policy) -> tuple[AnswerCheck, ...]:
    """Check a workbook against itself: its own given values, the student's own numbers.

    Args:
        submission: what was read.
        plan: of the variant that the workbook names.
        policy: for the bands.
    """
    # Nothing is known here that the workbook does not hold, so nothing can be told from the answer.
    unknown = dict.fromkeys(plan.quantities, math.nan)
    follow_through = follow(plan, submission.givens, submission.answers, unknown, policy)
    carried = {
        name
        for name, answer in submission.answers.items()
        if answer.reading is Reading.READ and name not in follow_through.not_carried
    }

    def check(quantity: Quantity) -> AnswerCheck:
        answer = submission.answers[quantity.id]
        state = _state_as_read(answer)
        if state is State.READ and _rests_on_own(plan, quantity, carried):
            comparison = Comparison(
                plan=plan,
                policy=policy,
                quantity=quantity,
                answer=answer,
                value=math.nan if answer.value is None else answer.value,
                reference_values=unknown,
                follow_through=follow_through,
            )
            state = _state_by_own_numbers(comparison)
        return AnswerCheck(quantity.id, state, answer, _SAID[state], answer.remarks)

    return tuple(check(quantity) for quantity in plan.answered)


def _state_as_read(answer: Answer) -> State:
    if answer.reading is Reading.BLANK:
        return State.BLANK
    if answer.reading is Reading.UNREADABLE:
        return State.UNREADABLE
    return State.READ if answer.unit_fits else State.WRONG_UNIT


def _rests_on_own(plan: Plan, quantity: Quantity, carried: AbstractSet[str]) -> bool:
    """Tell whether a quantity needs earlier answers and each of them counts as the student's own.

    An answer that is not carried on is replaced by what the given values lead to: "consistent" with
    that would tell that the later answer is right.
    """
    earlier = [name for name in plan.inputs[quantity.id] if plan.quantities[name].kind.answered]
    return bool(earlier) and carried >= set(earlier)


def _state_by_own_numbers(comparison: Comparison) -> State:
    if not math.isfinite(comparison.expected):
        return State.READ
    is_choice = comparison.quantity.kind is Kind.CHOICE
    judgement = judge_choice_answer(comparison) if is_choice else judge_value(comparison)
    follows = judgement.outcome.traits.right or (judgement.against is Against.PRINTED)
    return State.CONSISTENT if follows else State.INCONSISTENT
