"""How the points of a course fall on its items."""

from dataclasses import replace

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.course.quantity import Kind
from gripcourse.policy.model import Policy
from gripcourse.policy.points import points_of, shares_of
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
    # The reference policy weighs the length of a pin a quarter, a verdict half of a formula.
    assert points["pin_length"] == pytest.approx(0.25 * points["bearing_stress"])
    assert points["grip_holds"] == pytest.approx(0.5 * points["lifting_load"])


def test_a_main_result_has_the_same_points_in_every_variant(course: Course, policy: Policy) -> None:
    assert {"grip_force", "drive_force"} <= set(policy.main_points)
    for plan in all_plans(course):
        points = points_of(plan, policy)
        for name in points.keys() & policy.main_points.keys():
            assert points[name] == pytest.approx(policy.main_points[name])


def test_where_nothing_else_is_asked_a_main_result_has_the_whole_section(
    plan: Plan, policy: Policy
) -> None:
    force = plan.quantities["grip_force"]
    section = policy.section_points[force.section]
    alone = shares_of(force, policy, np.array([5.0]), np.array([0.0]))
    assert alone.tolist() == pytest.approx([section])


def test_in_a_section_without_points_nothing_has_any(plan: Plan, policy: Policy) -> None:
    unmarked = replace(policy, section_points={**policy.section_points, "grip": 0.0})
    points = points_of(plan, unmarked)
    assert {points["grip_force"], points["lifting_load"]} == {0.0}
