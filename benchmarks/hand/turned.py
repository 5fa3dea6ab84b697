"""Grippers that a motor turns: a screw with two halves, and a worm between two sectors."""

from math import atan, cos, degrees, hypot, pi, radians, sqrt

from hand.drive import backwards, motor
from hand.grip import grip
from hand.mount import mount
from hand.notebook import Notebook, arcsine, arctangent, cosine, tangent
from hand.parts import jaws, plain_finger

_THREADS = "trapezoidal threads"


def travel(n: Notebook) -> None:
    """Find how far a jaw goes from open to the smallest object."""
    n["jaw_travel"] = (n["diameter_max"] - n["diameter_min"]) / 2 + n["release_travel"]


def screw(n: Notebook) -> None:
    """Solve a gripper with a right-hand and a left-hand screw."""
    travel(n)
    grip(n)
    force = n["grip_force"]
    # The jaw tips in its guide: F at the overhang against a couple at the ends of the slide.
    n["guide_reaction"] = force * n["jaw_overhang"] / n["guide_length"]
    n["nut_force"] = force + 2 * n["guide_friction"] * n["guide_reaction"]
    first_thread(n)
    accepted_thread(n)
    screw_drive(n)
    n["lever_bending_moment"] = force * n["jaw_overhang"] / 1000
    n["pin_force"] = force / 2 + force * n["jaw_overhang"] / n["pin_spacing"]
    jaws(n)
    plain_finger(n)
    n["overall_length"] = n["jaw_overhang"] + n["body_length"]
    sides = max(n["nut_height"], n["guide_length"])
    n["overall_width"] = (
        n["diameter_min"] + 2 * n["jaw_travel"] + 2 * sides + 4 * n["thread_diameter"]
    )
    mount(n)


def first_thread(n: Notebook) -> None:
    """Choose a thread by wear and check the screw as a bar that is pulled and twisted."""
    height = 0.5  # of the profile, in pitches
    pressed = n["nut_force"] / n["thread_pressure_allowed"]  # mm²: π·d2·(H/P)·0.5·P
    n["pitch_diameter_required"] = sqrt(pressed / (pi * height * n["nut_height_factor"]))
    n["thread_diameter_first"] = n.row_not_below(
        _THREADS, "pitch diameter", n["pitch_diameter_required"], "diameter d"
    )
    flank = n["thread_friction"] / cosine(15)
    n["thread_friction_angle"] = arctangent(flank)
    first = n["thread_diameter_first"]
    pitch, middle, core = (
        n.row(_THREADS, "diameter d", first, one) for one in ("pitch P", "pitch dia", "core dia")
    )
    lead = degrees(atan(pitch / (pi * middle)))
    turned = n["nut_force"] * middle * tangent(lead + n["thread_friction_angle"])
    n["screw_torque_first"] = turned / 1000
    pull = n["nut_force"] / (pi * core**2 / 4)
    twist = 1000 * n["screw_torque_first"] / (pi * core**3 / 16)
    n["screw_stress"] = sqrt(pull**2 + 3 * twist**2)
    n["screw_ok"] = n["screw_stress"] <= n["screw_stress_allowed"]
    over = n["screw_stress"] / n["screw_stress_allowed"]
    n["core_diameter_required"] = core * sqrt(over)


def accepted_thread(n: Notebook) -> None:
    """Choose the thread that carries strength too, and read its row."""
    by_core = n.row_not_below(_THREADS, "core diameter", n["core_diameter_required"], "diameter d")
    n["thread_diameter"] = max(by_core, n["thread_diameter_first"])
    for name, column in (
        ("thread_pitch", "pitch P"),
        ("thread_pitch_diameter", "pitch dia"),
        ("core_diameter", "core dia"),
    ):
        n[name] = n.row(_THREADS, "diameter d", n["thread_diameter"], column)
    n["nut_height"] = n["nut_height_factor"] * n["thread_pitch_diameter"]
    bearing = pi * n["thread_pitch_diameter"] * 0.5 * n["nut_height"]
    n["thread_pressure"] = n["nut_force"] / bearing


def screw_drive(n: Notebook) -> None:
    """Find torque, efficiency and turns of the screw, then its motor."""
    middle, pitch, angle = (
        n["thread_pitch_diameter"],
        n["thread_pitch"],
        n["thread_friction_angle"],
    )
    n["lead_angle"] = arctangent(pitch / (pi * middle))
    arm = middle * tangent(n["lead_angle"] + angle)  # both halves, each d2/2
    n["torque_ratio"] = n["nut_force"] / n["grip_force"] * arm
    n["velocity_ratio"] = pitch / (2 * pi)
    n["shaft_turns_at_max"] = n["release_travel"] / pitch
    n["shaft_turns"] = n["jaw_travel"] / pitch
    n["jaw_speed"] = n["jaw_travel"] / n["closing_time"]
    # Of a radian's work T, two jaws give back F·p/2π each.
    n["mechanism_efficiency"] = 2 * n["velocity_ratio"] / n["torque_ratio"]
    n["drive_torque"] = n["grip_force"] * n["torque_ratio"] / 1000
    held = n["nut_force"] * middle * tangent(n["lead_angle"]) / 1000
    n["brake_torque"] = backwards(held, n["lead_angle"], angle)
    motor(n, angle)


def worm_sector(n: Notebook) -> None:
    """Solve a gripper whose worm swings two levers by sectors of a worm wheel."""
    travel(n)
    grip(n)
    n["worm_ratio"] = n["sector_teeth"] / n["worm_starts"]
    n["lead_angle"] = arctangent(n["worm_starts"] / n["worm_diameter_factor"])
    sector(n)
    swung_levers(n)
    arm = n["grip_arm"]
    per_jaw = {end: arm * cosine(n[f"grip_arm_tilt_{end}"]) for end in ("at_max", "at_min")}
    for end, one in per_jaw.items():
        n[f"torque_ratio_{end}"] = 2 * one / n["worm_ratio"]
    n["torque_ratio"] = max(n["torque_ratio_at_max"], n["torque_ratio_at_min"])
    n["velocity_ratio"] = max(per_jaw.values()) / n["worm_ratio"]
    worm_drive(n)
    n["lever_bending_moment"] = n["grip_force"] * (arm - n["pitch_radius"]) / 1000
    n["tooth_force"] = 1000 * n["sector_torque"] / n["pitch_radius"]
    outward = n["grip_force"] + n["tooth_force"] * tangent(20)
    n["pin_force"] = hypot(n["tooth_force"], outward)
    jaws(n)
    plain_finger(n)
    n["overall_length"] = arm + n["body_length"]
    open_ends = 2 * arm * sin_of(n["grip_arm_tilt_open"])
    n["overall_width"] = n["pivot_spacing"] + open_ends + n["lever_thickness"]
    mount(n)


def sector(n: Notebook) -> None:
    """Size the teeth of a sector."""
    teeth = n["sector_teeth"]
    n["equivalent_teeth"] = teeth / cos(radians(n["lead_angle"])) ** 3
    table = "teeth of worm wheels"
    n["tooth_form_factor"] = n.between_rows(table, "equivalent", n["equivalent_teeth"], "YF")
    n["sector_torque"] = n["grip_force"] * n["grip_arm"] / 1000
    bent = 1.5 * 1000 * n["sector_torque"] * n["load_factor"] * n["tooth_form_factor"]
    strength = teeth * n["worm_diameter_factor"] * n["tooth_stress_allowed"]
    n["module_required"] = (bent / strength) ** (1 / 3)
    n.choose("module", "modules of worm gears", n["module_required"])
    n["pivot_spacing"] = n["module"] * (n["worm_diameter_factor"] + teeth)
    n["pitch_radius"] = n["module"] * teeth / 2


def swung_levers(n: Notebook) -> None:
    """Find how far the levers swing out: their jaw pins stand at half a diameter and the offset."""
    n["pivot_offset"] = n["pivot_spacing"] / 2 - n["jaw_offset"]
    for end, radius in (
        ("open", n["diameter_max"] / 2 + n["release_travel"]),
        ("at_max", n["diameter_max"] / 2),
        ("at_min", n["diameter_min"] / 2),
    ):
        n[f"grip_arm_tilt_{end}"] = arcsine((radius - n["pivot_offset"]) / n["grip_arm"])


def worm_drive(n: Notebook) -> None:
    """Find speeds and torques of the worm, then its motor."""
    lead, angle = n["lead_angle"], n["thread_friction_angle"]
    n["mechanism_efficiency"] = tangent(lead) / tangent(lead + angle)
    swing = n["grip_arm_tilt_open"] - n["grip_arm_tilt_at_min"]
    n["shaft_turns"] = swing / 360 * n["worm_ratio"]
    turning = radians(swing) / n["closing_time"] * n["worm_ratio"]  # of the worm, rad/s
    n["jaw_speed"] = turning * n["velocity_ratio"]
    lossless = n["grip_force"] * n["torque_ratio"] / 1000
    n["drive_torque"] = lossless / n["mechanism_efficiency"]
    n["brake_torque"] = backwards(lossless, lead, angle)
    motor(n, angle)


def sin_of(angle: float) -> float:
    """Return the sine of an angle in degrees."""
    return cosine(90 - angle)
