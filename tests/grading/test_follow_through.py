"""What follows from a student's own numbers: errors are carried, impossible values are not."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from gripcourse.course.quantity import Kind
from gripcourse.grading.model import Against, Outcome

if TYPE_CHECKING:
    from conftest import Case

OUT_OF_REACH = "This value is outside what is possible. Later answers that follow from it count."


def costs_one_item(case: "Case", wrong: str, factor: float) -> None:
    """Check that a wrong value loses its own points, and that what follows it is followed."""
    findings = case.findings(case.following(**{wrong: factor * case.reference[wrong]}))
    lost = {one.quantity for one in findings.values() if one.points < one.max_points}
    assert lost - {one.id for one in case.plan.manual} == {wrong}, case.label
    later = {findings[name].outcome for name in case.needing(wrong)}
    assert later <= {Outcome.CARRIED, Outcome.CORRECT}
    assert Outcome.CARRIED in later


class TestCarriedErrors:
    @pytest.mark.parametrize(
        ("wrong", "factor"),
        [("lifting_load", 1.4), ("grip_force", 0.5), ("jaw_travel", 1.1), ("module", 1.37)],
    )
    def test_an_early_wrong_value_costs_one_item_and_the_rest_is_carried(
        self, table: "tuple[Case, ...]", wrong: str, factor: float
    ) -> None:
        racks = [case for case in table if case.plan.scheme.id == "rack_parallelogram"]
        for case in racks[:12]:
            costs_one_item(case, wrong, factor)

    def test_so_does_one_of_any_scheme(self, drawn: "tuple[Case, ...]") -> None:
        for case in drawn:
            costs_one_item(case, "lifting_load", 1.15)

    def test_a_carried_answer_says_what_it_follows_from(self, hydraulic: "Case") -> None:
        wrong = 2 * hydraulic.reference["grip_force"]
        answers = hydraulic.following(grip_force=wrong)
        finding = hydraulic.findings(answers)["drive_force"]
        assert finding.outcome is Outcome.CARRIED
        assert finding.against is Against.OWN_INPUTS
        assert finding.inputs["grip_force"] == pytest.approx(wrong)
        assert finding.expected == pytest.approx(answers["drive_force"])
        assert finding.reference == pytest.approx(hydraulic.reference["drive_force"])

    def test_the_policy_says_what_carried_answers_earn(self, hydraulic: "Case") -> None:
        half = hydraulic.with_policy(carried_credit=0.5)
        finding = half.findings(half.following(grip_force=2 * half.reference["grip_force"]))
        assert finding["drive_force"].points == pytest.approx(finding["drive_force"].max_points / 2)

    def test_the_right_answer_after_a_wrong_one_counts_too(self, hydraulic: "Case") -> None:
        answers = {**hydraulic.answers, "grip_force": 2 * hydraulic.reference["grip_force"]}
        assert hydraulic.lost(answers) == {"grip_force"}

    @settings(max_examples=15)
    @given(
        factors=st.dictionaries(
            st.sampled_from(["lifting_load", "jaw_travel", "gear_torque", "pin_force", "stroke"]),
            st.floats(0.5, 2.0),
        ),
        followed=st.booleans(),
    )
    def test_following_a_students_numbers_never_costs_marks(
        self, hydraulic: "Case", factors: dict[str, float], *, followed: bool
    ) -> None:
        wrong = {name: factor * hydraulic.reference[name] for name, factor in factors.items()}
        answers = hydraulic.following(**wrong) if followed else {**hydraulic.answers, **wrong}
        assume(all(math.isfinite(value) for value in answers.values()))
        plain = hydraulic.with_policy(carried_credit=0.0)
        assert hydraulic.judge(answers).score >= plain.judge(answers).score

    def test_wrong_answers_that_follow_from_nothing_earn_nothing(self, hydraulic: "Case") -> None:
        strict = hydraulic.without_errata
        names = ("lifting_load", "grip_force", "drive_force", "bore_required")
        wrong = {name: (1.3 + n / 10) * strict.reference[name] for n, name in enumerate(names)}
        assert set(names) <= strict.lost({**strict.answers, **wrong})

    def test_numbers_of_another_students_workbook_are_not_followed(self, hydraulic: "Case") -> None:
        wrong = hydraulic.following(grip_force=2 * hydraulic.reference["grip_force"])
        others = replace(hydraulic.submission({}).identity, student="s02")
        findings = hydraulic.findings(wrong, identity=others)
        assert Outcome.CARRIED not in {one.outcome for one in findings.values()}


class TestImpossibleValues:
    @pytest.mark.parametrize(
        ("name", "value"),
        [
            pytest.param("grip_force", -3900.0, id="below its bounds"),
            pytest.param("grip_force", 1e12, id="above its bounds"),
            pytest.param("arm_angle_at_max", -5.0, id="against its guard"),
        ],
    )
    def test_who_goes_on_with_the_right_number_loses_nothing_else(
        self, case: "Case", name: str, value: float
    ) -> None:
        findings = case.findings({**case.answers, name: value})
        assert findings[name].outcome is Outcome.WRONG
        assert OUT_OF_REACH in {str(one) for one in findings[name].remarks}
        for later in case.needing(name):
            used = findings[later].inputs
            assert used.get(name, case.reference[name]) == pytest.approx(case.reference[name])
            assert findings[later].outcome in {Outcome.CORRECT, Outcome.CARRIED}

    @pytest.mark.parametrize(("name", "factor"), [("grip_force", -1.0), ("grip_force", 1e9)])
    def test_who_goes_on_with_them_loses_nothing_else_either(
        self, hydraulic: "Case", name: str, factor: float
    ) -> None:
        value = factor * hydraulic.reference[name]
        follow = {**hydraulic.following(**{name: value}), name: value}
        found = {one: at for one, at in follow.items() if math.isfinite(at)}  # no size is so large
        lost = hydraulic.lost(found) & set(found)
        assert {one for one in lost if hydraulic.plan.quantities[one].kind is Kind.FORMULA} == {
            name
        }

    def test_possible_values_have_no_such_remark(self, case: "Case") -> None:
        remarks = [r for one in case.judge(case.answers).findings for r in one.remarks]
        assert remarks == []

    def test_what_nobody_can_compute_goes_to_a_person(self, hydraulic: "Case") -> None:
        impossible = {**hydraulic.given, "arm_length": 50.0}  # shorter than the travel of the jaw
        issued = replace(
            hydraulic.issued, variant=replace(hydraulic.issued.variant, given=impossible)
        )
        broken = replace(hydraulic, issued=issued)
        report = broken.judge(hydraulic.answers)
        finding = next(one for one in report.findings if one.quantity == "arm_angle_open")
        assert finding.outcome is Outcome.NOT_JUDGED
        assert "not_judged" in {flag.code for flag in report.flags}
        assert report.open_points > hydraulic.judge({}).open_points
        assert report.max_score + report.open_points == pytest.approx(hydraulic.policy.total)
