"""What else follows from a number that was used wrongly: sizes, verdicts, and seeming slips."""

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from gripcourse.course.quantity import Kind
from gripcourse.grading.as_calculated import held_by
from gripcourse.grading.submission_case import (
    GradingCase,
    JudgedAnswer,
    judge_answer,
    with_answers,
    with_given,
)
from gripcourse.grading.substitution import Substitution
from gripcourse.text.units import factor

_ISSUED = frozenset({Kind.GIVEN, Kind.CONSTANT})


def extended(
    case: GradingCase, judged: Sequence[JudgedAnswer], found: Sequence[Substitution]
) -> tuple[Substitution, ...]:
    """Let each number that was used wrongly explain all the wrong answers that follow from it.

    It was found by computed numbers that nothing else explains. A size taken for it, a verdict on
    it, or a number that a slip seemed to explain by itself, is no second mistake.

    Args:
        case: the submission.
        judged: every answer.
        found: what was used wrongly; no two of them explain one answer.
    """
    taken = {name for one in found for name in one.explains}
    extensions = []
    for one in found:
        more = tuple(_following(case, judged, one, taken))
        taken.update(more)
        extensions.append(replace(one, explains=(*one.explains, *more)))
    return tuple(extensions)


def _following(
    case: GradingCase, judged: Sequence[JudgedAnswer], one: Substitution, taken: Collection[str]
) -> Iterator[str]:
    used = _with_number(case, one) if math.isfinite(one.value) else None
    if used is None:
        return
    held = _held(case, used, judged, one)
    for answer in judged:
        name, comparison = answer.quantity.id, answer.comparison
        if name in taken or name == one.quantity or comparison is None:
            continue
        if answer.judgement.outcome.traits.mistake and comparison.answer.unit_fits:
            again = judge_answer(used, answer.quantity, comparison.answer)
            if again.judgement.outcome.traits.follows or name in held:
                yield name


def _held(
    case: GradingCase, used: GradingCase, judged: Sequence[JudgedAnswer], one: Substitution
) -> Collection[str]:
    """Return the answers that are what the calculator held of somebody who used the number."""
    quantity = case.plan.quantities[one.quantity]
    if quantity.kind in _ISSUED:
        held = held_by(used, judged)
    else:
        held = held_by(case, judged, {quantity.id: one.value * factor(quantity.unit)})
    return () if held is None else held.met


def _with_number(case: GradingCase, one: Substitution) -> GradingCase | None:
    """Return the case where the number is followed that was used; None for what nobody wrote."""
    if case.plan.quantities[one.quantity].kind in _ISSUED:
        return with_given(case, {one.quantity: one.value})
    answer = case.answers.get(one.quantity)
    if answer is None:
        return None
    used = replace(answer, value=one.value)
    return with_answers(case, {one.quantity: used}, {one.quantity})
