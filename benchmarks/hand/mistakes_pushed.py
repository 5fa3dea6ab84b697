"""Mistakes in the steps of levers that a rod moves along the axis."""

from math import radians
from typing import Final

from hand.notebook import Notebook, arcsine, arctangent, cosine, sine, tangent
from hand.pushed import radius_of
from hand.wrong import ENDS, POSITIONS, Mistake, alike, mistake, times


def _whole(n: Notebook, end: str) -> float:
    """Return what stands in the place of a jaw's radius where the diameter is not halved."""
    half = n["diameter_min"] / 2 if end == "at_min" else n["diameter_max"] / 2
    return radius_of(n, end) + half


def _rocker_ratio(n: Notebook, end: str) -> float:
    """Return the force ratio of a rocker without the cosine of its slot."""
    return 2 * n["guide_offset"] / (n["drive_arm"] * sine(n[f"drive_arm_angle_{end}"]))


ROCKERS: Final[tuple[Mistake, ...]] = (
    alike(
        "cosine of the slot once",
        "force_ratio",
        ENDS,
        lambda n, end: _rocker_ratio(n, end) / cosine(n[f"rocker_angle_{end}"]),
    ),
    alike(
        "sine of the drive arm left out",
        "force_ratio",
        ENDS,
        lambda n, end: (
            2 * n["guide_offset"] / n["drive_arm"] / cosine(n[f"rocker_angle_{end}"]) ** 2
        ),
    ),
    alike(
        "one jaw in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _rocker_ratio(n, end) / 2 / cosine(n[f"rocker_angle_{end}"]) ** 2,
    ),
    alike(
        "arcsine for the arctangent of the slot",
        "rocker_angle",
        POSITIONS,
        lambda n, end: arcsine((radius_of(n, end) - n["pivot_offset"]) / n["guide_offset"]),
    ),
    alike(
        "diameter for the radius in the slot's angle",
        "rocker_angle",
        POSITIONS,
        lambda n, end: arctangent((_whole(n, end) - n["pivot_offset"]) / n["guide_offset"]),
    ),
    mistake("offset of the jaw left out", pivot_offset=lambda n, _: n["pivot_spacing"] / 2),
    mistake(
        "sines for cosines in the stroke",
        stroke_required=lambda n, _: (
            n["drive_arm"]
            * abs(sine(n["drive_arm_angle_open"]) - sine(n["drive_arm_angle_at_min"]))
        ),
    ),
    mistake(
        "slot's force multiplied by the cosine",
        slot_force=lambda n, _: (
            n["grip_force"] * min(cosine(n[f"rocker_angle_{end}"]) for end in ENDS)
        ),
    ),
    mistake(
        "angle left out of the bending",
        lever_bending_moment=lambda n, _: n["grip_force"] * n["guide_offset"] / 1000,
    ),
    mistake(
        "area of the rod left out",
        piston_area=lambda n, right: right * n["bore"] ** 2 / (n["bore"] ** 2 - n["rod"] ** 2),
    ),
    mistake("bore and rod added", bore_required=lambda n, _: n["bore_without_rod"] + n["rod"]),
    mistake("whole drive force on the pivot", joint_force_x=lambda n, _: n["drive_force"]),
)

ADDED = "forces on the pivot added as numbers"


def _bell_crank(n: Notebook, end: str) -> float:
    return 2 * n["grip_arm"] * cosine(n[f"grip_arm_tilt_{end}"]) / n["drive_arm"]


TILTS: Final[tuple[Mistake, ...]] = (
    alike(
        "arctangent for the arcsine of the tilt",
        "grip_arm_tilt",
        POSITIONS,
        lambda n, end: arctangent((radius_of(n, end) - n["pivot_offset"]) / n["grip_arm"]),
    ),
    alike(
        "diameter for the radius in the tilt",
        "grip_arm_tilt",
        POSITIONS,
        lambda n, end: arcsine((_whole(n, end) - n["pivot_offset"]) / n["grip_arm"]),
    ),
    alike(
        "tilt in radians",
        "grip_arm_tilt",
        POSITIONS,
        lambda n, end: radians(arcsine((radius_of(n, end) - n["pivot_offset"]) / n["grip_arm"])),
    ),
)

# Bell-cranks that a rod turns: a crosshead with slots, or a plate under rollers.
BELL_CRANKS: Final[tuple[Mistake, ...]] = (
    alike(
        "cosine for the sine in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _bell_crank(n, end) / cosine(n[f"drive_arm_angle_{end}"]),
    ),
    alike("sine of the drive arm left out", "force_ratio", ENDS, _bell_crank),
    alike(
        "one jaw in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _bell_crank(n, end) / 2 / sine(n[f"drive_arm_angle_{end}"]),
    ),
    *TILTS,
    mistake("offset of the jaw left out", pivot_offset=lambda n, _: n["pivot_spacing"] / 2),
    mistake(
        "sines for cosines in the stroke",
        stroke_required=lambda n, _: (
            n["drive_arm"]
            * abs(sine(n["drive_arm_angle_open"]) - sine(n["drive_arm_angle_at_min"]))
        ),
    ),
    mistake(
        "cosine left out of the bending",
        lever_bending_moment=lambda n, _: n["grip_force"] * n["grip_arm"] / 1000,
    ),
)

SLOTS: Final[tuple[Mistake, ...]] = (
    *BELL_CRANKS,
    alike(
        "tilt added to the drive arm's angle",
        "drive_arm_angle",
        POSITIONS,
        lambda n, end: n["drive_arm_angle"] + n[f"grip_arm_tilt_{end}"],
    ),
    mistake("whole drive force at one slot", slot_force=times(2)),
    mistake(ADDED, joint_force=lambda n, _: n["joint_force_x"] + n["joint_force_y"]),
)

PRISMS: Final[tuple[Mistake, ...]] = (
    mistake(
        "whole angle of the prism for half",
        nominal_lever_angle=lambda n, right: right - n["prism_angle"] / 2,
    ),
    mistake(
        "whole angle of the prism in the nominal diameter",
        nominal_diameter=lambda n, right: (
            right / sine(n["prism_angle"] / 2) * sine(n["prism_angle"])
        ),
    ),
    mistake("factor two left out of the nominal diameter", nominal_diameter=times(0.5)),
    mistake(
        "sine for the cosine in the apex height",
        apex_height=lambda n, _: n["lever_length"] * abs(sine(n["nominal_lever_angle"])),
    ),
    mistake(
        "release on one side only",
        apex_offset_open=lambda n, right: (
            right - n["release_travel"] / 2 / sine(n["prism_angle"] / 2)
        ),
    ),
    alike(
        "shift added to the near arm",
        "arm_near",
        ENDS,
        lambda n, end: n["arm_near_part"] + n[f"arm_shift_{end}"],
    ),
    alike(
        "diameter for the radius in the shift",
        "arm_shift",
        ENDS,
        lambda n, end: 2 * radius_of(n, end) / tangent(n["prism_angle"] / 2),
    ),
    mistake(
        "moment with the height at the nominal diameter",
        lever_torque=lambda n, _: n["grip_force"] * n["apex_height"] / 1000,
    ),
    alike(
        "rotation left out of the drive arm",
        "force_ratio",
        ENDS,
        lambda n, end: (
            2 * n[f"centre_height_{end}"] / (n["drive_arm"] * cosine(n["drive_arm_tilt"]))
        ),
    ),
    alike(
        "one jaw in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: (
            n[f"centre_height_{end}"]
            / (n["drive_arm"] * cosine(n["drive_arm_tilt"] + n[f"lever_rotation_{end}"]))
        ),
    ),
    mistake(
        "stroke by cosines",
        stroke_required=lambda n, _: (
            n["drive_arm"]
            * abs(
                cosine(n["drive_arm_tilt"] + n["lever_rotation_open"])
                - cosine(n["drive_arm_tilt"] + n["lever_rotation_at_min"])
            )
        ),
    ),
    mistake("whole drive force at one slot", slot_force=times(2)),
    mistake(
        "faces without the tilt",
        face_force=lambda n, _: n["grip_force"] / (2 * sine(n["prism_angle"] / 2)),
    ),
    mistake(
        "forces at the pivot added as numbers",
        pin_force=lambda n, _: n["grip_force"] + n["slot_force"],
    ),
)
