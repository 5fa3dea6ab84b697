"""The load on the jaws, the forces at the points of contact, and the force of the grip."""

from math import hypot, sqrt

from hand.notebook import Notebook, arctangent, cosine, direction, sine, tangent

# Their jaws go straight across, at the end of the range that counts: a guide takes the rest.
_STRAIGHT = {"screw", "tangent_slider", "pinion_racks", "wedge_slide", "rack_parallelogram"}


def grip(n: Notebook, jaws: int = 2) -> None:
    """Find the grip force by the model of the variant."""
    n["contact_friction_angle"] = arctangent(n["friction"])
    model = n.option("grip_model") or "friction"
    if model.startswith("contact"):
        contact_load(n, model)
        contact_points(n)
        fingers(n)
        n["grip_force_min"] = max(n["finger_force_right"], n["finger_force_left"])
        n["grip_force"] = n["safety_factor"] * n["grip_force_min"]
    else:
        n["lifting_load"] = n["mass"] * (n["gravity"] + n["acceleration"])
        held_by_friction(n, model, jaws)
    elements(n)


def held_by_friction(n: Notebook, model: str, jaws: int) -> None:
    """Find the force that keeps the object from slipping, or from opening prisms as a wedge."""
    load = n["dynamic_factor"] * n["lifting_load"]
    if model == "prism_across":
        # The lower face alone carries half the load: N and f·N, summed up and down.
        half, friction = n["jaw_angle"], n["friction"]
        n["carrying_face_force"] = load / 2 / (cosine(half) + friction * sine(half))
        n["grip_force"] = n["carrying_face_force"] * (sine(half) - friction * cosine(half))
        return
    prisms = model == "prism_along" or n.sheet.scheme == "prism_lever"
    n["grip_force"] = load * (prism_share(n) if prisms else 1.0) / (jaws * n["friction"])


def prism_share(n: Notebook) -> float:
    """Return the force of a prism across the axis over the sum of its faces' normal forces."""
    if n.sheet.scheme == "prism_lever":
        # N1 = F·sin(δ + ε)/sin α and N2 = F·sin(δ - ε)/sin α add up to F·cos ε/sin(α/2).
        return sine(n["prism_angle"] / 2) / cosine(n["prism_tilt"])
    return sine(n["jaw_angle"])


def contact_load(n: Notebook, model: str) -> None:
    """Add up weight and inertia as vectors: along the arm, upward, and across both."""
    up, along, across = (
        n["acceleration_vertical"],
        n["acceleration_radial"],
        n["acceleration_tangential"],
    )
    g = n["gravity"]
    n["lifting_load"] = n["mass"] * sqrt((g + up) ** 2 + along**2 + across**2)
    if model == "contact_exact":
        n["coriolis_acceleration"] = 2 * n["turning_speed"] * n["extension_speed"]
        across += n["coriolis_acceleration"]
        n["load"] = n["mass"] * sqrt((g + up) ** 2 + along**2 + across**2)
    elif model == "contact":
        k = n["dynamic_factor"]
        n["load"] = n["mass"] * sqrt((g + k * up) ** 2 + (k * along) ** 2 + (k * across) ** 2)
    else:
        worst_motion(n)
    n["load_axial"] = n["load"] * cosine(n["load_elevation"]) * cosine(n["load_angle"])
    n["load_normal"] = n["load"] * cosine(n["load_elevation"]) * sine(n["load_angle"])
    n["load_binormal"] = n["load"] * sine(n["load_elevation"])


def worst_motion(n: Notebook) -> None:
    """Try each combination of motions; the greatest load gives its direction too."""
    shares = n.sheet.table("combinations of motions")
    loads = []
    for row, name in enumerate(("load_lift", "load_extend", "load_turn")):
        k = n["dynamic_factor"]
        up = n["gravity"] + k * n["acceleration_vertical"] * shares.column("lifting")[row]
        along = k * n["acceleration_radial"] * shares.column("extending")[row]
        across = k * n["acceleration_tangential"] * shares.column("turning")[row]
        n[name] = n["mass"] * sqrt(up**2 + along**2 + across**2)
        loads.append((n[name], row + 1, up, along, across))
    n["load"] = max(one for one, *_ in loads)
    n["motion"] = next(row for one, row, *_ in loads if one == max(loads)[0])
    _, _, up, along, across = loads[int(n["motion"]) - 1]
    n["load_angle"] = direction(up, along)
    n["load_elevation"] = direction(across, hypot(up, along))


def contact_points(n: Notebook) -> None:
    """Find the normal forces at the four points from the balance of the object.

    The axial part rests on the points ahead, 1 and 2; the normal part on the loaded jaw, 1 and 3;
    the binormal part is held by friction at all four. Friction acts against the load in each.
    """
    f = n["friction"]
    phi = [n[f"contact_angle_{i}"] for i in (1, 2, 3, 4)]
    # Along the axis each point gives cos φ + f·sin φ, across it sin φ - f·cos φ.
    n["contact_axial_1"], n["contact_axial_2"] = shared(
        n["load_axial"],
        [cosine(one) + f * sine(one) for one in phi[:2]],
        [sine(one) - f * cosine(one) for one in phi[:2]],
    )
    loaded = (phi[0], phi[2])
    n["contact_normal_1"], n["contact_normal_3"] = shared(
        n["load_normal"],
        [sine(one) + f * cosine(one) for one in loaded],
        [cosine(one) - f * sine(one) for one in loaded],
    )
    for ahead, behind in ((1, 3), (2, 4)):
        n[f"contact_binormal_{ahead}"], n[f"contact_binormal_{behind}"] = shared(
            n["load_binormal"] / 2,
            [f, f],
            [cosine(phi[ahead - 1]), cosine(phi[behind - 1])],
        )
    for point in (1, 2, 3, 4):
        parts = (f"contact_{part}_{point}" for part in ("axial", "normal", "binormal"))
        n[f"contact_force_{point}"] = sum(n[one] for one in parts if one in n)


def shared(load: float, useful: list[float], idle: list[float]) -> tuple[float, float]:
    """Share a load among two points whose idle parts balance each other."""
    (u1, u2), (i1, i2) = useful, idle
    if (u1, i1) == (u2, i2):  # alike: halves, also where the idle parts are nothing
        return load / (2 * u1), load / (2 * u2)
    both = u1 * i2 + u2 * i1
    return load * i2 / both, load * i1 / both


def fingers(n: Notebook) -> None:
    """Find what opens each finger, and the force at its jaw that keeps it closed."""
    f = n["friction"]
    phi = {i: n[f"contact_angle_{i}"] for i in (1, 2, 3, 4)}
    pushed = {i: n[f"contact_axial_{i}"] * (sine(phi[i]) - f * cosine(phi[i])) for i in (1, 2)}
    across = {i: n[f"contact_binormal_{i}"] * sine(phi[i]) for i in phi}
    from_normal = {
        i: n[f"contact_normal_{i}"] * (sine(phi[i]) + f * cosine(phi[i])) for i in (1, 3)
    }
    n["finger_opening_right"] = pushed[1] + sum(from_normal.values()) + across[1] + across[3]
    n["finger_opening_left"] = pushed[2] + across[2] + across[4]
    n["finger_pull_right"] = n["contact_axial_1"] * (cosine(phi[1]) + f * sine(phi[1]))
    n["finger_pull_left"] = n["contact_axial_2"] * (cosine(phi[2]) + f * sine(phi[2]))
    for side in ("right", "left"):
        n[f"finger_force_{side}"] = kept_closed(n, side)


def kept_closed(n: Notebook, side: str) -> float:
    """Return the force at a jaw, across the axis, that balances what opens its finger."""
    opening, pull = n[f"finger_opening_{side}"], n[f"finger_pull_{side}"]
    if n.sheet.scheme in _STRAIGHT:
        return opening
    if n.sheet.scheme == "prism_lever":
        height, beside = n["apex_height"], n["pivot_half_distance"]
        return about_the_pivot(n, side, (height, beside, n["nominal_diameter"] / 2))
    if "finger_spacing" in n:  # jaws fixed to their levers: both ends of the range
        beside = n["finger_spacing"] / 2
        return max(
            about_the_pivot(n, side, (n[f"finger_length_{end}"], beside, n[f"diameter_{size}"] / 2))
            for end, size in (("at_max", "max"), ("at_min", "min"))
        )
    # A jaw that turns on its pin: the pin goes across by l·cos χ and back by l·sin χ.
    ends = (n["grip_arm_tilt_at_max"], n["grip_arm_tilt_at_min"])
    return max(opening - pull * tangent(one) for one in ends)


def about_the_pivot(n: Notebook, side: str, place: tuple[float, float, float]) -> float:
    """Return the moment of the forces on a jaw about its lever's pivot, over the grip force's arm.

    Args:
        n: the calculation.
        side: of the jaw.
        place: of the object's centre before the pivot, of the pivot beside the axis; radius.
    """
    f, (height, beside, radius) = n["friction"], place
    ahead, behind = (1, 3) if side == "right" else (2, 4)
    moment = 0.0
    for point, sign in ((ahead, 1), (behind, -1)):
        phi = n[f"contact_angle_{point}"]
        axial, normal, binormal = (
            n.get(f"contact_{part}_{point}", 0.0) for part in ("axial", "normal", "binormal")
        )
        out = axial * (sine(phi) - f * cosine(phi)) + normal * (sine(phi) + f * cosine(phi))
        out += binormal * sine(phi)
        forward = axial * (cosine(phi) + f * sine(phi))
        forward += sign * normal * (cosine(phi) - f * sine(phi)) + sign * binormal * cosine(phi)
        moment += out * (height + sign * radius * cosine(phi))
        moment += forward * (beside - radius * sine(phi))
    return moment / height


def elements(n: Notebook) -> None:
    """Find the load of one working element by the position of the object."""
    load, position = n["lifting_load"], n.option("object_position")
    count = 1 if position == "one_element" else 2
    if position in {"one_element", "two_elements"}:
        n["element_force"] = load / count
        n["element_moment"] = n["element_force"] * n["load_overhang"] / 1000
    elif position == "friction_pair":
        # Of prisms on levers the force across the axis is asked for, not those of their faces.
        across = prism_share(n) if n.sheet.scheme == "prism_lever" else 1.0
        n["element_force"] = load * across / (2 * n["friction"])
    elif position:
        span, centre = n["pair_spacing"], n["centre_distance"]
        outside = 1 if position in {"pairs_beyond", "wide_pair"} else -1
        n["pair_force_near"] = load * (span + outside * centre) / span
        n["pair_force_far"] = load * centre / span
        n["element_force"] = n["pair_force_near"] / 2
