"""Mistakes in the steps of gears with racks."""

from math import cos, degrees, pi, radians
from typing import Final

from hand.mistakes_pushed import ADDED
from hand.notebook import Notebook, arccosine, arctangent, cosine, sine, tangent
from hand.wrong import ENDS, POSITIONS, Mistake, alike, mistake, row_below, times

_MODULES: Final = "modules of gears, GOST 9563-60, row 1"


def _root(n: Notebook) -> float:
    """Return the power that the module has of the load: m is on both sides for a pinion's."""
    return 1 / 2 if n.sheet.scheme == "pinion_racks" else 1 / 3


def _of_module(n: Notebook) -> float:
    return float(1.4 ** (3 * _root(n)))


def _other_root(n: Notebook, right: float) -> float:
    """Return a module by the cube root for the root, or by the root for the cube root.

    In the formula of a pinion all stands under the root, in that of a sector 1.4 before it.
    """
    if _root(n) == 1 / 2:
        return float(right ** (2 / 3))
    return float(1.4 * (right / 1.4) ** (3 / 2))


_GEARS: Final[tuple[Mistake, ...]] = (
    mistake("module: 1.4 left out", module_required=lambda n, r: r / _of_module(n)),
    mistake(
        "module: load factor left out",
        module_required=lambda n, r: r / n["load_factor"] ** _root(n),
    ),
    mistake(
        "module: face width factor left out",
        module_required=lambda n, r: r * n["face_width_factor"] ** _root(n),
    ),
    mistake(
        "module: teeth once too often",
        module_required=lambda n, r: r / n["gear_teeth"] ** _root(n),
    ),
    mistake("module: root of another degree", module_required=_other_root),
    mistake("module: one row too small", module=row_below(_MODULES)),
    mistake("gear: diameter for the radius", pitch_radius=times(2)),
    mistake("gear: face width by the radius", face_width=times(0.5)),
    mistake("gear: form factor without the teeth", tooth_form_factor=lambda _, __: 3.47),
    mistake("gear: torque in N·mm", gear_torque=times(1000)),
    mistake("gear: both jaws' torque", gear_torque=times(2)),
)


def _out(n: Notebook, end: str) -> float:
    """Return how far a jaw of a parallelogram stands out, in arms."""
    gripped = (n["diameter_max"] - n["diameter_min"]) / 2
    out = {"open": n["jaw_travel"], "at_max": gripped, "at_min": 0.0}[end]
    return out / n["arm_length"]


def _arm_ratio(n: Notebook) -> float:
    return 2 * n["arm_length"] / n["pitch_radius"]


def _arm_angle(n: Notebook, end: str) -> float:
    """Return the angle of an arm in degrees."""
    return 90 - arccosine(_out(n, end))


PARALLELOGRAMS: Final[tuple[Mistake, ...]] = (
    *_GEARS,
    alike(  # that the arms lie along the axis with the smallest object is seen, not computed
        "arccosine for the arcsine",
        "arm_angle",
        ("open", "at_max"),
        lambda n, e: arccosine(_out(n, e)),
    ),
    alike(
        "arctangent for the arcsine", "arm_angle", POSITIONS, lambda n, e: arctangent(_out(n, e))
    ),
    mistake(
        "difference of the diameters not halved",
        arm_angle_at_max=lambda n, _: 90 - arccosine(2 * _out(n, "at_max")),
    ),
    alike("arm's angle in radians", "arm_angle", POSITIONS, lambda n, e: radians(_arm_angle(n, e))),
    alike("cosine left out of the ratio", "force_ratio", ENDS, lambda n, _: _arm_ratio(n)),
    alike(
        "one jaw in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _arm_ratio(n) / 2 * cosine(n[f"arm_angle_{end}"]),
    ),
    alike(
        "cosine divided in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _arm_ratio(n) / cosine(n[f"arm_angle_{end}"]),
    ),
    alike(
        "degrees taken as radians in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _arm_ratio(n) * cos(n[f"arm_angle_{end}"]),
    ),
    mistake(
        "angle in degrees in the stroke",
        stroke_required=lambda n, _: n["pitch_radius"] * n["arm_angle_open"],
    ),
    mistake(
        "stroke by the sine",
        stroke_required=lambda n, _: n["pitch_radius"] * sine(n["arm_angle_open"]),
    ),
    mistake("stroke of both sectors", stroke_required=times(2)),
    mistake("diameter for the radius in the teeth's force", tooth_force=times(0.5)),
    mistake(
        "radial force of the teeth left out",
        joint_force=lambda n, _: (n["tooth_force"] ** 2 + n["grip_force"] ** 2) ** 0.5,
    ),
    mistake(
        "radial force of the teeth added",
        joint_force=lambda n, _: (
            (n["tooth_force"] ** 2 + (n["grip_force"] + n["tooth_force"] * tangent(20)) ** 2) ** 0.5
        ),
    ),
    mistake(
        ADDED,
        joint_force=lambda n, _: (
            n["tooth_force"] + abs(n["grip_force"] - n["tooth_force"] * tangent(20))
        ),
    ),
    mistake(
        "whole arm for the part outside of the sector",
        lever_bending_moment=lambda n, _: n["grip_force"] * n["arm_length"] / 1000,
    ),
    mistake("both jaws' force at a pin", jaw_pin_force=times(2)),
    mistake(
        "arms of one side in the width",
        overall_width=lambda n, r: r - n["arm_length"] * sine(n["arm_angle_open"]),
    ),
)


PINIONS: Final[tuple[Mistake, ...]] = (
    *_GEARS,
    mistake("one jaw in the ratio", force_ratio=times(0.5)),
    mistake("paths of both jaws added", velocity_ratio=times(2)),
    mistake(
        "module: two left out of the strength",
        module_required=lambda _, right: right * 2**0.5,
    ),
    mistake("diameter for the radius in the torque", gear_torque=times(2)),
    mistake(
        "turn in radians",
        pinion_turn=lambda _, right: radians(right),
        pinion_turn_at_max=lambda _, right: radians(right),
    ),
    mistake(
        "turn by the diameter",
        pinion_turn=times(0.5),
        pinion_turn_at_max=times(0.5),
    ),
    mistake("turn in revolutions", pinion_turn=times(1 / 360), pinion_turn_at_max=times(1 / 360)),
    mistake(
        "turn by the diameters' difference alone",
        pinion_turn=lambda n, _: degrees(
            (n["diameter_max"] - n["diameter_min"]) / 2 / n["pitch_radius"]
        ),
    ),
    mistake("stroke of both racks", stroke_required=times(2)),
    mistake("pinion's axle with one rack", pin_force=times(0.5)),
    mistake("both jaws' force at one rack", lever_bending_moment=times(2)),
    mistake(
        "pitch taken for the module in the rack",
        rack_length=lambda n, right: right - 4 * (pi - 1) * n["module"],
    ),
    mistake("travel of one jaw in the width", overall_width=lambda n, r: r - n["jaw_travel"]),
)
