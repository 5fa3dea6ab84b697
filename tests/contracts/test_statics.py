"""Force ratios follow from how the links move, forces from equilibrium.

Here the kinematics of each scheme is written down a second time, by hand and in plain Python, so
that a fault of its declaration cannot prove itself right.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.model import Course, WorkedExample
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import solve_variant

if TYPE_CHECKING:
    from conftest import Composition

ARM, RADIUS = 0.15, 0.051  # m, of the worked example: l and m·z/2
ANGLES = (0.0, 10.0, 20.0, 30.0, 36.8699)


@dataclass(frozen=True, slots=True)
class Motion:
    """How a jaw and the rod move with an angle: y(θ) and s(θ), in m."""

    jaw: Callable[[float], float]
    rod: Callable[[float], float]


RACK = Motion(jaw=lambda angle: ARM * math.sin(angle), rod=lambda angle: RADIUS * angle)


def force_ratio(motion: Motion, angle: float) -> float:
    """Return P/F of two jaws by virtual work: P·ds = 2·F·dy, differentiated numerically."""
    step = 1e-5
    jaw = motion.jaw(angle + step) - motion.jaw(angle - step)
    rod = motion.rod(angle + step) - motion.rod(angle - step)
    return 2 * jaw / rod


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("end", ["max", "min"])
def test_the_force_ratio_of_the_rack_is_its_virtual_work(
    plan: Plan, example: WorkedExample, end: str, angle: float
) -> None:
    values = solve_variant(plan, {**example.given, f"arm_angle_at_{end}": angle})
    assert values["arm_length"] == ARM * 1e3
    assert values["pitch_radius"] == RADIUS * 1e3
    expected = force_ratio(RACK, math.radians(angle))
    assert values[f"force_ratio_at_{end}"] == pytest.approx(expected, rel=1e-6)


def test_the_velocity_ratio_is_the_jaws_path_over_the_rods(
    plan: Plan, example: WorkedExample
) -> None:
    values = solve_variant(plan, example.given)
    assert values["velocity_ratio"] == pytest.approx(force_ratio(RACK, 0.0) / 2, rel=1e-6)


def test_travel_and_stroke_are_those_of_the_motion(plan: Plan, example: WorkedExample) -> None:
    values = solve_variant(plan, example.given)
    opened, closed = (math.radians(values[f"arm_angle_{end}"]) for end in ("open", "at_min"))
    held = math.radians(values["arm_angle_at_max"])
    travel = 1e3 * (RACK.jaw(opened) - RACK.jaw(closed))
    assert values["jaw_travel"] == pytest.approx(travel, rel=1e-9)
    assert values["release_travel"] == pytest.approx(
        1e3 * (RACK.jaw(opened) - RACK.jaw(held)), rel=1e-9
    )
    stroke = 1e3 * (RACK.rod(opened) - RACK.rod(closed))
    assert values["stroke_required"] == pytest.approx(stroke, rel=1e-9)


def test_a_sector_is_in_equilibrium_of_moments(plan: Plan, example: WorkedExample) -> None:
    values = solve_variant(plan, example.given)
    # About the pivot of one sector, arms along the axis: F_t·R = F·l.
    assert values["tooth_force"] * values["pitch_radius"] == pytest.approx(
        values["grip_force"] * values["arm_length"], rel=1e-12
    )
    # The rack is pushed by the drive and held by the teeth of both sectors; the example has no
    # losses in the mechanism and its worst position is this one.
    assert values["mechanism_efficiency"] == 1
    assert values["drive_force"] == pytest.approx(2 * values["tooth_force"], rel=1e-12)


def test_the_parallelogram_is_in_equilibrium_of_moments(plan: Plan, example: WorkedExample) -> None:
    values = solve_variant(plan, example.given)
    # The couple of the two pins carries the moment of the grip force: F_p·C = F·l.
    assert values["pin_force"] * values["pin_spacing"] == pytest.approx(
        values["grip_force"] * values["arm_length"], rel=1e-12
    )


def test_two_jaws_carry_the_load_by_friction(plan: Plan, example: WorkedExample) -> None:
    values = solve_variant(plan, example.given)
    assert 2 * values["friction"] * values["grip_force"] == pytest.approx(
        values["dynamic_factor"] * values["mass"] * (values["gravity"] + values["acceleration"]),
        rel=1e-12,
    )


def test_the_drive_is_sized_by_its_worst_position(composition: "Composition") -> None:
    ends = ("force_ratio_at_max", "force_ratio_at_min")
    has_ends = {"force_ratio", *ends} <= composition.plan.quantities.keys()
    faults = [
        reference.name
        for reference in composition.references
        if has_ends
        and reference.values["force_ratio"] != max(reference.values[end] for end in ends)
    ]
    assert faults == []


def test_every_scheme_declares_how_it_moves(course: Course) -> None:
    still = {"vacuum_cups", "electromagnet"}  # nothing moves in them
    assert [
        scheme.id
        for scheme in course.schemes.values()
        if scheme.kinematics is None and scheme.id not in still
    ] == []
