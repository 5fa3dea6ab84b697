"""The grip of prisms and the load with the Coriolis acceleration, by vectors and by a trajectory.

Nothing of the declared formulas is used here but their values.
"""

from collections.abc import Mapping

import numpy as np
import pytest
from numpy.typing import NDArray

from gripcourse.course.model import Course
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate
from gripcourse.text.units import factor

Array = NDArray[np.float64]
Values = Mapping[str, Array]

COUNT = 200
RANGES = {
    "mass": (0.5, 60),
    "acceleration": (0, 8),
    "friction": (0.1, 0.35),
    "dynamic_factor": (1.1, 1.3),
    "jaw_angle": (30, 80),
    "acceleration_vertical": (0, 8),
    "acceleration_tangential": (0.5, 6),
    "turning_speed": (0.5, 3),
    "extension_speed": (0.1, 1.5),
}


def solve(course: Course, grip_model: str, **fixed: Array | float) -> Values:
    """Draw random inputs, replace some in declared units, and compute all in SI."""
    example = course.schemes["rack_parallelogram"].example
    assert example is not None
    plan = make_plan(course, "rack_parallelogram", {**example.options, "grip_model": grip_model})
    rng = np.random.default_rng(21)
    drawn = {name: rng.uniform(*bounds, COUNT) for name, bounds in RANGES.items()}
    contact = {f"contact_angle_{point}": 60.0 for point in range(1, 5)}
    loads = {"load_angle": 30.0, "load_elevation": 20.0, "safety_factor": 1.5}
    known = {**example.given, "acceleration_radial": 0.0, **contact, **loads, **drawn, **fixed}
    return evaluate(plan, _in_si(plan, known)).values


def _in_si(plan: Plan, known: Mapping[str, Array | float]) -> dict[str, Array]:
    return {
        one.id: np.broadcast_to(np.asarray(known[one.id]) * factor(one.unit), (COUNT,))
        for one in (*plan.givens, *plan.constants)
        if one.id in known
    }


def test_four_faces_hold_the_object_along_its_axis(course: Course) -> None:
    values = solve(course, "prism_along")
    # A jaw presses on two faces, whose normals stand at the half-angle's complement to its way.
    normals = values["grip_force"] / (2 * np.cos(np.pi / 2 - values["jaw_angle"]))
    held = 4 * values["friction"] * normals
    load = values["mass"] * (values["gravity"] + values["acceleration"])
    np.testing.assert_allclose(held, values["dynamic_factor"] * load, rtol=1e-12)


def test_two_faces_carry_a_load_across_the_object(course: Course) -> None:
    """X is the way of the jaws, the load acts along −Y, the object slides down both faces."""
    values = solve(course, "prism_across")
    angle, friction = values["jaw_angle"], values["friction"]
    load = values["dynamic_factor"] * values["mass"] * (values["gravity"] + values["acceleration"])
    reactions = []
    for side in (-1.0, 1.0):
        normal = np.array([side * np.sin(angle), np.cos(angle)])
        down = np.array([side * np.cos(angle), -np.sin(angle)])  # along the face, to the mouth
        np.testing.assert_allclose(np.sum(normal * down, axis=0), 0, atol=1e-12)
        reactions.append(normal - friction * down)
    matrix = np.moveaxis(np.array(reactions), (0, 1, 2), (2, 1, 0))
    right_side = np.stack([np.zeros(COUNT), load], axis=1)
    forces = np.linalg.solve(matrix, right_side[..., None])[..., 0]
    np.testing.assert_allclose(values["carrying_face_force"], forces[:, 0], rtol=1e-9)
    opening = -forces[:, 0] * reactions[0][0]
    np.testing.assert_allclose(values["grip_force"], np.abs(opening), rtol=1e-9)


def test_prisms_that_open_to_a_plane_hold_as_flat_jaws_do(course: Course) -> None:
    flat = solve(course, "friction")["grip_force"]
    for grip_model in ("prism_along", "prism_across"):
        opened = solve(course, grip_model, jaw_angle=90.0)["grip_force"]
        np.testing.assert_allclose(opened, flat, rtol=1e-12)


@pytest.mark.parametrize("reach", [0.6, 1.4])
def test_the_exact_load_is_that_of_an_arm_that_turns_and_extends(
    course: Course, reach: float
) -> None:
    """The way of the object is differentiated twice, at the moment when the arm points along X."""
    free = solve(course, "contact_exact")
    turning, extending = free["turning_speed"], free["extension_speed"]
    speeding = free["acceleration_tangential"] / reach

    def place(time: float) -> Array:
        radius = reach + extending * time
        angle = turning * time + speeding * time**2 / 2
        height = free["acceleration_vertical"] * time**2 / 2
        return np.array([radius * np.cos(angle), radius * np.sin(angle), height])

    step = 1e-3
    weights = {-2: -1, -1: 16, 0: -30, 1: 16, 2: -1}
    second = sum(weight * place(number * step) for number, weight in weights.items())
    acceleration = second / (12 * step**2)
    values = solve(course, "contact_exact", acceleration_radial=-acceleration[0])
    up = np.array([np.zeros(COUNT), np.zeros(COUNT), values["gravity"]])
    expected = values["mass"] * np.linalg.norm(acceleration + up, axis=0)
    np.testing.assert_allclose(values["load"], expected, rtol=1e-6)
    coriolis = acceleration[1] - values["acceleration_tangential"]
    np.testing.assert_allclose(values["coriolis_acceleration"], coriolis, rtol=1e-6)
