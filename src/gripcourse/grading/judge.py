"""Judging one submission: pure, from answers and issued values to a report.

Each answer is compared with the reference first, then with its formula at the student's own earlier
numbers; the better counts. So one mistake costs once, and rounding on the way costs nothing.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from gripcourse.course.model import Kind, Quantity
from gripcourse.course.policy import Policy
from gripcourse.grading.causes import causes_of, roots_of, spoiled_first, spoiled_later
from gripcourse.grading.diagnose import CandidatesOf, diagnose
from gripcourse.grading.figures import figures_remark
from gripcourse.grading.flags import flags_of
from gripcourse.grading.judge_choice import judge_choice_answer
from gripcourse.grading.judge_value import judge_value
from gripcourse.grading.model import OPEN, Against, Finding, Outcome, Report
from gripcourse.grading.own import Own, follow
from gripcourse.grading.substitution import Substitution, by_answer, substitutions
from gripcourse.grading.view import Judgement, View
from gripcourse.marking.points import points_of
from gripcourse.slips.candidates import candidates_of as make_candidates
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
    candidates_of: CandidatesOf
    is_own: bool


@dataclass(frozen=True, slots=True)
class _Judged:
    """One quantity with what was concluded; `view` is None where there is no value to look at."""

    quantity: Quantity
    answer: Answer | None
    view: View | None
    judgement: Judgement


def judge(
    submission: Submission,
    issued: Issued,
    plan: Plan,
    policy: Policy,
    candidates_of: CandidatesOf | None = None,
) -> Report:
    """Judge a submission against the values that were issued to its student.

    Args:
        submission: what was read.
        issued: the register's entry of the student who handed it in.
        plan: of the issued variant.
        policy: points, bands and credits.
        candidates_of: the wrong methods of each quantity of the plan; None makes them anew.
    """
    methods = candidates_of or (lambda name: make_candidates(plan, name, policy.slips))
    case = _case(submission, issued, plan, policy, methods)
    first = [_judged(case, one, submission.answers.get(one.id)) for one in _in_order(plan)]
    views = {one.quantity.id: one.view for one in first if one.view is not None}
    judged = [_explained(case, one, views) for one in first]
    substituted = substitutions(_still_wrong(case, judged))
    judged = [_substituted(case, one, by_answer(substituted)) for one in judged]
    outcomes = {one.quantity.id: (one.judgement.outcome, one.judgement.against) for one in judged}
    roots = roots_of(plan, outcomes)
    findings = tuple(_finding(case, one, roots) for one in judged)
    closed = [finding for finding in findings if finding.outcome not in OPEN]
    return Report(
        file=submission.file,
        student=issued.student.id,
        name=issued.student.name,
        variant=issued.variant.id,
        scheme=plan.scheme.id,
        options=plan.options,
        language=issued.student.language or plan.course.language,
        score=sum(finding.points for finding in closed),
        max_score=sum(finding.max_points for finding in closed),
        open_points=sum(f.max_points for f in findings if f.outcome in OPEN),
        flags=flags_of(submission, issued, findings),
        findings=findings,
        remarks=submission.remarks,
        judged=True,
        digest=submission.digest,
        causes=causes_of(plan, findings, substituted),
        givens=submission.givens,
        creator=submission.creator,
    )


def _case(
    submission: Submission,
    issued: Issued,
    plan: Plan,
    policy: Policy,
    candidates_of: CandidatesOf,
) -> _Case:
    given = issued.variant.given
    reference = {
        name: float(value) for name, value in evaluate(plan, to_si(plan, given)).values.items()
    }
    # Another student's workbook holds nobody's own numbers here: nothing is followed from them.
    is_own = submission.identity.student in {"", issued.student.id}
    own = follow(plan, given, submission.answers if is_own else {}, reference, policy)
    return _Case(
        plan=plan,
        policy=policy,
        given=given,
        reference=reference,
        own=own,
        own_values=from_si(plan, own.evaluation.values),
        points=points_of(plan, policy),
        candidates_of=candidates_of,
        is_own=is_own,
    )


def _in_order(plan: Plan) -> list[Quantity]:
    """Order as the assignment does: by section, manual items last in theirs."""
    sections = {section.id: rank for rank, section in enumerate(plan.course.sections)}
    return sorted((*plan.answered, *plan.manual), key=lambda one: sections[one.section])


def _judged(case: _Case, quantity: Quantity, answer: Answer | None) -> _Judged:
    if quantity.kind is Kind.MANUAL:
        judgement = _without_value(Outcome.MANUAL, message("Marked by hand."))
    elif answer is None or answer.reading is Reading.BLANK:
        judgement = _without_value(Outcome.BLANK, message("No answer."))
    elif answer.reading is Reading.UNREADABLE or answer.value is None:
        judgement = _without_value(Outcome.UNREADABLE, message("The answer could not be read."))
    else:
        return _viewed(case, quantity, answer, answer.value)
    return _Judged(quantity, answer, None, judgement)


def _viewed(case: _Case, quantity: Quantity, answer: Answer, value: float) -> _Judged:
    view = View(
        plan=case.plan,
        policy=case.policy,
        quantity=quantity,
        answer=answer,
        value=value,
        reference_values=case.reference,
        own=case.own,
    )
    if not view.has_reference:
        said = message("There is no reference value for this variant; a person decides.")
        return _Judged(quantity, answer, view, _without_value(Outcome.NOT_JUDGED, said))
    judgement = judge_choice_answer(view) if quantity.kind is Kind.CHOICE else judge_value(view)
    return _Judged(quantity, answer, view, judgement)


def _explained(case: _Case, judged: _Judged, views: Mapping[str, View]) -> _Judged:
    """Name the slip behind a wrong answer; a unit that does not fit explains itself."""
    wrong = judged.judgement.outcome is Outcome.WRONG and case.is_own
    if judged.view is None or not wrong or not judged.view.answer.unit_fits:
        return judged
    name = judged.quantity.id
    later = [
        view
        for other, view in views.items()
        if name in case.plan.inputs[other] and view.quantity.kind is Kind.FORMULA
    ]
    judgement = diagnose(judged.view, judged.judgement, case.candidates_of, later)
    return replace(judged, judgement=judgement)


def _still_wrong(case: _Case, judged: Sequence[_Judged]) -> list[View]:
    """Return the answers that nothing explains yet, in order of calculation."""
    if not case.is_own:
        return []
    views = {
        one.quantity.id: one.view
        for one in judged
        if one.view is not None
        and one.judgement.outcome is Outcome.WRONG
        and one.view.answer.unit_fits
    }
    return [views[name] for name in case.plan.quantities if name in views]


def _substituted(case: _Case, judged: _Judged, found: Mapping[str, Substitution]) -> _Judged:
    """A number that was used wrongly costs the first answer that it spoils, and no other."""
    one = found.get(judged.quantity.id)
    if one is None:
        return judged
    first = one.explains[0]
    if judged.quantity.id == first:
        judgement = replace(
            judged.judgement,
            outcome=Outcome.SLIP,
            slip=f"used:{one.quantity}",
            tied=(f"used:{one.tied}",) if one.tied else (),
            message=spoiled_first(case.plan, one),
        )
        return replace(judged, judgement=judgement)
    judgement = replace(
        judged.judgement,
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        credit=case.policy.carried_credit,
        roots=(first,),
        message=spoiled_later(case.plan, one),
    )
    return replace(judged, judgement=judgement)


def _finding(case: _Case, judged: _Judged, roots: Mapping[str, set[str]]) -> Finding:
    quantity, answer, judgement = judged.quantity, judged.answer, judged.judgement
    available = case.points[quantity.id]
    follows = None if judged.view is None else judged.view.follows
    reference = _declared(case, quantity, case.reference.get(quantity.id))
    met = reference if judgement.outcome is Outcome.CORRECT else judgement.expected
    figures = figures_remark(quantity, answer, case.policy, met) if answer is not None else None
    share, said = figures if figures is not None else (1.0, None)
    return Finding(
        quantity=quantity.id,
        section=quantity.section,
        outcome=judgement.outcome,
        against=judgement.against,
        given=answer.value if answer is not None else None,
        typed=answer.typed if answer is not None else "",
        cell=answer.cell if answer is not None else "",
        reference=reference,
        expected=judgement.expected,
        band=judgement.band,
        inputs={name: case.own_values[name] for name in case.plan.inputs[quantity.id]},
        points=available * judgement.credit * share,
        max_points=available,
        slip=judgement.slip,
        message=judgement.message,
        remarks=(
            *judgement.remarks,
            *_reading_remarks(case, quantity, answer),
            *(() if said is None else (said,)),
        ),
        tied=judgement.tied,
        roots=judgement.roots or _sorted(case, roots.get(quantity.id, set())),
        half_unit=answer.half_unit if answer is not None else 0.0,
        low=None if follows is None or math.isnan(follows.low) else follows.low,
        high=None if follows is None or math.isnan(follows.high) else follows.high,
    )


def _sorted(case: _Case, names: set[str]) -> tuple[str, ...]:
    return tuple(name for name in case.plan.quantities if name in names)


def _without_value(outcome: Outcome, said: Message) -> Judgement:
    return Judgement(outcome, Against.NOTHING, None, 0.0, 0.0, "", (), (), said, ())


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
