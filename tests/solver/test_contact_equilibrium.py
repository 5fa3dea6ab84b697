"""The contact model of the grip against equilibrium of vectors, solved by numpy.

Axes as in the model: X across the gripper, Y along its axis away from the pivots, Z along the
object. Nothing of the declared formulas is used here but their values.
"""

from collections.abc import Mapping

import numpy as np
import pytest
from numpy.typing import NDArray

from gripcourse.course.model import Course
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate
from gripcourse.text.units import factor

Array = NDArray[np.float64]
Values = Mapping[str, Array]

COUNT = 400
X_SIDES = {1: 1.0, 2: -1.0, 3: 1.0, 4: -1.0}  # right or left of the object's centre
Y_SIDES = {1: 1.0, 2: 1.0, 3: -1.0, 4: -1.0}  # ahead or behind
RANGES = {
    "mass": (0.5, 60),
    "friction": (0.1, 0.35),
    "dynamic_factor": (1.1, 1.3),
    "safety_factor": (1.5, 2),
    "acceleration_vertical": (0, 8),
    "acceleration_radial": (0, 6),
    "acceleration_tangential": (0, 6),
    "load_angle": (0, 90),
    "load_elevation": (0, 90),
    "contact_angle_1": (40, 70),
    "contact_angle_2": (40, 70),
    "contact_angle_3": (40, 70),
    "contact_angle_4": (40, 70),
}


@pytest.fixture(scope="module")
def plan(course: Course) -> Plan:
    """The rack gripper with the contact model."""
    return contact_plan(course, "rack_parallelogram")


def contact_plan(course: Course, scheme: str) -> Plan:
    """Make the plan of a scheme with the options of its example and the contact model."""
    example = course.schemes[scheme].example
    assert example is not None
    return make_plan(course, scheme, {**example.options, "grip_model": "contact"})


def solve(plan: Plan, **fixed: float) -> Values:
    """Draw random inputs, replace some in declared units, and compute all in SI."""
    rng = np.random.default_rng(2263)
    example = plan.scheme.example
    assert example is not None
    known = {name: np.full(COUNT, value) for name, value in example.given.items()}
    known |= {name: rng.uniform(*bounds, COUNT) for name, bounds in RANGES.items()}
    known |= {name: np.full(COUNT, value) for name, value in fixed.items()}
    scaled = {
        name: value * factor(plan.quantities[name].unit)
        for name, value in known.items()
        if name in plan.quantities
    }
    return evaluate(plan, scaled).values


@pytest.fixture(scope="module")
def values(plan: Plan) -> Values:
    return solve(plan)


def inward(values: Values, point: int) -> Array:
    """Return the direction in which the jaw presses on the object at a point, shape (2, n)."""
    angle = values[f"contact_angle_{point}"]
    return -np.array([X_SIDES[point] * np.sin(angle), Y_SIDES[point] * np.cos(angle)])


def against(values: Values, point: int, motion: tuple[float, float]) -> Array:
    """Return the direction of the friction on the object at a point, against its motion (2, n)."""
    normal = inward(values, point)
    tangent = np.array([-normal[1], normal[0]])
    along = np.einsum("i,in->n", np.asarray(motion), tangent)
    return -np.sign(along) * tangent


def two_forces(
    values: Values, points: tuple[int, int], load: Array, motion: tuple[float, float]
) -> Array:
    """Solve the equilibrium of the object on two points with full friction, shape (n, 2)."""
    columns = [
        inward(values, point) + values["friction"] * against(values, point, motion)
        for point in points
    ]
    matrix = np.moveaxis(np.array(columns), (0, 1, 2), (2, 1, 0))
    right_side = -np.outer(load, motion)
    return np.linalg.solve(matrix, right_side[..., None])[..., 0]


def test_the_load_is_the_length_of_its_vector(values: Values) -> None:
    factor_ = values["dynamic_factor"]
    vector = values["mass"] * np.array(
        [
            values["gravity"] + factor_ * values["acceleration_vertical"],
            factor_ * values["acceleration_radial"],
            factor_ * values["acceleration_tangential"],
        ]
    )
    np.testing.assert_allclose(values["load"], np.linalg.norm(vector, axis=0), rtol=1e-12)
    parts = [values[f"load_{name}"] for name in ("axial", "normal", "binormal")]
    np.testing.assert_allclose(np.linalg.norm(parts, axis=0), values["load"], rtol=1e-12)


def test_the_axial_component_rests_on_the_points_ahead(values: Values) -> None:
    forces = two_forces(values, (1, 2), values["load_axial"], (0.0, 1.0))
    np.testing.assert_allclose(values["contact_axial_1"], forces[:, 0], rtol=1e-9)
    np.testing.assert_allclose(values["contact_axial_2"], forces[:, 1], rtol=1e-9)
    assert np.all(forces > 0)


def test_the_normal_component_rests_on_the_points_of_one_jaw(values: Values) -> None:
    forces = two_forces(values, (1, 3), values["load_normal"], (1.0, 0.0))
    np.testing.assert_allclose(values["contact_normal_1"], forces[:, 0], rtol=1e-9)
    np.testing.assert_allclose(values["contact_normal_3"], forces[:, 1], rtol=1e-9)
    assert np.all(forces > 0)


@pytest.mark.parametrize("points", [(1, 3), (2, 4)])
def test_each_jaw_holds_half_of_the_binormal_component_by_friction(
    values: Values, points: tuple[int, int]
) -> None:
    """Equilibrium of half the object along Z and along the gripper's axis."""
    one, other = points
    rows = [
        [values["friction"], values["friction"]],
        [inward(values, one)[1], inward(values, other)[1]],
    ]
    matrix = np.moveaxis(np.array(rows), 2, 0)
    right_side = np.stack([values["load_binormal"] / 2, np.zeros(COUNT)], axis=1)
    forces = np.linalg.solve(matrix, right_side[..., None])[..., 0]
    for column, name in enumerate(points):
        expected = forces[:, column]
        np.testing.assert_allclose(values[f"contact_binormal_{name}"], expected, rtol=1e-9)


def test_the_most_loaded_point_is_the_one_that_the_load_points_at(plan: Plan) -> None:
    even = solve(plan, **{f"contact_angle_{point}": 60.0 for point in X_SIDES})
    others = np.max([even[f"contact_force_{point}"] for point in (2, 3, 4)], axis=0)
    assert np.all(even["contact_force_1"] >= others)


@pytest.mark.parametrize("angle", [45.0, 60.0, 89.9999, 90.0])
def test_equal_angles_have_no_singular_place(plan: Plan, angle: float) -> None:
    """Also where the printed determinants are 0/0, at 90° less the friction angle, and flat."""
    equal = solve(plan, **{f"contact_angle_{point}": angle for point in X_SIDES})
    _check_equal(equal, np.radians(angle))
    beside = {f"contact_angle_{point}": 90 - np.degrees(np.arctan(0.2)) for point in X_SIDES}
    singular = solve(plan, friction=0.2, **beside)
    _check_equal(singular, np.pi / 2 - np.arctan(0.2))


def _check_equal(values: Values, angle: float) -> None:
    friction = values["friction"]
    axial = values["load_axial"] / (2 * (np.cos(angle) + friction * np.sin(angle)))
    normal = values["load_normal"] / (2 * (np.sin(angle) + friction * np.cos(angle)))
    binormal = values["load_binormal"] / (4 * friction)
    expected = {
        "contact_force_1": axial + normal + binormal,
        "contact_force_2": axial + binormal,
        "contact_force_3": normal + binormal,
        "contact_force_4": binormal,
    }
    for name, force in expected.items():
        np.testing.assert_allclose(values[name], force, rtol=1e-9)


def on_finger(values: Values, point: int) -> Array:
    """Return the force of the object on a finger at a point.

    Friction of each component of the load acts against the slip that this component would cause:
    ahead, to the right, and along the object, which has no part in the plane of gripping.
    """
    pressure = -inward(values, point)
    total = values[f"contact_binormal_{point}"] * pressure
    for component, slip in (("axial", (0.0, 1.0)), ("normal", (1.0, 0.0))):
        force = values.get(f"contact_{component}_{point}")
        if force is not None:
            total = total + force * (pressure - values["friction"] * against(values, point, slip))
    return total


@pytest.mark.parametrize(("side", "points"), [("right", (1, 3)), ("left", (2, 4))])
def test_the_forces_on_a_finger_are_the_sum_of_its_points(
    values: Values, side: str, points: tuple[int, int]
) -> None:
    total = on_finger(values, points[0]) + on_finger(values, points[1])
    opening = X_SIDES[points[0]] * total[0]
    np.testing.assert_allclose(values[f"finger_opening_{side}"], opening, rtol=1e-9)
    np.testing.assert_allclose(values[f"finger_pull_{side}"], total[1], rtol=1e-8, atol=1e-6)


def translating(values: Values, points: tuple[int, int], angle: Array | float) -> Array:
    """Return the force that balances a jaw which moves without turning, by virtual work.

    While it opens, the jaw moves along (cos θ, −sin θ), as the end of an arm at the angle θ does.
    """
    total = on_finger(values, points[0]) + on_finger(values, points[1])
    cosine, sine = np.broadcast_arrays(np.cos(angle), np.sin(angle), total[0])[:2]
    path = np.array([X_SIDES[points[0]] * cosine, -sine])
    return np.asarray(np.sum(total * path, axis=0) / cosine)


def turning(
    values: Values, points: tuple[int, int], length: Array, spacing: Array, diameter: Array
) -> Array:
    """Return the force that balances a finger which turns about its pivot, by cross products."""
    moment = np.zeros(COUNT)
    for point in points:
        pivot = np.array([X_SIDES[point] * spacing / 2, -length])
        place = -inward(values, point) * diameter / 2
        arm, force = place - pivot, on_finger(values, point)
        # Clockwise opens the right finger, counterclockwise the left one.
        moment += X_SIDES[point] * (arm[1] * force[0] - arm[0] * force[1])
    return np.asarray(moment / length)


SIDES = pytest.mark.parametrize(
    ("side", "points"), [("right", (1, 3)), ("left", (2, 4))], ids=["right", "left"]
)


@SIDES
def test_a_jaw_on_parallel_arms_is_balanced_by_virtual_work(
    values: Values, side: str, points: tuple[int, int]
) -> None:
    ends = ("at_min", "at_max")
    forces = [translating(values, points, values[f"arm_angle_{end}"]) for end in ends]
    pull = values[f"finger_pull_{side}"]
    assert np.all(pull >= 0)
    np.testing.assert_allclose(values[f"finger_force_{side}"], np.max(forces, axis=0), rtol=1e-9)


@SIDES
@pytest.mark.parametrize("scheme", ["plain_lever", "slot_crosshead", "cross_cylinder"])
def test_a_jaw_on_a_pin_is_balanced_by_virtual_work(
    course: Course, scheme: str, side: str, points: tuple[int, int]
) -> None:
    values = solve(contact_plan(course, scheme))
    ends = ("at_min", "at_max")
    forces = [translating(values, points, values[f"grip_arm_tilt_{end}"]) for end in ends]
    np.testing.assert_allclose(values[f"finger_force_{side}"], np.max(forces, axis=0), rtol=1e-9)


@SIDES
def test_a_sliding_jaw_is_balanced_by_virtual_work(
    course: Course, side: str, points: tuple[int, int]
) -> None:
    values = solve(contact_plan(course, "tangent_slider"))
    expected = translating(values, points, 0.0)
    np.testing.assert_allclose(values[f"finger_force_{side}"], expected, rtol=1e-9)


@SIDES
def test_a_finger_that_turns_is_balanced_by_moments_about_its_pivot(
    course: Course, values: Values, side: str, points: tuple[int, int]
) -> None:
    """What the shared part declares for schemes with pivots."""
    rng = np.random.default_rng(8)
    spacing = rng.uniform(0.02, 0.4, COUNT)
    lengths = {end: rng.uniform(0.1, 0.3, COUNT) for end in ("max", "min")}
    declared = course.parts["contact_grip"].quantities[f"finger_force_{side}"]
    assert declared.formula is not None
    known = {**values, "finger_spacing": spacing}
    known.update({f"finger_length_at_{end}": length for end, length in lengths.items()})
    found = evaluate_formula(declared.formula, declared.unit, known, {})
    forces = [
        turning(values, points, length, spacing, values[f"diameter_{end}"])
        for end, length in lengths.items()
    ]
    np.testing.assert_allclose(found, np.max(forces, axis=0), rtol=1e-9, atol=1e-6)


@SIDES
@pytest.mark.parametrize("scheme", ["link_lever_2", "wedge_roller", "slot_lever"])
def test_a_lever_with_a_fixed_jaw_is_balanced_by_moments_about_its_pivot(
    course: Course, scheme: str, side: str, points: tuple[int, int]
) -> None:
    values = solve(contact_plan(course, scheme))
    reach = [
        values["grip_arm"] * np.cos(values[f"grip_arm_tilt_at_{end}"]) for end in ("min", "max")
    ]
    for diameter, length in zip(("diameter_min", "diameter_max"), reach, strict=True):
        height = values["pivot_offset"] + np.sqrt(values["grip_arm"] ** 2 - length**2) * np.sign(
            values[diameter] / 2 - values["pivot_offset"]
        )
        np.testing.assert_allclose(height, values[diameter] / 2, rtol=1e-9)  # it is that lever
    spacing, diameters = (
        2 * values["pivot_offset"],
        (values["diameter_min"], values["diameter_max"]),
    )
    forces = [
        turning(values, points, length, spacing, diameter)
        for diameter, length in zip(diameters, reach, strict=True)
    ]
    expected = np.max(forces, axis=0)
    np.testing.assert_allclose(values[f"finger_force_{side}"], expected, rtol=1e-9, atol=1e-6)


@SIDES
def test_a_prism_is_balanced_by_moments_at_the_nominal_diameter(
    course: Course, side: str, points: tuple[int, int]
) -> None:
    """The object's centre stands where the bisector across the axis meets it: beside the ridge."""
    values = solve(contact_plan(course, "prism_lever"))
    lean = np.pi / 2 - values["prism_angle"] / 2 - values["attachment_angle"]
    length = values["lever_length"] * np.cos(lean)
    ridge = values["pivot_half_distance"] + values["lever_length"] * np.sin(lean)
    diameter = 2 * ridge * np.sin(values["prism_angle"] / 2)
    spacing = 2 * values["pivot_half_distance"]
    expected = turning(values, points, length, spacing, diameter)
    np.testing.assert_allclose(values[f"finger_force_{side}"], expected, rtol=1e-9, atol=1e-6)


def test_a_prism_that_tilts_by_five_degrees_needs_a_fifth_more_at_most(course: Course) -> None:
    """Why the four points are taken at the nominal diameter, and why variants keep within 5°."""
    plan = contact_plan(course, "prism_lever")
    opening = {"prism_angle": 110.0, "attachment_angle": 25.0}
    most: list[float] = []
    for tilt in (-10.0, -5.0, 0.0, 5.0):
        angles = {1: 55 + tilt, 2: 55 + tilt, 3: 55 - tilt, 4: 55 - tilt}
        values = solve(plan, **opening, **{f"contact_angle_{n}": a for n, a in angles.items()})
        lean = np.radians(90 - 55 - 25 + tilt)
        ridge = values["pivot_half_distance"] + values["lever_length"] * np.sin(lean)
        centre = values["lever_length"] * np.cos(lean) + ridge * np.tan(np.radians(tilt))
        diameter = 2 * ridge * np.sin(np.radians(55)) / np.cos(np.radians(tilt))
        spacing = 2 * values["pivot_half_distance"]
        fingers = [
            turning(values, points, centre, spacing, diameter) for points in ((1, 3), (2, 4))
        ]
        moment = np.max(fingers, axis=0) * centre
        arm = values["lever_length"] * np.cos(np.radians(90 - 55 - 25))  # of the grip force
        at_nominal = solve(plan, **opening, **{f"contact_angle_{n}": 55.0 for n in angles})
        most.append(float(np.max(moment / arm / at_nominal["grip_force_min"])))
    assert most == sorted(most)
    assert most[-2] == pytest.approx(1)
    assert most[-1] < 1.2


def test_the_object_is_in_equilibrium_between_equal_prisms_and_nowhere_slips(plan: Plan) -> None:
    """Sums of forces and the moment about its axis vanish; friction stays within Coulomb's cone."""
    values = solve(plan, **{f"contact_angle_{point}": 60.0 for point in X_SIDES})
    fingers = {point: on_finger(values, point) for point in X_SIDES}
    across, along = np.sum(list(fingers.values()), axis=0)
    np.testing.assert_allclose(across, values["load_normal"], rtol=1e-9, atol=1e-6)
    np.testing.assert_allclose(along, values["load_axial"], rtol=1e-9, atol=1e-6)
    turning_moment = np.zeros(COUNT)
    for point, force in fingers.items():
        radius = -inward(values, point)
        turning_moment += radius[0] * force[1] - radius[1] * force[0]
        tangential = radius[0] * force[1] - radius[1] * force[0]
        lengthwise = values["friction"] * values[f"contact_binormal_{point}"]
        limit = values["friction"] * values[f"contact_force_{point}"]
        assert np.all(np.hypot(tangential, lengthwise) <= limit * (1 + 1e-9))
    np.testing.assert_allclose(turning_moment / values["load"], 0, atol=1e-9)


def test_the_finger_that_a_normal_load_presses_on_carries_all_of_it(plan: Plan) -> None:
    even = {f"contact_angle_{point}": 60.0 for point in X_SIDES}
    values = solve(plan, load_angle=90.0, load_elevation=0.0, friction=0.3, **even)
    np.testing.assert_allclose(values["finger_opening_right"], values["load"], rtol=1e-9)


def test_the_grip_force_is_the_worse_finger_with_its_safety(values: Values) -> None:
    worse = np.maximum(values["finger_force_right"], values["finger_force_left"])
    np.testing.assert_allclose(values["grip_force"], values["safety_factor"] * worse, rtol=1e-12)


def test_flat_jaws_under_an_axial_load_hold_by_friction_alone(plan: Plan) -> None:
    flat = {f"contact_angle_{point}": 90.0 for point in X_SIDES}
    values = solve(plan, load_angle=0.0, load_elevation=0.0, **flat)
    expected = values["load"] / (2 * values["friction"])
    np.testing.assert_allclose(values["grip_force_min"], expected, rtol=1e-9)
