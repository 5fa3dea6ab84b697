"""Honest readings of a sheet, computed by hand from given values: all points, and a remark."""

import math
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.model import Against

if TYPE_CHECKING:
    from collections.abc import Iterator

    from conftest import Case


def of_scheme(table: "tuple[Case, ...]", scheme: str) -> "Iterator[Case]":
    return (one for one in table if one.plan.scheme.id == scheme)


def accepted(case: "Case", **read: float) -> None:
    """Both in right answers and carried on, another reading costs nothing."""
    for answers in ({**case.answers, **read}, case.following(**read)):
        report = case.judge(answers)
        assert report.score == pytest.approx(report.max_score), case.label
    findings = case.findings({**case.answers, **read})
    for name in read:
        assert findings[name].against is Against.ALTERNATIVE
        assert findings[name].remarks


class TestAngleOfADriveArm:
    def test_the_other_angle_between_arm_and_axis_is_its_supplement(
        self, table: "tuple[Case, ...]"
    ) -> None:
        """97.07° from the object is 82.93° from the drive."""
        tried = 0
        for case in of_scheme(table, "tangent_slider"):
            names = [f"drive_arm_angle_{where}" for where in ("at_max", "at_min", "open")]
            others = {name: 180 - case.reference[name] for name in names}
            if all(abs(others[name] / case.reference[name] - 1) > 0.02 for name in names):
                report = case.judge({**case.answers, **others})
                assert report.score == pytest.approx(report.max_score), case.label
                tried += 1
        assert tried


class TestMomentAtTheLug:
    def test_the_pivots_side_may_be_taken_by_its_force_alone(
        self, table: "tuple[Case, ...]"
    ) -> None:
        """P 516.7 N, F 149.2 N, h_2·cos ψ 50.88 mm, χ 0.347°: 367.5·0.05088·cos χ = 18.70 N·m."""
        tried = 0
        for case in of_scheme(table, "cross_cylinder"):
            given, reference = case.given, case.reference
            along = given["drive_arm"] * math.cos(math.radians(given["drive_arm_tilt"]))
            turn = math.cos(math.radians(reference["grip_arm_tilt_at_max"]))
            grip, drive = reference["grip_force"], reference["drive_force"]
            beyond = grip * (given["grip_arm"] - along) * turn / 1000
            before = (drive - grip) * along * turn / 1000
            if before > max(beyond, 1.02 * reference["lever_bending_moment"]):
                accepted(case, lever_bending_moment=before)
                tried += 1
        assert tried


class TestBrakeOfAScrew:
    def test_the_guides_may_be_counted_on_to_hold_too(self, table: "tuple[Case, ...]") -> None:
        """F 1320 N, 2·f·R 710 N, d_2 10.5 mm, λ − ρ′ 0.1675°: 18.7 N·mm, not 62.3."""
        tried = 0
        for case in of_scheme(table, "screw"):
            given, reference = case.given, case.reference
            slope = math.radians(reference["lead_angle"] - reference["thread_friction_angle"])
            rub = 2 * given["guide_friction"] * reference["guide_reaction"]
            if slope > 0 and rub < reference["grip_force"]:
                nut = reference["grip_force"] - rub
                diameter = reference["thread_pitch_diameter"]
                accepted(case, brake_torque=nut * diameter * math.tan(slope) / 1000)
                tried += 1
        assert tried
