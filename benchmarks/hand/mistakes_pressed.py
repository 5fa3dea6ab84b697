"""Mistakes in the steps of levers that a rod presses on: pins in slots, a plate under rollers."""

from math import cos, hypot, radians
from typing import Final

from hand.mistakes_pushed import ADDED, BELL_CRANKS, TILTS
from hand.notebook import Notebook, cosine, sine, tangent
from hand.wrong import ENDS, POSITIONS, Mistake, alike, mistake, times


def _slot_ratio(n: Notebook, end: str) -> float:
    """Return the force ratio of a lever with a slot without the cosines of the slot's angle."""
    return 2 * n["grip_arm"] * cosine(n[f"grip_arm_tilt_{end}"]) / n["slot_offset"]


def _turned_slot(n: Notebook, turn: float) -> float:
    """Return the stroke of a pin in a slot, by the tangent of an angle in other units."""
    at_min, opened = n["slot_angle_at_min"] * turn, n["slot_angle_open"] * turn
    return n["slot_offset"] * abs(at_min - opened)


SLOT_LEVERS: Final[tuple[Mistake, ...]] = (
    alike(
        "cosine of the slot once",
        "force_ratio",
        ENDS,
        lambda n, end: _slot_ratio(n, end) * cosine(n[f"slot_angle_{end}"]),
    ),
    alike("cosine of the slot left out", "force_ratio", ENDS, _slot_ratio),
    alike(
        "sine of the slot for its cosine",
        "force_ratio",
        ENDS,
        lambda n, end: _slot_ratio(n, end) * sine(n[f"slot_angle_{end}"]) ** 2,
    ),
    alike(
        "degrees taken as radians in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _slot_ratio(n, end) * cos(n[f"slot_angle_{end}"]) ** 2,
    ),
    alike(
        "one jaw in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _slot_ratio(n, end) / 2 * cosine(n[f"slot_angle_{end}"]) ** 2,
    ),
    alike(
        "tilt added to the slot's angle",
        "slot_angle",
        POSITIONS,
        lambda n, end: n["slot_angle"] + n[f"grip_arm_tilt_{end}"],
    ),
    *TILTS,
    mistake(
        "both jaws' force at one slot",
        slot_force=times(2),
        slot_force_at_min=times(2),
    ),
    mistake(
        "slot's force divided by the cosine",
        slot_force=lambda n, right: right / cosine(n["slot_angle_at_max"]) ** 2,
        slot_force_at_min=lambda n, right: right / cosine(n["slot_angle_at_min"]) ** 2,
    ),
    mistake(
        "sine for the cosine along the axis",
        joint_force_x=lambda n, _: n["slot_force"] * sine(n["slot_angle_at_max"]),
    ),
    mistake(
        "force of the slot added across the axis",
        joint_force_y=lambda n, _: n["grip_force"] + n["slot_force"] * sine(n["slot_angle_at_max"]),
    ),
    mistake("grip force left out across the axis", joint_force_y=lambda n, r: r - n["grip_force"]),
    mistake(
        f"{ADDED} (both ends)",
        joint_force_at_max=lambda n, _: n["joint_force_x"] + abs(n["joint_force_y"]),
        joint_force_at_min=lambda n, _: (
            n["slot_force_at_min"] * cosine(n["slot_angle_at_min"])
            + abs(n["grip_force"] - n["slot_force_at_min"] * sine(n["slot_angle_at_min"]))
        ),
    ),
    mistake(
        "sines for tangents in the stroke",
        stroke_required=lambda n, _: (
            n["slot_offset"] * abs(sine(n["slot_angle_at_min"]) - sine(n["slot_angle_open"]))
        ),
    ),
    mistake("stroke by the arc", stroke_required=lambda n, _: _turned_slot(n, radians(1))),
    mistake(
        "cosine left out of the bending",
        lever_bending_moment=lambda n, _: n["grip_force"] * n["grip_arm"] / 1000,
    ),
    mistake(
        "cosine multiplied in the slot's reach",
        slot_reach=lambda n, right: n["slot_offset"] ** 2 / right,
    ),
    mistake("pin left out of the slot's length", slot_length=lambda n, r: r - n["pin_diameter"]),
    mistake(
        "drive force for the pin's",
        pin_force=lambda n, _: n["drive_force"],
    ),
)


PLATES: Final[tuple[Mistake, ...]] = (
    *BELL_CRANKS,
    alike(
        "tilt added to the drive arm's angle",
        "drive_arm_angle",
        POSITIONS,
        lambda n, end: 90 - n["drive_arm_tilt"] + n[f"grip_arm_tilt_{end}"],
    ),
    alike(
        "right angle left out of the drive arm's angle",
        "drive_arm_angle",
        POSITIONS,
        lambda n, end: n["drive_arm_tilt"] + n[f"grip_arm_tilt_{end}"],
    ),
    alike(
        "degrees taken as radians in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: (
            2
            * n["grip_arm"]
            * cos(n[f"grip_arm_tilt_{end}"])
            / (n["drive_arm"] * cos(radians(90) - n[f"drive_arm_angle_{end}"]))
        ),
    ),
    mistake("whole drive force on one roller", roller_force=times(2)),
    mistake(ADDED, pin_force=lambda n, _: n["roller_force"] + n["grip_force"]),
    mistake("grip force left out at the pivot", pin_force=lambda n, _: n["roller_force"]),
    mistake(
        "whole drive force on the pivot",
        pin_force=lambda n, _: hypot(n["drive_force"], n["grip_force"]),
    ),
    mistake(
        "tangents for cosines in the stroke",
        stroke_required=lambda n, _: (
            n["drive_arm"]
            * abs(
                tangent(90 - n["drive_arm_angle_open"]) - tangent(90 - n["drive_arm_angle_at_min"])
            )
        ),
    ),
)
