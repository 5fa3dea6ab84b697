"""Two numbers that stand in each other's cells: one mistake, which costs the first of them."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.intended import better
from gripcourse.grading.submission_case import (
    GradingCase,
    JudgedAnswer,
    cost_already,
    judge_answer,
    with_answers,
)
from gripcourse.policy.bands import within
from gripcourse.submission.model import Answer
from gripcourse.text.words import message

_COPIED: Final = frozenset({Kind.FORMULA, Kind.PICK})
"""Kinds of answers whose number is written into the cell beside it."""


def exchanged_once(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Let the second of two answers count that were written into each other's cells.

    Whoever takes the ends of a range for each other has made one mistake too. What follows from
    the numbers as they were meant is no mistake at all.

    Args:
        case: the submission.
        judged: every answer.

    Returns:
        The same in the same order.
    """
    now, taken = list(judged), set[str]()
    for one, other in _pairs(judged):
        ids = {one.quantity.id, other.quantity.id}
        meant = _as_meant(case, one, other) if taken.isdisjoint(ids) else None
        if meant is not None:
            pair = (_first(one, other), _second(case, one, other))
            changed = {answer.quantity.id: answer for answer in pair}
            now = [changed.get(answer.quantity.id, _again(meant, answer)) for answer in now]
            taken |= ids
    return now


def _pairs(judged: Sequence[JudgedAnswer]) -> Iterator[tuple[JudgedAnswer, JudgedAnswer]]:
    """Yield wrong answers each of which is what the other should be.

    They have one unit, or stand one below the other: nobody writes into a cell far away what has
    another unit, and of two numbers that are wrong for other reasons few are each other's.
    """
    wrong = [
        (place, one, one.comparison)
        for place, one in enumerate(judged)
        if one.quantity.kind in _COPIED
        and one.comparison is not None
        and one.judgement.outcome.traits.mistake
    ]
    for (place, one, here), (below, other, there) in combinations(wrong, 2):
        is_next = below == place + 1 and one.quantity.section == other.quantity.section
        if (
            (is_next or one.quantity.unit == other.quantity.unit)
            and _is_for(here.value, there, one.quantity.id)
            and _is_for(there.value, here, other.quantity.id)
        ):
            yield one, other


def _as_meant(case: GradingCase, one: JudgedAnswer, other: JudgedAnswer) -> GradingCase | None:
    """Return the case with two numbers in each other's cells; None where they are not right there.

    Two answers of which one repeats the other would be wrong again.
    """
    if one.answer is None or other.answer is None:
        return None
    meant = {
        one.quantity.id: _with_number_of(one.answer, other.answer),
        other.quantity.id: _with_number_of(other.answer, one.answer),
    }
    after = with_answers(case, meant)
    found = (judge_answer(after, each.quantity, meant[each.quantity.id]) for each in (one, other))
    return after if all(each.judgement.outcome.traits.right for each in found) else None


def _with_number_of(answer: Answer, other: Answer) -> Answer:
    return replace(answer, value=other.value, half_unit=other.half_unit, figures=other.figures)


def _again(meant: GradingCase, judged: JudgedAnswer) -> JudgedAnswer:
    """Judge a mistake again by the numbers as they were meant."""
    if not judged.judgement.outcome.traits.mistake:
        return judged
    return better(judged, judge_answer(meant, judged.quantity, judged.answer))


def _is_for(value: float, comparison: Comparison, other: str) -> bool:
    """Tell whether a number is what an answer should be, by the reference or by own numbers.

    Args:
        value: that stands in the cell of another answer.
        comparison: of the answer.
        other: id of the other answer: if it is used here, it was what stands in this cell.
    """
    wanted = [comparison.reference, comparison.follows.nearest(value)]
    if other in comparison.plan.inputs[comparison.quantity.id]:
        wanted.append(comparison.following(other, comparison.value).nearest(value))
    return any(within(value, one, comparison.band_round(one)) for one in wanted)


def _first(one: JudgedAnswer, other: JudgedAnswer) -> JudgedAnswer:
    said = message(
        "The numbers of two answers are exchanged: this one and {title}. It costs once.",
        title=other.quantity.short_title,
    )
    return replace(one, judgement=replace(one.judgement, message=said))


def _second(case: GradingCase, one: JudgedAnswer, other: JudgedAnswer) -> JudgedAnswer:
    title = one.quantity.short_title
    said = message("Exchanged with {title}, which has cost already.", title=title)
    return cost_already(case, other, one.quantity.id, said)
