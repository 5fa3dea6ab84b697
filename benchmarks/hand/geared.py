"""Grippers whose jaws racks, gears, a wedge with slots or a cylinder across the axis move."""

from math import degrees, hypot, pi, radians

from hand.drive import cylinder, motor_of
from hand.grip import grip
from hand.mount import mount, overall
from hand.notebook import Notebook, arcsine, cosine, sine, tangent
from hand.parts import drilled_lever, jaws, plain_finger
from hand.pushed import governing, tilts
from hand.turned import travel


def rack_parallelogram(n: Notebook) -> None:
    """Solve a rack that turns two sectors with arms; parallelograms keep the jaws upright."""
    travel(n)
    grip(n)
    arm, force = n["arm_length"], n["grip_force"]
    gripped = (n["diameter_max"] - n["diameter_min"]) / 2
    # With the smallest object the arms lie along the axis.
    for one, out in (("open", n["jaw_travel"]), ("at_max", gripped), ("at_min", 0.0)):
        n[f"arm_angle_{one}"] = arcsine(out / arm)
    n["gear_torque"] = force * arm / 1000
    torque = 1000 * n["gear_torque"] * n["load_factor"] * teeth_factor(n)
    strength = n["gear_teeth"] ** 2 * n["face_width_factor"] * n["tooth_stress_allowed"]
    n["module_required"] = 1.4 * (torque / strength) ** (1 / 3)
    gear(n)
    for one in ("at_max", "at_min"):
        n[f"force_ratio_{one}"] = 2 * arm * cosine(n[f"arm_angle_{one}"]) / n["pitch_radius"]
    governing(n)
    n["stroke_required"] = n["pitch_radius"] * radians(n["arm_angle_open"])
    cylinder(n)
    n["tooth_force"] = 1000 * n["gear_torque"] / n["pitch_radius"]
    n["joint_force"] = hypot(n["tooth_force"], force - n["tooth_force"] * tangent(20))
    n["jaw_pin_force"] = force
    n["pin_force"] = max(n["joint_force"], n["jaw_pin_force"])
    n["lever_bending_moment"] = force * (arm - n["pitch_radius"]) / 1000
    jaws(n)
    plain_finger(n)
    n["rack_height"] = 5 * n["module"]
    n["pivot_spacing"] = max(
        2 * n["pitch_radius"] + n["rack_height"], n["diameter_min"] + 2 * n["lever_thickness"]
    )
    n["mechanism_length"] = arm + n["pitch_radius"] + n["rack_height"] + n["stroke"]
    over_arms = n["pivot_spacing"] + 2 * arm * sine(n["arm_angle_open"])
    n["overall_width"] = over_arms + 2 * n["pin_spacing"] + n["lever_thickness"]
    overall(n)
    mount(n)


def teeth_factor(n: Notebook) -> float:
    """Return the form factor of the teeth, where it is not given."""
    if n.asks("tooth_form_factor"):
        n["tooth_form_factor"] = 3.47 + 13.2 / n["gear_teeth"]
    return n["tooth_form_factor"]


def gear(n: Notebook) -> None:
    """Accept a module, and size the gear by it."""
    n.choose("module", "modules of gears, GOST 9563-60, row 1", n["module_required"])
    diameter = n["module"] * n["gear_teeth"]
    n["pitch_radius"] = diameter / 2
    n["face_width"] = n["face_width_factor"] * diameter


def pinion_racks(n: Notebook) -> None:
    """Solve two racks with jaws, one driven, and a pinion between them."""
    travel(n)
    grip(n)
    force, teeth = n["grip_force"], n["gear_teeth"]
    n["force_ratio"], n["velocity_ratio"] = 2.0, 1.0
    # m = 1.4·∛(T·K·Y/(z²·ψ·[σ])) with T = F·m·z/2 has m on both sides: m² remains.
    bent = force * n["load_factor"] * teeth_factor(n)
    strength = 2 * teeth * n["face_width_factor"] * n["tooth_stress_allowed"]
    n["module_required"] = (1.4**3 * bent / strength) ** 0.5
    gear(n)
    n["gear_torque"] = force * n["pitch_radius"] / 1000
    n["pinion_turn_at_max"] = degrees(n["release_travel"] / n["pitch_radius"])
    n["pinion_turn"] = degrees(n["jaw_travel"] / n["pitch_radius"])
    n["stroke_required"] = n["jaw_travel"]
    cylinder(n)
    n["pin_force"] = 2 * force
    n["lever_bending_moment"] = force * n["jaw_overhang"] / 1000
    jaws(n)
    plain_finger(n, n["face_width"], eye=False)
    n["rack_length"] = n["jaw_travel"] + 4 * pi * n["module"]
    axle = 3.75 * n["module"] + n["pitch_radius"]
    n["overall_length"] = n["jaw_overhang"] + axle + n["body_length"]
    n["drive_length"] = n["stroke"] + 1.5 * n["bore"]
    sides = n["diameter_min"] + 2 * n["jaw_travel"] + 2 * n["lever_thickness"]
    n["overall_width"] = sides + n["stroke"] + n["drive_length"]
    mount(n)


def wedge_slide(n: Notebook) -> None:
    """Solve a wedge whose slots draw jaws on straight guides together."""
    travel(n)
    grip(n)
    theta, rho, force = n["wedge_angle"], n["friction_angle"], n["grip_force"]
    for one in ("at_max", "at_min"):  # alike: a wedge's angle does not change
        n[f"force_ratio_{one}"] = 2 * tangent(theta + rho)
    n["force_ratio"] = max(n["force_ratio_at_max"], n["force_ratio_at_min"])
    n["velocity_ratio"] = tangent(theta)
    n["wedge_efficiency"] = tangent(theta) / tangent(theta + rho)
    n["stroke_required"] = n["jaw_travel"] / tangent(theta)
    n["rod_path_at_max"] = n["release_travel"] / tangent(theta)
    gripped = (n["diameter_max"] - n["diameter_min"]) / 2
    n["velocity_ratio_range"] = gripped / (n["stroke_required"] - n["rod_path_at_max"])
    if n.option("drive") == "electric":
        ball_screw(n)
    else:
        cylinder(n)
        n["drive_length"] = n["stroke"] + 1.5 * n["bore"]
    # Normal and friction together lean by ρ; across the axis they come to F.
    n["wedge_force"] = force / cosine(theta + rho) * cosine(rho)
    n["slot_contact_required"] = n["wedge_force"] / (n["slot_width"] * n["slot_pressure_allowed"])
    n.choose("slot_contact", "Ra20", n["slot_contact_required"])
    n["wedge_length"] = n["slot_contact"] * cosine(theta) + n["stroke_required"]
    n["pin_force"] = n["drive_force"]
    n["lever_bending_moment"] = force * n["jaw_overhang"] / 1000
    jaws(n)
    plain_finger(n, eye=False)
    n["mechanism_length"] = n["jaw_overhang"] + n["wedge_length"]
    n["overall_length"] = n["mechanism_length"] + n["drive_length"]
    n["overall_width"] = n["diameter_min"] + 2 * n["jaw_travel"] + 2 * n["lever_thickness"]
    mount(n)


def ball_screw(n: Notebook) -> None:
    """Size an actuator with a ball screw, its reducer and its motor."""
    n["drive_force"] = n["grip_force"] * n["force_ratio"] / n["mechanism_efficiency"]
    n["force_gain"] = n["grip_force"] / n["drive_force"]
    lead = n["screw_lead"]
    n["drive_torque"] = n["drive_force"] * lead / (2 * pi * n["screw_efficiency"]) / 1000
    n["shaft_turns"] = n["stroke_required"] / lead
    n["jaw_speed"] = n["jaw_travel"] / n["closing_time"]
    mechanism = n["wedge_efficiency"] * n["mechanism_efficiency"] * n["screw_efficiency"]
    n["total_efficiency"] = mechanism * n["drive_efficiency"]
    motor_of(n)
    n["drive_force_actual"] = n["drive_force"] * n["shaft_torque_actual"] / n["drive_torque"]
    n["drive_length"] = 2 * n["stroke_required"] + 8 * lead


def cross_cylinder(n: Notebook) -> None:
    """Solve a cylinder that draws two levers together across the axis."""
    travel(n)
    n["pivot_offset"] = n["pivot_spacing"] / 2 - n["jaw_offset"]
    tilts(n)
    grip(n)
    arm, psi = n["drive_arm"], n["drive_arm_tilt"]
    for one in ("open", "at_max", "at_min"):
        n[f"cylinder_angle_{one}"] = 90 - psi - n[f"grip_arm_tilt_{one}"]
    for one in ("at_max", "at_min"):
        jaw = n["grip_arm"] * cosine(n[f"grip_arm_tilt_{one}"])
        n[f"force_ratio_{one}"] = jaw / (arm * sine(n[f"cylinder_angle_{one}"]))
    governing(n)
    for one in ("open", "at_min"):
        apart = n["pivot_spacing"] + 2 * arm * cosine(n[f"cylinder_angle_{one}"])
        n[f"cylinder_span_{one}"] = apart
    n["stroke_required"] = n["cylinder_span_open"] - n["cylinder_span_at_min"]
    cylinder(n)
    n["joint_force"] = n["drive_force"] - n["grip_force"]
    n["pin_force"] = n["drive_force"]
    tilt, force = n["grip_arm_tilt_at_max"], n["grip_force"]
    beyond = force * (n["grip_arm"] - arm * cosine(psi)) * cosine(tilt)
    before = beyond + n["drive_force"] * arm * sine(psi) * sine(tilt)
    n["lever_bending_moment"] = max(abs(beyond), abs(before)) / 1000
    jaws(n)
    drilled_lever(n)
    n["drive_length"] = n["stroke"] + 1.5 * n["bore"]
    n["overall_length"] = n["grip_arm"] + n["body_length"]
    reach = max(
        n["grip_arm"] * sine(n["grip_arm_tilt_open"]), arm * cosine(n["cylinder_angle_open"])
    )
    n["overall_width"] = n["pivot_spacing"] + 2 * reach + n["lever_thickness"]
    mount(n)
