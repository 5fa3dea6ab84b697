"""What a joint does to its first body for each of its unknowns: force and moment about the origin.

A wrench is (force along x, force along y, moment), each of shape (n,); forces in N, lengths in m.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gripcourse.formula.tree import Formula
from gripcourse.proofs.equilibrium.model import Joint

Array = NDArray[np.float64]
Wrench = tuple[Array, Array, Array]
Value = Callable[[Formula], Array]


@dataclass(frozen=True, slots=True)
class Support:
    """One of many equal supports.

    Attributes:
        x, y: where it is.
        along, across: its distance from the middle of all, along and across.
        is_there: where there are so many.
    """

    x: Array
    y: Array
    along: Array
    across: Array
    is_there: NDArray[np.bool_]


def force_at(x: Array, y: Array, along: Array, across: Array) -> Wrench:
    """Return the wrench of a force with these components at a point."""
    return along, across, x * across - y * along


def unit_wrenches(joint: Joint, known: Mapping[str, Array], value: Value) -> list[Wrench]:
    """Return the wrench on the first body for one unit of each unknown of a joint."""
    shape = np.shape(next(iter(known.values())))
    zero, one = np.zeros(shape), np.ones(shape)
    couple = (zero, zero, one)
    if joint.kind == "couple":
        return [couple]
    x, y = known[f"{joint.at}_x"], known[f"{joint.at}_y"]
    match joint.kind:
        case "row" | "grid":
            found = _row(joint, x, y, value) if joint.kind == "row" else _grid(joint, x, y, value)
        case "pin" | "weld":
            found = [force_at(x, y, one, zero), force_at(x, y, zero, one)]
        case "link":
            away = known[f"{joint.to}_x"] - x, known[f"{joint.to}_y"] - y
            length = np.hypot(*away)
            found = [force_at(x, y, away[0] / length, away[1] / length)]
        case "slider":
            found = [_turned(x, y, value(joint.formulas["along"]) + np.pi / 2, zero)]
        case _:
            angle = value(joint.formulas["direction"])
            found = [_turned(x, y, angle, zero + _lean(joint, value))]
            if joint.is_rough:
                found.append(_turned(x, y, angle + np.pi / 2, zero))
    return [*found, couple] if joint.kind in {"weld", "slider"} else found


def _lean(joint: Joint, value: Value) -> Array:
    """Return the angle by which the force of a slot, contact or mesh is turned."""
    for key in ("friction_angle", "pressure_angle"):
        if key in joint.formulas:
            return value(joint.formulas[key])
    return np.asarray(0.0)


def _turned(x: Array, y: Array, angle: Array, lean: Array) -> Wrench:
    """Return the wrench of one unit along an angle, and of what goes with it across."""
    across = np.tan(lean)
    return force_at(
        x,
        y,
        np.cos(angle) - across * np.sin(angle),
        np.sin(angle) + across * np.cos(angle),
    )


def supports(joint: Joint, x: Array, y: Array, value: Value) -> list[Support]:
    """Return the supports of a row, from its one end to the other, or of a grid.

    A row lies across its direction: the first support is at its right, looking along the force.
    """
    count, pitch = value(joint.formulas["count"]), value(joint.formulas["pitch"])
    if joint.kind == "grid":
        rows, row_pitch = value(joint.formulas["rows"]), value(joint.formulas["row_pitch"])
        angle = np.zeros_like(x)
    else:
        rows, row_pitch = np.ones_like(x), np.zeros_like(x)
        angle = value(joint.formulas["direction"]) + np.pi / 2
    found = []
    for row in range(_most(rows)):
        for place in range(_most(count)):
            along = (place - (count - 1) / 2) * pitch
            across = (row - (rows - 1) / 2) * row_pitch
            found.append(
                Support(
                    x + along * np.cos(angle) - across * np.sin(angle),
                    y + along * np.sin(angle) + across * np.cos(angle),
                    along,
                    across,
                    (place < count) & (row < rows),
                )
            )
    return found


def _most(count: Array) -> int:
    return int(np.nanmax(count, initial=0))


def _row(joint: Joint, x: Array, y: Array, value: Value) -> list[Wrench]:
    """Equal supports of a rigid body: their forces change evenly from one end to the other."""
    angle = value(joint.formulas["direction"])
    pitch = value(joint.formulas["pitch"])
    mean = [np.zeros_like(x) for _ in range(3)]
    slope = [np.zeros_like(x) for _ in range(3)]
    for one in supports(joint, x, y, value):
        wrench = force_at(one.x, one.y, np.cos(angle), np.sin(angle))
        for part in range(3):
            mean[part] += np.where(one.is_there, wrench[part], 0.0)
            slope[part] += np.where(one.is_there, wrench[part] * one.along / pitch, 0.0)
    return [(mean[0], mean[1], mean[2]), (slope[0], slope[1], slope[2])]


def _grid(joint: Joint, x: Array, y: Array, value: Value) -> list[Wrench]:
    """Equal supports that hold a rigid body in the plane: it shifts and turns a little."""
    pitch = value(joint.formulas["pitch"])
    parts = [[np.zeros_like(x) for _ in range(3)] for _ in range(3)]
    for one in supports(joint, x, y, value):
        zero, full = np.zeros_like(x), np.ones_like(x)
        for total, (along, across) in zip(
            parts,
            ((full, zero), (zero, full), (-one.across / pitch, one.along / pitch)),
            strict=True,
        ):
            wrench = force_at(one.x, one.y, along, across)
            for part in range(3):
                total[part] += np.where(one.is_there, wrench[part], 0.0)
    return [(one[0], one[1], one[2]) for one in parts]


def results(
    joint: Joint, known: Mapping[str, Array], found: Mapping[str, Array], value: Value
) -> dict[str, Array]:
    """Return what follows from the unknowns of a joint, by the last part of the name."""
    if joint.is_rough:
        return {"force": np.hypot(found["normal"], found["tangent"])}
    match joint.kind:
        case "pin" | "weld":
            return {"force": np.hypot(found["x"], found["y"])}
        case "slot" | "contact":
            lean = _lean(joint, value)
            return {
                "tangent": found["normal"] * np.tan(lean),
                "force": np.abs(found["normal"] / np.cos(lean)),
            }
        case "mesh":
            lean = _lean(joint, value)
            return {
                "normal": found["tangent"] * np.tan(lean),
                "force": np.abs(found["tangent"] / np.cos(lean)),
            }
        case "row" | "grid":
            return {"largest": _largest(joint, known, found, value)}
        case _:
            return {}


def _largest(
    joint: Joint, known: Mapping[str, Array], found: Mapping[str, Array], value: Value
) -> Array:
    x, y = known[f"{joint.at}_x"], known[f"{joint.at}_y"]
    pitch = value(joint.formulas["pitch"])
    most = np.full_like(x, -np.inf)
    for one in supports(joint, x, y, value):
        if joint.kind == "row":
            amount = found["mean"] + found["slope"] * one.along / pitch
        else:
            amount = np.hypot(
                found["x"] - found["turn"] * one.across / pitch,
                found["y"] + found["turn"] * one.along / pitch,
            )
        most = np.where(one.is_there, np.maximum(most, amount), most)
    return np.asarray(most)
