"""Jaws, levers and pins: contact stress, bending, shear and bearing."""

from math import pi, sqrt

from hand.notebook import Notebook, arccosine, cosine, not_below, sine, tangent


def jaws(n: Notebook) -> None:
    """Size the jaws by contact stress, and prisms by bending too."""
    e1, e2 = n["elastic_modulus_jaw"], n["elastic_modulus_object"]
    n["reduced_modulus"] = 2 * e1 * e2 / (e1 + e2)
    shape = n.option("jaw_shape")
    if shape == "crossed":
        crossed_bars(n)
        return
    if shape == "concave":
        n["concave_fits"] = n["jaw_radius_first"] >= n["diameter_max"] / 2
        n.choose("jaw_radius", "Ra40", max(n["jaw_radius_first"], n["diameter_max"] / 2))
    flat = 2 / n["diameter_min"]
    jaw = 0.0 if shape in {"flat", "prism"} else 1 / n["jaw_radius"]
    n["reduced_radius"] = 1 / (flat - jaw if shape == "concave" else flat + jaw)
    if shape == "prism":
        prism_faces(n)
    force = n["face_force"] if "face_force" in n else n["grip_force"]
    along = 0.418**2 * force * n["reduced_modulus"] / n["reduced_radius"]  # N/mm·MPa
    n["jaw_width_required"] = along / n["contact_stress_allowed"] ** 2
    least = max(n["least_jaw_width"], n["lever_width"] / 4)
    n.choose("jaw_width", "Ra20", max(n["jaw_width_required"], least))
    n["contact_stress"] = sqrt(along / least)
    n["contact_ok"] = n["contact_stress"] <= n["contact_stress_allowed"]
    if shape == "prism":
        prism_plate(n)
    if n.asks("jaw_size"):
        serrated_pad(n)


def crossed_bars(n: Notebook) -> None:
    """Check round bars that lie across a round object: a point of contact."""
    radii = sorted((n["diameter_min"] / 2, n["jaw_radius"]))
    n["jaw_width"] = 2 * n["jaw_radius"]
    n["radius_ratio"] = radii[0] / radii[1]
    table = "contact of crossed cylinders"
    n["contact_factor"] = n.between_rows(table, "smaller", n["radius_ratio"], "mσ")
    pressed = n["grip_force"] * n["reduced_modulus"] ** 2 / radii[1] ** 2
    n["contact_stress"] = n["contact_factor"] * pressed ** (1 / 3)
    n["contact_ok"] = n["contact_stress"] <= n["contact_stress_allowed"]
    stress = n["contact_stress"]
    n["jaw_hardness"] = n.row_not_below("by hardness", "allowed", stress, "HRC")


def serrated_pad(n: Notebook) -> None:
    """Take the pad that is as wide as the jaw and two thirds of the lever."""
    pads, widest = "serrated pads", max(n["jaw_width"], n["lever_width"] * 2 / 3)
    n["jaw_size"] = n.row_not_below(pads, "D of round", widest, "No.")
    n["jaw_pad_side"] = n.row(pads, "No.", n["jaw_size"], "D of round")
    n["jaw_pad_height"] = n.row(pads, "No.", n["jaw_size"], "height")
    n["jaw_pad_thread"] = n.row(pads, "No.", n["jaw_size"], "thread M")


def prism_faces(n: Notebook) -> None:
    """Find the force on a face and the limits of the prism's angle and chord."""
    half, least, most = n["jaw_angle"], n["diameter_min"] / 2, n["diameter_max"] / 2
    n["jaw_angle_min"] = arccosine(sqrt(least / most))
    n["jaw_chord_min"] = 2 * most * cosine(half)
    n["jaw_chord_max"] = 2 * least / cosine(half)
    across = "carrying_face_force" in n
    n["face_force"] = n["carrying_face_force"] if across else n["grip_force"] / (2 * sine(half))


def prism_plate(n: Notebook) -> None:
    """Size the plate of a prism; its face is bent about the apex."""
    half, most = n["jaw_angle"], n["diameter_max"] / 2
    spread = n["face_force"] * most / (n["jaw_width"] * n["reduced_modulus"])
    n["contact_band"] = 3.04 * sqrt(spread) * 1000
    low, high = n["jaw_chord_min"], n["jaw_chord_max"]
    sizes = sorted(n.sheet.table("Ra20").column("") + n.sheet.table("Ra40").column(""))
    n["jaw_chord"] = next(one for one in sizes if low < one < high)
    arm = most / tangent(half)  # from the apex to the line of contact
    bending = 6 * n["face_force"] * arm / n["jaw_width"]
    n["jaw_thickness_required"] = sqrt(bending / n["jaw_bending_stress_allowed"])
    n["jaw_thickness_ok"] = n["jaw_thickness_required"] <= n["least_jaw_thickness"]
    thickness = max(n["jaw_thickness_required"], n["least_jaw_thickness"])
    n.choose("jaw_thickness", "Ra20", thickness)


def pins(n: Notebook, length: float | None = None) -> None:
    """Size the pins by shear, check the first one in bearing, accept one that bears both.

    Args:
        n: the calculation.
        length: of the pin; None for the width of the lever.
    """
    force = n["pin_force"]
    area = force / (n["shear_planes"] * n["shear_stress_allowed"])
    n["pin_diameter_required"] = sqrt(4 * area / pi)
    n.choose("pin_diameter_first", "diameters of pins", n["pin_diameter_required"])
    n["pin_length"] = n["lever_width"] if length is None else length
    allowed = n["bearing_stress_allowed"]
    n["bearing_stress"] = force / (n["pin_diameter_first"] * n["pin_length"])
    n["bearing_ok"] = n["bearing_stress"] <= allowed
    smallest = n.row_not_below("smallest pins", "for masses", n["mass"], "diameter")
    by_bearing = force / (allowed * n["pin_length"])
    least = max(n["pin_diameter_first"], by_bearing, smallest)
    n.choose("pin_diameter", "diameters of pins", least)


def drilled_lever(n: Notebook) -> None:
    """Size a lever by its bending moment, then with the hole of its pin in the section."""
    bending = 6000 * n["lever_bending_moment"] / n["lever_width"]
    n["lever_thickness_required"] = sqrt(bending / n["bending_stress_allowed"])
    pins(n)
    walls = n["eye_factor"] * n["pin_diameter"]
    n.choose("lever_thickness_first", "Ra20", max(n["lever_thickness_required"], walls))
    first, hole = n["lever_thickness_first"], n["pin_diameter"]
    n["lever_stress"] = bending * first / (first**3 - hole**3)
    slender = n["lever_width"] / n["slenderness_allowed"]
    over = n["lever_stress"] / n["bending_stress_allowed"]
    n["lever_ok"] = over <= 1 and not_below(first, slender)
    n.choose("lever_thickness", "Ra20", max(first, first * sqrt(over), slender))


def plain_finger(n: Notebook, pin_length: float | None = None, *, eye: bool = True) -> None:
    """Size a finger whose dangerous section has no hole.

    Args:
        n: the calculation.
        pin_length: length of the pin; None for the width of the lever.
        eye: whether the pin goes through the finger.
    """
    bending = 6000 * n["lever_bending_moment"] / n["lever_width"]
    n["lever_thickness_required"] = sqrt(bending / n["bending_stress_allowed"])
    pins(n, pin_length)
    least = max(
        n["lever_thickness_required"],
        n["lever_width"] / n["slenderness_allowed"],
        n["eye_factor"] * n["pin_diameter"] if eye else 0.0,
    )
    n.choose("lever_thickness", "Ra20", least)
