"""What a student may see before the deadline.

How each answer was read, whether its unit and its magnitude fit, and by policy whether the numbers
fit each other. Never the reference, and nothing that would tell it: an answer that rests on given
values alone is not judged, because there "consistent" would say "correct". Nor is a single answer,
by default: whoever may ask of each number finds all of them. A section is told as a whole, where
everything in it was answered.
"""

import math
from collections.abc import Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.entry_meant import with_entries_meant
from gripcourse.grading.follow_through import follow
from gripcourse.grading.judge_choice import judge_choice_answer
from gripcourse.grading.judge_value import judge_value
from gripcourse.grading.model import Against
from gripcourse.policy.model import Policy, Tells
from gripcourse.solver.plan import Plan
from gripcourse.submission.model import Answer, Reading, Submission
from gripcourse.text.words import Message, message


class State(StrEnum):
    """What a student learns about one answer."""

    BLANK = "blank"
    UNREADABLE = "unreadable"
    WRONG_UNIT = "wrong_unit"
    IMPLAUSIBLE = "implausible"  # outside what is physically thinkable, whatever the variant
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


class SectionState(StrEnum):
    """What a student learns about the numbers of a section, all together."""

    OPEN = "open"  # something in it is not answered or cannot be read, or there is too little
    FITS = "fits"
    DOES_NOT_FIT = "does_not_fit"


@dataclass(frozen=True, slots=True)
class SectionCheck:
    """What is said about a section: its id, its state and a sentence."""

    section: str
    state: SectionState
    message: Message


@dataclass(frozen=True, slots=True)
class SelfCheck:
    """What is said about a workbook; no sections where only the reading is told."""

    answers: tuple[AnswerCheck, ...]
    sections: tuple[SectionCheck, ...]


_SAID_OF_SECTION = {
    SectionState.OPEN: message("Not shown yet: answer everything in this section first."),
    SectionState.FITS: message("These numbers follow from each other."),
    SectionState.DOES_NOT_FIT: message("At least one number does not follow from the others."),
}

_LEAST_JUDGED: Final = 3
"""Answers of a section that must rest on others: fewer, and the section says what one answer is."""

_SAID = {
    State.BLANK: message("No answer yet."),
    State.UNREADABLE: message("The answer could not be read."),
    State.WRONG_UNIT: message("The unit does not fit this quantity."),
    State.IMPLAUSIBLE: message("Read; the magnitude is not possible. Check unit and decimal sign."),
    State.READ: message("Read."),
    State.CONSISTENT: message("Read; consistent with your own numbers."),
    State.INCONSISTENT: message("Read; does not follow from your own numbers."),
}


def self_check(
    submission: Submission, plan: Plan, policy: Policy, tells: Tells = Tells.READING
) -> SelfCheck:
    """Check a workbook against itself: its own given values, the student's own numbers.

    Args:
        submission: what was read.
        plan: of the variant that the workbook names.
        policy: for the bands.
        tells: how much is told.
    """
    submission = with_entries_meant(submission, plan)
    read = {one.id: _state_as_read(one, submission.answers[one.id]) for one in plan.answered}
    judged = {} if tells is Tells.READING else _judged(submission, plan, policy, read)
    shown = {**read, **judged} if tells is Tells.ANSWERS else read
    return SelfCheck(
        answers=tuple(_answer(name, state, submission) for name, state in shown.items()),
        sections=() if tells is Tells.READING else tuple(_sections(plan, read, judged)),
    )


def _answer(name: str, state: State, submission: Submission) -> AnswerCheck:
    answer = submission.answers[name]
    return AnswerCheck(name, state, answer, _SAID[state], answer.remarks)


def _judged(
    submission: Submission, plan: Plan, policy: Policy, read: Mapping[str, State]
) -> dict[str, State]:
    """Return whether each answer that rests on others follows from them."""
    # Nothing is known here that the workbook does not hold, so nothing can be told from the answer.
    unknown = dict.fromkeys(plan.quantities, math.nan)
    follow_through = follow(plan, submission.givens, submission.answers, unknown, policy)
    carried = {
        name
        for name, answer in submission.answers.items()
        if answer.reading is Reading.READ and name not in follow_through.not_carried
    }
    found: dict[str, State] = {}
    for quantity in plan.answered:
        answer = submission.answers[quantity.id]
        if read[quantity.id] is State.READ and _rests_on_own(plan, quantity, carried):
            comparison = Comparison(
                plan=plan,
                policy=policy,
                quantity=quantity,
                answer=answer,
                value=math.nan if answer.value is None else answer.value,
                reference_values=unknown,
                follow_through=follow_through,
            )
            found[quantity.id] = _state_by_own_numbers(comparison)
    return found


def _sections(
    plan: Plan, read: Mapping[str, State], judged: Mapping[str, State]
) -> Iterator[SectionCheck]:
    for section in plan.course.sections:
        names = [one.id for one in plan.answered if one.section == section.id]
        states = [judged[name] for name in names if judged.get(name, State.READ) is not State.READ]
        if not names:
            continue
        state = SectionState.OPEN
        if all(read[name] is State.READ for name in names) and len(states) >= _LEAST_JUDGED:
            fits = State.INCONSISTENT not in states
            state = SectionState.FITS if fits else SectionState.DOES_NOT_FIT
        yield SectionCheck(section.id, state, _SAID_OF_SECTION[state])


def _state_as_read(quantity: Quantity, answer: Answer) -> State:
    if answer.reading is Reading.BLANK:
        return State.BLANK
    if answer.reading is Reading.UNREADABLE:
        return State.UNREADABLE
    if not answer.unit_fits:
        return State.WRONG_UNIT
    low, high = quantity.bounds
    possible = answer.value is None or low <= answer.value <= high
    return State.READ if possible else State.IMPLAUSIBLE


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
