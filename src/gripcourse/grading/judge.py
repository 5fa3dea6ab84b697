"""Judging one submission: pure, from answers and issued values to a report.

Each answer is compared with the reference first, then with its formula at the student's own earlier
numbers; the better counts. So one mistake costs once, and rounding on the way costs nothing.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from gripcourse.course.quantity import Quantity
from gripcourse.grading.as_calculated import as_calculated
from gripcourse.grading.causes import causes_of, roots_of, spoiled_first, spoiled_later
from gripcourse.grading.charged_once import shortened_once
from gripcourse.grading.diagnose import CandidatesOf, said_of_blank
from gripcourse.grading.entry_meant import with_entries_meant
from gripcourse.grading.exchanged import exchanged_once
from gripcourse.grading.extended import extended
from gripcourse.grading.flags import flags_of
from gripcourse.grading.intended import as_intended
from gripcourse.grading.made_elsewhere import told_by_others
from gripcourse.grading.model import Cause, Finding, Outcome, Report, sums_of
from gripcourse.grading.same_factor import same_factor_once
from gripcourse.grading.same_number import same_number_once
from gripcourse.grading.same_slip import same_slip_once
from gripcourse.grading.shown_manner import in_own_manner
from gripcourse.grading.significant_digits import figures_remark
from gripcourse.grading.submission_case import (
    GradingCase,
    JudgedAnswer,
    cost_already,
    explain,
    judge_answer,
    make_case,
)
from gripcourse.grading.substitution import Substitution, by_answer, substitutions
from gripcourse.grading.support import is_calculated, withhold_unsupported
from gripcourse.policy.model import Policy
from gripcourse.slips.candidates import candidates_of as make_candidates
from gripcourse.slips.model import SlipId
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import from_si
from gripcourse.submission.model import Answer, Reading, Submission
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued


def judge(
    submission: Submission,
    issued: Issued,
    plan: Plan,
    policy: Policy,
    candidates_of: CandidatesOf | None = None,
) -> Report:
    """Judge a submission against the values that were issued to its student.

    Each step looks at all answers and changes the conclusion about some of them:

    1. compared: with the reference, and with the formula at the student's own earlier numbers.
    2. explained: a wrong answer that a known wrong method gives becomes a slip; how the student
       writes numbers, as the right answers show, tells methods apart.
    3. intended: what follows from a number that was only written down wrongly is no mistake; a
       constant that was shortened too far, or two numbers in each other's cells, cost once.
    4. settled: what one number used wrongly explains costs once, where it is used first; a number
       that is asked for in several cells costs once too, and so does one wrong method in formulas
       that are alike, or one factor; of several with one number, the one made elsewhere is named.
    5. supported: in a work that hardly calculates, what follows needs what it follows from.
    6. findings: conclusions with points, remarks, and the wrong answers at their root.

    Args:
        submission: what was read.
        issued: the register's entry of the student who handed it in.
        plan: of the issued variant.
        policy: points, bands and credits.
        candidates_of: the wrong methods of each quantity of the plan; None makes them anew.
    """
    methods = candidates_of or (lambda name: make_candidates(plan, name, policy.slips))
    submission = with_entries_meant(submission, plan)
    case = make_case(submission, issued, plan, policy, methods)
    compared = [judge_answer(case, one, submission.answers.get(one.id)) for one in _in_order(plan)]
    case, compared = in_own_manner(case, compared)
    explained = as_calculated(case, explain(case, compared))
    intended = exchanged_once(case, shortened_once(case, as_intended(case, explained)))
    found = substitutions(case, intended)
    substituted = extended(case, intended, found)
    settled = [_substituted(case, one, by_answer(substituted)) for one in intended]
    settled = told_by_others(case, settled)
    if is_calculated(case, settled):
        settled = same_slip_once(case, same_number_once(case, settled))
        settled = same_factor_once(case, settled)
    supported = withhold_unsupported(case, settled)
    findings = _findings(case, supported)
    return _report(submission, issued, case, findings, causes_of(plan, findings, substituted))


def _report(
    submission: Submission,
    issued: Issued,
    case: GradingCase,
    findings: tuple[Finding, ...],
    causes: tuple[Cause, ...],
) -> Report:
    plan, sums = case.plan, sums_of(findings)
    return Report(
        file=submission.file,
        student=issued.student.id,
        name=issued.student.name,
        variant=issued.variant.id,
        scheme=plan.scheme.id,
        options=plan.options,
        language=issued.student.language or plan.course.language,
        score=sums.score,
        max_score=sums.max_score,
        open_points=sums.open_points,
        flags=flags_of(submission, issued, findings),
        findings=findings,
        remarks=submission.remarks,
        judged=True,
        digest=submission.digest,
        causes=causes,
        givens=submission.givens,
        creator=submission.creator,
        version=issued.version,
        made_for=issued.version,
    )


def _in_order(plan: Plan) -> list[Quantity]:
    """Order as the assignment does: by section, manual items last in theirs."""
    sections = {section.id: rank for rank, section in enumerate(plan.course.sections)}
    return sorted(plan.asked, key=lambda one: sections[one.section])


def _substituted(
    case: GradingCase, judged: JudgedAnswer, found: Mapping[str, Substitution]
) -> JudgedAnswer:
    """A number that was used wrongly costs the first answer that it spoils, and no other."""
    one = found.get(judged.quantity.id)
    if one is None:
        return judged
    first = one.explains[0]
    if one.is_slip:
        return _through_blank(case, judged, one)
    if judged.quantity.id == first:
        judgement = replace(
            judged.judgement,
            outcome=Outcome.SLIP if one.named else Outcome.WRONG,
            slip=SlipId.used(one.quantity) if one.named else None,
            tied=(SlipId.used(one.tied),) if one.tied else (),
            message=spoiled_first(case.plan, one),
        )
        return replace(judged, judgement=judgement)
    return cost_already(case, judged, first, spoiled_later(case.plan, one))


def _through_blank(case: GradingCase, judged: JudgedAnswer, found: Substitution) -> JudgedAnswer:
    """A slip in a step that was left blank has cost that step, and costs nothing more."""
    step = case.plan.quantities[found.quantity]
    said = message(
        "Follows from a slip in a step that you left blank, {title}.", title=step.short_title
    )
    if found.methods:
        said = said_of_blank([(step, method) for method in found.methods])
    free = cost_already(case, judged, step.id, said)
    named = tuple(one.id for one in found.methods)
    judgement = replace(free.judgement, slip=named[0] if named else None, tied=named[1:])
    return replace(free, judgement=judgement)


def _findings(case: GradingCase, settled: Sequence[JudgedAnswer]) -> tuple[Finding, ...]:
    outcomes = {one.quantity.id: (one.judgement.outcome, one.judgement.against) for one in settled}
    numbers = case.follow_through.numbers.values
    roots = roots_of(case.plan, outcomes, numbers, case.reference)
    own = from_si(case.plan, numbers)
    return tuple(_finding(case, one, own, roots.get(one.quantity.id, set())) for one in settled)


def _finding(
    case: GradingCase, judged: JudgedAnswer, own: Mapping[str, float], roots: set[str]
) -> Finding:
    quantity, judgement = judged.quantity, judged.judgement
    answer = judged.answer or _blank(quantity)
    reference = _declared(case, quantity, case.reference.get(quantity.id))
    share, said = _figures(case, judged, reference)
    low, high = _range(judged)
    available = case.points[quantity.id]
    return Finding(
        quantity=quantity.id,
        section=quantity.section,
        outcome=judgement.outcome,
        against=judgement.against,
        given=answer.value,
        typed=answer.typed,
        cell=answer.cell,
        reference=reference,
        expected=judgement.expected,
        band=judgement.band,
        inputs=_inputs(case, judged, own),
        points=available * judgement.credit * share,
        max_points=available,
        slip=judgement.slip,
        message=judgement.message,
        remarks=(*judgement.remarks, *_reading_remarks(case, quantity, answer), *said),
        tied=judgement.tied,
        roots=judgement.roots or _sorted(case, roots),
        half_unit=answer.half_unit,
        low=low,
        high=high,
    )


def _blank(quantity: Quantity) -> Answer:
    """Stand in for the cell of an answer that the workbook does not have."""
    return Answer(quantity.id, Reading.BLANK, None, "", "", 0.0, "", unit_fits=True, remarks=())


def _figures(
    case: GradingCase, judged: JudgedAnswer, reference: float | None
) -> tuple[float, tuple[Message, ...]]:
    """Return the share of the points that the significant figures leave, and what is said."""
    if judged.answer is None:
        return 1.0, ()
    judgement = judged.judgement
    met = reference if judgement.outcome.traits.equals_reference else judgement.expected
    found = figures_remark(judged.quantity, judged.answer, case.policy, met)
    return (1.0, ()) if found is None else (found[0], (found[1],))


def _range(judged: JudgedAnswer) -> tuple[float | None, float | None]:
    """Return the range that the rounding of earlier answers leaves, in the declared unit."""
    if judged.comparison is None:
        return None, None
    low, high = judged.comparison.follows.low, judged.comparison.follows.high
    return None if math.isnan(low) else low, None if math.isnan(high) else high


def _inputs(case: GradingCase, judged: JudgedAnswer, own: Mapping[str, float]) -> dict[str, float]:
    """Return what the worked line substitutes, in declared units.

    Args:
        case: the submission.
        judged: the answer.
        own: every quantity at the numbers that the case follows, in declared units.
    """
    names = case.plan.inputs[judged.quantity.id]
    comparison = judged.comparison
    if comparison is None or comparison.follow_through is case.follow_through:
        return {name: own[name] for name in names}
    numbers = comparison.follow_through.numbers
    return from_si(case.plan, {name: numbers.values[name] for name in names})


def _sorted(case: GradingCase, names: set[str]) -> tuple[str, ...]:
    return tuple(name for name in case.plan.quantities if name in names) if names else ()


def _reading_remarks(case: GradingCase, quantity: Quantity, answer: Answer) -> tuple[Message, ...]:
    if quantity.id in case.follow_through.not_carried and answer.unit_fits:
        not_carried = message(
            "This value is outside what is possible. Later answers that follow from it count."
        )
        return (*answer.remarks, not_carried)
    return answer.remarks


def _declared(case: GradingCase, quantity: Quantity, value: float | None) -> float | None:
    if value is None or math.isnan(value):
        return None
    return from_si(case.plan, {quantity.id: value})[quantity.id]
