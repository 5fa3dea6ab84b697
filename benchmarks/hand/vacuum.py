"""Suction cups on a frame: the load that each bears, their size, the ejector and the frame."""

from math import hypot, log, pi, sqrt

from hand.beam import beam, sheet_mass, wrist
from hand.mount import flange
from hand.notebook import Notebook


def vacuum_cups(n: Notebook) -> None:
    """Solve a gripper with suction cups."""
    sheet_mass(n)
    off, along = loads(n)
    layout(n)
    demand(n, off, along)
    air(n)
    cups(n)
    ejector(n)
    beam(n)
    cross_beam(n)
    frame(n)
    moments(n, off, along)
    flange(n)


def loads(n: Notebook) -> tuple[float, float]:
    """Return what pulls the object off the cups, and what shifts it along them, in N."""
    mass, g, case = n["mass"], n["gravity"], n.option("load_case")
    if case == "lift":
        off, along = mass * (g + n["acceleration"]), 0.0
    elif case == "sideways":
        off, along = mass * g, mass * n["acceleration"]
    elif case == "combined":
        off, along = mass * (g + n["acceleration"]), mass * n["acceleration_sideways"]
    elif case == "vertical":
        off, along = 0.0, mass * (g + n["acceleration"])
    else:
        off = mass * n["acceleration_normal"]
        along = mass * hypot(g + n["acceleration"], n["acceleration_sideways"])
    if along:
        n["shear_load"] = along
        along = n["shear_load"]
    n["lifting_load"] = hypot(off, along)
    by_friction = along / n["friction"] if along else 0.0
    n["holding_force"] = n["safety_factor"] * (off + by_friction)
    return off, along


def layout(n: Notebook) -> None:
    """Put a cup into the middle of each equal share of the object."""
    columns, rows = n["cup_columns"], n["cup_rows"]
    n["cup_count"] = columns * rows
    n["cup_pitch_x"] = n["object_length"] / columns
    n["cup_pitch_y"] = n["object_width"] / rows
    n["cup_x"] = n["cup_pitch_x"] * (columns - 1) / 2
    n["cup_y"] = n["cup_pitch_y"] * (rows - 1) / 2
    xs = [n["cup_pitch_x"] * (i - (columns - 1) / 2) for i in range(int(columns))]
    ys = [n["cup_pitch_y"] * (i - (rows - 1) / 2) for i in range(int(rows))]
    n["tilt_square_sum"] = rows * sum(one**2 for one in xs) / 1e6
    n["turn_square_sum"] = sum(x**2 + y**2 for x in xs for y in ys) / 1e6


def demand(n: Notebook, off: float, along: float) -> None:
    """Find the share of the most loaded cup, in the pull and in the shift."""
    count, offset = n["cup_count"], n["load_offset"]
    if off:
        tilted = offset * n["cup_x"] / (1e6 * n["tilt_square_sum"])
        n["tilt_share"] = 1 / count + tilted
    if along:
        # The shift acts across the offset: its moment adds to it along, and pushes sideways.
        per = offset / (1e6 * n["turn_square_sum"])
        n["turn_share"] = hypot(1 / count + per * n["cup_x"], per * n["cup_y"])
    pull = off * n["tilt_share"] if off else 0.0
    shift = along * n["turn_share"] / n["friction"] if along else 0.0
    n["cup_demand"] = n["safety_factor"] * (pull + shift)
    n["cup_force"] = n["holding_force"] / count
    if off:
        n["column_share"] = n["cup_rows"] * n["tilt_share"]
    else:
        per = offset / (1e6 * n["turn_square_sum"])
        n["column_share"] = n["cup_rows"] * (1 / count + per * n["cup_x"])


def air(n: Notebook) -> None:
    """Find the pressures, in kPa: 12.5 mbar less for each 100 m."""
    n["atmospheric_pressure"] = 101.325 - 1.25 * n["altitude"] / 100
    n["residual_pressure"] = n["atmospheric_pressure"] - n["vacuum"]


def held(n: Notebook, area: float, vacuum: float) -> float:
    """Return what a cup holds, in N, by its outer area in mm² and its vacuum in kPa."""
    outside, inside = n["atmospheric_pressure"] / 1000, n["atmospheric_pressure"] / 1000
    inside -= vacuum / 1000
    model = n.option("vacuum_model")
    if model == "classical":
        pressure = (n["atmosphere_factor"] * outside - inside) / n["leak_factor"]
        return n["seal_factor"] * area * pressure
    if model == "lip":
        return area * (outside - inside * n["lip_ratio"] ** 2)
    return area * vacuum / 1000


def cups(n: Notebook) -> None:
    """Choose cups as if all bore the same, then by the most loaded one; set the switch."""
    per_area = held(n, 1.0, n["vacuum"])
    n["cup_area_required"] = n["cup_force"] / per_area / 100
    n["cup_diameter_required"] = sqrt(400 * n["cup_area_required"] / pi)
    n.choose("cup_diameter_first", "diameters of suction cups", n["cup_diameter_required"])
    first = n["cup_diameter_first"]
    if n.option("vacuum_model") == "lip":
        n["lip_outer_area"] = pi * first**2 / 400
        n["lip_inner_area"] = n["lip_outer_area"] * n["lip_ratio"] ** 2
    n["cup_force_actual"] = held(n, pi * first**2 / 4, n["vacuum"])
    n["cup_ok"] = n["cup_force_actual"] >= n["cup_demand"]
    larger = first * sqrt(n["cup_demand"] / n["cup_force_actual"])
    n.choose("cup_diameter", "diameters of suction cups", max(first, larger))
    area = pi * n["cup_diameter"] ** 2 / 4
    n["holding_force_actual"] = (
        n["cup_count"] * n["cup_force_actual"] * (n["cup_diameter"] / first) ** 2
    )
    n["safety_actual"] = n["safety_factor"] * n["holding_force_actual"] / n["holding_force"]
    # What a cup holds grows evenly with the vacuum.
    none, full = held(n, area, 0.0), held(n, area, n["vacuum"])
    n["vacuum_required"] = n["vacuum"] * (n["cup_demand"] - none) / (full - none)
    n.choose("vacuum_setting", "settings of vacuum switches", n["vacuum_required"])
    n["setting_has_reserve"] = n["vacuum_setting"] <= 0.8 * n["vacuum"]


def ejector(n: Notebook) -> None:
    """Choose ejector and hose, and see how long the vacuum takes."""
    flows, table = "volume flow of a cup", "single-stage vacuum ejectors"
    n["suction_per_cup"] = n.row_not_below(flows, "cup diameter", n["cup_diameter"], "flow")
    n["suction_flow"] = n["cup_count"] * n["suction_per_cup"]
    n["ejector_suction"] = n.row_not_below(table, "suction", n["suction_flow"], "suction")
    suction = n["ejector_suction"]
    n["ejector_nozzle"] = n.row(table, "suction", suction, "nozzle")
    n["air_consumption"] = n.row(table, "suction", suction, "air")
    flow = suction * 1e6 / 60  # mm³/s
    n["hose_bore_required"] = sqrt(4 * flow / (pi * n["air_speed"] * 1000))
    n.choose("hose_bore", "inner diameters of vacuum hoses", n["hose_bore_required"])
    diameter = n["cup_diameter"]
    n["cup_volume"] = pi * diameter**2 / 4 * (diameter / 8) / 3 / 1000
    hose = pi * n["hose_bore"] ** 2 / 4 * n["hose_length"]  # mm²·m is cm³
    n["evacuated_volume"] = n["cup_count"] * n["cup_volume"] + hose
    emptied = log(n["atmospheric_pressure"] / n["residual_pressure"])
    n["evacuation_time_ideal"] = n["evacuated_volume"] * 1000 / flow * emptied
    n["evacuation_time"] = 1.3 * n["evacuation_time_ideal"]
    n["air_per_grip"] = n["air_consumption"] * n["evacuation_time"] / 60
    late = n["evacuation_time"] / n["evacuation_time_allowed"]
    n["evacuation_ok"] = late <= 1
    n["suction_needed"] = suction * max(late, 1.0)
    n.choose("ejector_count", "numbers of ejectors", late)


def cross_beam(n: Notebook) -> None:
    """Size the most loaded cross-beam, which bears one column of cups."""
    load, width = n["lifting_load"] * n["column_share"], n["object_width"]
    n["cross_moment"] = load * width / 8 / 1000
    strong = 6000 * n["cross_moment"] / (n["cross_width"] * n["bending_stress_allowed"])
    n["cross_height_by_strength"] = sqrt(strong)
    sinks = 12 * load * width**3 / (128 * n["elastic_modulus_beam"] * n["cross_width"])
    n["cross_height_by_stiffness"] = (sinks / n["deflection_allowed"]) ** (1 / 3)
    least = max(n["cross_height_by_strength"], n["cross_height_by_stiffness"])
    n.choose("cross_height", "Ra10", least)


def frame(n: Notebook) -> None:
    """Find the overall sizes."""
    n["cup_height"] = 0.4 * n["cup_diameter"]
    n["cup_edge_x"], n["cup_edge_y"] = n["cup_pitch_x"] / 2, n["cup_pitch_y"] / 2
    n["overall_length"] = (
        n["cup_height"] + n["fitting_height"] + n["cross_height"] + n["beam_height"]
    )
    n["frame_length"] = 2 * n["cup_x"] + n["cup_diameter"]
    n["overall_width"] = 2 * n["cup_y"] + n["cup_diameter"]


def moments(n: Notebook, off: float, along: float) -> None:
    """Find the moments at the flange: the pull at the offset, the shift at the cups' face."""
    offset, length = n["load_offset"], n["overall_length"]
    n["mount_bending"] = (off * offset + along * length) / 1000
    if along:
        n["mount_torque"] = along * offset / 1000
    else:
        wrist(n)
