"""Every declared slip, erratum and alternative can be met: its value differs, the grader says so.

A wrong method that gives the right number is useless: nobody would be told. Another reading that
always gives it is none.
"""

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from datetime import date
from enum import StrEnum
from typing import TypeAlias

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import Array, evaluate
from gripcourse.formula.tree import Formula
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Against, Finding
from gripcourse.policy.bands import band, within
from gripcourse.policy.model import Policy
from gripcourse.proofs.model import Proof, ProofKind, ProofResult, Verdict, concluded, short_name
from gripcourse.proofs.samples import SampleSource, Trial, redrawn
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.model import Candidate, SlipId
from gripcourse.solver.sizes import choose, entry
from gripcourse.submission.model import Answer, Identity, Reading, Submission
from gripcourse.text.units import factor
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued, Student

Method: TypeAlias = tuple[str, str, str]
"""File, quantity and id of a slip, an erratum or an alternative."""


class MethodSort(StrEnum):
    """What declares a method."""

    SLIP = "slip"  # the grader must name it
    ERRATUM = "erratum"  # a course may accept it: it needs no name
    ALTERNATIVE = "alternative"  # the grader must accept it with a remark


_DAY = date(2026, 1, 1)
_TRIED = 3  # variants in which the grader may name a wrong method, before it counts as not named
_MANY = 512  # variants among which one is looked for that shows what seldom shows


@dataclass(frozen=True, slots=True)
class WrongValue:
    """What a wrong method gives in one variant.

    Attributes:
        quantity: the declaration.
        name: id of the slip or alternative, or number of the erratum.
        key: where the method is declared, below the quantity.
        sort: what declares it.
        place: of the variant in its trial.
        value, right: in the declared unit.
    """

    quantity: Quantity
    name: str
    key: str
    sort: MethodSort
    place: int
    value: float
    right: float

    @property
    def method(self) -> Method:
        """What tells the method from every other."""
        return (self.quantity.file, self.quantity.id, self.name)


def wrong_values(
    trial: Trial, without: Collection[Method] = (), only: Method | None = None
) -> Iterator[WrongValue]:
    """Compute declared wrong methods at the right numbers of every variant.

    Args:
        trial: the variants.
        without: methods that are left out.
        only: the one that is asked for; None for all.
    """
    count = len(trial.variants)
    for one in trial.plan.answered:
        size = factor(one.unit)
        right = trial.values[one.id] / size
        for name, key, sort, result in _methods(trial, one):
            method = (one.file, one.id, name)
            if method in without or only not in {None, method}:
                continue
            values = result / size
            for place in range(count):
                value = float(values[place]) if values.ndim else float(values)
                yield WrongValue(one, name, key, sort, place, value, float(right[place]))


def is_seen(wrong: WrongValue, policy: Policy) -> bool:
    """Tell whether a wrong value lies outside the band round the right one."""
    return not within(wrong.value, wrong.right, band(wrong.quantity, wrong.right, policy))


@dataclass(frozen=True, slots=True)
class _Survey:
    """What was found out about wrong methods so far.

    Attributes:
        met: every method that some composition has, with a value of it.
        done: those that showed and were named, or need no name.
        instead: what the grader said of the others that showed.
    """

    met: dict[Method, WrongValue]
    done: set[Method]
    instead: dict[Method, Finding]


def prove_wrong_methods(
    source: SampleSource, policy: Policy, trials: Sequence[Trial]
) -> Iterator[ProofResult]:
    """Look for a variant that shows each declared wrong method, and let the grader name the slips.

    A method of a shared part is looked for until one composition shows it. What none shows is
    looked for among many more variants.

    Args:
        source: of further variants.
        policy: bands, credits and the generic slips that compete with the declared ones.
        trials: numbers to try.

    Returns:
        A result for each file that declares wrong methods.
    """
    survey = _Survey({}, set(), {})
    for trial in trials:
        _look(source.course, policy, trial, survey)
    for method in [one for one in survey.met if one not in survey.done]:
        for trial in (one for one in trials if _declares(one, method)):
            more = redrawn(source, trial, _MANY)
            if more is not None:
                _look(source.course, policy, more, survey, method)
            if method in survey.done:
                break
    by_file: dict[str, list[Method]] = {}
    for method in survey.met:
        by_file.setdefault(method[0], []).append(method)
    for file, methods in by_file.items():
        proof = Proof(ProofKind.WRONG_METHODS, short_name(file), file, "")
        problems = [
            _problem(survey.met[one], survey.instead.get(one))
            for one in methods
            if one not in survey.done
        ]
        left = [survey.met[one] for one in methods if one not in survey.done]
        # No variant is refused for an erratum: one that never shows is a question, no fault.
        forgiven = all(one.sort is MethodSort.ERRATUM for one in left)
        verdict = Verdict.OPEN if forgiven else Verdict.FAILS
        if left:
            yield ProofResult(proof, verdict, len(methods), tuple(problems))
        else:
            yield concluded(proof, len(methods), ())


def _declares(trial: Trial, method: Method) -> bool:
    """Tell whether a composition has the very quantity of a method."""
    file, name, _ = method
    return name in trial.plan.quantities and trial.plan.quantities[name].file == file


def _look(
    course: Course, policy: Policy, trial: Trial, survey: _Survey, only: Method | None = None
) -> None:
    """Look for wrong methods in the variants of one composition."""
    judged = _judge_of(course, policy, trial)
    tried: dict[Method, int] = {}
    for wrong in wrong_values(trial, survey.done, only):
        survey.met[wrong.method] = wrong
        if wrong.method in survey.done:
            continue
        # Of a decision only the rule is wrong: it seldom leads to another entry of the series.
        if wrong.quantity.kind is Kind.CHOICE:
            survey.done.add(wrong.method)
            continue
        if not is_seen(wrong, policy) or not math.isfinite(wrong.value):
            continue
        if wrong.sort is MethodSort.ERRATUM:
            survey.done.add(wrong.method)
            continue
        tried[wrong.method] = tried.get(wrong.method, 0) + 1
        if tried[wrong.method] <= _TRIED:
            finding = judged(wrong)
            survey.instead[wrong.method] = finding
            if _is_met(wrong, finding):
                survey.done.add(wrong.method)


def _is_met(wrong: WrongValue, finding: Finding) -> bool:
    """Tell whether the grader took an answer for what it is."""
    if wrong.sort is MethodSort.ALTERNATIVE:
        return finding.against is Against.ALTERNATIVE
    named = {finding.slip, *finding.tied}
    return SlipId.declared(wrong.name) in named or _is_printed(wrong, finding)


def _methods(trial: Trial, one: Quantity) -> Iterator[tuple[str, str, MethodSort, Array]]:
    """Yield each declared wrong method with its result in SI."""
    plan = trial.plan

    def result(formula: Formula) -> Array:
        found = evaluate(formula, one.unit, trial.values, plan.columns)
        return choose(plan, one, found, trial.values)

    for slip in one.slips:
        yield slip.id, f"slip.{slip.id}", MethodSort.SLIP, result(slip.formula)
    for other in one.alternatives:
        key = f"alternative.{other.id}"
        yield other.id, key, MethodSort.ALTERNATIVE, result(other.formula)
    for printed in one.as_printed:
        key = f"as_printed.{printed.erratum}"
        if printed.formula is not None:
            yield printed.erratum, key, MethodSort.ERRATUM, result(printed.formula)
        elif printed.rounding is not None and one.choice is not None and one.formula is not None:
            required = evaluate(one.formula, one.unit, trial.values, plan.columns)
            taken = entry(plan, one.choice, printed.rounding, required)
            yield printed.erratum, key, MethodSort.ERRATUM, taken


def _is_printed(wrong: WrongValue, finding: Finding) -> bool:
    """Tell whether the answer is accepted as a source prints it: the slip is that erratum."""
    return finding.slip in {SlipId.declared(one.erratum) for one in wrong.quantity.as_printed}


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
        message("Correct it, remove it, or widen the ranges that variants are drawn from."),
    )


def _what(wrong: WrongValue, finding: Finding | None) -> Message:
    if finding is None:
        return message(
            "'{name}' gives the right value in every variant that was tried.", name=wrong.name
        )
    if wrong.sort is MethodSort.ALTERNATIVE:
        return message(
            "The grader does not accept '{name}': {said}", name=wrong.name, said=finding.message
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
