"""What answers rest on: credit that comes from one's own numbers needs numbers that were earned.

An answer that follows from the student's own numbers earns its points, because one mistake costs
once. That is fair as long as somebody calculated: zeros follow from zeros, the smallest size suits
the smallest number, and "yes" is right half of the time. So a work is looked at as a whole. Where
most of its computed answers are right, follow, or are understood, every consequence counts. Where
most are neither, an answer counts only if what it rests on does.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.grading.model import Outcome
from gripcourse.grading.submission_case import GradingCase, JudgedAnswer
from gripcourse.policy.bands import within
from gripcourse.slips.model import USED
from gripcourse.solver.plan import Plan, depends_on_given
from gripcourse.text.words import message

_FEW: Final = 2  # mistakes that somebody makes who calculated
# What may not suit what was issued; a yes or no is wrong by chance.
_FOUND: Final = frozenset({Kind.FORMULA, Kind.CHOICE, Kind.PICK})


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
    earned = _earned(case, judged)
    return [
        _withheld(case, one, earned) if not earned.get(one.quantity.id, True) else one
        for one in judged
    ]


def is_calculated(case: GradingCase, judged: Sequence[JudgedAnswer]) -> bool:
    """Tell whether enough of the computed answers of a work are right or follow.

    Those that use issued numbers are also looked at by themselves: all others follow from each
    other in a neighbour's work as well. Zeros that follow from zeros, rough numbers and known slips
    speak neither for nor against it. A size or an entry of a table that does not suit what was
    issued speaks against it; one that does is met by chance.
    """
    numbers = [one for one in judged if one.comparison is not None and not _is_nothing(one)]
    computed = [one for one in numbers if one.quantity.kind is Kind.FORMULA]
    found = [one for one in numbers if one.quantity.kind in _FOUND]
    counted = _counted(computed, _is_unexplained)
    share = case.policy.calculated_share
    if not counted.calculated or counted.share < share:
        return False
    # One or two numbers are read wrongly; who has more of them wrong has somebody else's.
    misread = {one.judgement.slip for one in found if _is_misread(case.plan, one)}
    is_mistaken = _is_mistake if len(misread) > _FEW else _is_unexplained
    own = [
        one for one in found if _uses_issued(case.plan, one.quantity.id) and not _is_forgiven(one)
    ]
    counted = _counted(own, is_mistaken)
    return counted.mistaken <= _FEW or counted.share >= share


@dataclass(frozen=True, slots=True)
class _Counted:
    """How many answers show that somebody calculated, and how many speak against it."""

    calculated: int
    mistaken: int

    @property
    def share(self) -> float:
        return self.calculated / max(1, self.calculated + self.mistaken)


def _counted(judged: Sequence[JudgedAnswer], counts: Callable[[JudgedAnswer], bool]) -> _Counted:
    calculated = sum(
        one.judgement.outcome.traits.calculated and one.quantity.kind is Kind.FORMULA
        for one in judged
    )
    return _Counted(calculated, sum(map(counts, judged)))


def _is_unexplained(judged: JudgedAnswer) -> bool:
    return _is_mistake(judged) and not judged.judgement.outcome.traits.named


def _is_mistake(judged: JudgedAnswer) -> bool:
    return judged.judgement.outcome.traits.mistake


def _is_misread(plan: Plan, judged: JudgedAnswer) -> bool:
    """Tell whether an answer is the first that follows from another number than was issued."""
    slip = judged.judgement.slip
    return (
        slip is not None and slip.kind == USED and plan.quantities[slip.detail].kind is Kind.GIVEN
    )


def _uses_issued(plan: Plan, name: str) -> bool:
    return any(plan.quantities[one].kind is Kind.GIVEN for one in plan.inputs[name])


def _is_forgiven(judged: JudgedAnswer) -> bool:
    """Tell whether an answer follows from none of the student's numbers, but from one used wrongly.

    In a neighbour's work all do that use one issued number.
    """
    comparison, traits = judged.comparison, judged.judgement.outcome.traits
    if comparison is None or not traits.follows:
        return False
    return not comparison.fits(comparison.follows.nearest(comparison.value))


def _is_nothing(judged: JudgedAnswer) -> bool:
    """Tell whether an answer is a zero that only follows from others."""
    comparison, traits = judged.comparison, judged.judgement.outcome.traits
    if comparison is None or traits.equals_reference or not traits.calculated:
        return False
    return within(comparison.value, 0.0, comparison.band_round(0.0))


def _earned(case: GradingCase, judged: Sequence[JudgedAnswer]) -> dict[str, bool]:
    """Tell of each answer that was typed whether it was earned."""
    by_id = {one.quantity.id: one for one in judged}
    earned: dict[str, bool] = {}
    spoiled: set[str] = set()  # what is wrong, or rests on what is, and was not earned
    for name in case.plan.quantities:
        if name in by_id and by_id[name].judgement.outcome.traits.typed:
            basis = tuple(_basis(case.plan, name, earned))
            earned[name] = _is_earned(case, by_id[name], basis, earned, spoiled)
            is_wrong = by_id[name].judgement.outcome.traits.mistake
            if not earned[name] and (is_wrong or not spoiled.isdisjoint(basis)):
                spoiled.add(name)
    return earned


def _is_earned(
    case: GradingCase,
    judged: JudgedAnswer,
    basis: Sequence[str],
    earned: Mapping[str, bool],
    spoiled: set[str],
) -> bool:
    traits = judged.judgement.outcome.traits
    if not (traits.calculated or traits.named) or _is_nothing(judged):
        return False
    # Nobody meets a computed number within its band by guessing; the same one for all is known.
    # What is right beside wrong numbers that it rests on was not computed with them.
    is_met = traits.equals_reference and not judged.quantity.exact
    if is_met and depends_on_given(case.plan, judged.quantity.id):
        return spoiled.isdisjoint(basis) or _is_exactly_right(judged)
    return bool(basis) and all(earned[name] for name in basis)


def _is_exactly_right(judged: JudgedAnswer) -> bool:
    """Tell whether an answer is the reference as exactly as it was typed, not only in its band."""
    comparison = judged.comparison
    return comparison is not None and comparison.meets_as_typed(comparison.reference)


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
