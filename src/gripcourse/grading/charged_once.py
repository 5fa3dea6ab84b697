"""A constant that was shortened too far costs the first answer that shows it, and no other."""

from collections.abc import Sequence

from gripcourse.grading.judge_blank import coarse_in_blank
from gripcourse.grading.shortened import shortened_in
from gripcourse.grading.submission_case import (
    GradingCase,
    JudgedAnswer,
    cost_already,
    in_order_of_steps,
)
from gripcourse.text.words import message


def shortened_once(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Let the later of the answers that a shortened constant makes too coarse count.

    Args:
        case: the submission.
        judged: every answer.

    Returns:
        The same in the same order.
    """
    first: dict[tuple[str, float], str] = {}
    later: dict[str, JudgedAnswer] = {}
    for one in in_order_of_steps(case, judged):
        constant = _constant(one)
        if constant is None:
            continue
        if constant in first:
            later[one.quantity.id] = _carried(case, one, first[constant])
        else:
            first[constant] = one.quantity.id
    return [later.get(one.quantity.id, one) for one in judged]


def _constant(judged: JudgedAnswer) -> tuple[str, float] | None:
    """Return the constant and its value where nothing but it makes an answer too coarse."""
    traits = judged.judgement.outcome.traits
    coarse = traits.right and not traits.equals_reference and not traits.follows
    if judged.comparison is None or not coarse:
        return None
    found = shortened_in(judged.comparison)
    if found is None:
        return coarse_in_blank(judged.comparison)
    return found[0].name, found[0].value


def _carried(case: GradingCase, judged: JudgedAnswer, root: str) -> JudgedAnswer:
    said = message(
        "Follows from the coarse constant that has cost {title}.",
        title=case.plan.quantities[root].short_title,
    )
    return cost_already(case, judged, root, said)
