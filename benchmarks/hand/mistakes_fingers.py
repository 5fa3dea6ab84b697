"""Mistakes in the steps of levers that links or a wedge turn."""

from typing import Final

from hand.mistakes_pushed import ADDED, TILTS
from hand.notebook import Notebook, arcsine, cosine, sine, tangent
from hand.wrong import ENDS, POSITIONS, Mistake, alike, mistake, times

LINKS: Final[tuple[Mistake, ...]] = (
    alike(
        "one finger fewer in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _link_ratio(n, end) * (_fingers(n) - 1) / _fingers(n),
    ),
    alike(
        "cosine for the sine of the link in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _link_ratio(n, end) / tangent(n[f"link_angle_{end}"]),
    ),
    alike(
        "tilts left out of the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: (
            _fingers(n) * n["grip_arm"] / n["drive_arm"] * tangent(n[f"link_angle_{end}"])
        ),
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
    *TILTS,
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
)


def _link_across(n: Notebook, end: str) -> float:
    """Return how far the end of the drive arm stands from the crosshead's pin, across the axis."""
    turned = n["drive_arm_tilt"] + n[f"grip_arm_tilt_{end}"]
    return n["pivot_offset"] - n["drive_arm"] * sine(turned) - n["crosshead_offset"]


def _link_ratio(n: Notebook, end: str) -> float:
    gamma, turned = n[f"link_angle_{end}"], n["drive_arm_tilt"] + n[f"grip_arm_tilt_{end}"]
    jaw = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{end}"])
    return _fingers(n) * jaw * sine(gamma) / (n["drive_arm"] * cosine(gamma + turned))


def _fingers(n: Notebook) -> float:
    """Return how many fingers there are; a scheme with two does not say so."""
    return n.get("finger_count", 2.0)


def _wedge_ratio(n: Notebook, end: str, rho: float) -> float:
    angle = n["wedge_angle"] + rho
    turned = n["roller_arm_tilt"] + n[f"grip_arm_tilt_{end}"]
    jaw = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{end}"])
    return _fingers(n) * jaw * sine(angle) / (n["roller_arm"] * cosine(angle + turned))


WEDGES: Final[tuple[Mistake, ...]] = (
    alike(
        "friction of the wedge left out of the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _wedge_ratio(n, end, 0.0),
    ),
    alike(
        "one roller fewer in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _wedge_ratio(n, end, n["friction_angle"]) * (_fingers(n) - 1) / _fingers(n),
    ),
    alike(
        "friction angle subtracted in the ratio",
        "force_ratio",
        ENDS,
        lambda n, end: _wedge_ratio(n, end, -n["friction_angle"]),
    ),
    alike(
        "tilts left out of the ratio",
        "force_ratio",
        ENDS,
        lambda n, _: (
            _fingers(n)
            * n["grip_arm"]
            / n["roller_arm"]
            * tangent(n["wedge_angle"] + n["friction_angle"])
        ),
    ),
    *TILTS,
    mistake(
        "friction in the velocity ratio",
        velocity_ratio=lambda n, _: n["force_ratio_at_max"] / _fingers(n),
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
    mistake(ADDED, joint_force=lambda n, _: n["joint_force_x"] + n["joint_force_y"]),
)


def _rise(n: Notebook) -> float:
    """Return how far a roller goes across while the jaws close, over its arm."""
    turned = [n["roller_arm_tilt"] + n[f"grip_arm_tilt_{end}"] for end in ("open", "at_min")]
    return sine(turned[0]) - sine(turned[1])


THREE: Final[tuple[Mistake, ...]] = (mistake("two jaws share by friction", grip_force=times(1.5)),)
