"""Of several mistakes with one number, the one that the same work has made elsewhere.

A tangent that is left out counts as 1, and so does the tangent of an angle of 35.3° where the
calculator takes degrees for radians. One number does not tell them apart. Another answer may, whose
angle is another: how a calculator is set is kept throughout a work, and so is how formulas that
are alike are understood.
"""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import TypeAlias

from gripcourse.formula.tree import form
from gripcourse.grading.same_slip import likenesses
from gripcourse.grading.submission_case import GradingCase, JudgedAnswer
from gripcourse.policy.slips import SlipKind
from gripcourse.slips.model import Candidate
from gripcourse.text.words import message

_Habit: TypeAlias = tuple[object, ...]
"""What is done wrongly, and in formulas like which; of how a calculator is set, only what."""


def told_by_others(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Name one of several mistakes where another answer of the work names it alone.

    Args:
        case: the submission.
        judged: every answer.

    Returns:
        The same in the same order.
    """
    named = {one.quantity.id: _named(case, one) for one in judged}
    if all(len(methods) <= 1 for methods in named.values()):
        return list(judged)
    alone = {
        habit
        for one in judged
        if len(named[one.quantity.id]) == 1
        for habit in _habits(case, one, named[one.quantity.id][0])
    }
    return [_told(case, one, named[one.quantity.id], alone) for one in judged]


def _named(case: GradingCase, judged: JudgedAnswer) -> list[list[Candidate]]:
    """Return the methods that an answer names for its own formula, those of one hint together."""
    judgement = judged.judgement
    if judgement.slip is None or not judgement.outcome.traits.mistake or judgement.elsewhere:
        return []
    ids = (judgement.slip, *judgement.tied)
    known = {one.id: one for one in case.candidates_of(judged.quantity.id)}
    if any(one not in known for one in ids):
        return []  # of a number that was used, or of a step that was left blank
    methods: list[list[Candidate]] = []
    for one in (known[id_] for id_ in ids):
        said = next((some for some in methods if some[0].hint == one.hint), None)
        if said is None:
            methods.append([one])
        else:
            said.append(one)
    return methods


def _habits(
    case: GradingCase, judged: JudgedAnswer, method: Sequence[Candidate]
) -> Iterator[_Habit]:
    for one in method:
        if one.kind == SlipKind.ANGLE_UNIT:
            yield (one.kind,)
        for alike in likenesses(case, judged):
            yield one.id, alike
            yield form(one.formula.tree), alike


def _told(
    case: GradingCase,
    judged: JudgedAnswer,
    methods: Sequence[Sequence[Candidate]],
    alone: Collection[_Habit],
) -> JudgedAnswer:
    made = [one for one in methods if any(habit in alone for habit in _habits(case, judged, one))]
    if len(methods) <= 1 or len(made) != 1:
        return judged
    first, *others = made[0]
    judgement = replace(
        judged.judgement,
        slip=first.id,
        tied=tuple(one.id for one in others),
        credit=first.credit,
        message=message("A known slip: {hint}", hint=first.hint),
    )
    return replace(judged, judgement=judgement)
