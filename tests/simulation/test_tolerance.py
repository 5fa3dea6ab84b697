"""The audit applies the grader's own rule, and proposes what refuses no honest answer."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Against, Outcome
from gripcourse.policy.model import Policy
from gripcourse.simulation.arithmetic import Hand
from gripcourse.simulation.cohort import issue_to_nobody
from gripcourse.simulation.honest import hands_of, work_honestly
from gripcourse.simulation.in_memory import read_of
from gripcourse.simulation.model import Action, ActionKind, Mix, SimulatedWork
from gripcourse.simulation.student import Classroom
from gripcourse.simulation.tally import TallyRule
from gripcourse.simulation.tolerance import ToleranceAudit, audit_tolerances, round_up, to_write
from gripcourse.solver.plan import make_plan
from gripcourse.submission.interpret import interpret
from gripcourse.variants.draw import draw
from gripcourse.variants.model import Variant
from gripcourse.variants.space import load_spaces


@pytest.fixture(scope="module")
def variants(course: Course) -> Sequence[Variant]:
    return draw(course, load_spaces(course), 4, 9).variants


@pytest.fixture(scope="module")
def found(course: Course, policy: Policy, mix: Mix, variants: Sequence[Variant]) -> ToleranceAudit:
    return audit_tolerances(course, policy, replace(mix, answers=1), variants, 1)


def one_way(hands: Hand, way: int) -> Hand:
    return Hand(
        hands.figures[[way]],
        hands.cuts[[way]],
        hands.keeps[[way]],
        hands.pi[[way]],
        {name: values[[way]] for name, values in hands.constants.items()},
    )


@pytest.mark.parametrize("narrow", [0.01, 0.0005])
def test_the_rule_is_the_graders(
    course: Course, policy: Policy, mix: Mix, room: Classroom, narrow: float
) -> None:
    """Answers typed as text; a narrow band makes the grader refuse some of them."""
    strict = replace(policy, tolerance=replace(policy.tolerance, relative=narrow), floors={})
    hands = hands_of(mix)
    variants = draw(course, load_spaces(course), 5, 4).variants
    behaviour = next(iter(room.behaviours.values()))
    accepted = refused = 0
    for number, issued in enumerate(issue_to_nobody(course, mix, variants, 1)):
        way = number % hands.figures.size
        plan = make_plan(course, issued.variant.scheme, issued.variant.options)
        honest = work_honestly(plan, [issued.variant.given], one_way(hands, way), strict)
        figures = int(hands.figures[way])
        actions = tuple(
            Action(
                one.id, ActionKind.RIGHT, "", "", (), None, None, as_text(value, figures, one.kind)
            )
            for one in plan.answered
            for value in [float(honest.typed[one.id][0])]
        )
        work = SimulatedWork(issued.student.id, issued.student.id, behaviour, actions, 0, 0)
        submission = interpret(read_of(work, issued), plan.quantities.values())
        report = judge(submission, issued, plan, strict)
        said = {one.quantity: one for one in report.findings}
        for quantity in plan.answered:
            if quantity.kind is not Kind.FORMULA or quantity.integer:
                continue
            rule = TallyRule(honest, quantity, strict, honest.expected(quantity))
            band = narrow if quantity.tolerance is None else quantity.tolerance.relative
            accepts = bool(rule.accepts(honest.typed[quantity.id], band)[0])
            finding = said[quantity.id]
            says = finding.outcome in {Outcome.CORRECT, Outcome.CARRIED}
            # What is outside of its band may be excused by something earlier, or be as printed.
            excused = bool(finding.roots) or finding.against is Against.PRINTED
            assert says == accepts or (says and excused), finding.quantity
            accepted, refused = accepted + accepts, refused + (not accepts)
    assert accepted > 100
    assert refused > 0 or narrow == 0.01


def as_text(value: float, figures: int, kind: Kind) -> str | float:
    if kind is Kind.VERDICT:
        return value
    if kind is not Kind.FORMULA:
        return f"{value:.12g}"
    mantissa, power = f"{value:.{figures - 1}e}".split("e")
    return f"{mantissa.replace('.', ',')}e{power}" if int(power) < figures else f"{value:.0f}"


def test_every_computed_quantity_is_audited(found: ToleranceAudit) -> None:
    assert len(found.quantities) > 120
    assert all(one.quantity.kind is Kind.FORMULA for one in found.quantities)
    assert found.ways == 56
    assert all(one.tally.answers % found.ways == 0 for one in found.quantities)


def test_a_proposal_refuses_no_honest_answer(
    found: ToleranceAudit, course: Course, policy: Policy, mix: Mix, variants: Sequence[Variant]
) -> None:
    written = {one.quantity.id: to_write(one, policy) for one in found.quantities}
    again = audit_tolerances(
        course, replace(policy, tolerances=written), replace(mix, answers=1), variants, 1
    )
    assert not again.refuses
    assert not any(one.changes for one in again.quantities)


def test_a_wider_band_accepts_more_of_everything(found: ToleranceAudit) -> None:
    for one in found.quantities:
        assert (np.diff(one.tally.refused_by_band) <= 0).all()
        assert (np.diff(one.tally.accepted_by_band) >= 0).all()
        assert one.tally.accepted_by_band[-1] <= one.tally.slips


def test_what_a_declaration_allows_is_not_narrowed(found: ToleranceAudit) -> None:
    declared = [one for one in found.quantities if one.quantity.tolerance is not None]
    for one in declared:
        assert one.quantity.tolerance is not None
        assert one.proposed.relative >= one.quantity.tolerance.relative


def test_nothing_is_narrowed_after_few_answers(
    course: Course, policy: Policy, mix: Mix, variants: Sequence[Variant]
) -> None:
    few = audit_tolerances(course, policy, mix, variants[:1], 1)
    for one in few.quantities:
        assert one.proposed.relative >= one.now.relative
        assert one.proposed.absolute >= one.now.absolute


@pytest.mark.parametrize(
    ("value", "expected"),
    [(0.011, 0.02), (0.05, 0.05), (0.051, 0.1), (1.0, 1.0), (7.3, 10.0), (230.0, 500.0)],
)
def test_an_absolute_tolerance_is_a_round_number(value: float, expected: float) -> None:
    assert round_up(value) == pytest.approx(expected, rel=1e-12)
