"""The mounting: a flange by its moments, or a bayonet joint by its axial load."""

from hand.notebook import Notebook, not_below

_TABLE = "flanges of grippers"


def mount(n: Notebook) -> None:
    """Choose what joins a gripper with jaws to the arm; the overall length is needed before."""
    load = n["dynamic_factor"] * n["lifting_load"]
    if n.option("mounting") == "bayonet":
        bayonet(n, load)
        return
    n["mount_bending"] = load * n["overall_length"] / 1000
    n["mount_torque"] = load * n["load_offset"] / 1000
    beside = any("inside the bolt heads" in one.title for one in n.sheet.tables)
    flange(n, 1.2 * n["bore"] if beside else 0.0)


def flange(n: Notebook, barrel: float = 0.0) -> None:
    """Choose a flange by bending, then by torque and by what its bolts leave room for."""
    version = "II" if n.option("mounting") == "square_flange" else "I"
    table = n.sheet.table(_TABLE)
    sizes = table.column("nominal")
    bending, torque = table.column(f"{version}: [Mb]"), table.column(f"{version}: [Mₜ]")
    room = [barrel] * len(sizes)
    if barrel:
        known = n.sheet.table("inside the bolt heads")
        inside = dict(zip(known.column("nominal"), known.column("largest"), strict=True))
        room = [inside[one] for one in sizes]

    def first(*wanted: bool) -> bool:
        return all(wanted)

    n["flange_first"] = next(
        size for size, one in zip(sizes, bending, strict=True) if not_below(one, n["mount_bending"])
    )
    place = sizes.index(n["flange_first"])
    will_do = [
        first(n["mount_torque"] <= most, barrel <= inner)
        for most, inner in zip(torque, room, strict=True)
    ]
    n["flange_ok"] = will_do[place]
    n["flange_size"] = next(
        size for size, one in list(zip(sizes, will_do, strict=True))[place:] if one
    )
    n["flange_bolt_circle"] = n.row(_TABLE, "nominal", n["flange_size"], "bolt circle")
    column, name = (
        ("II: side", "flange_side") if version == "II" else ("I: outer", "flange_diameter")
    )
    n[name] = n.row(_TABLE, "nominal", n["flange_size"], column)


def bayonet(n: Notebook, load: float) -> None:
    """Choose a bayonet joint that the rod passes through and that bears both forces."""
    n["mount_axial"] = (n["drive_force_actual"] + load) / 1000
    table = n.sheet.table("bayonet joints")
    sizes = zip(table.column("nominal"), table.column("allowed"), strict=True)
    n["bayonet_size"] = next(
        size
        for size, most in sizes
        if not_below(most, n["mount_axial"]) and not_below(size, 2 * n["rod"])
    )
    for name, column in (
        ("bayonet_collar", "shank: collar"),
        ("bayonet_length", "shank: length"),
        ("bayonet_socket", "socket: diameter"),
    ):
        n[name] = n.row("bayonet joints", "nominal", n["bayonet_size"], column)


def overall(n: Notebook) -> None:
    """Add the cylinder to the length of the mechanism, where it stands in front of the flange."""
    n["drive_length"] = n["stroke"] + 1.5 * n["bore"]
    behind = n.option("mounting") == "bayonet"  # the cylinder stays on the arm
    n["overall_length"] = n["mechanism_length"] + (0 if behind else n["drive_length"])
