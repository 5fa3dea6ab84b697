"""Another honest reading of a quantity: full credit, a remark, carried on."""

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.quantity import Alternative, Kind, Quantity
from gripcourse.formula.evaluate import evaluate
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.grading.model import Against, Outcome
from gripcourse.slips.candidates import candidates_of
from gripcourse.solver.solve import to_si
from gripcourse.text.units import factor
from gripcourse.text.words import LANGUAGES, Texts, Words

if TYPE_CHECKING:
    from conftest import Case

REMARK = Texts({language: f"read otherwise ({language})" for language in LANGUAGES})


def with_reading(case: "Case", quantity: str, formula: str) -> "Case":
    """Let a quantity of a case have one more reading."""
    other = Alternative("test", Formula(formula, parse(formula), {}), REMARK)
    declared = replace(case.plan.quantities[quantity], alternatives=(other,))
    quantities = {**case.plan.quantities, quantity: declared}
    answered = tuple(quantities[one.id] for one in case.plan.answered)
    return replace(case, plan=replace(case.plan, quantities=quantities, answered=answered))


def declared_readings(case: "Case") -> Iterator[tuple[Quantity, Alternative, float]]:
    known = {name: np.asarray(v) for name, v in to_si(case.plan, case.reference).items()}
    for quantity in case.plan.answered:
        for other in quantity.alternatives:
            value = evaluate(other.formula, quantity.unit, known, case.plan.columns)
            yield quantity, other, float(value) / factor(quantity.unit)


class TestValue:
    def test_each_declared_reading_earns_all_points_with_its_remark(
        self, hydraulic: "Case"
    ) -> None:
        found = list(declared_readings(hydraulic))
        assert {"pin_length", "lifting_load", "grip_force"} <= {one.id for one, _, _ in found}
        for quantity, other, value in found:
            finding = hydraulic.findings({**hydraulic.answers, quantity.id: value})[quantity.id]
            assert (finding.outcome, finding.against) == (Outcome.CORRECT, Against.ALTERNATIVE)
            assert finding.points == pytest.approx(finding.max_points)
            for language in LANGUAGES:
                said = " ".join(Words(language).say(one) for one in finding.remarks)
                assert other.remark.of(language) in said

    def test_it_is_carried_on(self, hydraulic: "Case") -> None:
        for quantity, _, value in declared_readings(hydraulic):
            report = hydraulic.judge(hydraulic.following(**{quantity.id: value}))
            assert report.score == pytest.approx(report.max_score), quantity.id

    def test_it_is_recognised_at_the_students_own_numbers(self, hydraulic: "Case") -> None:
        force = 1234.0
        own = {"pin_force": force, "pin_diameter_first": 16.0}
        value = force / (16.0 * hydraulic.given["bearing_stress_allowed"])
        finding = hydraulic.findings({**own, "pin_length": value})["pin_length"]
        assert finding.against is Against.ALTERNATIVE

    def test_no_wrong_method_is_looked_for_that_computes_it(self, hydraulic: "Case") -> None:
        half = "dynamic_factor*lifting_load/friction"  # what a declared slip computes
        case = with_reading(hydraulic, "grip_force", half)
        names = {str(one.id) for one in candidates_of(case.plan, "grip_force", case.policy.slips)}
        assert "one_jaw_only" not in names
        assert "friction_left_out" in names


class TestChoice:
    def test_a_size_for_another_requirement_is_sound(self, hydraulic: "Case") -> None:
        largest = 500.0
        assert hydraulic.plan.quantities["bore"].kind is Kind.CHOICE
        case = with_reading(hydraulic, "bore", "8*bore_required")
        finding = case.findings({**case.answers, "bore": largest})["bore"]
        assert (finding.outcome, finding.against) == (Outcome.CORRECT, Against.ALTERNATIVE)
        assert str(finding.remarks[0]).endswith("read otherwise (en)")
        assert finding.points == pytest.approx(finding.max_points)
