"""Wrong answers that are right by what the calculator of a student held.

Of somebody whose cells hold few digits, or who takes ten for gravity, the calculation is done again
in each way of going on; the one that most answers show is the student's. What comes out is as sharp
as a calculator's display, so that a wrong number is met by it no more often than by the right one.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.grading.calculator import (
    AS_WRITTEN,
    FINEST,
    Held,
    Way,
    calculated,
    half_unit_of,
    in_cell,
    is_written_for,
    result_of,
)
from gripcourse.grading.comparison import Comparison, Judgement
from gripcourse.grading.intended import better
from gripcourse.grading.judge_rough import judge_rounded
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.shortened import EXACTLY, shortenings
from gripcourse.grading.submission_case import (
    GradingCase,
    JudgedAnswer,
    explain,
    judge_answer,
    with_answers,
)
from gripcourse.policy.slips import OF_WRITING
from gripcourse.submission.model import Answer
from gripcourse.text.units import factor
from gripcourse.text.words import Message, message

_MOST_TRIED: Final = 6  # wrong answers of which it is tried what was gone on with
_MOST_WAYS: Final = 4  # that as many answers show
_LEAST_MET: Final = 0.5  # share of the computed answers; who meets fewer did not calculate so
_FOLLOWS: Final[Message] = message(
    "Follows from what your calculator held; your cells show it rounded."
)


def as_calculated(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Judge again what follows from no cell, by what the calculator held.

    Args:
        case: the submission.
        judged: every answer, explained.

    Returns:
        The same in the same order.
    """
    wrong = _wrong(case, judged)
    held = held_by(case, judged)
    if held is None:
        return list(judged)
    return [
        replace(one, judgement=_following(one.comparison, one.judgement, held))
        if one.comparison is not None and one.quantity.id in wrong & held.met
        else one
        for one in _at_held(case, judged, wrong - held.met, held)
    ]


def held_by(
    case: GradingCase, judged: Sequence[JudgedAnswer], instead: Mapping[str, float] = AS_WRITTEN
) -> Held | None:
    """Return what the calculator of a student held; None where that is not to be told.

    Only somebody who writes few digits, or shortens a constant too far, has other numbers in the
    calculator than the cells tell.

    Args:
        case: the submission.
        judged: every answer.
        instead: what was gone on with after some answers, SI, by id.
    """
    wrong = _wrong(case, judged)
    if not wrong or not any(one.judgement.outcome.traits.coarse for one in judged):
        return None
    typed = {
        one.quantity.id: one.comparison
        for one in judged
        if one.comparison is not None and one.comparison.answer.unit_fits
    }
    held = _likeliest(case, typed, wrong, instead)
    computed = sum(one.quantity.kind is Kind.FORMULA for one in typed.values())
    return held if len(held.met) >= _LEAST_MET * computed else None


def _at_held(
    case: GradingCase, judged: Sequence[JudgedAnswer], wrong: set[str], held: Held
) -> list[JudgedAnswer]:
    """Judge and explain wrong answers by the digits that the calculator held of earlier ones."""
    if not wrong or not held.way.keeps:
        return list(judged)
    kept = {name: _unrounded(case, name, held.values[name]) for name in held.met}
    after = with_answers(case, kept)
    again = [
        judge_answer(after, one.quantity, one.answer) if one.quantity.id in wrong else one
        for one in judged
    ]
    explained = explain(after, again, wrong)
    return [_told(one, later) for one, later in zip(judged, explained, strict=True)]


def _told(one: JudgedAnswer, later: JudgedAnswer) -> JudgedAnswer:
    """Return what tells more; that a number stands in the wrong cell is told by the cells."""
    only_typed = one.judgement.elsewhere or one.judgement.mistyped
    if only_typed and not later.judgement.outcome.traits.named:
        return one
    return better(later, one)


def _unrounded(case: GradingCase, name: str, value: float) -> Answer:
    value /= factor(case.plan.quantities[name].unit)
    return replace(case.answers[name], value=value, half_unit=FINEST * abs(value))


def _wrong(case: GradingCase, judged: Sequence[JudgedAnswer]) -> set[str]:
    return {one.quantity.id for one in judged if _is_wrong(case, one)}


def _is_wrong(case: GradingCase, judged: JudgedAnswer) -> bool:
    comparison = judged.comparison
    return (
        case.is_own
        and judged.quantity.kind is Kind.FORMULA
        and judged.judgement.outcome.traits.mistake
        and comparison is not None
        and comparison.answer.unit_fits
    )


def _likeliest(
    case: GradingCase,
    typed: Mapping[str, Comparison],
    wrong: set[str],
    instead: Mapping[str, float],
) -> Held:
    """Return what comes out in the way that most answers show, of equal ones the plainest."""
    constants = (EXACTLY, *shortenings(case.plan, list(case.plan.quantities), case.policy.habits))
    ways = (Way(one, keeps, instead) for one in constants for keeps in (True, False))
    held = [calculated(case, typed, way) for way in ways]
    most = max(map(_count, held))
    likely = [one for one in held if _count(one) == most][:_MOST_WAYS]
    return max((_with_wrong_ones(case, typed, wrong, one) for one in likely), key=_count)


def _with_wrong_ones(
    case: GradingCase, typed: Mapping[str, Comparison], wrong: set[str], held: Held
) -> Held:
    """Try what was gone on with after each wrong answer: what most later ones show counts."""
    tried = 0
    for name in case.plan.quantities:
        if name in wrong - held.met and tried < _MOST_TRIED:
            tried += 1
            ways = (
                replace(held.way, instead={**held.way.instead, name: number})
                for number in _instead(case, typed, name, held)
            )
            others = (calculated(case, typed, way) for way in ways)
            held = max((held, *others), key=_count)
    return held


def _count(held: Held) -> int:
    return len(held.met)


def _instead(
    case: GradingCase, typed: Mapping[str, Comparison], name: str, held: Held
) -> Iterator[float]:
    """Yield what may have been gone on with after a wrong answer, SI.

    It is the right result, beside which something else was written, or a wrong method's, unrounded;
    or whatever rounds to the answer and leads to a later one.
    """
    answer, keeps = typed[name], held.way.keeps
    quantity = answer.quantity
    right, number = held.results[quantity.id], answer.value * factor(quantity.unit)
    if math.isfinite(right):
        yield right if keeps else in_cell(case, quantity, right)
    for one in case.candidates_of(quantity.id):
        result = evaluate_number(one.formula, quantity.unit, held.values, case.plan.columns)
        if is_written_for(case, answer, result):
            if one.kind in OF_WRITING and result and math.isfinite(right):
                yield number * right / result
            if keeps:
                yield result
    if keeps:
        yield from _shown_later(case, typed, answer, held)


def _shown_later(
    case: GradingCase, typed: Mapping[str, Comparison], answer: Comparison, held: Held
) -> Iterator[float]:
    """Yield the numbers, SI, that round to an answer and lead to one that is computed from it."""
    name, scale = answer.quantity.id, factor(answer.quantity.unit)
    half_unit = half_unit_of(case, answer)
    ends = [(answer.value + side * half_unit) * scale for side in (-1, 1)]
    for later in typed.values():
        quantity = later.quantity
        if quantity.kind is not Kind.FORMULA or name not in case.plan.inputs[quantity.id]:
            continue
        low, high = (
            result_of(case, quantity, held.way, {**held.values, name: end}) for end in ends
        )
        # So near to each other two ends leave a straight line between them.
        share = (later.value * factor(quantity.unit) - low) / (high - low or math.nan)
        if 0 <= share <= 1:
            yield ends[0] + share * (ends[1] - ends[0])


def _following(answer: Comparison, judgement: Judgement, held: Held) -> Judgement:
    """Conclude that an answer is what the calculator held, perhaps rounded too far."""
    result = held.results[answer.quantity.id] / factor(answer.quantity.unit)
    if not answer.fits(result):
        rough = judge_rounded(answer, result, Against.OWN_INPUTS)
        if rough is not None:
            return replace(rough, expected=result, held=True)
    return replace(
        judgement,
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        expected=result,
        band=answer.band_round(result),
        credit=answer.policy.carried_credit,
        slip=None,
        tied=(),
        roots=(),
        message=_FOLLOWS,
        remarks=(),
        elsewhere="",
        mistyped=False,
        held=True,
    )
