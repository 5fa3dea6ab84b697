"""The beam that carries cups or magnets, and the flange behind it."""

from math import sqrt

from hand.notebook import Notebook


def beam(n: Notebook) -> None:
    """Size a beam of the object's length by strength, then by what its end sinks."""
    load, length, width = n["lifting_load"], n["object_length"], n["beam_width"]
    offset = n["load_offset"]
    # Half the load at a quarter of the length, and what an offset adds.
    n["beam_moment"] = load * (length / 8 + offset / 2) / 1000
    strong = 6000 * n["beam_moment"] / (width * n["bending_stress_allowed"])
    n["beam_height_by_strength"] = sqrt(strong)
    n.choose("beam_height_first", "Ra10", max(n["beam_height_by_strength"], length / 50))
    # w = G·l²·(l + 4.4·e)/(128·E·J) with J = b·h³/12.
    sinks = 12 * load * length**2 * (length + 4.4 * offset)
    sinks /= 128 * n["elastic_modulus_beam"] * width
    n["beam_deflection"] = sinks / n["beam_height_first"] ** 3
    n["beam_ok"] = n["beam_deflection"] <= n["deflection_allowed"]
    n["beam_height_by_stiffness"] = (sinks / n["deflection_allowed"]) ** (1 / 3)
    least = max(n["beam_height_first"], n["beam_height_by_stiffness"])
    n.choose("beam_height", "Ra10", least)


def wrist(n: Notebook) -> None:
    """Find the torque of a wrist that turns the object about an axis beside its centre."""
    squares = (n["object_length"] ** 2 + n["object_width"] ** 2) / 12 + n["load_offset"] ** 2
    n["object_inertia"] = n["mass"] * squares / 1e6
    n["mount_torque"] = n["object_inertia"] * n["turning_acceleration"]


def sheet_mass(n: Notebook) -> None:
    """Weigh a plate, where its mass is not given."""
    if "mass" not in n:
        volume = n["object_length"] * n["object_width"] * n["object_thickness"] / 1e9
        n["mass"] = volume * n["density"]
