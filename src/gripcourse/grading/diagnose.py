"""What is behind the wrong answers of a submission: slips in them, and in what was left out.

A slip may have been made in a step that the student did not write down; then its result shows only
in the next answer that was.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.grading.choices import same_size, sound_sizes
from gripcourse.grading.comparison import Comparison, ExpectedRange, Judgement
from gripcourse.grading.explain import (
    Explanation,
    Weighed,
    conclude,
    density_alone,
    weigh,
    with_later_answers,
)
from gripcourse.grading.lost_cosine import said_of_lost_cosine
from gripcourse.grading.mistyped import is_mistyped
from gripcourse.grading.model import Against, Outcome
from gripcourse.grading.other_cell import is_number_of, weigh_other_cell
from gripcourse.grading.typed_density import density
from gripcourse.grading.unwritten import UNWRITTEN, carried_here, unwritten_before
from gripcourse.policy.slips import OF_WRITING
from gripcourse.slips.model import Candidate
from gripcourse.solver.sizes import choose
from gripcourse.text.units import factor
from gripcourse.text.words import Message, message

CandidatesOf = Callable[[str], tuple[Candidate, ...]]
"""The wrong methods of a quantity, by its id."""


def diagnose(
    comparison: Comparison,
    judgement: Judgement,
    candidates_of: CandidatesOf,
    later: Sequence[Comparison],
) -> Judgement:
    """Name the slip behind a wrong answer.

    Args:
        comparison: of the answer.
        judgement: that it is wrong.
        candidates_of: the wrong methods of each quantity.
        later: the answers whose formulas use this one.

    Returns:
        The judgement with the slip that explains the answer, itself where none does.
    """
    if comparison.quantity.kind is Kind.CHOICE:
        return _with_wrong_rule(comparison, judgement, candidates_of(comparison.quantity.id))
    other_size = _with_other_size(comparison, judgement)
    if other_size is not None:
        return other_size
    if comparison.quantity.kind not in {Kind.FORMULA, Kind.PICK}:
        return judgement
    candidates = candidates_of(comparison.quantity.id)
    met = weigh(comparison, candidates)
    judgement = replace(judgement, alone=density_alone(comparison, met, candidates))
    weighed = [with_later_answers(one, later) for one in met]
    for earlier in _unwritten(comparison, Kind.FORMULA):
        weighed += _weigh_earlier(comparison, earlier, candidates_of(earlier))
    other, rival = weigh_other_cell(comparison)
    if other is not None:
        # A method that leads to the very number of the other answer is no rival of it.
        explanation = conclude(comparison, weighed)
        if explanation is not None and is_number_of(comparison, other, explanation.likeliest):
            return _with_other_end(comparison, judgement, explanation, other)
    explanation = conclude(comparison, weighed, rival)
    return _explained(comparison, judgement, explanation, other)


def _explained(
    comparison: Comparison,
    judgement: Judgement,
    explanation: Explanation | None,
    other: str | None,
) -> Judgement:
    """Say what explains an answer; `other` is one that has the same number."""
    if explanation is None:
        if other is not None:
            return _with_other_cell(comparison, judgement, other)
        return _with_typed_digits(judgement) if is_mistyped(comparison) else judgement
    if explanation.likeliest.of == comparison.quantity.id:
        return _with_slip(comparison, judgement, explanation)
    methods = (explanation.likeliest, *explanation.tied)
    if any(one.of in comparison.follow_through.not_carried for one in methods):
        return judgement  # that step is not blank: what its number leads to is looked at by itself
    return _with_earlier_slip(comparison, judgement, explanation)


def _with_wrong_rule(
    comparison: Comparison, judgement: Judgement, candidates: tuple[Candidate, ...]
) -> Judgement:
    """Name the slip by which a decision is exactly what its wrong rule asks for.

    Nothing is named where several rules lead to that size: a series has few entries.
    """
    choice = comparison.quantity.choice
    if choice is None or not candidates:
        return judgement
    scale = factor(comparison.quantity.unit)
    needed = np.array([comparison.at_own(one.formula).value for one in candidates]) * scale
    own = comparison.follow_through.evaluation.values
    taken = choose(comparison.plan, comparison.quantity, needed, own).tolist()
    met = [
        one
        for one, size in zip(candidates, taken, strict=True)
        if same_size(comparison.value * scale, size)
    ]
    if len(met) != 1:
        return judgement
    said = message("A known slip: {hint}", hint=met[0].hint)
    return replace(
        judgement, outcome=Outcome.SLIP, credit=met[0].credit, slip=met[0].id, message=said
    )


def _with_other_cell(comparison: Comparison, judgement: Judgement, other: str) -> Judgement:
    title = comparison.plan.quantities[other].short_title
    said = message("The same number stands in another cell: {title}.", title=title)
    return replace(judgement, remarks=(*judgement.remarks, said), elsewhere=other)


def _with_typed_digits(judgement: Judgement) -> Judgement:
    said = message("Digits may have been exchanged, lost or doubled when it was typed.")
    return replace(judgement, remarks=(*judgement.remarks, said), mistyped=True)


def _with_other_end(
    comparison: Comparison, judgement: Judgement, explanation: Explanation, other: str
) -> Judgement:
    """Name a method by which the number of another answer is computed: which it was shows nowhere.

    What follows is looked at as with a number in the wrong cell.
    """
    said = message(
        "A known slip: {hint} Or the number of another cell was written here: {title}.",
        hint=explanation.likeliest.candidate.hint,
        title=comparison.plan.quantities[other].short_title,
    )
    slip = _with_slip(comparison, judgement, explanation)
    return replace(slip, message=said, elsewhere=other)


def _with_slip(comparison: Comparison, judgement: Judgement, explanation: Explanation) -> Judgement:
    likeliest = explanation.likeliest.candidate
    return replace(
        judgement,
        outcome=Outcome.SLIP,
        credit=likeliest.credit,
        slip=likeliest.id,
        tied=tuple(one.candidate.id for one in explanation.tied),
        message=_said(comparison, explanation),
    )


def _said(comparison: Comparison, explanation: Explanation) -> Message:
    likeliest = explanation.likeliest.candidate
    others = _said_otherwise(explanation)
    together = [one.candidate for one in (explanation.likeliest, *others)]
    if all(one.of == comparison.quantity.id for one in others):
        lost_cosine = said_of_lost_cosine(together)
        if lost_cosine is not None:
            return lost_cosine
    match others:
        case (other, *_) if other.of != comparison.quantity.id:
            return message(
                "One of two known slips. Either: {hint} Or, in a step that you left blank, "
                "{title}: {other}",
                hint=likeliest.hint,
                title=comparison.plan.quantities[other.of].short_title,
                other=other.candidate.hint_after([likeliest]),
            )
        case (other, third) if third.of == comparison.quantity.id:
            return message(
                "One of three known slips. Either: {hint} Or: {other} Or: {third}",
                hint=likeliest.hint,
                other=other.candidate.hint_after([likeliest]),
                third=third.candidate.hint_after([likeliest, other.candidate]),
            )
        case (other, *_):
            return message(
                "One of two known slips. Either: {hint} Or: {other}",
                hint=likeliest.hint,
                other=other.candidate.hint_after([likeliest]),
            )
    return message("A known slip: {hint}", hint=likeliest.hint)


def _said_otherwise(explanation: Explanation) -> tuple[Weighed, ...]:
    """Return the tied methods of which more is to be said than of those before them.

    A wrong sign in one place of a formula and in another are one sentence.
    """
    said, others = [explanation.likeliest], []
    for one in explanation.tied:
        if all(one.of != other.of or one.candidate.hint != other.candidate.hint for other in said):
            others.append(one)
            said.append(one)
    return tuple(others)


def _said_of_earlier(comparison: Comparison, explanation: Explanation) -> Message:
    quantities = comparison.plan.quantities
    methods = (explanation.likeliest, *_said_otherwise(explanation))
    return said_of_blank([(quantities[one.of], one.candidate) for one in methods])


def said_of_blank(methods: Sequence[tuple[Quantity, Candidate]]) -> Message:
    """Say of an answer what was done wrongly in a step that was left blank: one thing, or two."""
    (step, method), *others = methods
    for other, another in others:
        if other is step:
            return message(
                "Follows from one of two slips in a step that you left blank, {title}. Either: "
                "{hint} Or: {other}",
                title=step.short_title,
                hint=method.hint,
                other=another.hint_after([method]),
            )
        return message(
            "Follows from a slip in a step that you left blank, {title}: {hint} Or from another "
            "one, {step}: {other}",
            title=step.short_title,
            hint=method.hint,
            step=other.short_title,
            other=another.hint_after([method]),
        )
    return message(
        "Follows from a slip in a step that you left blank, {title}: {hint}",
        title=step.short_title,
        hint=method.hint,
    )


def _with_earlier_slip(
    comparison: Comparison, judgement: Judgement, explanation: Explanation
) -> Judgement:
    """The slip was made in a step that is blank and earns nothing there; it costs once."""
    likeliest = explanation.likeliest
    return replace(
        judgement,
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        credit=comparison.policy.carried_credit,
        slip=likeliest.candidate.id,
        tied=tuple(one.candidate.id for one in explanation.tied),
        roots=(likeliest.of,),
        message=_said_of_earlier(comparison, explanation),
    )


def _with_other_size(comparison: Comparison, judgement: Judgement) -> Judgement | None:
    """Accept what follows from another sound size that the student did not write down."""
    for name in _unwritten(comparison, Kind.CHOICE):
        sizes = sound_sizes(comparison, name)
        if not sizes:
            continue
        here = carried_here(comparison, name, np.asarray(sizes)) / factor(comparison.quantity.unit)
        for size, value in zip(sizes, here.tolist(), strict=True):
            if comparison.fits(_spread_as(comparison.follows, value).nearest(comparison.value)):
                title = comparison.plan.quantities[name].short_title
                declared = size / factor(comparison.plan.quantities[name].unit)
                return replace(
                    judgement,
                    outcome=Outcome.CARRIED,
                    against=Against.OWN_INPUTS,
                    credit=comparison.policy.carried_credit,
                    message=message(
                        "Follows if {title} was chosen as {value}, which you did not write down.",
                        title=title,
                        value=declared,
                    ),
                )
    return None


def _unwritten(comparison: Comparison, kind: Kind) -> list[str]:
    """Return the quantities of a kind that lead to this one through no number of the student's."""
    quantities = comparison.plan.quantities
    return [name for name in unwritten_before(comparison) if quantities[name].kind is kind]


def _weigh_earlier(
    comparison: Comparison, name: str, candidates: tuple[Candidate, ...]
) -> list[Weighed]:
    """Weigh wrong methods of an earlier step by what they make of this answer.

    Nothing was written there, so that nothing was written in another unit.
    """
    candidates = tuple(one for one in candidates if one.kind not in OF_WRITING)
    if not candidates:
        return []
    unit = comparison.plan.quantities[name].unit
    values = comparison.follow_through.evaluation.values
    results = [
        float(evaluate_formula(one.formula, unit, values, comparison.plan.columns))
        for one in candidates
    ]
    here = carried_here(comparison, name, np.asarray(results)) / factor(comparison.quantity.unit)
    return [
        Weighed(name, candidate, value, UNWRITTEN * candidate.prior * density(comparison, spread))
        for candidate, value in zip(candidates, here.tolist(), strict=True)
        for spread in [_spread_as(comparison.follows, value)]
        if np.isfinite(value)
    ]


def _spread_as(follows: ExpectedRange, value: float) -> ExpectedRange:
    """Return a range that is as wide, in proportion, as what follows from the right method."""
    if follows.value == 0 or not np.isfinite(follows.value):
        return ExpectedRange(value, value, value)
    down, up = sorted((follows.low / follows.value * value, follows.high / follows.value * value))
    return ExpectedRange(value, min(down, value), max(up, value))
