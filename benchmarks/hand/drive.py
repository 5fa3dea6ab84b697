"""What moves the jaws: a cylinder that pushes or pulls, or a motor with its reducer."""

from math import pi, sqrt

from hand.notebook import Notebook, not_below, tangent


def cylinder(n: Notebook) -> None:
    """Size the cylinder by the drive force of the worst position and the stroke of the links.

    Needed before: force ratio, grip force and required stroke.
    """
    n["drive_force"] = n["grip_force"] * n["force_ratio"] / n["mechanism_efficiency"]
    n["force_gain"] = n["grip_force"] / n["drive_force"]
    pressed = n["supply_pressure"] * n["cylinder_efficiency"]  # MPa that count
    piston = sqrt(4 * n["drive_force"] / (pi * pressed))
    if n.asks("bore_without_rod"):
        pulling(n, piston)
        n["piston_area"] = pi * (n["bore"] ** 2 - n["rod"] ** 2) / 4
    else:
        n["bore_required"] = piston
        pushing(n)
        n["piston_area"] = pi * n["bore"] ** 2 / 4
    n["drive_force_actual"] = pressed * n["piston_area"]
    least = n["stroke_required"]
    if n.option("drive") == "pneumatic":
        table = "bores and rods of pneumatic"
        least = max(least, n.row(table, "bore", n["bore"], "least standard stroke"))
    n.choose("stroke", "strokes of cylinders", least)
    n["piston_speed"] = n["stroke_required"] / n["closing_time"]
    n["supply_flow"] = n["piston_area"] * n["piston_speed"] * 60 / 1e6


def pushing(n: Notebook) -> None:
    """Choose bores for a piston that works with its whole area, and the rod."""
    bores = bore_sizes(n)
    n["bore_first"] = next(one for one in bores if not_below(one, n["bore_required"]))
    first_force(n, pi * n["bore_first"] ** 2 / 4)
    least = max(n["bore_first"], n["bore_required"] * sqrt(n["drive_reserve"]))
    n["bore"] = next(one for one in bores if not_below(one, least))
    if n.option("drive") == "pneumatic":
        n["rod"] = n.row("bores and rods of pneumatic", "bore", n["bore"], "rod")
    else:
        n.choose("rod", "rods of hydraulic", 0.3 * n["bore"], lambda one: one <= 0.7 * n["bore"])


def pulling(n: Notebook, piston: float) -> None:
    """Choose bores for a piston that pulls: the rod takes a part of its area."""
    bores, reserve = bore_sizes(n), n["drive_reserve"]
    n["bore_without_rod"] = piston
    n["bore_first"] = next(one for one in bores if not_below(one, n["bore_without_rod"]))
    table = "bores and rods of pneumatic"
    if n.option("drive") == "pneumatic":
        ring = sqrt(reserve) * n["bore_without_rod"]
        bore = n.row_not_below(table, "√", ring, "bore")
        n["rod"] = n.row(table, "bore", bore, "rod")
        first_rod = n.row(table, "bore", n["bore_first"], "rod")
    else:
        n.choose("rod", "rods of hydraulic", 0.45 * n["bore_without_rod"])
        first_rod = n["rod"]
    n["bore_required"] = sqrt(n["bore_without_rod"] ** 2 + n["rod"] ** 2)
    first_force(n, pi * (n["bore_first"] ** 2 - first_rod**2) / 4)
    least = max(n["bore_first"], sqrt(reserve * n["bore_without_rod"] ** 2 + n["rod"] ** 2))
    n["bore"] = next(one for one in bores if not_below(one, least) and rod_fits(n, one))


def rod_fits(n: Notebook, bore: float) -> bool:
    """Tell whether the accepted rod goes with a bore."""
    if n.option("drive") == "pneumatic":
        return n.row("bores and rods of pneumatic", "bore", bore, "rod") == n["rod"]
    return 0.3 * bore <= n["rod"] <= 0.7 * bore


def bore_sizes(n: Notebook) -> tuple[float, ...]:
    """Return the bores that there are; of hydraulic cylinders the preferred row."""
    if n.option("drive") == "pneumatic":
        return n.sheet.table("bores and rods of pneumatic").column("bore")
    return n.sheet.table("bores of hydraulic cylinders, GOST 6540-68, row 1").column("")


def first_force(n: Notebook, area: float) -> None:
    """Find the grip force that the first bore gives, and whether it has the reserve."""
    pull = n["supply_pressure"] * n["cylinder_efficiency"] * area
    n["grip_force_first"] = pull * n["mechanism_efficiency"] / n["force_ratio"]
    n["grip_holds"] = n["grip_force_first"] >= n["drive_reserve"] * n["grip_force"]


def motor(n: Notebook, friction_angle: float) -> None:
    """Size motor and reducer, and the brake of a mechanism that does not lock itself.

    Needed before: lead angle, torque ratio, efficiency, speed of the jaws and turns of the shaft.

    Args:
        n: the calculation.
        friction_angle: in thread or worm, in degrees.
    """
    n["self_locking"] = n["lead_angle"] < friction_angle
    n["total_efficiency"] = n["mechanism_efficiency"] * n["drive_efficiency"]
    motor_of(n)


def motor_of(n: Notebook) -> None:
    """Choose the motor and its reducer by the whole efficiency."""
    useful = 2 * n["grip_force"] * n["jaw_speed"] / 1000
    n["motor_power_required"] = useful / n["total_efficiency"]
    watts = n["motor_power_required"]
    n.choose("motor_power_first", "powers of electric motors", watts / 1000)
    reserve = n["drive_reserve"] * watts / 1000
    n["grip_holds"] = n["motor_power_first"] >= reserve
    n.choose("motor_power", "powers of electric motors", max(n["motor_power_first"], reserve))
    n["shaft_speed"] = 60 * n["shaft_turns"] / n["closing_time"]
    n["gear_ratio"] = n["motor_speed"] / n["shaft_speed"]
    turning = 2 * pi * n["motor_speed"] / 60
    at_motor = 1000 * n["motor_power"] / turning
    n["shaft_torque_actual"] = at_motor * n["gear_ratio"] * n["drive_efficiency"]
    n["grip_force_actual"] = n["grip_force"] * n["shaft_torque_actual"] / n["drive_torque"]


def backwards(forward: float, lead: float, friction_angle: float) -> float:
    """Return the torque that a load turns back with, of the one that it takes without friction."""
    return max(forward * tangent(lead - friction_angle) / tangent(lead), 0.0)
