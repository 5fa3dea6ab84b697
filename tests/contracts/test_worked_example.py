"""The numbers of the worked examples. Source: the guide, section 5, recomputed exactly."""

import pytest

from gripcourse.course.model import Convention, Course
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant


def test_a_number_of_the_worked_example(
    course: Course, expected_key: tuple[str, Convention, str]
) -> None:
    scheme, convention, quantity = expected_key
    example = course.schemes[scheme].example
    assert example is not None
    plan = make_plan(course, scheme, example.options, convention)
    values = solve_variant(plan, {**example.given, **example.chosen[convention]})
    expected, difference = example.expected[convention][quantity]
    assert values[quantity] == pytest.approx(expected, rel=1e-12, abs=difference)


def test_the_guide_at_its_own_gravity_and_at_the_courses(course: Course) -> None:
    example = course.schemes["rack_parallelogram"].example
    assert example is not None
    plan = make_plan(course, "rack_parallelogram", example.options)
    given = {name: value for name, value in example.given.items() if name != "gravity"}
    # the guide, section 5, and erratum 16: 3851 N with the course's own constant
    assert solve_variant(plan, {**given, "gravity": 10.0})["grip_force"] == pytest.approx(3900)
    assert solve_variant(plan, given)["grip_force"] == pytest.approx(3850.6, abs=0.05)
