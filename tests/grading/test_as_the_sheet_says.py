"""What a sheet says of an answer is judged from the student's own numbers, wrong as they may be."""

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from conftest import Case

ENDS = ("force_ratio_at_max", "force_ratio_at_min")


@pytest.mark.parametrize("wrong", ENDS)
@pytest.mark.parametrize("times", [0.4, 1.5])
def test_the_larger_of_ones_own_ratios_sizes_the_drive(
    table: "tuple[Case, ...]", wrong: str, times: float
) -> None:
    """Though mechanics lets one end govern: whoever has a wrong number there sees another."""
    met = set()
    for case in table:
        if not set(ENDS) <= case.answers.keys():
            continue
        other = next(name for name in ENDS if name != wrong)
        number = times * case.reference[other]
        larger = {wrong: number, "force_ratio": max(number, case.reference[other])}
        answers = case.following(**larger)
        lost = case.lost(answers)
        assert lost.isdisjoint({"force_ratio", "drive_force", "bore"}), case.label
        met.add(case.plan.scheme.id)
    assert {"cross_cylinder", "link_lever_2", "rack_parallelogram", "wedge_roller"} <= met


def test_a_gain_follows_from_ones_own_forces(table: "tuple[Case, ...]") -> None:
    """K_P is F/P: a drive force that was multiplied by the efficiency costs once."""
    met = 0
    for case in table:
        if not {"force_gain", "drive_force"} <= case.answers.keys():
            continue
        values = {**case.given, **case.answers}
        force = values["grip_force"] * values["force_ratio"] * values["mechanism_efficiency"]
        gain = values["grip_force"] / force
        answers = {**case.following(drive_force=force), "force_gain": gain}
        assert case.without_errata.lost(answers) == {"drive_force"}, case.label
        met += 1
    assert met


def test_the_efficiency_over_the_ratio_is_the_gain_too(hydraulic: "Case") -> None:
    """Beside a wrong drive force it is right, for the ratio is."""
    wrong = hydraulic.following(drive_force=2.5 * hydraulic.reference["drive_force"])
    answers = {**wrong, "force_gain": hydraulic.reference["force_gain"]}
    assert hydraulic.lost(answers) == {"drive_force"}


def test_an_efficiency_follows_from_ones_own_ratios(table: "tuple[Case, ...]") -> None:
    """That of a screw is 2·u/j too, which a wrong lead angle does not change any more."""
    case = next(one for one in table if one.plan.scheme.id == "screw")
    wrong = case.following(lead_angle=3 * case.reference["lead_angle"])
    efficiency = 2 * wrong["velocity_ratio"] / wrong["torque_ratio"]
    assert efficiency != pytest.approx(wrong["mechanism_efficiency"], rel=0.1)
    ratio = {name: wrong[name] for name in ("lead_angle", "torque_ratio")}
    answers = case.following(**ratio, mechanism_efficiency=efficiency)
    assert case.lost(answers) == {"lead_angle"}


def test_a_torque_follows_from_ones_own_speed(flat_belt: "Case") -> None:
    """Behind the drive it is the power over the speed there, as well as a torque times a ratio."""
    given = flat_belt.given
    wrong = given["motor_speed"] * flat_belt.reference["ratio_actual"]
    torque = 9550 * given["power"] * given["efficiency"] / wrong
    answers = flat_belt.following(driven_speed=wrong, torque_large=torque)
    assert flat_belt.lost(answers) == {"driven_speed"}


def test_a_power_follows_from_ones_own_torque(table: "tuple[Case, ...]") -> None:
    """Torque times the speed of the shaft: a wrong torque is one mistake."""
    case = next(one for one in table if "drive_torque" in one.answers)
    wrong = {name: 1.4 * case.reference[name] for name in ("drive_torque", "motor_power_required")}
    follow = case.following(**wrong)
    assert case.lost(follow) == {"drive_torque"}
