"""Numbers that were written down wrongly, and calculated with rightly.

Who writes 3.9 where 3900 is asked has made a slip of writing, who writes 5 where 5.2 is asked has
rounded, and who goes on to the right result from a wrong number has miscopied it: the number in the
calculator may have been the right one. So later answers may follow from the number that was meant
as well as from the one that was written; the better counts.
"""

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.grading.comparison import Comparison
from gripcourse.grading.judge_rough import is_rounded_from
from gripcourse.grading.shortened import shortened_in
from gripcourse.grading.submission_case import (
    GradingCase,
    JudgedAnswer,
    explain,
    judge_answer,
    with_answers,
)
from gripcourse.policy.slips import OF_WRITING
from gripcourse.solver.plan import Plan
from gripcourse.submission.model import Answer

# A work in which more of the computed answers are wrong was not calculated.
_MOST_WRONG: Final = 0.5


def as_intended(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Judge again what does not follow from the numbers as written.

    Args:
        case: the submission.
        judged: every answer, explained.

    Returns:
        The same in the same order, each with the better of both conclusions.
    """
    outside = _impossible(case, judged)
    best = _from_impossible(case, judged, outside)
    seen, known, changed = list(best), dict[str, Answer](), set(outside)
    before = case
    while _is_worth_while(best, known):
        new = _newly_intended(case, seen, known)
        if not new:
            break
        known |= new
        after = with_answers(case, known)
        changed |= new.keys() | _changed(before, after)
        seen = _again(after, seen, known.keys(), changed)
        best = [better(*pair) for pair in zip(best, seen, strict=True)]
        before, changed = after, set()
    return best


def _impossible(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[str]:
    """Return the answers that cannot be, and that others may follow from."""
    if not any(_may_be_better(one) for one in judged):
        return []
    return [
        name
        for name in case.follow_through.not_carried
        if case.answers[name].unit_fits and math.isfinite(case.answers[name].value or 0.0)
    ]


def _from_impossible(
    case: GradingCase, judged: Sequence[JudgedAnswer], outside: Collection[str]
) -> list[JudgedAnswer]:
    """Judge again what does not follow otherwise, now from numbers that cannot be.

    A force of 10¹² N is a mistake; who computes on with it makes no second one.
    """
    if not outside:
        return list(judged)
    after = with_answers(case, {}, outside)
    again = _again(after, judged, (), _changed(case, after).union(outside))
    return [better(*pair) for pair in zip(judged, again, strict=True)]


def _newly_intended(
    case: GradingCase, judged: Sequence[JudgedAnswer], known: Collection[str]
) -> dict[str, Answer]:
    """Return what was meant by answers that were not looked at yet, none of which needs another.

    What only seems written wrongly, beside an earlier one, may follow from what was meant.
    """
    new = {
        one.quantity.id: answer
        for one in judged
        if one.quantity.id not in known and (answer := _intended(case, one, judged)) is not None
    }
    return {name: new[name] for name in _earliest(case.plan, new.keys())}


def better(one: JudgedAnswer, later: JudgedAnswer) -> JudgedAnswer:
    """Return the better of two conclusions about an answer, the first of two that are alike."""
    return later if _worth(later) > _worth(one) else one


def _intended(
    case: GradingCase, one: JudgedAnswer, judged: Sequence[JudgedAnswer]
) -> Answer | None:
    """Return what was meant where an answer was only written down wrongly."""
    comparison, traits = one.comparison, one.judgement.outcome.traits
    if comparison is None or not math.isfinite(comparison.expected):
        return None
    # Who shortens a constant goes on with what is written, which only digits are missing of.
    coarse = traits.coarse and shortened_in(comparison) is None
    rounded = coarse or (traits.equals_reference and _is_right_by_rounding(comparison))
    # A number that was written into the wrong cell was not the one that was computed with, nor was
    # one whose digits were exchanged in typing.
    only_typed = traits.mistake and (one.judgement.elsewhere or one.judgement.mistyped)
    if rounded or only_typed or (traits.mistake and _is_used_rightly(case, comparison, judged)):
        return replace(comparison.answer, value=comparison.expected)
    return _written_wrongly(case, one, comparison) if traits.named else None


def _is_right_by_rounding(comparison: Comparison) -> bool:
    """Tell whether a number lost the digits by which it would have been another than the right one.

    A ratio of 2.08 that follows from an earlier mistake is written as 2, where 2.02 is right.
    """
    follows = comparison.follows.nearest(comparison.value)
    return not comparison.fits(follows) and is_rounded_from(comparison, follows)


def _written_wrongly(
    case: GradingCase, judged: JudgedAnswer, comparison: Comparison
) -> Answer | None:
    """Return what was meant where the slip was one of writing."""
    for candidate in case.candidates_of(judged.quantity.id):
        if candidate.id == judged.judgement.slip and candidate.kind in OF_WRITING:
            written = comparison.at_own(candidate.formula).value
            ratio = comparison.expected / written if written else math.nan
            if not math.isfinite(ratio) or ratio == 0:
                return None
            half_unit = comparison.answer.half_unit * abs(ratio)
            return replace(comparison.answer, value=comparison.value * ratio, half_unit=half_unit)
    return None


def _is_used_rightly(
    case: GradingCase, comparison: Comparison, judged: Sequence[JudgedAnswer]
) -> bool:
    """Tell whether a later answer is right that the number as written does not lead to."""
    name = comparison.quantity.id
    return any(
        one.quantity.kind is Kind.FORMULA
        and one.comparison is not None
        and name in case.plan.inputs[one.quantity.id]
        and one.judgement.outcome.traits.equals_reference
        and not one.comparison.fits(one.comparison.follows.nearest(one.comparison.value))
        for one in judged
    )


def _earliest(plan: Plan, names: Collection[str]) -> list[str]:
    """Return those of the quantities that depend on none of the others."""
    depending: set[str] = set()
    found = []
    for name in plan.quantities:
        if not depending.isdisjoint(plan.inputs[name]):
            depending.add(name)
        elif name in names:
            found.append(name)
            depending.add(name)
    return found


def _again(
    case: GradingCase,
    judged: Sequence[JudgedAnswer],
    known: Collection[str],
    changed: Collection[str],
) -> list[JudgedAnswer]:
    """Judge and explain again what the changed numbers may lead to; the rest stays as it is."""
    open_ = {one.quantity.id for one in judged if _rests_on_earlier(one)}
    reached = _reached(case, changed, open_)
    return explain(
        case,
        [
            judge_answer(case, one.quantity, one.answer)
            if one.quantity.id in open_ & reached - set(known)
            else one
            for one in judged
        ],
        reached,
    )


def _is_worth_while(judged: Sequence[JudgedAnswer], known: Collection[str]) -> bool:
    """Tell whether something may follow from what was meant, in a work that was calculated.

    Where most numbers are wrong nothing was meant: some seem written wrongly by chance, and each
    would lead to others that do.
    """
    wrong = [one for one in judged if _may_be_better(one)]
    computed = [
        one for one in judged if one.quantity.kind is Kind.FORMULA and one.comparison is not None
    ]
    mistaken = sum(one.quantity.kind is Kind.FORMULA for one in wrong)
    return mistaken <= _MOST_WRONG * len(computed) and any(
        one.quantity.id not in known for one in wrong
    )


def _changed(before: GradingCase, after: GradingCase) -> set[str]:
    """Return what is followed with another number, or only before or after."""
    one, other = before.follow_through.known, after.follow_through.known
    return {name for name in one.keys() | other.keys() if one.get(name) != other.get(name)}


def _reached(case: GradingCase, changed: Collection[str], asked: Collection[str]) -> set[str]:
    """Return what changed numbers may lead to, or what they may explain, of what is asked.

    A number that the student wrote down passes nothing on. An answer is explained by wrong methods
    with inputs of their own, in steps that were not written down too, and by the answers that use
    it, so that other inputs of theirs matter.
    """
    plan, known = case.plan, case.follow_through.known
    moved, tried = set(changed), set[str]()
    reached = set(changed)
    for name in plan.quantities:
        inputs = plan.inputs[name]
        is_moved = not moved.isdisjoint(inputs)
        if is_moved or name in changed:
            reached.update(inputs)
        if name in known and name not in asked:
            continue
        if is_moved or not tried.isdisjoint(inputs) or _is_tried_with(case, name, moved):
            reached.add(name)
            if name not in known:
                tried.add(name)
        if is_moved and name not in known:
            moved.add(name)
    return reached


def _is_tried_with(case: GradingCase, name: str, moved: Collection[str]) -> bool:
    """Tell whether a rule, an erratum or a wrong method of a quantity looks at what moved."""
    used = case.plan.quantities[name].uses
    tried = (one.formula.names for one in case.candidates_of(name))
    return any(one in moved for names in (used, *tried) for one in names)


def _may_be_better(judged: JudgedAnswer) -> bool:
    return judged.comparison is not None and judged.judgement.outcome.traits.mistake


def _rests_on_earlier(judged: JudgedAnswer) -> bool:
    """Tell whether the student's earlier numbers have a part in the conclusion."""
    traits = judged.judgement.outcome.traits
    return traits.mistake or traits.follows or traits.coarse


def _worth(judged: JudgedAnswer) -> tuple[float, bool]:
    traits = judged.judgement.outcome.traits
    return judged.judgement.credit, traits.named or not traits.mistake
