"""One wrong method in formulas that are alike: whoever thinks wrongly at both ends thinks so once.

Positions, jaws and directions are computed by one formula with other numbers. A factor left out of
it, or a sign the wrong way round, is one mistake wherever it is written down.
"""

from collections.abc import Sequence
from typing import TypeAlias

from gripcourse.course.quantity import Kind
from gripcourse.formula.tree import form
from gripcourse.grading.submission_case import GradingCase, JudgedAnswer, cost_already
from gripcourse.slips.model import USED, SlipId
from gripcourse.text.words import message

_Mistake: TypeAlias = tuple[SlipId, str, tuple[object, ...]]


def same_slip_once(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Let a slip that is made in several formulas of one form cost the first of them.

    Args:
        case: the submission.
        judged: every answer.

    Returns:
        The same in the same order.
    """
    order = {name: rank for rank, name in enumerate(case.plan.quantities)}
    first: dict[_Mistake, str] = {}
    for one in sorted(judged, key=lambda each: order.get(each.quantity.id, 0)):
        mistake = _mistake(case, one)
        if mistake is not None:
            first.setdefault(mistake, one.quantity.id)
    return [_once(case, one, first) for one in judged]


def _mistake(case: GradingCase, judged: JudgedAnswer) -> _Mistake | None:
    """Return what was done wrongly, in a formula of which form; None where nothing is named."""
    slip = judged.judgement.slip
    mistaken = judged.judgement.outcome.traits.mistake
    if (
        not mistaken
        or slip is None
        or slip.kind == USED
        or judged.quantity.kind is not Kind.FORMULA
    ):
        return None
    formula = case.plan.reference_formula(judged.quantity.id)
    return None if formula is None else (slip, judged.quantity.unit, form(formula.tree))


def _once(case: GradingCase, judged: JudgedAnswer, first: dict[_Mistake, str]) -> JudgedAnswer:
    mistake = _mistake(case, judged)
    root = judged.quantity.id if mistake is None else first[mistake]
    if root == judged.quantity.id:
        return judged
    said = message(
        "The same mistake as in {title}; that has cost already.",
        title=case.plan.quantities[root].short_title,
    )
    return cost_already(case, judged, root, said)
