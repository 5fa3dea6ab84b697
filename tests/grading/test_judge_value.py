"""One computed answer: known slips, printed errata, a unit that does not fit."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.quantity import Kind, Quantity, Slip
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.grading.model import Against, Finding, Outcome
from gripcourse.policy.bands import band, within
from gripcourse.solver.solve import to_si
from gripcourse.submission.model import Answer
from gripcourse.text.units import factor
from gripcourse.text.words import LANGUAGES, Words

if TYPE_CHECKING:
    from conftest import Case, DrawMore

ReadAnswer = Callable[..., Answer]


def value_of(case: "Case", quantity: Quantity, formula: Formula) -> float:
    """Compute another formula of a quantity from the reference, in the declared unit."""
    known = {name: np.asarray(v) for name, v in to_si(case.plan, case.reference).items()}
    scale = factor(quantity.unit)
    return float(evaluate(formula, quantity.unit, known, case.plan.columns)) / scale


def apart(case: "Case", quantity: Quantity, value: float, others: list[float]) -> bool:
    """Whether a value is told from others at the policy's tolerance."""
    return not any(within(value, other, band(quantity, other, case.policy)) for other in others)


def told_slips(case: "Case") -> Iterator[tuple[Quantity, Slip, float]]:
    """The declared slips that this variant tells from the right answer, errata and other slips."""
    for quantity in case.plan.answered:
        values = [value_of(case, quantity, slip.formula) for slip in quantity.slips]
        accepted = [case.reference[quantity.id]] + [
            value_of(case, quantity, one.formula) for one in quantity.as_printed if one.formula
        ]
        for number, (slip, value) in enumerate(zip(quantity.slips, values, strict=True)):
            told = apart(case, quantity, value, [*accepted, *values[:number]])
            if math.isfinite(value) and told:
                yield quantity, slip, value


class TestSlips:
    def test_every_declared_slip_is_recognised_in_some_variant(
        self, drawn: "tuple[Case, ...]", draw_more: "DrawMore"
    ) -> None:
        # A wrong rule seldom leads to another size of a series: those have tests of their own.
        declared = {
            (case.plan.scheme.id, quantity.id, slip.id)
            for case in drawn
            for quantity in case.plan.answered
            if quantity.kind is not Kind.CHOICE
            for slip in quantity.slips
        }
        told = {(q.id, s.id) for case in drawn for q, s, _ in told_slips(case)}
        missing = {scheme for scheme, *slip in declared if tuple(slip) not in told}
        told |= {(q.id, s.id) for case in draw_more(missing) for q, s, _ in told_slips(case)}
        assert told >= {(quantity, slip) for _, quantity, slip in declared}

    def test_a_slip_is_named_and_earns_its_credit(self, drawn: "tuple[Case, ...]") -> None:
        """Every slip that some of the variants tell, in the first that does."""
        asked: set[tuple[str, str, str]] = set()
        for case in drawn[::8]:
            for quantity, slip, value in told_slips(case):
                if (quantity.file, quantity.id, slip.id) in asked:
                    continue
                asked.add((quantity.file, quantity.id, slip.id))
                # With the sizes that stand before it: another sound size could lead there too.
                finding = case.findings({**case.answers, quantity.id: value})[quantity.id]
                assert (finding.outcome, str(finding.slip)) == (Outcome.SLIP, slip.id), quantity.id
                assert finding.points == pytest.approx(slip.credit * finding.max_points)

    @pytest.mark.parametrize("language", LANGUAGES)
    def test_its_hint_is_given_in_the_readers_language(
        self, hydraulic: "Case", language: str
    ) -> None:
        for quantity, slip, value in told_slips(hydraulic):
            finding = hydraulic.findings({quantity.id: value})[quantity.id]
            assert slip.hint.of(language) in Words(language).say(finding.message)

    def test_a_slip_is_recognised_at_the_students_own_numbers_too(self, hydraulic: "Case") -> None:
        load = 1234.0  # wrong; then the friction of the second jaw is forgotten on top of it
        force = hydraulic.given["dynamic_factor"] * load / hydraulic.given["friction"]
        finding = hydraulic.findings({"lifting_load": load, "grip_force": force})["grip_force"]
        assert str(finding.slip) == "one_jaw_only"

    def test_what_follows_a_slip_is_carried(self, hydraulic: "Case") -> None:
        answers = hydraulic.following(grip_force=2 * hydraulic.reference["grip_force"])
        findings = hydraulic.findings(answers)
        assert str(findings["grip_force"].slip) == "one_jaw_only"
        assert hydraulic.lost(answers) == {"grip_force"}


class TestPrintedErrata:
    def test_a_whole_solution_as_the_guide_prints_it_is_accepted(
        self, drawn: "tuple[Case, ...]", hydraulic: "Case"
    ) -> None:
        for case in (hydraulic, *drawn):
            report = case.judge(case.printed())
            assert report.score == pytest.approx(report.max_score)

    def test_each_printed_formula_is_accepted_with_a_remark(self, hydraulic: "Case") -> None:
        for quantity, erratum, finding in printed_findings(hydraulic):
            assert finding.outcome is Outcome.CORRECT, quantity
            assert finding.against is Against.PRINTED
            assert finding.points == pytest.approx(finding.max_points)
            assert any(erratum in str(remark) for remark in finding.remarks)

    def test_there_are_errata_to_accept(self, hydraulic: "Case") -> None:
        found = {erratum for _, erratum, _ in printed_findings(hydraulic)}
        assert found >= {"E10", "E12", "E14", "E16"}

    @pytest.mark.parametrize("language", LANGUAGES)
    def test_the_remark_says_what_is_wrong_in_the_readers_language(
        self, hydraulic: "Case", language: str
    ) -> None:
        quantity = hydraulic.plan.quantities["bearing_stress"]
        value = hydraulic.printed()["bearing_stress"]
        answers = {**hydraulic.printed(), "bearing_stress": value}
        said = [Words(language).say(r) for r in hydraulic.findings(answers)[quantity.id].remarks]
        assert any(quantity.as_printed[0].note.of(language) in one for one in said)

    def test_a_policy_may_refuse_them_and_names_them(self, hydraulic: "Case") -> None:
        strict = hydraulic.with_policy(printed_credit=None)
        for quantity, erratum, finding in printed_findings(strict):
            assert (finding.outcome, str(finding.slip)) == (Outcome.SLIP, erratum), quantity
            assert finding.points == 0

    def test_a_policy_may_give_a_share_of_the_points(self, hydraulic: "Case") -> None:
        for _, _, finding in printed_findings(hydraulic.with_policy(printed_credit=0.7)):
            assert finding.points == pytest.approx(0.7 * finding.max_points)

    def test_what_earns_most_counts(self, hydraulic: "Case") -> None:
        """An answer that both follows from own numbers and is printed is not paid the lesser."""
        answers = hydraulic.printed()
        unfollowed = hydraulic.with_policy(carried_credit=0.0)
        finding = unfollowed.findings(answers)["bearing_stress"]
        assert finding.points == pytest.approx(finding.max_points)


def printed_findings(case: "Case") -> Iterator[tuple[str, str, Finding]]:
    """Answer one quantity at a time as the source prints it, all others left blank."""
    for quantity in case.plan.answered:
        for one in quantity.as_printed:
            if one.formula is None:
                continue
            value = value_of(case, quantity, one.formula)
            if apart(case, quantity, value, [case.reference[quantity.id]]):
                yield quantity.id, one.erratum, case.findings({quantity.id: value})[quantity.id]


class TestUnits:
    @pytest.mark.parametrize("quantity", ["lifting_load", "module", "rod"])
    def test_the_right_number_with_a_wrong_unit_earns_the_policys_share(
        self, case: "Case", read_answer: ReadAnswer, quantity: str
    ) -> None:
        value = case.reference[quantity]
        wrong = read_answer(quantity, value, unit="kg", unit_fits=False)
        finding = case.findings({**case.answers, quantity: wrong})[quantity]
        assert finding.outcome is Outcome.WRONG
        share = case.policy.wrong_unit_credit
        assert finding.points == pytest.approx(share * finding.max_points)
        assert str(finding.message) == "The number is right, the unit is not."

    @pytest.mark.parametrize(("quantity", "value"), [("lifting_load", 77.0), ("module", 77.0)])
    def test_a_wrong_number_with_a_wrong_unit_earns_nothing(
        self, case: "Case", read_answer: ReadAnswer, quantity: str, value: float
    ) -> None:
        wrong = read_answer(quantity, value, unit="kg", unit_fits=False)
        finding = case.findings({quantity: wrong})[quantity]
        assert (finding.outcome, finding.points) == (Outcome.WRONG, 0)

    def test_a_value_with_a_wrong_unit_is_not_carried_on(
        self, hydraulic: "Case", read_answer: ReadAnswer
    ) -> None:
        wrong = read_answer("lifting_load", 77.0, unit="kg", unit_fits=False)
        findings = hydraulic.findings({**hydraulic.answers, "lifting_load": wrong})
        right = hydraulic.reference["lifting_load"]
        assert findings["grip_force"].inputs["lifting_load"] == pytest.approx(right)


class TestPicks:
    def test_a_pick_is_judged_by_the_students_own_size(self, hydraulic: "Case") -> None:
        answers = hydraulic.following(flange_size=120)
        finding = hydraulic.findings(answers)["flange_bolt_circle"]
        assert finding.outcome is Outcome.CARRIED

    def test_another_rows_value_is_wrong_and_the_table_is_named(self, hydraulic: "Case") -> None:
        finding = hydraulic.findings({**hydraulic.answers, "flange_diameter": 145.0})
        assert finding["flange_diameter"].outcome is Outcome.WRONG
        said = "The table gives another value for your size."
        assert str(finding["flange_diameter"].message) == said

    def test_a_table_value_has_no_band(self, hydraulic: "Case") -> None:
        """One per cent of 144 mm would let a number pass that stands in no table."""
        close = 1.002 * hydraulic.reference["flange_diameter"]
        assert "flange_diameter" in hydraulic.lost({**hydraulic.answers, "flange_diameter": close})


def test_a_verdict_whose_right_answer_is_no_earns_for_no_and_not_for_yes(
    hydraulic: "Case",
) -> None:
    """A pin that the course lets fail in bearing."""
    case = with_limit(hydraulic, 0.0)
    found = {
        value: case.findings({**case.answers, "bearing_ok": value})["bearing_ok"]
        for value in (0, 1)
    }
    assert found[0].outcome is Outcome.CORRECT
    assert (found[1].outcome, found[1].points) == (Outcome.WRONG, 0)
    assert "opposite" in str(found[1].message)


def test_a_right_verdict_stands_where_right_numbers_say_the_opposite_by_digits_not_typed(
    hydraulic: "Case",
) -> None:
    """The stress is under its limit by 2 ‰ in the calculator; what was typed is over it."""
    stress = hydraulic.reference["bearing_stress"]
    case = with_limit(hydraulic, 1.002 * stress / hydraulic.reference["bearing_stress_allowed"])
    found = {
        off: case.findings({**case.answers, "bearing_stress": (1 + off) * stress})
        for off in (0.006, 0.1)
    }
    assert found[0.006]["bearing_stress"].outcome is Outcome.CORRECT
    assert found[0.006]["bearing_ok"].outcome is Outcome.CORRECT
    # A number that nothing explains costs by itself: the verdict was on the right one.
    assert found[0.1]["bearing_stress"].outcome is Outcome.WRONG
    assert found[0.1]["bearing_ok"].outcome is Outcome.CORRECT


def with_limit(case: "Case", share: float) -> "Case":
    """Let the pin hold up to a share of its allowed stress only."""
    verdict = case.plan.quantities["bearing_ok"]
    condition = parse(f"bearing_stress <= {share!r}*bearing_stress_allowed")
    asked = replace(verdict, formula=Formula("limit", condition, {}), must_hold=False)
    quantities = {**case.plan.quantities, asked.id: asked}
    answered = tuple(quantities[one.id] for one in case.plan.answered)
    plan = replace(case.plan, quantities=quantities, answered=answered)
    holds = case.reference["bearing_stress"] <= share * case.reference["bearing_stress_allowed"]
    return replace(case, plan=plan, reference={**case.reference, asked.id: float(holds)})
