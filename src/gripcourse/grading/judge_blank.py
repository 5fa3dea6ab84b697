"""Judging a number that follows through blank steps, as people compute them."""

from collections.abc import Iterator

from gripcourse.course.quantity import Kind
from gripcourse.grading.comparison import Comparison, Judgement, conclude
from gripcourse.grading.judge_rough import is_rounded_from
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.shortened import said_too_coarse, title_of_constant
from gripcourse.grading.through_blank import ThroughBlank, through_blank
from gripcourse.text.words import Message, message


def judge_through_blank(comparison: Comparison) -> Judgement | None:
    """Conclude that a number follows through steps that were left blank, as people compute them.

    What would have been right in the cell of a step costs nothing where the cell is blank; what
    would have been too coarse there costs the first answer that shows it.
    """
    coarse = None
    for one in _met(comparison):
        if not one.coarse:
            credit, said = comparison.policy.carried_credit, _said(comparison, one)
            return conclude(comparison, Outcome.CARRIED, Against.OWN_INPUTS, credit, said)
        coarse = coarse or one
    if coarse is None:
        return None
    credit, said = comparison.policy.rough_credit, _said_of_coarse(comparison, coarse)
    return conclude(comparison, Outcome.ROUGH, Against.OWN_INPUTS, credit, said)


def coarse_in_blank(comparison: Comparison) -> tuple[str, float] | None:
    """Return the shortened constant and its value, SI, that makes an answer too coarse."""
    for one in through_blank(comparison):
        if one.constant and _as_typed(comparison, one):
            return one.constant, one.way.constants[one.constant]
    return None


def _met(comparison: Comparison) -> Iterator[ThroughBlank]:
    return (one for one in through_blank(comparison) if _is_met(comparison, one))


def _is_met(comparison: Comparison, one: ThroughBlank) -> bool:
    """Tell whether an answer is what a way leads to.

    What is lost on the way must be met as exactly as the answer was typed: the band is wide enough
    for other mistakes.
    """
    nearest = one.expected.nearest(comparison.value)
    if comparison.quantity.kind is Kind.VERDICT:
        return comparison.fits(nearest)
    return _as_typed(comparison, one) or (one.coarse and is_rounded_from(comparison, nearest))


def _as_typed(comparison: Comparison, one: ThroughBlank) -> bool:
    return comparison.meets_as_typed(one.expected.nearest(comparison.value))


def _said(comparison: Comparison, found: ThroughBlank) -> Message:
    plan = comparison.plan
    for name in found.way.formulas:
        return message(
            "Follows from another reading of {title}, which you left blank.",
            title=plan.quantities[name].short_title,
        )
    for name, value in found.way.constants.items():
        return message(
            "Follows if {title} is taken as {value} in a step that you left blank.",
            title=title_of_constant(plan, name),
            value=value,
        )
    return message("Follows if the steps that you left blank were rounded.")


def _said_of_coarse(comparison: Comparison, found: ThroughBlank) -> Message:
    if found.constant:
        value = found.way.constants[found.constant]
        return said_too_coarse(comparison.plan, found.constant, value)
    return message(
        "Right, but a step that you left blank was rounded too far: keep at least {figures} "
        "significant figures.",
        figures=comparison.policy.figures,
    )
