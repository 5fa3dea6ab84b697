"""The motion of a scheme: its coordinates at any position of the drive, and its effort ratio there.

All values are in SI; the drive's coordinate is a length or an angle.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.kinematics import Direction, Kinematics
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import Values, evaluate

Array = NDArray[np.float64]


def drive_at(motion: Kinematics, values: Values, position: str) -> Array:
    """Return the drive's coordinate at a position that the scheme has."""
    return evaluate_formula(motion.at[position], motion.unit, values, {})


def coordinates(motion: Kinematics, values: Values, drive: Array) -> dict[str, Array]:
    """Return every coordinate where the drive stands at `drive`.

    Args:
        motion: the scheme's kinematics.
        values: of the scheme's quantities.
        drive: coordinate of the drive, shape (n,) or ().
    """
    known: dict[str, Array] = {**values, motion.drive: drive}
    found: dict[str, Array] = {}
    for one in motion.coordinates:
        found[one.id] = evaluate_formula(one.formula, one.unit, known, {})
        known[one.id] = found[one.id]
    return found


def declared_ratio(
    plan: Plan, motion: Kinematics, known: Mapping[str, Array], position: str, drive: Array
) -> Array:
    """Return the effort of the drive over that of one output, by the scheme's closed form.

    Args:
        plan: of the scheme.
        motion: its kinematics.
        known: givens and decisions; friction as the caller wants it.
        position: whose formula to use.
        drive: where the drive stands, shape (n,).
    """
    at_rest = evaluate(plan, known).values
    where = coordinates(motion, at_rest, drive)
    state = {name: where[one] for name, one in motion.state.get(position, {}).items()}
    # Everything but the position stays as it is: sizes are not chosen anew at every position.
    fixed = {name: value for name, value in at_rest.items() if name not in motion.ratio.values()}
    return evaluate(plan, {**fixed, **state}).computed[motion.ratio[position]]


def work_ratio(
    plan: Plan,
    motion: Kinematics,
    known: Mapping[str, Array],
    position: str,
    drive: Array,
    step: float,
) -> Array:
    """Return the same ratio by virtual work: what all outputs move over what the drive moves.

    A central difference of fourth order; it knows nothing of the closed form. What describes the
    position is frozen where the drive stands: a force keeps its direction in a virtual motion.
    """
    at_rest = evaluate(plan, known).values
    where = coordinates(motion, at_rest, drive)
    frozen = {name: where[one] for name, one in motion.state.get(position, {}).items()}
    values = {**at_rest, **frozen}
    outputs = evaluate_formula(motion.outputs, "", values, {})

    def output(place: Array) -> Array:
        return coordinates(motion, values, place)[motion.output]

    near = output(drive + step) - output(drive - step)
    far = output(drive + 2 * step) - output(drive - 2 * step)
    sense = 1 if motion.direction is Direction.GROWS else -1
    return sense * outputs * (8 * near - far) / (12 * step)
