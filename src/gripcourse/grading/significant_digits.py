"""Significant figures: counted from what was typed, judged apart from the value."""

import math

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.policy.model import Policy
from gripcourse.submission.model import Answer
from gripcourse.text.words import Message, message

_SAME = 1e-9  # relative: what floating point and reading leave of equal numbers


def figures_remark(
    quantity: Quantity, answer: Answer, policy: Policy, expected: float | None = None
) -> tuple[float, Message] | None:
    """Tell whether an answer was typed with too few or too many figures.

    Only what is certain is told. A cell that holds a number loses the zeros at its end: that too
    few were typed is certain there only where the expected value, rounded, has no such zeros.

    Args:
        quantity: only a computed one has figures; a size from a series or a verdict has none.
        answer: as it was read.
        policy: what is asked, and the share that is kept.
        expected: the value that the answer was found to equal, in the declared unit; None where
            there is none.

    Returns:
        The share of the points that the answer keeps, with the sentence for the student; None
        where nothing is wrong or nothing is certain.
    """
    rule, count = policy.figure_rule, answer.figures
    if quantity.kind is not Kind.FORMULA or count is None or answer.value is None:
        return None
    if rule.most and count > rule.most:
        said = message(
            "Typed with {figures} significant figures; at most {most} are asked.",
            figures=count,
            most=rule.most,
        )
        return rule.credit, said
    at_most = _most_typed(answer, answer.value, rule.least, expected)
    if rule.least and at_most is not None and at_most < rule.least:
        said = message(
            "Typed with {figures} significant figures; at least {least} are asked.",
            figures=at_most,
            least=rule.least,
        )
        return rule.credit, said
    return None


def _most_typed(answer: Answer, value: float, least: int, expected: float | None) -> int | None:
    """Return how many figures an answer can have had; None where that has no certain bound."""
    if expected is not None and math.isclose(value, expected, rel_tol=_SAME):
        return None  # nothing was lost: further figures are zeros
    if answer.figures_at_most is not None:
        return answer.figures_at_most
    if expected is None or not expected or _may_be_rounded(value, expected, least):
        return None
    return answer.figures


def _may_be_rounded(value: float, expected: float, figures: int) -> bool:
    """Tell whether a value may be another rounded to so many figures, one unit of the last off.

    One unit, because what it was computed from was rounded too.
    """
    unit = 10.0 ** (math.floor(math.log10(abs(expected))) - figures + 1)
    return abs(value - expected) <= unit * (1.5 + _SAME)
