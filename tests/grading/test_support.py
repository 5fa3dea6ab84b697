"""Credit that rests on one's own numbers needs numbers that were earned."""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.quantity import Kind
from gripcourse.grading.outcome import Outcome

if TYPE_CHECKING:
    from collections.abc import Sequence

    from conftest import Case

WORKS = 6


def nothing_computed(case: "Case", number: float | None) -> dict[str, float]:
    """One number everywhere, "yes" to every question, the smallest size of every series."""
    answers = {}
    for one in case.plan.answered:
        if one.kind is Kind.VERDICT:
            answers[one.id] = 1.0
        elif one.kind is Kind.CHOICE:
            answers[one.id] = min(case.reference[one.id], one.bounds[0] * 1000)
        else:
            answers[one.id] = one.bounds[0] if number is None else number
    return answers


@pytest.mark.parametrize("number", [None, 0.0, 0.01, 1.0], ids=["least", "0", "0.01", "1"])
def test_who_computes_nothing_earns_next_to_nothing(hydraulic: "Case", number: float) -> None:
    report = hydraulic.judge(nothing_computed(hydraulic, number))
    assert report.score <= 0.05 * (report.max_score - report.open_points)


def test_right_numbers_blurred_by_a_third_earn_next_to_nothing(hydraulic: "Case") -> None:
    blur = np.random.default_rng(4)
    answers = {
        name: value * (1.0 if one.exact else float(np.exp(blur.choice([-1, 1]) * 0.3)))
        for name, value in hydraulic.answers.items()
        for one in [hydraulic.plan.quantities[name]]
    }
    report = hydraulic.judge(answers)
    assert report.score <= 0.05 * (report.max_score - report.open_points)


def test_a_lone_yes_is_not_supported(hydraulic: "Case") -> None:
    finding = hydraulic.findings({"bearing_ok": hydraulic.reference["bearing_ok"]})["bearing_ok"]
    assert (finding.outcome, finding.points) == (Outcome.UNSUPPORTED, 0.0)
    assert "the numbers that it rests on" in str(finding.message)


def test_what_is_not_supported_says_which_numbers_it_rests_on(hydraulic: "Case") -> None:
    wrong = {
        one.id: 1.37 * hydraulic.reference[one.id]
        for one in hydraulic.plan.answered
        if one.kind is Kind.FORMULA
    }
    finding = hydraulic.findings({**hydraulic.answers, **wrong})["bearing_ok"]
    assert finding.outcome is Outcome.UNSUPPORTED
    assert "bearing_stress" in finding.roots


def test_what_is_the_same_in_every_variant_is_not_earned_by_itself(
    table: "tuple[Case, ...]",
) -> None:
    case = next(one for one in table if one.plan.scheme.id == "pinion_racks")
    wrong = {
        one.id: 1.37 * case.reference[one.id]
        for one in case.plan.answered
        if one.kind is Kind.FORMULA and one.id != "force_ratio"
    }
    finding = case.findings({**case.answers, **wrong})["force_ratio"]
    assert (finding.outcome, finding.points) == (Outcome.UNSUPPORTED, 0.0)
    assert "the same in every variant" in str(finding.message)
    assert case.findings(case.answers)["force_ratio"].outcome is Outcome.CORRECT


def test_one_unexplained_mistake_anywhere_costs_once(hydraulic: "Case") -> None:
    for one in hydraulic.plan.answered:
        if one.kind is Kind.FORMULA:
            value = 1.0937 * hydraulic.reference[one.id]
            lost = hydraulic.lost(hydraulic.following(**{one.id: value}))
            assert len(lost) <= 1, one.id


def test_a_work_of_one_right_section_keeps_what_it_earned(hydraulic: "Case") -> None:
    section = {one.id for one in hydraulic.plan.answered if one.section == "scheme"}
    answers = {name: value for name, value in hydraulic.answers.items() if name in section}
    findings = hydraulic.findings(answers)
    assert all(findings[name].outcome is Outcome.CORRECT for name in section)


def neighbours_shares(table: "Sequence[Case]", most: int | None = None) -> list[float]:
    """What the next variant's right answers earn, of the points that no person gives."""
    alike = sorted(table, key=lambda case: case.plan.scheme.id)
    pairs = [pair for pair in pairwise(alike) if pair[0].plan.scheme.id == pair[1].plan.scheme.id]
    reports = [
        case.judge({name: n for name, n in other.answers.items() if name in case.answers})
        for case, other in pairs[:most]
    ]
    return [one.score / (one.max_score - one.open_points) for one in reports]


def test_a_neighbours_consistent_numbers_earn_next_to_nothing(table: "tuple[Case, ...]") -> None:
    """They follow from each other, but for those that use what was issued to somebody else."""
    shares = neighbours_shares(table, WORKS)
    assert len(shares) == WORKS
    assert sum(shares) / WORKS <= 0.05


def test_what_follows_from_a_number_of_somebody_else_is_not_computed_from_ones_own(
    flat_belt: "Case",
) -> None:
    """Ten of fourteen issued numbers are another's; what uses one of them follows from that one."""
    theirs = {
        "motor_speed": 1420.0,
        "ratio_wanted": 2.0,
        "slip_ratio": 0.012,
        "centre_distance": 1350.0,
        "ply_count": 5.0,
        "preload_stress": 1.6,
        "inclination": 70.0,
        "duty_factor": 0.8,
        "friction": 0.44,
        "shaft_stress_allowed": 75.0,
    }
    report = flat_belt.judge(flat_belt.following(**theirs))
    assert report.score <= 0.2 * report.max_score


def test_sizes_that_suit_other_issued_numbers_speak_against_a_calculation(v_belt: "Case") -> None:
    """Six of nine issued numbers are another's: two are found out, a size and two answers stay."""
    theirs = {
        "motor_speed": 1460.0,
        "ratio_wanted": 4.1,
        "slip_ratio": 0.02,
        "efficiency": 0.93,
        "layout_distance": 1690.0,
        "service_factor": 1.5,
    }
    report = v_belt.judge(v_belt.following(**theirs))
    assert report.score <= 0.2 * report.max_score


@pytest.mark.parametrize(
    "given", ["motor_speed", "ratio_wanted", "service_factor", "layout_distance"]
)
def test_a_size_that_suits_one_misread_number_costs_nobody_the_work(
    v_belt: "Case", given: str
) -> None:
    misread = v_belt.following(**{given: 1.2 * v_belt.given[given]})
    report = v_belt.judge(misread)
    assert not any(one.outcome is Outcome.UNSUPPORTED for one in report.findings)


def mostly_wrong(case: "Case") -> dict[str, float]:
    """Two thirds of the computed answers are off by a tenth, each by itself; the rest is right."""
    computed = [one.id for one in case.plan.answered if one.kind is Kind.FORMULA]
    wrong = {name: 1.1 * case.reference[name] for place, name in enumerate(computed) if place % 3}
    return {**case.answers, **wrong}


def test_a_number_near_the_right_one_was_not_computed_from_wrong_ones(flat_belt: "Case") -> None:
    """It lies in its band by chance, as a neighbour's angle does; exactly right it counts."""
    answers = {**mostly_wrong(flat_belt), "small_diameter": 999.0}
    right = flat_belt.reference["wrap_angle"]
    near = flat_belt.findings({**answers, "wrap_angle": 1.008 * right})["wrap_angle"]
    exact = flat_belt.findings({**answers, "wrap_angle": right})["wrap_angle"]
    assert (near.outcome, near.points) == (Outcome.UNSUPPORTED, 0.0)
    assert "small_diameter" in near.roots
    assert (exact.outcome, exact.points) == (Outcome.CORRECT, exact.max_points)


def test_a_number_near_the_right_one_counts_where_it_rests_on_nothing_wrong(
    flat_belt: "Case",
) -> None:
    answers = {
        **mostly_wrong(flat_belt),
        "torque_small": 1.008 * flat_belt.reference["torque_small"],
    }
    finding = flat_belt.findings(answers)["torque_small"]
    assert (finding.outcome, finding.points) == (Outcome.CORRECT, finding.max_points)


def test_neighbours_numbers_earn_next_to_nothing_where_few_answers_use_issued_ones(
    belt_table: "tuple[Case, ...]",
) -> None:
    """Of a belt drive's answers most follow from a few, and an angle of wrap is near another's."""
    shares = neighbours_shares(belt_table)
    assert len(shares) == len(belt_table) - 2
    assert sum(shares) / len(shares) <= 0.02
