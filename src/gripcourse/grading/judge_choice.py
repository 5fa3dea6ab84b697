"""Judging a design decision against the required value, the reference's or the student's own."""

import math
from collections.abc import Iterator

import numpy as np

from gripcourse.course.quantity import Rounding
from gripcourse.formula.tree import Name
from gripcourse.grading.choices import judge_choice, largest_size, printed_choice, same_size
from gripcourse.grading.comparison import Comparison, Judgement, conclude
from gripcourse.grading.judge_value import ANOTHER_READING
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.other_versions import as_printed, read_otherwise
from gripcourse.grading.rounding import endings, kept_figures
from gripcourse.grading.size_condition import Satisfies, by_formulas, conditions_at_own
from gripcourse.grading.through_blank import through_blank
from gripcourse.text.units import factor
from gripcourse.text.words import message


def judge_choice_answer(comparison: Comparison) -> Judgement:
    """Judge a decision: sound by the reference, by the student's own numbers, or as printed."""
    judgement = _judge_size(comparison)
    return judgement if comparison.answer.unit_fits else _with_wrong_unit(judgement, comparison)


def _with_wrong_unit(judgement: Judgement, comparison: Comparison) -> Judgement:
    """The right size with a unit that measures something else earns what the policy says."""
    if not judgement.outcome.traits.right:
        return judgement
    said = message("The number is right, the unit is not.")
    credit = comparison.policy.wrong_unit_credit
    return conclude(comparison, Outcome.WRONG, Against.NOTHING, credit, said)


def _judge_size(comparison: Comparison) -> Judgement:
    formula = comparison.plan.reference_formula(comparison.quantity.id)
    if formula is None:
        return conclude(comparison, Outcome.NOT_JUDGED, Against.NOTHING, 0.0, message("No rule."))
    scale = factor(comparison.quantity.unit)
    chosen = comparison.value * scale
    required = comparison.at_reference(formula) * scale
    plan, quantity = comparison.plan, comparison.quantity
    reference = by_formulas(plan, quantity, comparison.reference_values)
    if judge_choice(plan, quantity, chosen, required, reference).sound:
        said = message("A sound decision.")
        return conclude(comparison, Outcome.CORRECT, Against.REFERENCE, 1.0, said)
    own_required = comparison.at_own(formula)
    is_answer = isinstance(formula.tree, Name)
    written = () if is_answer else _as_written(own_required.value, comparison)
    # What is needed is known as finely as the earlier numbers were typed.
    verdicts = [
        judge_choice(plan, quantity, chosen, end * scale, satisfies)
        for satisfies in _own_conditions(comparison, own_required.value)
        for end in (own_required.value, own_required.low, own_required.high, *written)
    ]
    follow_through = verdicts[0]
    # After a slip no entry may satisfy a further condition; the rule's own pick is no new fault.
    picked = any(same_size(chosen, one) for one in _by_the_rule(comparison))
    sound = picked or any(verdict.sound for verdict in verdicts)
    if sound or _is_sound_through_blank(comparison, own_required.value):
        said = message("A sound decision for your own earlier numbers.")
        credit = comparison.policy.carried_credit
        return conclude(comparison, Outcome.CARRIED, Against.OWN_INPUTS, credit, said)
    return (
        _judge_largest(comparison, chosen, own_required.low * scale)
        or _judge_alternative(comparison, chosen)
        or _judge_printed(comparison, chosen, own_required.value * scale)
    ) or conclude(
        comparison,
        Outcome.WRONG if follow_through.slip is None else Outcome.SLIP,
        Against.NOTHING,
        0.0,
        follow_through.fault or message("The required value cannot be computed from your numbers."),
        slip=follow_through.slip,
    )


def _judge_largest(comparison: Comparison, chosen: float, required: float) -> Judgement | None:
    """Judge the largest size there is, where an earlier mistake asks for a larger one.

    Args:
        comparison: of the decision.
        chosen: the size, SI.
        required: what it must not be below at the student's own numbers, at least, SI.
    """
    choice = comparison.quantity.choice
    if choice is None or choice.rounding is not Rounding.UP:
        return None
    largest = largest_size(comparison.plan, choice)
    if not (required > largest and same_size(chosen, largest)):
        return None
    said = message("No size is large enough for your own earlier numbers; this is the largest.")
    credit = comparison.policy.carried_credit
    return conclude(comparison, Outcome.CARRIED, Against.OWN_INPUTS, credit, said)


def _is_sound_through_blank(comparison: Comparison, required: float) -> bool:
    """Tell whether a size is sound by constants and digits as people lose them in blank steps."""
    plan, quantity, scale = comparison.plan, comparison.quantity, factor(comparison.quantity.unit)
    conditions = _own_conditions(comparison, required)
    return any(
        judge_choice(plan, quantity, comparison.value * scale, needed * scale, one).sound
        for needed in {way.expected.value for way in through_blank(comparison) if not way.coarse}
        for one in conditions
    )


def _by_the_rule(comparison: Comparison) -> Iterator[float]:
    """Yield what the rule takes at the student's own numbers, SI.

    A size may be stepped up to, or not, for a last digit that was not typed.
    """
    yield comparison.expected * factor(comparison.quantity.unit)
    if comparison.quantity.steps_up:
        moved = comparison.follow_through.moved.computed[comparison.quantity.id]
        yield from np.unique(moved).tolist()


def _own_conditions(comparison: Comparison, required: float) -> tuple[Satisfies, ...]:
    """Return the ways in which the size may satisfy its condition at the student's own numbers.

    Where no size of the series does, after a slip, nobody can step up to one: the first will do.
    """
    plan, quantity, numbers = (
        comparison.plan,
        comparison.quantity,
        comparison.follow_through.numbers,
    )
    without = math.isnan(numbers.computed[quantity.id]) and math.isfinite(required)
    if quantity.steps_up and without:
        return (lambda _: True,)
    return conditions_at_own(plan, quantity, numbers)


def _as_written(required: float, comparison: Comparison) -> tuple[float, ...]:
    """Return what is needed as people write it down who keep as many figures as are asked.

    It is computed on the way to the size and no answer of its own, so it was not typed: whoever
    rounds or cuts off every number does so with this one too.
    """
    if not required or not math.isfinite(required):
        return ()
    policy = comparison.policy
    return tuple(kept_figures(required, policy.figures, cut=cut) for cut in endings(policy))


def _judge_alternative(comparison: Comparison, chosen: float) -> Judgement | None:
    """Judge a size by the other readings of what is required, at the reference and at own."""
    scale = factor(comparison.quantity.unit)
    plan, quantity = comparison.plan, comparison.quantity
    reference = (by_formulas(plan, quantity, comparison.reference_values),)
    own = conditions_at_own(plan, quantity, comparison.follow_through.numbers)
    for other in comparison.quantity.alternatives:
        required = (
            (comparison.at_reference(other.formula), reference),
            (comparison.at_own(other.formula).value, own),
        )
        if any(
            judge_choice(plan, quantity, chosen, value * scale, satisfies).sound
            for value, conditions in required
            for satisfies in conditions
        ):
            return conclude(
                comparison,
                Outcome.CORRECT,
                Against.ALTERNATIVE,
                1.0,
                ANOTHER_READING,
                remarks=(read_otherwise(other),),
            )
    return None


def _judge_printed(comparison: Comparison, chosen: float, required: float) -> Judgement | None:
    printed = printed_choice(comparison.plan, comparison.quantity, required)
    credit = comparison.policy.printed_credit
    if printed is None or credit is None or not same_size(chosen, printed):
        return None
    erratum = next(one for one in comparison.quantity.as_printed if one.rounding is not None)
    said, remarks = message("Accepted as the source prints it."), (as_printed(erratum),)
    return conclude(comparison, Outcome.CORRECT, Against.PRINTED, credit, said, remarks=remarks)
