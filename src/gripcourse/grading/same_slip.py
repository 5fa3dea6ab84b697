"""One wrong method in formulas that are alike: whoever thinks wrongly at both ends thinks so once.

Positions, sides and directions are computed by one formula with other numbers. A factor left out of
it, or a sign the wrong way round, is one mistake wherever it is written down. So it is at every
position of what moves, though one formula has a term more than another. So is the wrong row of a
table of which several columns are asked for. What one formula declares and the general kinds find
in another is the same where it computes alike. A calculator that takes degrees for radians does so
in every formula.
"""

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Final, TypeAlias

from gripcourse.course.quantity import Kind
from gripcourse.formula.tree import Call, form
from gripcourse.grading.explain import weigh
from gripcourse.grading.submission_case import (
    GradingCase,
    JudgedAnswer,
    cost_already,
    in_order_of_steps,
    is_unexplained,
)
from gripcourse.policy.slips import SlipKind
from gripcourse.slips.model import USED, SlipId
from gripcourse.text.words import message

Alike: TypeAlias = tuple[str, tuple[object, ...]]
"""What formulas have in common that are alike."""

_Method: TypeAlias = SlipId | tuple[object, ...]
"""What is done wrong: by its name, or by the form of what is computed instead."""

_Mistake: TypeAlias = tuple[_Method, Alike]

_OF_THE_CALCULATOR: Final[_Mistake] = SlipId(SlipKind.ANGLE_UNIT, ""), ("", ())
"""How a calculator is set is one thing, whatever the formulas are like."""


def same_slip_once(case: GradingCase, judged: Sequence[JudgedAnswer]) -> list[JudgedAnswer]:
    """Let a slip that is made in several formulas of one form cost the first of them.

    Args:
        case: the submission.
        judged: every answer.

    Returns:
        The same in the same order.
    """
    first: dict[_Mistake, str] = {}
    in_doubt = _alike_in_doubt(case, judged)
    for one in in_order_of_steps(case, judged):
        named = _named(case, one) or _met(case, one, in_doubt)
        # Of several that a number does not tell apart, the one that was made before was made again.
        root = next((first[mistake] for mistake in named if mistake in first), one.quantity.id)
        for mistake in named:
            first.setdefault(mistake, root)
    return [_once(case, one, first) for one in judged]


def _alike_in_doubt(case: GradingCase, judged: Sequence[JudgedAnswer]) -> set[Alike]:
    """Return what several wrong answers have in common that nothing explains.

    A number that stands at both ends may have been copied there: that rivals the method that gives
    it at both, and neither is named. One method is met at both by chance seldom.
    """
    unexplained = [set(likenesses(case, one)) for one in judged if is_unexplained(case, one)]
    counts = Counter(alike for of_one in unexplained for alike in of_one)
    return {alike for alike, count in counts.items() if count > 1}


def _met(case: GradingCase, judged: JudgedAnswer, in_doubt: Collection[Alike]) -> list[_Mistake]:
    """Return the methods that give an answer which nothing explains, as it gives those alike."""
    comparison = judged.comparison
    if comparison is None or not is_unexplained(case, judged):
        return []
    alike_ones = [one for one in likenesses(case, judged) if one in in_doubt]
    if not alike_ones:
        return []
    met = weigh(comparison, case.candidates_of(judged.quantity.id))
    return [(one.candidate.id, alike) for one in met for alike in alike_ones]


def likenesses(case: GradingCase, judged: JudgedAnswer) -> Iterator[Alike]:
    """Yield what an answer has in common with those that are computed or read alike."""
    name, kind = judged.quantity.id, judged.quantity.kind
    formula = case.plan.reference_formula(name)
    if formula is None:
        return
    match formula.tree:
        case Call(_, arguments, str(column)) if kind is Kind.PICK:
            yield column.partition(".")[0], arguments  # the table, and what its row is found by
        case tree if kind is Kind.FORMULA:
            yield judged.quantity.unit, form(tree)
            kinematics = case.plan.scheme.kinematics
            for position in kinematics.at if kinematics is not None else ():
                whatever = name.removesuffix(f"_{position}")
                if whatever != name:
                    yield judged.quantity.unit, (whatever,)


def _named(case: GradingCase, judged: JudgedAnswer) -> list[_Mistake]:
    """Return what was done wrongly, and in formulas like which, where that is named."""
    slip = judged.judgement.slip
    mistaken = judged.judgement.outcome.traits.mistake
    if not mistaken or slip is None or slip.kind == USED:
        return []
    named = {slip, *judged.judgement.tied}
    instead = [one for one in case.candidates_of(judged.quantity.id) if one.id in named]
    methods: list[_Method] = [slip, *judged.judgement.tied]
    methods += [form(one.formula.tree) for one in instead]
    found = [(one, alike) for one in methods for alike in likenesses(case, judged)]
    of_setting = any(one.kind == SlipKind.ANGLE_UNIT for one in named)
    return [*found, _OF_THE_CALCULATOR] if of_setting else found


def _once(case: GradingCase, judged: JudgedAnswer, first: Mapping[_Mistake, str]) -> JudgedAnswer:
    found = _named(case, judged) or _repeated(case, judged, first)
    root = first[found[0]] if found else judged.quantity.id
    if root == judged.quantity.id:
        return judged
    said = message(
        "The same mistake as in {title}; that has cost already.",
        title=case.plan.quantities[root].short_title,
    )
    return cost_already(case, judged, root, said)


def _repeated(
    case: GradingCase, judged: JudgedAnswer, first: Mapping[_Mistake, str]
) -> list[_Mistake]:
    """Return the slips of a formula that is alike, where they give this answer too.

    Alone it was in doubt: of a small angle nobody can tell radians from its sine. How a calculator
    was set speaks for every formula.
    """
    comparison = judged.comparison
    if not first or comparison is None or not is_unexplained(case, judged):
        return []
    alike_ones = set(likenesses(case, judged))
    candidates = case.candidates_of(judged.quantity.id)
    made: dict[_Method, _Mistake] = {}
    if _OF_THE_CALCULATOR in first:
        for one in candidates:
            if one.kind == SlipKind.ANGLE_UNIT:
                made[one.id] = _OF_THE_CALCULATOR
    made |= {one[0]: one for one in first if one[1] in alike_ones}
    met = weigh(comparison, [one for one in candidates if one.id in made])
    return [made[one.candidate.id] for one in met]
