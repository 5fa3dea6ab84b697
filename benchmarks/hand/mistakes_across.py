"""Mistakes in the steps of a wedge with slots, and of a cylinder across the axis."""

from math import pi
from typing import Final

from hand.mistakes_pushed import TILTS
from hand.notebook import Notebook, cosine, sine, tangent
from hand.wrong import ENDS, POSITIONS, Mistake, alike, mistake, row_below, times


def _leans(n: Notebook) -> float:
    return n["wedge_angle"] + n["friction_angle"]


WEDGE_SLIDES: Final[tuple[Mistake, ...]] = (
    alike(
        "friction left out of the ratio",
        "force_ratio",
        ENDS,
        lambda n, _: 2 * tangent(n["wedge_angle"]),
    ),
    alike(
        "friction subtracted in the ratio",
        "force_ratio",
        ENDS,
        lambda n, _: 2 * tangent(n["wedge_angle"] - n["friction_angle"]),
    ),
    alike("one jaw in the ratio", "force_ratio", ENDS, lambda n, _: tangent(_leans(n))),
    alike(
        "sine for the tangent in the ratio", "force_ratio", ENDS, lambda n, _: 2 * sine(_leans(n))
    ),
    alike("cotangent in the ratio", "force_ratio", ENDS, lambda n, _: 2 / tangent(_leans(n))),
    mistake("friction in the velocity ratio", velocity_ratio=lambda n, _: tangent(_leans(n))),
    mistake("velocity ratio turned over", velocity_ratio=lambda _, right: 1 / right),
    mistake("efficiency of the wedge turned over", wedge_efficiency=lambda _, right: 1 / right),
    mistake(
        "tangent multiplied in the stroke",
        stroke_required=lambda n, _: n["jaw_travel"] * tangent(n["wedge_angle"]),
    ),
    mistake(
        "sine for the tangent in the stroke",
        stroke_required=lambda n, _: n["jaw_travel"] / sine(n["wedge_angle"]),
    ),
    mistake("travel of both jaws in the stroke", stroke_required=times(2)),
    mistake(
        "tangent multiplied in the release",
        rod_path_at_max=lambda n, _: n["release_travel"] * tangent(n["wedge_angle"]),
    ),
    mistake("difference of the diameters not halved", velocity_ratio_range=times(2)),
    mistake(
        "cosine of the friction left out of the slot's force",
        wedge_force=lambda n, _: n["grip_force"] / cosine(_leans(n)),
    ),
    mistake(
        "sine for the cosine in the slot's force",
        wedge_force=lambda n, _: n["grip_force"] / sine(_leans(n)),
    ),
    mistake(
        "friction left out of the slot's force",
        wedge_force=lambda n, _: n["grip_force"] / cosine(n["wedge_angle"]),
    ),
    mistake(
        "width of the slot left out",
        slot_contact_required=lambda n, right: right * n["slot_width"],
    ),
    mistake("slot one row too short", slot_contact=row_below("Ra20")),
    mistake(
        "sine for the cosine in the wedge's length",
        wedge_length=lambda n, _: n["slot_contact"] * sine(n["wedge_angle"]) + n["stroke_required"],
    ),
    mistake(
        "stroke left out of the wedge's length", wedge_length=lambda n, r: r - n["stroke_required"]
    ),
    mistake("one jaw's part at the pin", pin_force=times(0.5)),
    mistake("both jaws' force at one jaw", lever_bending_moment=times(2)),
    mistake("2π left out of the screw's torque", drive_torque=times(2 * pi)),
    mistake(
        "efficiency of the screw multiplied",
        drive_torque=lambda n, right: right * n["screw_efficiency"] ** 2,
    ),
    mistake("screw's turns a second for a minute", shaft_speed=times(1 / 60)),
    mistake(
        "screw's turns by the jaw's travel",
        shaft_turns=lambda n, _: n["jaw_travel"] / n["screw_lead"],
    ),
    mistake(
        "efficiency of the wedge left out of the whole",
        total_efficiency=lambda n, right: right / n["wedge_efficiency"],
    ),
)


def _jaw(n: Notebook, end: str) -> float:
    return n["grip_arm"] * cosine(n[f"grip_arm_tilt_{end}"]) / n["drive_arm"]


CYLINDERS_ACROSS: Final[tuple[Mistake, ...]] = (
    *TILTS,
    mistake("offset of the jaw left out", pivot_offset=lambda n, _: n["pivot_spacing"] / 2),
    mistake(
        "whole distance of the pivots for half",
        pivot_offset=lambda n, _: n["pivot_spacing"] - n["jaw_offset"],
    ),
    alike(
        "tilt added to the cylinder's angle",
        "cylinder_angle",
        POSITIONS,
        lambda n, end: 90 - n["drive_arm_tilt"] + n[f"grip_arm_tilt_{end}"],
    ),
    alike(
        "right angle left out of the cylinder's angle",
        "cylinder_angle",
        POSITIONS,
        lambda n, end: n["drive_arm_tilt"] + n[f"grip_arm_tilt_{end}"],
    ),
    alike(
        "two jaws in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: 2 * _jaw(n, end) / sine(n[f"cylinder_angle_{end}"]),
    ),
    alike(
        "cosine for the sine in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _jaw(n, end) / cosine(n[f"cylinder_angle_{end}"]),
    ),
    alike("sine left out of the ratio", "force_ratio", ENDS, _jaw),
    alike(
        "arms turned over in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: sine(n[f"cylinder_angle_{end}"]) / _jaw(n, end),
    ),
    alike(
        "sine for the cosine in the span",
        "cylinder_span",
        ("open", "at_min"),
        lambda n, end: n["pivot_spacing"] + 2 * n["drive_arm"] * sine(n[f"cylinder_angle_{end}"]),
    ),
    alike(
        "one lever in the span",
        "cylinder_span",
        ("open", "at_min"),
        lambda n, end: n["pivot_spacing"] + n["drive_arm"] * cosine(n[f"cylinder_angle_{end}"]),
    ),
    alike(
        "levers subtracted in the span",
        "cylinder_span",
        ("open", "at_min"),
        lambda n, end: n["pivot_spacing"] - 2 * n["drive_arm"] * cosine(n[f"cylinder_angle_{end}"]),
    ),
    mistake("stroke of one lever", stroke_required=times(0.5)),
    mistake(
        "grip force added at the pivot",
        joint_force=lambda n, _: n["drive_force"] + n["grip_force"],
    ),
    mistake(
        "half of the drive force at a lever",
        joint_force=lambda n, _: n["drive_force"] / 2 - n["grip_force"],
    ),
    mistake("pivot's force for the cylinder's pin", pin_force=lambda n, _: n["joint_force"]),
    mistake("cylinder's pin with half of the force", pin_force=times(0.5)),
    mistake(
        "whole grip arm in the bending",
        lever_bending_moment=lambda n, _: n["grip_force"] * n["grip_arm"] / 1000,
    ),
    mistake(
        "levers of one side in the width",
        overall_width=lambda n, right: (right + n["pivot_spacing"] + n["lever_thickness"]) / 2,
    ),
)
