"""Judging one submission: pure, from answers and issued values to a report.

Each answer is compared with the reference first, then with its formula at the student's own earlier
numbers; the better counts. So one mistake costs once, and rounding on the way costs nothing.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from gripcourse.course.model import Kind, Quantity
from gripcourse.course.policy import Policy
from gripcourse.grading.flags import flags_of
from gripcourse.grading.judge_choice import judge_choice_answer
from gripcourse.grading.judge_value import judge_value
from gripcourse.grading.model import OPEN, Against, Finding, Outcome, Report
from gripcourse.grading.own import Own, follow
from gripcourse.grading.points import points_of
from gripcourse.grading.view import Judgement, View
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import evaluate, from_si, to_si
from gripcourse.submission.model import Answer, Reading, Submission
from gripcourse.variants.model import Issued
from gripcourse.words import Message, message


@dataclass(frozen=True, slots=True)
class _Case:
    """One submission on the judge's table."""

    plan: Plan
    policy: Policy
    given: Mapping[str, float]
    reference: Mapping[str, float]
    own: Own
    own_values: Mapping[str, float]
    points: Mapping[str, float]


def judge(submission: Submission, issued: Issued, plan: Plan, policy: Policy) -> Report:
    """Judge a submission against the values that were issued to its student.

    Args:
        submission: what was read.
        issued: the register's entry of the student who handed it in.
        plan: of the issued variant.
        policy: points, bands and credits.
    """
    case = _case(submission, issued, plan, policy)
    findings = tuple(
        _finding(case, quantity, submission.answers.get(quantity.id))
        for quantity in _in_order(plan)
    )
    judged = [finding for finding in findings if finding.outcome not in OPEN]
    return Report(
        file=submission.file,
        student=issued.student.id,
        name=issued.student.name,
        variant=issued.variant.id,
        scheme=plan.scheme.id,
        options=plan.options,
        language=issued.student.language or plan.course.language,
        score=sum(finding.points for finding in judged),
        max_score=sum(finding.max_points for finding in judged),
        open_points=sum(f.max_points for f in findings if f.outcome in OPEN),
        flags=flags_of(submission, issued, findings),
        findings=findings,
        remarks=submission.remarks,
        judged=True,
        digest=submission.digest,
    )


def _case(submission: Submission, issued: Issued, plan: Plan, policy: Policy) -> _Case:
    given = issued.variant.given
    reference = {
        name: float(value) for name, value in evaluate(plan, to_si(plan, given)).values.items()
    }
    # Another student's workbook holds nobody's own numbers here: nothing is followed from them.
    is_own = submission.identity.student in {"", issued.student.id}
    own = follow(plan, given, submission.answers if is_own else {}, reference)
    return _Case(
        plan=plan,
        policy=policy,
        given=given,
        reference=reference,
        own=own,
        own_values=from_si(plan, own.evaluation.values),
        points=points_of(plan, policy),
    )


def _in_order(plan: Plan) -> list[Quantity]:
    """Order as the assignment does: by section, manual items last in theirs."""
    sections = {section.id: rank for rank, section in enumerate(plan.course.sections)}
    return sorted((*plan.answered, *plan.manual), key=lambda one: sections[one.section])


def _finding(case: _Case, quantity: Quantity, answer: Answer | None) -> Finding:
    judgement = _judgement(case, quantity, answer)
    available = case.points[quantity.id]
    return Finding(
        quantity=quantity.id,
        section=quantity.section,
        outcome=judgement.outcome,
        against=judgement.against,
        given=answer.value if answer is not None else None,
        typed=answer.typed if answer is not None else "",
        cell=answer.cell if answer is not None else "",
        reference=_declared(case, quantity, case.reference.get(quantity.id)),
        expected=judgement.expected,
        band=judgement.band,
        inputs={name: case.own_values[name] for name in case.plan.inputs[quantity.id]},
        points=available * judgement.credit,
        max_points=available,
        slip=judgement.slip,
        message=judgement.message,
        remarks=(*judgement.remarks, *_reading_remarks(case, quantity, answer)),
        half_unit=answer.half_unit if answer is not None else 0.0,
    )


def _judgement(case: _Case, quantity: Quantity, answer: Answer | None) -> Judgement:
    if quantity.kind is Kind.MANUAL:
        return _without_value(Outcome.MANUAL, message("Marked by hand."))
    if answer is None or answer.reading is Reading.BLANK:
        return _without_value(Outcome.BLANK, message("No answer."))
    if answer.reading is Reading.UNREADABLE or answer.value is None:
        return _without_value(Outcome.UNREADABLE, message("The answer could not be read."))
    view = View(
        plan=case.plan,
        policy=case.policy,
        quantity=quantity,
        answer=answer,
        value=answer.value,
        reference_values=case.reference,
        own=case.own,
    )
    if not view.has_reference:
        return _without_value(
            Outcome.NOT_JUDGED,
            message("There is no reference value for this variant; a person decides."),
        )
    if quantity.kind is Kind.CHOICE:
        return judge_choice_answer(view)
    return judge_value(view)


def _without_value(outcome: Outcome, said: Message) -> Judgement:
    return Judgement(outcome, Against.NOTHING, None, 0.0, 0.0, "", said, ())


def _reading_remarks(case: _Case, quantity: Quantity, answer: Answer | None) -> tuple[Message, ...]:
    if answer is None:
        return ()
    if quantity.id in case.own.not_carried and answer.unit_fits:
        not_carried = message(
            "Later answers were not followed from this value: it is outside what is possible."
        )
        return (*answer.remarks, not_carried)
    return answer.remarks


def _declared(case: _Case, quantity: Quantity, value: float | None) -> float | None:
    if value is None or math.isnan(value):
        return None
    return from_si(case.plan, {quantity.id: value})[quantity.id]
