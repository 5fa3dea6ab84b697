"""Mistakes in the steps of a screw, and of a worm with sectors."""

from math import degrees, hypot, pi, radians, sqrt
from typing import Final

from hand.notebook import Notebook, arccosine, arctangent, cosine, sine, tangent
from hand.wrong import ENDS, POSITIONS, Mistake, alike, mistake, row_beside, times

_THREADS = "trapezoidal threads"


def _first_row(n: Notebook, column: str) -> float:
    return n.row(_THREADS, "diameter d", n["thread_diameter_first"], column)


def _stress(n: Notebook, core: float, polar: float) -> float:
    """Return the stress of a screw with its core and the divisor of its polar section."""
    pull = n["nut_force"] / (pi * core**2 / 4)
    twist = 1000 * n["screw_torque_first"] / (pi * core**3 / polar)
    return sqrt(pull**2 + 3 * twist**2)


SCREW: Final[tuple[Mistake, ...]] = (
    mistake(
        "one end of the slide rubs",
        nut_force=lambda n, _: n["grip_force"] + n["guide_friction"] * n["guide_reaction"],
    ),
    mistake(
        "flanks taken as square",
        thread_friction_angle=lambda n, _: arctangent(n["thread_friction"]),
    ),
    mistake(
        "friction angle in radians",
        thread_friction_angle=lambda _, right: radians(right),
    ),
    mistake(
        "nominal for the pitch diameter in the torque",
        screw_torque_first=lambda n, right: (
            right * n["thread_diameter_first"] / _first_row(n, "pitch dia")
        ),
    ),
    mistake(
        "section of twisting with 32",
        screw_stress=lambda n, _: _stress(n, _first_row(n, "core dia"), 32),
    ),
    mistake(
        "three left out beside the twisting",
        screw_stress=lambda n, _: hypot(
            n["nut_force"] / (pi * _first_row(n, "core dia") ** 2 / 4),
            1000 * n["screw_torque_first"] / (pi * _first_row(n, "core dia") ** 3 / 16),
        ),
    ),
    mistake(
        "pitch diameter for the core in the stress",
        screw_stress=lambda n, _: _stress(n, _first_row(n, "pitch dia"), 16),
    ),
    mistake("pitch of another row", thread_pitch=row_beside(_THREADS, "pitch P")),
    mistake(
        "pi left out of the lead angle",
        lead_angle=lambda n, _: arctangent(n["thread_pitch"] / n["thread_pitch_diameter"]),
    ),
    mistake("one half of the screw in the torque", torque_ratio=times(0.5)),
    mistake(
        "friction left out of the torque",
        torque_ratio=lambda n, _: n["thread_pitch_diameter"] * tangent(n["lead_angle"]),
    ),
    mistake("turns of both jaws added", shaft_turns=times(2)),
    mistake("power of one jaw", motor_power_required=times(0.5)),
    mistake("turns a second for turns a minute", shaft_speed=times(1 / 60)),
    mistake(
        "both pins at half their distance",
        pin_force=lambda n, _: (
            n["grip_force"] / 2 + 2 * n["grip_force"] * n["jaw_overhang"] / n["pin_spacing"]
        ),
    ),
    mistake(
        "pins without the moment",
        pin_force=lambda n, _: n["grip_force"] / 2,
    ),
)


def _beyond(n: Notebook, end: str) -> float:
    """Return how far a jaw's pin stands beyond the pivot."""
    return (
        n["grip_arm"] * sine(0)
        + {
            "open": n["diameter_max"] / 2 + n["release_travel"],
            "at_max": n["diameter_max"] / 2,
            "at_min": n["diameter_min"] / 2,
        }[end]
        - n["pivot_offset"]
    )


WORM: Final[tuple[Mistake, ...]] = (
    alike(
        "arccosine for the arcsine",
        "grip_arm_tilt",
        POSITIONS,
        lambda n, end: arccosine(_beyond(n, end) / n["grip_arm"]),
    ),
    alike(
        "arctangent for the arcsine",
        "grip_arm_tilt",
        POSITIONS,
        lambda n, end: arctangent(_beyond(n, end) / n["grip_arm"]),
    ),
    mistake(
        "whole distance of the pivots for half",
        pivot_offset=lambda n, _: n["pivot_spacing"] - n["jaw_offset"],
    ),
    mistake("offset of the jaw left out", pivot_offset=lambda n, _: n["pivot_spacing"] / 2),
    alike(
        "one lever in the torque",
        "torque_ratio",
        ENDS,
        lambda n, end: n["grip_arm"] * cosine(n[f"grip_arm_tilt_{end}"]) / n["worm_ratio"],
    ),
    alike(
        "sine for the cosine in the torque",
        "torque_ratio",
        ENDS,
        lambda n, end: 2 * n["grip_arm"] * sine(n[f"grip_arm_tilt_{end}"]) / n["worm_ratio"],
    ),
    mistake("root for the cube root", module_required=lambda _, right: right**1.5),
    mistake(
        "form factor by the real teeth",
        tooth_form_factor=lambda n, _: n.between_rows(
            "teeth of worm wheels", "equivalent", n["sector_teeth"], "YF"
        ),
    ),
    mistake(
        "lead angle turned over",
        lead_angle=lambda n, _: arctangent(n["worm_diameter_factor"] / n["worm_starts"]),
    ),
    mistake(
        "friction angle subtracted",
        mechanism_efficiency=lambda n, _: (
            tangent(max(n["lead_angle"] - n["thread_friction_angle"], 0.2))
            / tangent(n["lead_angle"])
        ),
    ),
    mistake(
        "whole lever for the part outside of the sector",
        lever_bending_moment=lambda n, _: n["grip_force"] * n["grip_arm"] / 1000,
    ),
    mistake("diameter for the radius of the sector", pitch_radius=times(2)),
    mistake(
        "radial force of the teeth left out",
        pin_force=lambda n, _: hypot(n["tooth_force"], n["grip_force"]),
    ),
    mistake("turns in radians", shaft_turns=lambda _, right: right * 360 / degrees(1) / 360),
    mistake(
        "ratio of the worm left out of the turns",
        shaft_turns=lambda n, right: right / n["worm_ratio"],
    ),
    mistake("mean speed of a jaw", jaw_speed=lambda n, _: n["jaw_travel"] / n["closing_time"]),
)
