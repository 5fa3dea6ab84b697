"""Mistakes in the steps of levers that a rod moves along the axis."""

from typing import Final

from hand.notebook import Notebook, arcsine, arctangent, cosine, sine, tangent
from hand.wrong import ENDS, POSITIONS, Mistake, alike, mistake, times


def _radius(n: Notebook, end: str) -> float:
    return {
        "open": n["diameter_max"] / 2 + n["release_travel"],
        "at_max": n["diameter_max"] / 2,
        "at_min": n["diameter_min"] / 2,
    }[end]


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
        lambda n, end: arcsine((_radius(n, end) - n["pivot_offset"]) / n["guide_offset"]),
    ),
    alike(
        "diameter for the radius in the slot's angle",
        "rocker_angle",
        POSITIONS,
        lambda n, end: arctangent((2 * _radius(n, end) - n["pivot_offset"]) / n["guide_offset"]),
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

_SUM = "forces on the pivot added as numbers"


def _bell_crank(n: Notebook, end: str) -> float:
    return 2 * n["grip_arm"] * cosine(n[f"grip_arm_tilt_{end}"]) / n["drive_arm"]


SLOTS: Final[tuple[Mistake, ...]] = (
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
    alike(
        "tilt added to the drive arm's angle",
        "drive_arm_angle",
        POSITIONS,
        lambda n, end: n["drive_arm_angle"] + n[f"grip_arm_tilt_{end}"],
    ),
    alike(
        "arctangent for the arcsine",
        "grip_arm_tilt",
        POSITIONS,
        lambda n, end: arctangent((_radius(n, end) - n["pivot_offset"]) / n["grip_arm"]),
    ),
    mistake("offset of the jaw left out", pivot_offset=lambda n, _: n["pivot_spacing"] / 2),
    mistake("whole drive force at one slot", slot_force=times(2)),
    mistake(_SUM, joint_force=lambda n, _: n["joint_force_x"] + n["joint_force_y"]),
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

LINKS: Final[tuple[Mistake, ...]] = (
    alike(
        "two fingers in the ratio", "force_ratio", ENDS, lambda n, end: _link_ratio(n, end) * 2 / 3
    ),
    alike(
        "tilts left out of the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: 3 * n["grip_arm"] / n["drive_arm"] * tangent(n[f"link_angle_{end}"]),
    ),
    alike(
        "arcsine for the arccosine of the link",
        "link_angle",
        POSITIONS,
        lambda n, end: arcsine(_link_across(n, end) / n["link_length"]),
    ),
    alike(
        "crosshead's offset left out",
        "link_angle",
        POSITIONS,
        lambda n, end: (
            90 - arcsine((_link_across(n, end) + n["crosshead_offset"]) / n["link_length"])
        ),
    ),
    alike(
        "arctangent for the arcsine of the tilt",
        "grip_arm_tilt",
        POSITIONS,
        lambda n, end: arctangent((_radius(n, end) - n["pivot_offset"]) / n["grip_arm"]),
    ),
    alike(
        "arm left out of the crosshead's distance",
        "crosshead_distance",
        ("open", "at_min"),
        lambda n, end: n["link_length"] * sine(n[f"link_angle_{end}"]),
    ),
    mistake(
        "tilt of the grip arm left out of the link's force",
        link_force=lambda n, right: right / cosine(n["grip_arm_tilt_at_max"]),
        link_force_at_min=lambda n, right: right / cosine(n["grip_arm_tilt_at_min"]),
    ),
    mistake(
        "grip force left out across the pivot",
        joint_force_y=lambda n, right: right - n["grip_force"],
    ),
    mistake(
        "forces on the pivot added as numbers (both ends)",
        joint_force_at_max=lambda n, _: n["joint_force_x"] + n["joint_force_y"],
        joint_force_at_min=lambda n, _: (
            n["grip_force"]
            + n["link_force_at_min"]
            * (sine(n["link_angle_at_min"]) + cosine(n["link_angle_at_min"]))
        ),
    ),
    mistake("two jaws share by friction", grip_force=times(1.5)),
)


def _link_across(n: Notebook, end: str) -> float:
    """Return how far the end of the drive arm stands from the crosshead's pin, across the axis."""
    turned = n["drive_arm_tilt"] + n[f"grip_arm_tilt_{end}"]
    return n["pivot_offset"] - n["drive_arm"] * sine(turned) - n["crosshead_offset"]


def _link_ratio(n: Notebook, end: str) -> float:
    gamma, turned = n[f"link_angle_{end}"], n["drive_arm_tilt"] + n[f"grip_arm_tilt_{end}"]
    jaw = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{end}"])
    return 3 * jaw * sine(gamma) / (n["drive_arm"] * cosine(gamma + turned))


def _wedge_ratio(n: Notebook, end: str, rho: float, fingers: float = 3) -> float:
    angle = n["wedge_angle"] + rho
    turned = n["roller_arm_tilt"] + n[f"grip_arm_tilt_{end}"]
    jaw = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{end}"])
    return fingers * jaw * sine(angle) / (n["roller_arm"] * cosine(angle + turned))


WEDGES: Final[tuple[Mistake, ...]] = (
    alike(
        "friction of the wedge left out of the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _wedge_ratio(n, end, 0.0),
    ),
    alike(
        "two rollers in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _wedge_ratio(n, end, n["friction_angle"], 2),
    ),
    alike(
        "tilts left out of the ratio",
        "force_ratio",
        ENDS,
        lambda n, _: (
            3 * n["grip_arm"] / n["roller_arm"] * tangent(n["wedge_angle"] + n["friction_angle"])
        ),
    ),
    alike(
        "arctangent for the arcsine of the tilt",
        "grip_arm_tilt",
        POSITIONS,
        lambda n, end: arctangent((_radius(n, end) - n["pivot_offset"]) / n["grip_arm"]),
    ),
    mistake(
        "friction in the velocity ratio", velocity_ratio=lambda n, _: n["force_ratio_at_max"] / 3
    ),
    mistake("efficiency of the wedge turned over", wedge_efficiency=lambda _, right: 1 / right),
    mistake(
        "stroke by the way across alone",
        stroke_required=lambda n, _: n["roller_arm"] * (_rise(n)) / tangent(n["wedge_angle"]),
    ),
    mistake(
        "tangent multiplied in the stroke",
        stroke_required=lambda n, _: n["roller_arm"] * _rise(n) * tangent(n["wedge_angle"]),
    ),
    mistake("half the thickness of the wedge", wedge_thickness=times(0.5)),
    mistake(
        "rollers' diameter for their radius in the wedge",
        wedge_thickness=lambda n, right: right - n["roller_diameter"] * cosine(n["wedge_angle"]),
    ),
    mistake(
        "normal force for the roller's force",
        roller_force=lambda n, right: right * cosine(n["friction_angle"]),
    ),
    mistake(_SUM, joint_force=lambda n, _: n["joint_force_x"] + n["joint_force_y"]),
    mistake("two jaws share by friction", grip_force=times(1.5)),
)


def _rise(n: Notebook) -> float:
    """Return how far a roller goes across while the jaws close, over its arm."""
    turned = [n["roller_arm_tilt"] + n[f"grip_arm_tilt_{end}"] for end in ("open", "at_min")]
    return sine(turned[0]) - sine(turned[1])


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
        lambda n, end: 2 * _radius(n, end) / tangent(n["prism_angle"] / 2),
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
