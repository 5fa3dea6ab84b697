"""Every declared slip and erratum can be met: its value differs, and the grader names it.

A wrong method that gives the right number is useless: nobody would be told.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from datetime import date

from gripcourse.course.model import Course, Kind, Quantity
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import Array, evaluate
from gripcourse.formula.tree import Formula
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Finding
from gripcourse.policy.bands import band, within
from gripcourse.policy.model import Policy
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, concluded
from gripcourse.proofs.samples import Trial
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.model import Candidate
from gripcourse.solver.solve import choose, reference_rounding
from gripcourse.submission.model import Answer, Identity, Reading, Submission
from gripcourse.text.units import factor
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued, Student

_DAY = date(2026, 1, 1)
_TRIED = 3  # variants in which the grader may name a wrong method, before it counts as not named


@dataclass(frozen=True, slots=True)
class WrongValue:
    """What a wrong method gives in one variant.

    Attributes:
        quantity: the declaration.
        name: id of the slip, or number of the erratum.
        key: where the method is declared, below the quantity.
        is_slip: whether it is a slip, which the grader must name, or an erratum.
        place: of the variant in its trial.
        value, right: in the declared unit.
    """

    quantity: Quantity
    name: str
    key: str
    is_slip: bool
    place: int
    value: float
    right: float

    @property
    def method(self) -> tuple[str, str, str]:
        """What tells the method from every other."""
        return (self.quantity.file, self.quantity.id, self.name)


def wrong_values(trial: Trial) -> Iterator[WrongValue]:
    """Compute every declared wrong method at the right numbers of every variant."""
    count = len(trial.variants)
    for one in trial.plan.answered:
        size = factor(one.unit)
        right = trial.values[one.id] / size
        for name, key, is_slip, result in _methods(trial, one):
            values = result / size
            for place in range(count):
                value = float(values[place]) if values.ndim else float(values)
                yield WrongValue(one, name, key, is_slip, place, value, float(right[place]))


def is_seen(wrong: WrongValue, policy: Policy) -> bool:
    """Tell whether a wrong value lies outside the band round the right one."""
    return not within(wrong.value, wrong.right, band(wrong.quantity, wrong.right, policy))


def prove_wrong_methods(
    course: Course, policy: Policy, name: str, file: str, trials: Sequence[Trial]
) -> ProofResult:
    """Look for a variant that shows each declared wrong method, and let the grader name the slips.

    Args:
        course: whose methods they are.
        policy: bands, credits and the generic slips that compete with the declared ones.
        name, file: of the scheme.
        trials: numbers to try.
    """
    proof = Proof(ProofKind.WRONG_METHODS, name, file, "")
    if not trials:
        said = message("There is neither a worked example nor a range to draw variants from.")
        return ProofResult(proof, Verdict.OPEN, 0, (), said)
    met: dict[tuple[str, str, str], WrongValue] = {}
    seen: set[tuple[str, str, str]] = set()
    named: set[tuple[str, str, str]] = set()
    instead: dict[tuple[str, str, str], Finding] = {}
    for trial in trials:
        judged = _judge_of(course, policy, trial)
        tried: dict[tuple[str, str, str], int] = {}
        for wrong in wrong_values(trial):
            met[wrong.method] = wrong
            if wrong.method in named or not is_seen(wrong, policy):
                continue
            seen.add(wrong.method)
            if not wrong.is_slip or wrong.quantity.kind is Kind.CHOICE:
                named.add(wrong.method)  # an erratum may be accepted; a series has few entries
                continue
            tried[wrong.method] = tried.get(wrong.method, 0) + 1
            if tried[wrong.method] > _TRIED or not math.isfinite(wrong.value):
                continue
            finding = judged(wrong)
            instead[wrong.method] = finding
            if wrong.name in {finding.slip, *finding.tied} or _is_printed(wrong, finding):
                named.add(wrong.method)
    problems = tuple(
        _problem(wrong, instead.get(method))
        for method, wrong in met.items()
        if method not in named and not (wrong.quantity.kind is Kind.CHOICE and method not in seen)
    )
    return concluded(proof, len(met), problems)


def _methods(trial: Trial, one: Quantity) -> Iterator[tuple[str, str, bool, Array]]:
    """Yield each declared wrong method with its result in SI."""
    plan = trial.plan

    def result(formula: Formula) -> Array:
        found = evaluate(formula, one.unit, trial.values, plan.columns)
        if one.choice is not None:
            return choose(found, one.choice, reference_rounding(one, plan.convention), plan)
        return found

    for slip in one.slips:
        yield slip.id, f"slip.{slip.id}", True, result(slip.formula)
    for printed in one.as_printed:
        key = f"as_printed.{printed.erratum}"
        if printed.formula is not None:
            yield printed.erratum, key, False, result(printed.formula)
        elif printed.rounding is not None and one.choice is not None and one.formula is not None:
            required = evaluate(one.formula, one.unit, trial.values, plan.columns)
            taken = choose(required, one.choice, printed.rounding, plan)
            yield printed.erratum, key, False, taken


def _is_printed(wrong: WrongValue, finding: Finding) -> bool:
    """Tell whether the answer is accepted as a source prints it: the slip is that erratum."""
    return finding.slip in {one.erratum for one in wrong.quantity.as_printed}


def _judge_of(course: Course, policy: Policy, trial: Trial) -> Callable[[WrongValue], Finding]:
    """Make a judge of single answers; the wrong methods of each quantity are made once."""
    plan = trial.plan
    made: dict[str, tuple[Candidate, ...]] = {}

    def methods(name: str) -> tuple[Candidate, ...]:
        if name not in made:
            made[name] = candidates_of(plan, name, policy.slips)
        return made[name]

    def judged(wrong: WrongValue) -> Finding:
        variant = trial.variants[wrong.place]
        student = Student("s1", "", "", "", course.language, "")
        issued = Issued(student, variant, _DAY, None, "")
        answer = Answer(
            quantity=wrong.quantity.id,
            reading=Reading.READ,
            value=wrong.value,
            typed=repr(wrong.value),
            cell="",
            half_unit=0.0,
            unit="",
            unit_fits=True,
            remarks=(),
        )
        submission = Submission(
            file="",
            digest="",
            identity=Identity(student.id, variant.id, variant.scheme, plan.options, ""),
            creator="",
            givens=dict(variant.given),
            answers={answer.quantity: answer},
            remarks=(),
        )
        report = judge(submission, issued, plan, policy, methods)
        return next(one for one in report.findings if one.quantity == answer.quantity)

    return judged


def _problem(wrong: WrongValue, finding: Finding | None) -> Problem:
    one = wrong.quantity
    return Problem(
        one.file,
        f"quantity.{one.id}.{wrong.key}",
        _what(wrong, finding),
        message("Mend it, remove it, or widen the ranges that variants are drawn from."),
    )


def _what(wrong: WrongValue, finding: Finding | None) -> Message:
    if finding is None:
        return message(
            "'{name}' gives the right value in every variant that was tried.", name=wrong.name
        )
    if finding.slip:
        return message(
            "The grader takes an answer with '{name}' for '{slip}'.",
            name=wrong.name,
            slip=finding.slip,
        )
    return message(
        "The grader does not name '{name}': {said}", name=wrong.name, said=finding.message
    )
