"""How the points of a course fall on its items."""

import pytest

from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.course.quantity import Kind
from gripcourse.policy.model import Policy
from gripcourse.policy.points import points_of
from gripcourse.solver.plan import Plan, make_plan


def all_plans(course: Course) -> list[Plan]:
    """Every scheme with any two choices of its options together."""
    return [
        make_plan(course, scheme.id, options)
        for scheme in course.schemes.values()
        for options in pair_option_sets(scheme)
    ]


def test_the_points_of_each_scheme_and_option_add_up_to_the_total(
    course: Course, policy: Policy
) -> None:
    plans = all_plans(course)
    assert len(plans) >= 2
    sums = [sum(points_of(plan, policy).values()) for plan in plans]
    assert sums == pytest.approx([policy.total] * len(plans))


def test_the_points_of_a_section_are_what_the_policy_says(course: Course, policy: Policy) -> None:
    for plan in all_plans(course):
        points = points_of(plan, policy)
        sums: dict[str, float] = {}
        for name, value in points.items():
            section = plan.quantities[name].section
            sums[section] = sums.get(section, 0) + value
        assert sums == pytest.approx(dict(policy.section_points))


def test_only_what_a_student_hands_in_has_points(plan: Plan, policy: Policy) -> None:
    kinds = {plan.quantities[name].kind for name in points_of(plan, policy)}
    assert kinds <= {kind for kind in Kind if kind.answered} | {Kind.MANUAL}


def test_a_quantitys_own_weight_goes_before_its_kinds(plan: Plan, policy: Policy) -> None:
    points = points_of(plan, policy)
    # The reference policy weighs the grip force 3 and the load 1, both in the section of the grip.
    assert points["grip_force"] == pytest.approx(3 * points["lifting_load"])
    assert points["grip_holds"] == pytest.approx(0.5 * points["lifting_load"])
