"""Electromagnets on a beam: poles, windings, iron and the beam."""

from math import pi, sqrt

from hand.beam import beam, sheet_mass, wrist
from hand.mount import flange
from hand.notebook import Notebook


def electromagnet(n: Notebook) -> None:
    """Solve a gripper with two-pole electromagnets."""
    sheet_mass(n)
    n["lifting_load"] = n["mass"] * (n["gravity"] + n["acceleration"])
    sheared = n.option("load_case") == "shear"
    pressed = n["lifting_load"] / (n["friction"] if sheared else 1.0)
    n["holding_force"] = n["safety_factor"] * pressed
    poles(n)
    winding(n)
    heat(n)
    force(n)
    iron(n)
    beam(n)
    n["magnet_length"] = n["pole_spacing"] + n["core_diameter"] + 2 * n["coil_thickness"]
    n["magnet_height"] = n["core_length"] + n["yoke_height"]
    n["frame_length"] = 2 * n["magnet_x"] + n["magnet_length"]
    across = n["core_diameter"] + 2 * n["coil_thickness"]
    n["overall_width"] = max(across, n["beam_width"])
    n["overall_length"] = n["magnet_height"] + n["beam_height"]
    arm = n["overall_length"] if sheared else n["load_offset"]
    n["mount_bending"] = n["lifting_load"] * arm / 1000
    if sheared:
        n["mount_torque"] = n["lifting_load"] * n["load_offset"] / 1000
    else:
        wrist(n)
    flange(n)


def poles(n: Notebook) -> None:
    """Size the cores as if all poles bore the same, then by the most loaded one."""
    n["pole_count"] = 2 * n["magnet_count"]
    n["magnet_pitch"] = n["object_length"] / n["magnet_count"]
    n["magnet_x"] = n["magnet_pitch"] * (n["magnet_count"] - 1) / 2
    n["equivalent_gap"] = 2 * n["air_gap"] + n["iron_path"] / n["permeability"]
    n["pole_force_required"] = n["holding_force"] / n["pole_count"]
    pull = n["flux_density_design"] ** 2 / (2 * n["magnetic_constant"]) / 1e6  # N/mm²
    n["pole_area_required"] = n["pole_force_required"] / pull
    n["core_diameter_required"] = sqrt(4 * n["pole_area_required"] / pi)
    n.choose("core_diameter_first", "Ra10", n["core_diameter_required"])
    first = n["core_diameter_first"]
    n["pole_force_first"] = pull * pi * first**2 / 4
    between = 1.25 * first + 2 * n["coil_thickness"] + n["coil_clearance"]
    n["pole_spacing_required"] = between
    n.choose("pole_spacing", "Ra20", n["pole_spacing_required"])
    n["outer_pole_x"] = n["magnet_x"] + n["pole_spacing"] / 2
    count = int(n["magnet_count"])
    middles = [n["magnet_pitch"] * (i - (count - 1) / 2) for i in range(count)]
    half = n["pole_spacing"] / 2
    squares = sum((one + side) ** 2 for one in middles for side in (half, -half))
    n["pole_square_sum"] = squares / 1e6
    # Pulled off, the beam tilts; along the faces the load turns the plate about the axis.
    n["pole_share"] = 1 / n["pole_count"] + n["load_offset"] * n["outer_pole_x"] / squares
    n["pole_demand"] = n["holding_force"] * n["pole_share"]
    n["pole_ok"] = n["pole_force_first"] >= n["pole_demand"]
    larger = first * sqrt(n["pole_demand"] / n["pole_force_first"])
    n.choose("core_diameter", "Ra20", max(first, larger))
    n["pole_area"] = pi * n["core_diameter"] ** 2 / 4


def winding(n: Notebook) -> None:
    """Wind the coils: wire by the ampere-turns, turns by the current density."""
    gap = n["equivalent_gap"] / 1000
    n["ampere_turns_required"] = n["flux_density_design"] * gap / n["magnetic_constant"]
    n["turn_length"] = pi * (n["core_diameter"] + n["coil_thickness"])
    turn = n["turn_length"] / 1000
    volts, rho = n["supply_voltage"], n["resistivity"]
    # U = I·R = I·ρ·N·l/q, and I·N is what is wanted.
    n["wire_area_required"] = rho * turn * n["ampere_turns_required"] / volts
    n["wire_diameter_required"] = sqrt(4 * n["wire_area_required"] / pi)
    n.choose("wire_diameter", "diameters of winding wire", n["wire_diameter_required"])
    n["wire_area"] = pi * n["wire_diameter"] ** 2 / 4
    n["turns_required"] = volts / (rho * turn * n["current_density_allowed"])
    n.choose("turns", "preferred numbers", n["turns_required"])
    n["coil_resistance"] = rho * n["turns"] * turn / n["wire_area"]
    n["coil_current"] = volts / n["coil_resistance"]
    n["ampere_turns"] = n["turns"] * n["coil_current"]
    n["current_density"] = n["coil_current"] / n["wire_area"]
    n["coil_power"] = volts * n["coil_current"]
    n["total_power"] = n["magnet_count"] * n["coil_power"]


def heat(n: Notebook) -> None:
    """Find the room that the coils take and how warm they get."""
    copper = n["turns"] * n["wire_area"] / 2  # mm² in one coil
    n["coil_height"] = copper / (n["fill_factor"] * n["coil_thickness"])
    outer = n["core_diameter"] + 2 * n["coil_thickness"]
    n["cooling_surface"] = 2 * pi * outer * n["coil_height"] / 100
    watts = n["coil_power"] * n["duty_factor"] / 100
    n["temperature_rise"] = watts / (n["heat_transfer"] * n["cooling_surface"] / 1e4)
    n["heating_ok"] = n["temperature_rise"] <= n["temperature_rise_allowed"]
    cool = n["temperature_rise_allowed"] / n["temperature_rise"]
    n["duty_factor_possible"] = n["duty_factor"] * min(cool, 1.0)


def force(n: Notebook) -> None:
    """Find the flux density of the finished winding, and what the poles hold."""
    gap = n["equivalent_gap"] / 1000
    n["flux_density"] = n["magnetic_constant"] * n["ampere_turns"] / gap
    pull = n["flux_density"] ** 2 / (2 * n["magnetic_constant"]) / 1e6
    n["pole_force"] = pull * n["pole_area"]
    n["holding_force_actual"] = n["pole_count"] * n["pole_force"]


def iron(n: Notebook) -> None:
    """Size yoke and core, and see what the plate lets through."""
    flux = n["flux_density"] * n["pole_area"] / n["flux_density_allowed"]  # mm² of steel
    n["yoke_height_required"] = flux / n["core_diameter"]
    n.choose("yoke_height", "Ra20", n["yoke_height_required"])
    n["core_length"] = 1.1 * n["coil_height"]
    n["iron_path_actual"] = 2 * n["core_length"] + n["yoke_height"] + 2 * n["pole_spacing"]
    n["plate_thickness_required"] = flux / (pi * n["core_diameter"] / 2)
    thick = n["object_thickness"] / n["plate_thickness_required"]
    n["plate_ok"] = thick >= 1
    n["pole_force_possible"] = n["pole_force"] * min(thick, 1.0) ** 2
