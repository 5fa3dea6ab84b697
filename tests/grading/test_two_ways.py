"""What can be computed from moments can be computed from P/F too: a mistake in one costs once."""

import math
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from conftest import Case

RATIOS = ("force_ratio_at_max", "force_ratio_at_min")


def first_of(table: "tuple[Case, ...]", scheme: str) -> "Case":
    return next(one for one in table if one.plan.scheme.id == scheme)


def sine(case: "Case", name: str) -> float:
    return math.sin(math.radians(case.reference[name]))


def cosine(case: "Case", name: str) -> float:
    return math.cos(math.radians(case.reference[name]))


@pytest.mark.parametrize("scheme", ["link_lever_2", "link_lever_3"])
@pytest.mark.parametrize("end", ["at_max", "at_min"])
def test_the_crosshead_shares_its_force_among_the_links(
    scheme: str, end: str, table: "tuple[Case, ...]"
) -> None:
    # P/n = F1·sin γ, where the other way takes moments about the lever's pivot; P/F with cos γ.
    case = first_of(table, scheme)
    angle, name = f"link_angle_{end}", "link_force" if end == "at_max" else "link_force_at_min"
    ratio = case.reference[f"force_ratio_{end}"] * cosine(case, angle) / sine(case, angle)
    force = case.reference["grip_force"] * ratio / case.given["finger_count"] / sine(case, angle)
    answers = case.following(**{f"force_ratio_{end}": ratio, name: force})
    assert case.lost(answers) == {f"force_ratio_{end}"}


@pytest.mark.parametrize("end", ["at_max", "at_min"])
def test_half_of_the_rod_s_force_is_the_axial_part_of_a_pin_s_force(
    end: str, table: "tuple[Case, ...]"
) -> None:
    # P/2 = N·cos φ; P/F with cos φ for its square.
    case = first_of(table, "slot_lever")
    name = "slot_force" if end == "at_max" else "slot_force_at_min"
    across = cosine(case, f"slot_angle_{end}")
    ratio = case.reference[f"force_ratio_{end}"] / across
    force = case.reference["grip_force"] * ratio / 2 / across
    answers = case.following(**{f"force_ratio_{end}": ratio, name: force})
    assert case.lost(answers) == {f"force_ratio_{end}"}


@pytest.mark.parametrize("scheme", ["wedge_roller", "wedge_roller_3"])
def test_the_wedge_shares_its_force_among_the_rollers(
    scheme: str, table: "tuple[Case, ...]"
) -> None:
    # P/n = F_R·sin(θ + ρ); P/F with the cosine.
    case = first_of(table, scheme)
    inclined = math.radians(case.given["wedge_angle"] + case.given["friction_angle"])
    ratio = case.reference[RATIOS[0]] / math.tan(inclined)
    force = case.reference["grip_force"] * ratio / case.given["finger_count"] / math.sin(inclined)
    answers = case.following(force_ratio_at_max=ratio, roller_force=force)
    assert case.lost(answers) == {RATIOS[0]}


def test_a_slot_s_force_taken_from_moments_is_no_second_mistake(
    table: "tuple[Case, ...]",
) -> None:
    # N·l1·sin θ = F·l2·cos χ; the grip force is wrong as well, and has cost by itself.
    case = first_of(table, "slot_crosshead")
    arms = case.given["grip_arm"] / case.given["drive_arm"]
    at_ends = (
        cosine(case, f"grip_arm_tilt_{end}") / sine(case, f"drive_arm_angle_{end}")
        for end in ("at_max", "at_min")
    )
    force = 2 * case.reference["grip_force"] * arms * max(at_ends)
    half = {name: case.reference[name] / 2 for name in RATIOS}
    answers = case.following(**half, grip_force=2 * case.reference["grip_force"], slot_force=force)
    assert case.lost(answers) == {RATIOS[0], "grip_force"}


def test_a_rocker_is_bent_by_the_force_of_its_slot(table: "tuple[Case, ...]") -> None:
    # M = N_s·b/cos θ, as the sheet says: from N_s = F·cos θ as well.
    case = first_of(table, "tangent_slider")
    steep = min(cosine(case, f"rocker_angle_{end}") for end in ("at_max", "at_min"))
    force = case.reference["grip_force"] * steep
    answers = case.following(
        slot_force=force,
        lever_bending_moment=force * case.given["guide_offset"] / steep / 1000,
        guide_force=force * math.sqrt(1 - steep**2),
    )
    assert case.lost(answers) == {"slot_force"}


def test_the_paths_of_a_wedge_follow_from_its_velocity_ratio(
    table: "tuple[Case, ...]",
) -> None:
    case = first_of(table, "wedge_slide")
    slope = math.radians(case.given["wedge_angle"] + case.given["friction_angle"])
    ratio = math.tan(slope)  # friction changes no path
    answers = case.following(
        velocity_ratio=ratio,
        stroke_required=case.reference["jaw_travel"] / ratio,
        rod_path_at_max=case.given["release_travel"] / ratio,
    )
    assert case.lost(answers) == {"velocity_ratio"}


def test_a_cylinder_s_grip_force_follows_from_the_gain_of_the_mechanism(
    table: "tuple[Case, ...]",
) -> None:
    case = next(
        one
        for one in table
        if "grip_force_first" in one.answers and "bore_without_rod" not in one.answers
    )
    gain = 1 / case.reference["force_gain"]  # upside down
    area = math.pi * case.reference["bore_first"] ** 2 / 4
    pressed = case.given["supply_pressure"] * case.given["cylinder_efficiency"] * area
    answers = case.following(force_gain=gain, grip_force_first=pressed * gain)
    assert case.lost(answers) == {"force_gain"}


def test_the_grip_force_grows_with_the_power_of_the_motor(table: "tuple[Case, ...]") -> None:
    case = first_of(table, "screw")
    needed = case.reference["motor_power_required"] / 2  # one jaw
    answers = case.following(motor_power_required=needed)
    chosen = answers["motor_power"] * 1000 / needed
    answers |= {"grip_force_actual": case.reference["grip_force"] * chosen}
    assert case.lost(answers) == {"motor_power_required"}
