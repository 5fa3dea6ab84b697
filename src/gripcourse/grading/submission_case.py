"""One submission on the judge's table: what its answers are compared with, one answer at a time."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.grading.comparison import Comparison, Judgement
from gripcourse.grading.diagnose import CandidatesOf, diagnose
from gripcourse.grading.follow_through import FollowThrough, follow
from gripcourse.grading.judge_choice import judge_choice_answer
from gripcourse.grading.judge_value import judge_value
from gripcourse.grading.manner import UNKNOWN, Manner
from gripcourse.grading.model import Against, Outcome
from gripcourse.policy.model import Policy
from gripcourse.policy.points import points_of
from gripcourse.solver.numbers import evaluate_numbers
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import to_si
from gripcourse.submission.model import Answer, Reading, Submission
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued


@dataclass(frozen=True, slots=True)
class GradingCase:
    """What the answers of a submission are compared with.

    Attributes:
        given: the issued values, in declared units.
        answers: what is followed; none of a workbook that is another student's.
        reference: the reference values, SI.
        own: the calculation at the student's own numbers.
        points: of every answer.
        candidates_of: the wrong methods of each quantity.
        is_own: whether the workbook is the student's own, as far as it says.
        manner: how the student writes numbers, as far as that is known.
    """

    plan: Plan
    policy: Policy
    given: Mapping[str, float]
    answers: Mapping[str, Answer]
    reference: Mapping[str, float]
    follow_through: FollowThrough
    points: Mapping[str, float]
    candidates_of: CandidatesOf
    is_own: bool
    manner: Manner = UNKNOWN


@dataclass(frozen=True, slots=True)
class JudgedAnswer:
    """One quantity with what was concluded; `view` is None where there is no value to look at."""

    quantity: Quantity
    answer: Answer | None
    comparison: Comparison | None
    judgement: Judgement


def make_case(
    submission: Submission,
    issued: Issued,
    plan: Plan,
    policy: Policy,
    candidates_of: CandidatesOf,
) -> GradingCase:
    """Lay a submission on the table; see `judge` for the arguments."""
    given = issued.variant.given
    reference = evaluate_numbers(plan, to_si(plan, given)).values
    # Another student's workbook holds nobody's own numbers here: nothing is followed from them.
    is_own = submission.identity.student in {"", issued.signed_for}
    answers = submission.answers if is_own else {}
    follow_through = follow(plan, given, answers, reference, policy)
    return GradingCase(
        plan=plan,
        policy=policy,
        given=given,
        answers=answers,
        reference=reference,
        follow_through=follow_through,
        points=points_of(plan, policy),
        candidates_of=candidates_of,
        is_own=is_own,
    )


def with_answers(
    case: GradingCase, answers: Mapping[str, Answer], anyway: Collection[str] = ()
) -> GradingCase:
    """Return the case where these answers are followed instead of those of the same ids.

    Args:
        case: the submission.
        answers: what is followed.
        anyway: answers that are followed though they are physically unthinkable.
    """
    followed = {**case.answers, **answers}
    follow_through = follow(case.plan, case.given, followed, case.reference, case.policy, anyway)
    return replace(case, answers=followed, follow_through=follow_through)


def with_given(case: GradingCase, given: Mapping[str, float]) -> GradingCase:
    """Return the case where these values, in declared units, stand in the place of issued ones."""
    taken = {**case.given, **given}
    follow_through = follow(case.plan, taken, case.answers, case.reference, case.policy)
    return replace(case, given=taken, follow_through=follow_through)


def judge_answer(case: GradingCase, quantity: Quantity, answer: Answer | None) -> JudgedAnswer:
    """Judge one answer by its value; a wrong one is not explained yet."""
    if quantity.kind is Kind.MANUAL:
        judgement = _without_value(Outcome.MANUAL, message("Marked by hand."))
    elif answer is None or answer.reading is Reading.BLANK:
        judgement = _without_value(Outcome.BLANK, message("No answer."))
    elif answer.reading is Reading.UNREADABLE or answer.value is None:
        judgement = _without_value(Outcome.UNREADABLE, message("The answer could not be read."))
    else:
        return _viewed(case, quantity, answer, answer.value)
    return JudgedAnswer(quantity, answer, None, judgement)


def explain(
    case: GradingCase, judged: Sequence[JudgedAnswer], only: Collection[str] | None = None
) -> list[JudgedAnswer]:
    """Name the slips behind wrong answers; a unit that does not fit explains itself.

    Args:
        case: the submission.
        judged: every answer.
        only: ids of those that are looked at; None for all.
    """
    views = {one.quantity.id: one.comparison for one in judged if one.comparison is not None}
    return [
        replace(one, judgement=_diagnosed(case, one.comparison, one.judgement, views))
        if one.comparison is not None
        and (only is None or one.quantity.id in only)
        and is_unexplained(case, one)
        else one
        for one in judged
    ]


def in_order_of_steps(case: GradingCase, judged: Iterable[JudgedAnswer]) -> list[JudgedAnswer]:
    """Return answers in the order in which they are computed: who pays first, pays."""
    order = {name: rank for rank, name in enumerate(case.plan.quantities)}
    return sorted(judged, key=lambda one: order.get(one.quantity.id, 0))


def cost_already(case: GradingCase, judged: JudgedAnswer, root: str, said: Message) -> JudgedAnswer:
    """Return an answer as one that costs nothing more: what is wrong with it has cost elsewhere.

    Args:
        case: the submission.
        judged: the answer.
        root: id of the answer that it has cost.
        said: to the student.
    """
    judgement = replace(
        judged.judgement,
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        credit=case.policy.carried_credit,
        slip=None,
        tied=(),
        roots=(root,),
        message=said,
    )
    return replace(judged, judgement=judgement)


def is_unexplained(case: GradingCase, judged: JudgedAnswer) -> bool:
    """Tell whether an answer is wrong and nothing says why yet."""
    traits = judged.judgement.outcome.traits
    wrong = traits.mistake and not traits.named and case.is_own
    return wrong and judged.comparison is not None and judged.comparison.answer.unit_fits


def _diagnosed(
    case: GradingCase, comparison: Comparison, judgement: Judgement, views: Mapping[str, Comparison]
) -> Judgement:
    name = comparison.quantity.id
    later = [
        other
        for user, other in views.items()
        if name in case.plan.inputs[user] and other.quantity.kind is Kind.FORMULA
    ]
    return diagnose(comparison, judgement, case.candidates_of, later)


def _viewed(case: GradingCase, quantity: Quantity, answer: Answer, value: float) -> JudgedAnswer:
    comparison = Comparison(
        plan=case.plan,
        policy=case.policy,
        quantity=quantity,
        answer=answer,
        value=value,
        reference_values=case.reference,
        follow_through=case.follow_through,
        manner=case.manner,
    )
    if not comparison.has_reference:
        said = message("There is no reference value for this variant; the instructor decides.")
        return JudgedAnswer(quantity, answer, comparison, _without_value(Outcome.NOT_JUDGED, said))
    judgement = (
        judge_choice_answer(comparison) if quantity.kind is Kind.CHOICE else judge_value(comparison)
    )
    return JudgedAnswer(quantity, answer, comparison, judgement)


def _without_value(outcome: Outcome, said: Message) -> Judgement:
    return Judgement(outcome, Against.NOTHING, None, 0.0, 0.0, None, (), (), said, ())
