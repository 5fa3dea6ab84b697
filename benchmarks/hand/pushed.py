"""Grippers with levers that a rod moves along the axis."""

from math import hypot, sqrt

from hand.drive import cylinder
from hand.grip import grip
from hand.mount import mount, overall
from hand.notebook import (
    Notebook,
    arccosine,
    arcsine,
    arctangent,
    cosine,
    direction,
    sine,
    tangent,
)
from hand.parts import drilled_lever, jaws
from hand.turned import travel

_ENDS = ("at_max", "at_min")
_POSITIONS = ("open", "at_max", "at_min")


def radius_of(n: Notebook, position: str) -> float:
    """Return the distance of a jaw's face from the axis."""
    if position == "at_min":
        return n["diameter_min"] / 2
    return n["diameter_max"] / 2 + (n["release_travel"] if position == "open" else 0.0)


def governing(n: Notebook, driven: float = 2) -> None:
    """Take the larger force ratio; by virtual work the jaws' paths are its part for each jaw."""
    n["force_ratio"] = max(n[f"force_ratio_{one}"] for one in _ENDS)
    n["velocity_ratio"] = n["force_ratio"] / driven


def tangent_slider(n: Notebook) -> None:
    """Solve rockers whose slots move jaws on straight guides, and which a rod pulls."""
    travel(n)
    grip(n)
    n["pivot_offset"] = n["pivot_spacing"] / 2 - n["jaw_offset"]
    offset, arm = n["guide_offset"], n["drive_arm"]
    for one in _POSITIONS:
        n[f"rocker_angle_{one}"] = arctangent((radius_of(n, one) - n["pivot_offset"]) / offset)
    for one in _POSITIONS:
        n[f"drive_arm_angle_{one}"] = 90 + n["drive_arm_tilt"] - n[f"rocker_angle_{one}"]
    for one in _ENDS:
        # F at the jaw is N·cos θ at the slot, at b/cos θ from the pivot; P/2 has l·sin β.
        along = cosine(n[f"rocker_angle_{one}"])
        moment = offset / along**2
        n[f"force_ratio_{one}"] = 2 * moment / (arm * sine(n[f"drive_arm_angle_{one}"]))
    governing(n)
    least = min(cosine(n[f"rocker_angle_{one}"]) for one in _ENDS)
    n["slot_force"] = n["grip_force"] / least
    sideways = max(abs(tangent(n[f"rocker_angle_{one}"])) for one in _ENDS)
    n["guide_force"] = n["grip_force"] * sideways
    n["stroke_required"] = arm * (
        cosine(n["drive_arm_angle_open"]) - cosine(n["drive_arm_angle_at_min"])
    )
    cylinder(n)
    n["joint_force_x"] = n["grip_force"] * max(
        n[f"force_ratio_{one}"] / 2 / n["mechanism_efficiency"] + tangent(n[f"rocker_angle_{one}"])
        for one in _ENDS
    )
    n["lever_bending_moment"] = n["slot_force"] * offset / least / 1000
    n["pin_force"] = max(
        hypot(n["joint_force_x"], n["grip_force"]), n["slot_force"], n["drive_force"] / 2
    )
    jaws(n)
    drilled_lever(n)
    n["mechanism_length"] = n["jaw_overhang"] + offset + arm + n["stroke"]
    open_jaws = n["diameter_min"] + 2 * n["jaw_travel"] + 2 * n["jaw_offset"]
    n["overall_width"] = max(n["pivot_spacing"], open_jaws) + 4 * n["pin_diameter"]
    overall(n)
    mount(n)


def slot_crosshead(n: Notebook) -> None:
    """Solve bell-cranks whose pins a crosshead carries along in transverse slots."""
    travel(n)
    n["pivot_offset"] = n["pivot_spacing"] / 2 - n["jaw_offset"]
    bent_levers(n, n["drive_arm_angle"])
    arm = n["drive_arm"]
    n["slot_force"] = n["grip_force"] * n["force_ratio"] / 2
    n["joint_force_x"], n["joint_force_y"] = n["slot_force"], n["grip_force"]
    n["joint_force"] = hypot(n["joint_force_x"], n["joint_force_y"])
    n["stroke_required"] = arm * (
        cosine(n["drive_arm_angle_open"]) - cosine(n["drive_arm_angle_at_min"])
    )
    cylinder(n)
    lever_moment(n)
    n["pin_force"] = n["joint_force"]
    jaws(n)
    drilled_lever(n)
    inmost = min(sine(n["drive_arm_angle_open"]), sine(n["drive_arm_angle_at_min"]))
    n["slot_length"] = arm * (1 - inmost) + n["pin_diameter"]
    back = arm * cosine(n["drive_arm_angle_open"])
    n["mechanism_length"] = ahead(n) + back + 1.5 * n["pin_diameter"]
    over_jaws = n["diameter_max"] + 2 * n["release_travel"] + 2 * n["jaw_offset"]
    n["overall_width"] = max(
        over_jaws + n["lever_thickness"], n["pivot_spacing"] + 2 * arm + 3 * n["pin_diameter"]
    )
    overall(n)
    mount(n)


def tilts(n: Notebook) -> None:
    """Find the tilts of the grip arm: how far the jaw stands beyond the pivot, over the arm."""
    for one in _POSITIONS:
        beyond = radius_of(n, one) - n["pivot_offset"]
        n[f"grip_arm_tilt_{one}"] = arcsine(beyond / n["grip_arm"])
    if n.asks("finger_spacing"):
        n["finger_spacing"] = 2 * n["pivot_offset"]
        for one in _ENDS:
            n[f"finger_length_{one}"] = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{one}"])


def bent_levers(n: Notebook, drive_arm_angle: float) -> None:
    """Find how bent levers stand, and their force ratios: F at the grip arm, P/2 at the drive arm.

    Args:
        n: the notebook, with the pivots and what the jaws must hold.
        drive_arm_angle: from the drive arm to the axis, in degrees, where the grip arm lies along.
    """
    tilts(n)
    grip(n)
    for one in _POSITIONS:
        n[f"drive_arm_angle_{one}"] = drive_arm_angle - n[f"grip_arm_tilt_{one}"]
    for one in _ENDS:
        jaw = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{one}"])
        n[f"force_ratio_{one}"] = 2 * jaw / (n["drive_arm"] * sine(n[f"drive_arm_angle_{one}"]))
    governing(n)


def ahead(n: Notebook) -> float:
    """Return how far the jaws stand before the pivots, at most."""
    return n["grip_arm"] * max(cosine(n[f"grip_arm_tilt_{one}"]) for one in _ENDS)


def lever_moment(n: Notebook) -> None:
    """Find the bending moment at the pivot, where the arm of the grip force is longest."""
    n["lever_bending_moment"] = n["grip_force"] * ahead(n) / 1000


def link_lever(n: Notebook) -> None:
    """Solve levers that a crosshead turns by links."""
    travel(n)
    fingers = int(n["finger_count"]) if "finger_count" in n else 2
    tilts(n)
    grip(n, fingers)
    arm, link, turned = n["drive_arm"], n["link_length"], dict[str, float]()
    for one in _POSITIONS:
        turned[one] = n["drive_arm_tilt"] + n[f"grip_arm_tilt_{one}"]
        across = n["pivot_offset"] - arm * sine(turned[one]) - n["crosshead_offset"]
        n[f"link_angle_{one}"] = arccosine(across / link)
    for one, name in (("at_max", "link_force"), ("at_min", "link_force_at_min")):
        gamma = n[f"link_angle_{one}"]
        jaw = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{one}"])
        per_force = jaw / (arm * cosine(gamma + turned[one]))  # F1/F by moments about the pivot
        n[f"force_ratio_{one}"] = fingers * per_force * sine(gamma)
        n[name] = n["grip_force"] * per_force
        along, out = n[name] * sine(gamma), n["grip_force"] + n[name] * cosine(gamma)
        if one == "at_max":
            n["joint_force_x"], n["joint_force_y"] = along, out
        n[f"joint_force_{one}"] = hypot(along, out)
    governing(n, fingers)
    n["joint_force"] = max(n["joint_force_at_max"], n["joint_force_at_min"])
    for one in ("open", "at_min"):
        behind = arm * cosine(turned[one]) + link * sine(n[f"link_angle_{one}"])
        n[f"crosshead_distance_{one}"] = behind
    n["stroke_required"] = n["crosshead_distance_open"] - n["crosshead_distance_at_min"]
    cylinder(n)
    lever_moment(n)
    n["pin_force"] = n["joint_force"]
    jaws(n)
    drilled_lever(n)
    n["mechanism_length"] = ahead(n) + n["crosshead_distance_open"] + 1.5 * n["pin_diameter"]
    open_width = n["diameter_max"] + 2 * n["release_travel"]
    arms = 2 * (n["pivot_offset"] - arm * sine(turned["at_min"]))
    n["overall_width"] = max(open_width + 3 * n["lever_thickness"], arms + n["lever_thickness"])
    overall(n)
    mount(n)


def wedge_roller(n: Notebook) -> None:
    """Solve levers with rollers that a wedge, or a cone, spreads."""
    travel(n)
    fingers = int(n["finger_count"]) if "finger_count" in n else 2
    tilts(n)
    grip(n, fingers)
    arm, theta, rho = n["roller_arm"], n["wedge_angle"], n["friction_angle"]
    turned = {one: n["roller_arm_tilt"] + n[f"grip_arm_tilt_{one}"] for one in _POSITIONS}
    lossless = {}
    for one in _ENDS:
        # The force on the roller leans forward from the transverse by θ, with friction by θ + ρ.
        jaw = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{one}"])
        pressed = jaw / (arm * cosine(theta + rho + turned[one]))
        n[f"force_ratio_{one}"] = fingers * pressed * sine(theta + rho)
        lossless[one] = fingers * jaw * sine(theta) / (arm * cosine(theta + turned[one]))
        if one == "at_max":
            n["roller_force"] = n["grip_force"] * pressed
    n["force_ratio"] = max(n[f"force_ratio_{one}"] for one in _ENDS)
    n["velocity_ratio"] = lossless["at_max"] / fingers
    n["wedge_efficiency"] = lossless["at_max"] / n["force_ratio_at_max"]
    n["joint_force_x"] = n["roller_force"] * sine(theta + rho)
    n["joint_force_y"] = n["grip_force"] + n["roller_force"] * cosine(theta + rho)
    n["joint_force"] = hypot(n["joint_force_x"], n["joint_force_y"])
    roller = {
        one: (-arm * cosine(turned[one]), n["pivot_offset"] - arm * sine(turned[one]))
        for one in _POSITIONS
    }
    (open_x, open_y), (x, y) = roller["open"], roller["at_min"]
    n["stroke_required"] = (y - open_y) / tangent(theta) + (x - open_x)
    cylinder(n)
    lever_moment(n)
    n["pin_force"] = n["joint_force"]
    jaws(n)
    drilled_lever(n)
    n["wedge_thickness"] = 2 * (y - n["roller_diameter"] / 2 * cosine(theta))
    n["mechanism_length"] = ahead(n) - open_x + n["roller_diameter"] + n["stroke_required"]
    open_width = n["diameter_max"] + 2 * n["release_travel"]
    n["overall_width"] = max(open_width + 2 * n["lever_thickness"], 2 * y + n["roller_diameter"])
    overall(n)
    mount(n)


def prism_lever(n: Notebook) -> None:
    """Solve levers with prisms fixed to them, turned by a crosshead with transverse slots."""
    travel(n)
    turned_prisms(n)
    grip(n)
    n["lever_torque"] = n["grip_force"] * max(n[f"centre_height_{one}"] for one in _ENDS) / 1000
    arm = n["drive_arm"]
    for one in _ENDS:
        lever = arm * cosine(n["drive_arm_tilt"] + n[f"lever_rotation_{one}"])
        n[f"force_ratio_{one}"] = 2 * n[f"centre_height_{one}"] / lever
    governing(n)
    n["slot_force"] = n["grip_force"] * n["force_ratio"] / 2
    n["stroke_required"] = arm * (
        sine(n["drive_arm_tilt"] + n["lever_rotation_open"])
        - sine(n["drive_arm_tilt"] + n["lever_rotation_at_min"])
    )
    cylinder(n)
    # Across the bisector both faces balance: N1·sin(δ + ε) = N2·sin(δ - ε), together F across.
    delta = 90 - n["prism_angle"] / 2
    n["face_force"] = n["grip_force"] * sine(delta + n["prism_tilt"]) / sine(n["prism_angle"])
    n["lever_bending_moment"] = n["lever_torque"]
    n["pin_force"] = hypot(n["grip_force"], n["slot_force"])
    jaws(n)
    drilled_lever(n)
    n["mechanism_length"] = n["apex_height"] + arm + 1.5 * n["pin_diameter"]
    open_angle = n["nominal_lever_angle"] + n["lever_rotation_open"]
    apex = n["pivot_half_distance"] + n["lever_length"] * sine(open_angle)
    n["overall_width"] = max(
        2 * apex + 3 * n["lever_thickness"],
        2 * (n["pivot_half_distance"] + arm) + 3 * n["pin_diameter"],
    )
    overall(n)
    mount(n)


def turned_prisms(n: Notebook) -> None:
    """Find how levers with prisms turn with the diameter, and where the object's centre goes."""
    half, gamma, length = n["prism_angle"] / 2, n["attachment_angle"], n["lever_length"]
    beside = n["pivot_half_distance"]
    n["nominal_lever_angle"] = 90 - half - gamma
    nominal = n["nominal_lever_angle"]
    n["nominal_diameter"] = 2 * (beside + length * sine(nominal)) * sine(half)
    n["apex_height"] = length * cosine(nominal)
    n["arm_far_part"] = length * cosine(180 - 2 * half - gamma)
    n["arm_near_part"] = length * cosine(gamma)
    for one in _POSITIONS:
        diameter = 2 * radius_of(n, one)
        n[f"apex_offset_{one}"] = diameter / (2 * sine(half)) - length * sine(nominal)
        reduced = n[f"apex_offset_{one}"]
        reach = sqrt(reduced**2 + n["apex_height"] ** 2)
        n[f"lever_rotation_{one}"] = arccosine(beside / reach) - direction(
            n["apex_height"], reduced
        )
        if one == "open":
            continue
        n[f"arm_shift_{one}"] = diameter / 2 / tangent(half)
        n[f"arm_far_{one}"] = n["arm_far_part"] + n[f"arm_shift_{one}"]
        n[f"arm_near_{one}"] = n["arm_near_part"] - n[f"arm_shift_{one}"]
        epsilon = n[f"lever_rotation_{one}"]
        omega = nominal + epsilon
        across = beside + length * sine(omega)
        n[f"centre_height_{one}"] = length * cosine(omega) + across * tangent(epsilon)
        n[f"centre_error_{one}"] = n[f"centre_height_{one}"] - n["apex_height"]
    n["prism_tilt"] = max(abs(n[f"lever_rotation_{one}"]) for one in _ENDS)
