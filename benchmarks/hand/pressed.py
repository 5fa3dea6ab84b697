"""Levers that a rod presses on: by a pin in slots, or by a plate under rollers."""

from math import hypot

from hand.drive import cylinder
from hand.grip import grip
from hand.mount import mount, overall
from hand.notebook import Notebook, cosine, sine, tangent
from hand.parts import drilled_lever, jaws
from hand.pushed import ahead, bent_levers, governing, lever_moment, tilts
from hand.turned import travel

_ENDS = ("at_max", "at_min")


def slot_lever(n: Notebook) -> None:
    """Solve levers with slots, along which pins of the rod slide."""
    travel(n)
    tilts(n)
    grip(n)
    offset, force = n["slot_offset"], n["grip_force"]
    for one in ("open", *_ENDS):
        n[f"slot_angle_{one}"] = n["slot_angle"] - n[f"grip_arm_tilt_{one}"]
    for one, name in (("at_max", "slot_force"), ("at_min", "slot_force_at_min")):
        # N at h/cos φ from the pivot; its part along the axis is half of P.
        phi = n[f"slot_angle_{one}"]
        jaw = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{one}"])
        n[f"force_ratio_{one}"] = 2 * jaw * cosine(phi) ** 2 / offset
        n[name] = force * jaw * cosine(phi) / offset
        along, across = n[name] * cosine(phi), force - n[name] * sine(phi)
        if one == "at_max":
            n["joint_force_x"], n["joint_force_y"] = along, across
        n[f"joint_force_{one}"] = hypot(along, across)
    governing(n)
    n["joint_force"] = max(n["joint_force_at_max"], n["joint_force_at_min"])
    n["stroke_required"] = offset * (
        tangent(n["slot_angle_at_min"]) - tangent(n["slot_angle_open"])
    )
    cylinder(n)
    lever_moment(n)
    n["pin_force"] = max(n["joint_force"], n["slot_force"], n["slot_force_at_min"])
    jaws(n)
    drilled_lever(n)
    least = min(cosine(n["slot_angle_open"]), cosine(n["slot_angle_at_min"]))
    n["slot_reach"] = offset / least
    n["slot_length"] = n["slot_reach"] - offset + n["pin_diameter"]
    n["mechanism_length"] = ahead(n) + 2 * n["pin_diameter"] + n["stroke_required"]
    reach = n["pivot_offset"] + n["slot_reach"] * cosine(n["slot_angle_open"])
    n["overall_width"] = max(
        n["diameter_max"] + 2 * n["release_travel"] + 2 * n["lever_thickness"],
        2 * reach + 2 * n["pin_diameter"],
    )
    overall(n)
    mount(n)


def plain_lever(n: Notebook) -> None:
    """Solve bent levers on whose rollers a plate presses."""
    travel(n)
    n["pivot_offset"] = n["pivot_spacing"] / 2 - n["jaw_offset"]
    bent_levers(n, 90 - n["drive_arm_tilt"])
    arm, force = n["drive_arm"], n["grip_force"]
    n["stroke_required"] = arm * (
        cosine(n["drive_arm_angle_open"]) - cosine(n["drive_arm_angle_at_min"])
    )
    cylinder(n)
    n["roller_force"] = n["drive_force"] / 2
    n["pin_force"] = hypot(n["roller_force"], force)
    lever_moment(n)
    jaws(n)
    drilled_lever(n)
    n["mechanism_length"] = n["grip_arm"] + arm
    reach = max(arm, n["grip_arm"] * sine(n["grip_arm_tilt_open"]))
    n["overall_width"] = n["pivot_spacing"] + 2 * reach + n["lever_thickness"]
    overall(n)
    mount(n)
