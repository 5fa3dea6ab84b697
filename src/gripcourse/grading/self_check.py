"""What a student may see before the deadline.

How each answer was read, and whether the numbers fit each other. Never the reference, and nothing
that would tell it. An answer that rests on given values alone is not judged: saying "consistent" would say "correct".
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from gripcourse.course.model import Kind, Quantity
from gripcourse.course.policy import Policy
from gripcourse.grading.judge_choice import judge_choice_answer
from gripcourse.grading.judge_value import judge_value
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.own import follow
from gripcourse.grading.view import View
from gripcourse.solver.plan import Plan
from gripcourse.submission.model import Answer, Reading, Submission
from gripcourse.words import Message, message


class State(StrEnum):
    """What a student learns about one answer."""

    BLANK = "blank"
    UNREADABLE = "unreadable"
    WRONG_UNIT = "wrong_unit"
    READ = "read"
    CONSISTENT = "consistent"
    INCONSISTENT = "inconsistent"


@dataclass(frozen=True, slots=True)
class Check:
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


def self_check(submission: Submission, plan: Plan, policy: Policy) -> tuple[Check, ...]:
    """Check a workbook against itself: its own given values, the student's own numbers.

    Args:
        submission: what was read.
        plan: of the variant that the workbook names.
        policy: for the bands.
    """
    view_of = _views(submission, plan, policy)
    return tuple(
        _check(plan, quantity, submission.answers[quantity.id], submission.answers, view_of)
        for quantity in plan.answered
    )


def _views(submission: Submission, plan: Plan, policy: Policy) -> Mapping[str, View]:
    # Nothing is known here that the workbook does not hold, so nothing can be told from the answer.
    unknown = dict.fromkeys(plan.quantities, math.nan)
    own = follow(plan, submission.givens, submission.answers, unknown)
    return {
        quantity.id: View(
            plan=plan,
            policy=policy,
            quantity=quantity,
            answer=answer,
            value=answer.value,
            reference_values=unknown,
            own=own,
        )
        for quantity in plan.answered
        if (answer := submission.answers[quantity.id]).value is not None
    }


def _check(
    plan: Plan,
    quantity: Quantity,
    answer: Answer,
    answers: Mapping[str, Answer],
    view_of: Mapping[str, View],
) -> Check:
    state = _state(plan, quantity, answer, answers, view_of)
    return Check(quantity.id, state, answer, _SAID[state], answer.remarks)


def _state(
    plan: Plan,
    quantity: Quantity,
    answer: Answer,
    answers: Mapping[str, Answer],
    view_of: Mapping[str, View],
) -> State:
    if answer.reading is Reading.BLANK:
        return State.BLANK
    if answer.reading is Reading.UNREADABLE:
        return State.UNREADABLE
    if not answer.unit_fits:
        return State.WRONG_UNIT
    if not _rests_on_own(plan, quantity, answers):
        return State.READ
    follows = _follows(view_of[quantity.id])
    return State.CONSISTENT if follows else State.INCONSISTENT


def _rests_on_own(plan: Plan, quantity: Quantity, answers: Mapping[str, Answer]) -> bool:
    """Tell whether every earlier answer that this one needs is there, and there is at least one."""
    earlier = [name for name in plan.inputs[quantity.id] if plan.quantities[name].kind.answered]
    return bool(earlier) and all(answers[name].reading is Reading.READ for name in earlier)


def _follows(view: View) -> bool:
    is_choice = view.quantity.kind is Kind.CHOICE
    judgement = judge_choice_answer(view) if is_choice else judge_value(view)
    return judgement.outcome in {Outcome.CORRECT, Outcome.CARRIED} or (
        judgement.against is Against.PRINTED
    )
