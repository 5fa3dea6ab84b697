"""What answers rest on: credit that comes from one's own numbers needs numbers that were earned.

An answer that follows from the student's own numbers earns its points, because one mistake costs
once. That is fair as long as somebody calculated: zeros follow from zeros, the smallest size suits
the smallest number, and "yes" is right half of the time. So a work is looked at as a whole. Where
most of its computed answers are right, follow, or are understood, every consequence counts. Where
most are neither, an answer counts only if what it rests on does.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.grading.model import Outcome
from gripcourse.grading.submission_case import GradingCase, JudgedAnswer
from gripcourse.policy.bands import within
from gripcourse.solver.plan import Plan, depends_on_given
from gripcourse.text.words import message

_FEW: Final = 2  # mistakes that somebody makes who calculated


def withhold_unsupported(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Take the credit from answers that rest on numbers which nobody earned.

    Args:
        case: the submission.
        judged: every answer, with all that is known about it.

    Returns:
        The same in the same order.
    """
    if is_calculated(case, judged):
        return list(judged)
    by_id = {one.quantity.id: one for one in judged}
    earned: dict[str, bool] = {}
    for name in case.plan.quantities:
        if name in by_id and by_id[name].judgement.outcome.traits.typed:
            earned[name] = _is_earned(case, by_id[name], earned)
    return [
        _withheld(case, one, earned) if not earned.get(one.quantity.id, True) else one
        for one in judged
    ]


def is_calculated(case: GradingCase, judged: Sequence[JudgedAnswer]) -> bool:
    """Tell whether enough of the computed answers of a work are right or follow.

    Those that use issued numbers are also looked at by themselves: all others follow from each
    other in a neighbour's work as well. Zeros that follow from zeros, rough numbers and known slips
    speak neither for nor against it.
    """
    computed = [
        one
        for one in judged
        if one.quantity.kind is Kind.FORMULA and one.comparison is not None and not _is_nothing(one)
    ]
    calculated, unexplained = _counted(computed)
    share = case.policy.calculated_share
    if not calculated or calculated < share * (calculated + unexplained):
        return False
    calculated, unexplained = _counted(
        one for one in computed if _uses_issued(case.plan, one.quantity.id)
    )
    return unexplained <= _FEW or calculated >= share * (calculated + unexplained)


def _counted(judged: Iterable[JudgedAnswer]) -> tuple[int, int]:
    """Return how many answers show that somebody calculated, and how many nothing explains."""
    traits = [one.judgement.outcome.traits for one in judged]
    return sum(one.calculated for one in traits), sum(
        one.mistake and not one.named for one in traits
    )


def _uses_issued(plan: Plan, name: str) -> bool:
    return any(plan.quantities[one].kind is Kind.GIVEN for one in plan.inputs[name])


def _is_nothing(judged: JudgedAnswer) -> bool:
    """Tell whether an answer is a zero that only follows from others."""
    comparison, traits = judged.comparison, judged.judgement.outcome.traits
    if comparison is None or traits.equals_reference or not traits.calculated:
        return False
    return within(comparison.value, 0.0, comparison.band_round(0.0))


def _is_earned(case: GradingCase, judged: JudgedAnswer, earned: Mapping[str, bool]) -> bool:
    traits = judged.judgement.outcome.traits
    if not (traits.calculated or traits.named) or _is_nothing(judged):
        return False
    # Nobody meets a computed number within its band by guessing; the same one for all is known.
    is_met = traits.equals_reference and not judged.quantity.exact
    if is_met and depends_on_given(case.plan, judged.quantity.id):
        return True
    basis = list(_basis(case.plan, judged.quantity.id, earned))
    return bool(basis) and all(earned[name] for name in basis)


def _basis(plan: Plan, name: str, answered: Mapping[str, bool]) -> Iterator[str]:
    """Yield the answers that an answer rests on, through steps that were not written down."""
    waiting, seen = list(plan.inputs[name]), set[str]()
    while waiting:
        one = waiting.pop()
        if one in seen:
            continue
        seen.add(one)
        if one in answered:
            yield one
        else:
            waiting += plan.inputs[one]


def _withheld(case: GradingCase, judged: JudgedAnswer, earned: Mapping[str, bool]) -> JudgedAnswer:
    judgement = judged.judgement
    if not judgement.credit:
        return judged
    if judgement.outcome.traits.mistake:
        return replace(judged, judgement=replace(judgement, credit=0.0))
    roots = tuple(
        name for name in _basis(case.plan, judged.quantity.id, earned) if not earned[name]
    )
    said = (
        message("It counts only with the numbers that it rests on, and these are not explained.")
        if depends_on_given(case.plan, judged.quantity.id)
        else message("It is the same in every variant, and counts only in a work that calculates.")
    )
    return replace(
        judged,
        judgement=replace(
            judgement,
            outcome=Outcome.UNSUPPORTED,
            credit=0.0,
            roots=tuple(one for one in case.plan.quantities if one in roots),
            message=said,
        ),
    )
