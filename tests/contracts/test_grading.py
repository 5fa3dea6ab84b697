"""What answers earn in every scheme: all right everything, one wrong all but its own item."""

from collections.abc import Callable
from dataclasses import replace
from datetime import date
from functools import cache
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Report
from gripcourse.policy.bands import band
from gripcourse.policy.model import Policy
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.model import Candidate
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer, Identity, Reading, Submission
from gripcourse.text.units import factor
from gripcourse.variants.model import Issued, Student, Variant
from support.each import each, named_if_it_fails

if TYPE_CHECKING:
    from conftest import Composition

MOVED = 1.1  # bands


def methods_of(plan: Plan, policy: Policy) -> Callable[[str], tuple[Candidate, ...]]:
    """Make the wrong methods of each quantity once for all answers of a composition."""
    return cache(lambda name: candidates_of(plan, name, policy.slips))


def judged(
    composition: "Composition",
    answers: dict[str, float],
    policy: Policy,
    methods: Callable[[str], tuple[Candidate, ...]] | None = None,
) -> Report:
    """Judge answers to the composition's first set of numbers."""
    plan, given = composition.plan, composition.example.given
    variant = Variant("001", plan.scheme.id, plan.options, given)
    student = Student("s01", "Иванова Ольга", "РТК-41", "", "ru", "")
    issued = Issued(student, variant, date(2026, 9, 7), None, "a1" * 32)
    identity = Identity(student.id, variant.id, variant.scheme, plan.options, issued.signature)
    read = {
        name: Answer(name, Reading.READ, value, str(value), "", 0.0, "", unit_fits=True, remarks=())
        for name, value in answers.items()
    }
    submission = Submission("s01.xlsx", "0" * 64, identity, "", dict(given), read, ())
    return judge(submission, issued, plan, policy, methods)


def reference_answers(composition: "Composition") -> dict[str, float]:
    values = solve_variant(composition.plan, composition.example.given)
    return {one.id: values[one.id] for one in composition.plan.answered}


def moved(one: Quantity, value: float, policy: Policy) -> float:
    """Return an answer just outside the band; a verdict turned round."""
    if one.kind is Kind.VERDICT:
        return 1 - value
    return value + MOVED * band(one, value, policy)


def moved_alone(
    composition: "Composition", one: Quantity, right: dict[str, float], policy: Policy
) -> float:
    """Return an answer just outside the band, on a side where it means nothing else.

    That is neither another verdict on it nor another reading of the sheet.
    """
    plan, given = composition.plan, composition.example.given
    value = moved(one, right[one.id], policy)
    other_side = 2 * right[one.id] - value
    verdicts = [
        name
        for name, inputs in plan.inputs.items()
        if one.id in inputs and plan.quantities[name].kind is Kind.VERDICT
    ]
    if verdicts:
        values = solve_variant(plan, {**given, one.id: value})
        if any(values[name] != right[name] for name in verdicts):
            return other_side
    for reading in one.alternatives:
        known = composition.example.values
        meant = float(evaluate(reading.formula, one.unit, known, plan.columns)) / factor(one.unit)
        if abs(value - meant) <= band(one, meant, policy):
            return other_side
    return value


def steps_from(plan: Plan, one: Quantity) -> set[object]:
    """Name an answer with its own formula, and with that of everything computed from it.

    What schemes share is declared in one file, and has one name.
    """

    def written(name: str) -> tuple[str, str | None]:
        formula = plan.reference_formula(name)
        return plan.quantities[name].file, None if formula is None else formula.text

    users = (name for name, inputs in plan.inputs.items() if one.id in inputs)
    own = (one.id, written(one.id))
    return {own, *((*own, name, written(name)) for name in users)}


@each("compositions", "composition")
def test_reference_answers_earn_everything(composition: "Composition", policy: Policy) -> None:
    report = judged(composition, reference_answers(composition), policy)
    assert report.score == pytest.approx(report.max_score)
    assert report.score + report.open_points == pytest.approx(policy.total)


def test_one_answer_outside_its_band_loses_that_item_only(
    compositions: "tuple[Composition, ...]",
    subtests: pytest.Subtests,
    policy: Policy,
) -> None:
    """Every answer that is declared, with each formula that it goes into.

    An answer is tried again where another composition or another scheme computes it, or what
    follows from it, by another formula or declares it itself.
    """
    strict = replace(policy, printed_credit=None)  # else near a printed one it would earn all
    seen: set[object] = set()  # steps from an answer to what is computed from it
    for composition in compositions:
        with named_if_it_fails(subtests, composition=composition.name):
            right = reference_answers(composition)
            methods, faults = methods_of(composition.plan, strict), []
            for one in composition.plan.answered:
                steps = steps_from(composition.plan, one)
                if steps <= seen:
                    continue
                seen |= steps
                answers = {**right, one.id: moved_alone(composition, one, right, strict)}
                report = judged(composition, answers, strict, methods)
                lost = {
                    found.quantity
                    for found in report.findings
                    if found.points < found.max_points - 1e-9
                }
                lost -= {manual.id for manual in composition.plan.manual}
                if lost != {one.id}:
                    faults.append(f"{one.id}: {sorted(lost)}")
            assert faults == []
