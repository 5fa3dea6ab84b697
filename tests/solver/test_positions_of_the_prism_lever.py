"""Where the lever with a prism stands: the seven positions of the paper's table, and its numbers.

Table 1 of Pavlenko and Godunko's second paper gives the diameter by |ω| and |ε| in seven rows; the
course has one equation with signs. The angle of the lever is negative on the side of the axis.
"""

import math

import pytest

from gripcourse.course.model import Course
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant

HALF, LENGTH = 40.0, 100.0  # mm: a and L


def rotation_at(course: Course, diameter: float, prism: float, attachment: float) -> float:
    """Return the lever's rotation from its nominal position when an object is held, degrees."""
    return held(course, diameter, prism, attachment)["lever_rotation_at_max"]


def held(course: Course, diameter: float, prism: float, attachment: float) -> dict[str, float]:
    """Solve the scheme for an object as the largest of the range, declared units."""
    example = course.schemes["prism_lever"].example
    assert example is not None
    plan = make_plan(course, "prism_lever", example.options)
    sizes = {
        "pivot_half_distance": HALF,
        "lever_length": LENGTH,
        "prism_angle": prism,
        "attachment_angle": attachment,
        "diameter_max": diameter,
    }
    return dict(solve_variant(plan, {**example.given, **sizes}))


def diameter_of(lean: float, rotation: float, prism: float) -> float:
    """Return 2(a + L·sin ω)·sin(α/2)/cos ε; the paper writes −sin w for a lever on the right."""
    reach = HALF + LENGTH * math.sin(math.radians(lean))
    return 2 * reach * math.sin(math.radians(prism / 2)) / math.cos(math.radians(rotation))


@pytest.mark.parametrize(
    ("prism", "attachment", "lean", "rotation"),
    [
        (120, 30, 0, 0),  # 1: vertical, nominal
        (120, 20, 10, 0),  # 2: nominal, to the left: w = 90 − α/2 − γ
        (120, 40, -10, 0),  # 3: nominal, to the right: w = γ + α/2 − 90
        (120, 20, 18, 8),  # 4: larger, to the left: w = 90 + e − α/2 − γ
        (120, 40, -2, 8),  # 5: larger, still to the right: w = γ + α/2 − 90 − e
        (120, 20, 2, -8),  # 6: smaller, to the left: w = 90 − e − α/2 − γ
        (120, 40, -18, -8),  # 7: smaller, to the right: w = γ + α/2 − 90 + e
    ],
)
def test_the_seven_positions_of_the_paper_are_one_equation(
    course: Course, prism: float, attachment: float, lean: float, rotation: float
) -> None:
    assert lean == 90 + rotation - prism / 2 - attachment
    diameter = diameter_of(lean, rotation, prism)
    assert rotation_at(course, diameter, prism, attachment) == pytest.approx(rotation, abs=1e-6)


@pytest.mark.parametrize(
    ("diameter", "rotation", "height"),
    [
        (70.35, -10, 92.95),
        (84.70, -5, 95.36),
        (99.36, 0, 98.48),
        (114.55, 5, 102.36),
        (130.50, 10, 107.05),
    ],
)
def test_the_centre_of_the_object_rises_with_its_diameter(
    course: Course, diameter: float, rotation: float, height: float
) -> None:
    # α = 120°, γ = 20°; computed by vector geometry
    values = held(course, diameter, 120, 20)
    assert values["lever_rotation_at_max"] == pytest.approx(rotation, abs=0.005)
    assert values["centre_error_at_max"] == pytest.approx(height - 98.48, abs=0.015)
