"""A number that is right but rounded too far is neither wrong nor a slip."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.quantity import Kind
from gripcourse.grading.model import Against
from gripcourse.grading.outcome import Outcome
from gripcourse.submission.model import Answer, Reading

if TYPE_CHECKING:
    from conftest import Case


def typed(name: str, value: float, last_digit: float) -> Answer:
    return Answer(name, Reading.READ, value, f"{value:g}", "", last_digit / 2, "", True, ())


@pytest.fixture
def case(hydraulic: "Case") -> "Case":
    return hydraulic.without_errata


def test_two_figures_where_three_are_needed_are_rough(case: "Case") -> None:
    right = case.reference["arm_angle_open"]
    whole = float(round(right / 10) * 10)
    assert not right * 0.99 < whole < right * 1.01, "the example must be rough"
    answers = {**case.answers, "arm_angle_open": typed("arm_angle_open", whole, 10)}
    finding = case.findings(answers)["arm_angle_open"]
    assert finding.outcome is Outcome.ROUGH
    assert str(finding.message).startswith("Right, but rounded too far: give at least 3")


def test_what_was_computed_from_the_number_in_the_calculator_still_counts(case: "Case") -> None:
    wrong = case.following(lifting_load=1.09 * case.reference["lifting_load"])
    rough = typed("grip_force", 1.04 * wrong["grip_force"], 0.1 * wrong["grip_force"])
    findings = case.findings({**wrong, "grip_force": rough})
    assert findings["grip_force"].outcome is Outcome.ROUGH
    assert findings["drive_force"].outcome is Outcome.CARRIED


def test_a_number_that_rounding_made_right_was_computed_with_as_it_was(case: "Case") -> None:
    wrong = case.following(pitch_radius=1.04 * case.reference["pitch_radius"])
    right = case.reference["force_ratio"]
    answers = {**wrong, "force_ratio": typed("force_ratio", right, 0.1 * right)}
    findings = case.findings(answers)
    assert findings["force_ratio"].outcome is Outcome.CORRECT
    assert findings["drive_force"].outcome is Outcome.CARRIED
    assert case.lost({**wrong, "force_ratio": right}) > {"pitch_radius"}, "with all its digits"


def test_what_is_rounded_from_ones_own_number_earns_though_the_right_one_is_far(
    case: "Case",
) -> None:
    """Cut off, it would be the right number too, and would earn nothing."""
    own = {**case.answers, "lifting_load": 0.955 * case.reference["lifting_load"]}
    follows = case.following(lifting_load=own["lifting_load"])["grip_force"]
    unit = 0.08 * case.reference["grip_force"]
    rough = typed("grip_force", 0.985 * follows, unit)
    finding = case.findings({**own, "grip_force": rough})["grip_force"]
    assert abs(rough.value or 0) < 0.95 * case.reference["grip_force"]
    assert (finding.outcome, finding.against) == (Outcome.ROUGH, Against.OWN_INPUTS)
    assert finding.points == pytest.approx(finding.max_points * case.policy.rough_credit)


def test_a_number_with_all_its_digits_is_not_rough(case: "Case") -> None:
    value = 1.04 * case.reference["arm_angle_open"]
    finding = case.findings({**case.answers, "arm_angle_open": value})["arm_angle_open"]
    assert finding.outcome is not Outcome.ROUGH


def test_a_very_coarse_number_is_said_to_be_rough_and_earns_nothing(case: "Case") -> None:
    right = case.reference["arm_angle_open"]
    coarse = typed("arm_angle_open", right * 0.8, right)
    finding = case.findings({**case.answers, "arm_angle_open": coarse})["arm_angle_open"]
    assert (finding.outcome, finding.points) == (Outcome.ROUGH, 0.0)


def test_a_size_of_a_series_is_taken_as_it_stands(case: "Case") -> None:
    size = typed("bore", case.reference["bore"] * 1.03, 100)
    finding = case.findings({**case.answers, "bore": size})["bore"]
    assert finding.outcome is not Outcome.ROUGH


def test_a_number_exactly_between_two_may_be_rounded_to_either(drawn: "tuple[Case, ...]") -> None:
    halves = [
        case.without_errata
        for case in drawn
        if abs(case.reference.get("jaw_travel", 0.0) % 1 - 0.5) < 1e-9
        and case.reference["jaw_travel"] < 45
    ]
    assert halves
    for case in halves:
        right = case.reference["jaw_travel"]
        for whole in (round(right - 0.5), round(right + 0.5)):
            answers = {**case.answers, "jaw_travel": typed("jaw_travel", whole, 1)}
            assert case.findings(answers)["jaw_travel"].outcome is Outcome.ROUGH, case.label


def test_ten_for_gravity_rounded_far_is_rough_too(drawn: "tuple[Case, ...]") -> None:
    """66 for 65.11 N, which are 66.3 N with ten for gravity."""
    said = set()
    for case in drawn:
        if "load_lift" not in case.answers:
            continue
        ten, right = case.following(gravity=10.0)["load_lift"], case.reference["load_lift"]
        step = 10.0 ** (math.floor(math.log10(ten)) - 1)
        coarse = round(ten / step) * step
        off = max(0.01 * right, step if coarse < right else step / 2)
        if abs(coarse - right) > off and abs(coarse - ten) < 0.45 * step:
            answers = {**case.answers, "load_lift": typed("load_lift", coarse, step)}
            said.add(case.without_errata.findings(answers)["load_lift"].outcome)
    assert said == {Outcome.ROUGH}


def test_an_entry_of_a_table_that_was_rounded_is_not_one_of_another_row(
    drawn: "tuple[Case, ...]",
) -> None:
    """17 for 16.5 mm; with all digits of another number it is no rounding."""
    tried = 0
    for case in drawn:
        for one in case.plan.answered:
            right = case.reference.get(one.id, 1.0)
            figures = float(f"{right:.2g}")
            if one.kind is not Kind.PICK or not one.exact or one.integer or figures == right:
                continue
            digit = 10.0 ** (math.floor(math.log10(right)) - 1)
            sound = case.without_errata
            finding = sound.findings({**sound.answers, one.id: typed(one.id, figures, digit)})
            assert finding[one.id].outcome is Outcome.ROUGH, case.label
            assert str(finding[one.id].message).endswith("with all its figures.")
            exactly = typed(one.id, figures, digit * 1e-6)
            assert sound.findings({**sound.answers, one.id: exactly})[one.id].points == 0
            tried += 1
    assert tried


def test_a_number_a_whole_unit_below_is_not_cut_off(case: "Case") -> None:
    """18 is 18.97 with its digits cut off, and not 19."""
    right = case.reference["arm_angle_open"]
    unit = 0.1 * right
    for lost, outcome in ((0.97, Outcome.ROUGH), (1.0, Outcome.WRONG)):
        answers = {
            **case.answers,
            "arm_angle_open": typed("arm_angle_open", right - lost * unit, unit),
        }
        assert case.findings(answers)["arm_angle_open"].outcome is outcome, lost


def test_zeros_stand_for_few_digits_alone(drawn: "tuple[Case, ...]") -> None:
    """100 is no 68, though it is the nearest whole hundred; it may be 98."""
    said = set()
    for case in drawn:
        for one in case.plan.answered:
            right = case.reference.get(one.id, 1.0)
            if one.kind is not Kind.PICK or one.integer or not 50 < right < 100:
                continue
            hundred = replace(typed(one.id, 100.0, 1), figures=1)
            finding = case.without_errata.findings({**case.answers, one.id: hundred})[one.id]
            is_right = 100 - right <= 0.1 * right
            said.add((is_right, finding.outcome is Outcome.ROUGH))
    assert (False, False) in said
    assert said <= {(False, False), (True, True)}
