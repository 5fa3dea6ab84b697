"""Credit that rests on one's own numbers needs numbers that were earned."""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.quantity import Kind
from gripcourse.grading.outcome import Outcome

if TYPE_CHECKING:
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


def test_a_neighbours_consistent_numbers_earn_next_to_nothing(table: "tuple[Case, ...]") -> None:
    """They follow from each other, but for those that use what was issued to somebody else."""
    shares: list[float] = []
    alike = sorted(table, key=lambda case: case.plan.scheme.id)
    for case, other in pairwise(alike[: len(alike) // 3]):
        if case.plan.scheme.id == other.plan.scheme.id and len(shares) < WORKS:
            theirs = {name: n for name, n in other.answers.items() if name in case.answers}
            report = case.judge(theirs)
            shares.append(report.score / (report.max_score - report.open_points))
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
