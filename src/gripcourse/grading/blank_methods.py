"""Wrong methods in a step that was left blank: what they lead to, and how common each is."""

import math
from dataclasses import dataclass

from gripcourse.course.quantity import Kind
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.grading.submission_case import GradingCase
from gripcourse.slips.model import Candidate


@dataclass(frozen=True, slots=True)
class BlankMethod:
    """A wrong method of a blank step, what it gives there, SI, and its share of the mistakes."""

    candidate: Candidate
    value: float
    share: float


def methods_in_blank(case: GradingCase, name: str) -> list[BlankMethod]:
    """Return what may have been done wrongly in a step; none where the student has a number of it.

    Args:
        case: the submission.
        name: id of the step.
    """
    quantity, own = case.plan.quantities[name], case.follow_through
    if name in own.known or quantity.kind not in {Kind.FORMULA, Kind.PICK}:
        return []
    candidates = case.candidates_of(name)
    total = case.policy.slips.unexplained + sum(one.prior for one in candidates)
    found = [BlankMethod(one, _value(case, name, one), one.prior / total) for one in candidates]
    return [one for one in found if math.isfinite(one.value)]


def _value(case: GradingCase, name: str, candidate: Candidate) -> float:
    unit, values = case.plan.quantities[name].unit, case.follow_through.numbers.values
    return evaluate_number(candidate.formula, unit, values, case.plan.columns)
