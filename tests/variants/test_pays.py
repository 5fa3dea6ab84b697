"""Rules of a policy under which guessing would pay are named; what a mistake costs is known."""

import re
from dataclasses import replace

import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Tolerance
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import plan_of
from gripcourse.solver.solve import solve_variant
from gripcourse.variants.model import Variant
from gripcourse.variants.pays import MOST_APART, mistake_costs, paying_rules, uneven_costs
from support.issued_table import issued_table


@pytest.fixture(scope="module")
def issued(course: Course) -> tuple[Variant, ...]:
    return issued_table(course)


def said(course: Course, policy: Policy, issued: tuple[Variant, ...]) -> list[tuple[str, str]]:
    return [(str(one.key), str(one.what)) for one in paying_rules(course, policy, issued, "t.csv")]


def test_nothing_pays_in_the_reference_course(
    course: Course, policy: Policy, issued: tuple[Variant, ...]
) -> None:
    assert said(course, policy, issued) == []


def test_a_mistake_in_a_main_result_costs_alike(
    course: Course, policy: Policy, issued: tuple[Variant, ...]
) -> None:
    main = [one for one in mistake_costs(course, policy, issued) if one.is_main]
    assert {"grip_force", "drive_force"} <= {one.quantity for one in main}
    assert all(one.apart <= MOST_APART for one in main)


def test_what_costs_much_more_in_some_variants_is_told_of_other_answers_too(
    course: Course, policy: Policy, issued: tuple[Variant, ...]
) -> None:
    found = uneven_costs(mistake_costs(course, policy, issued), policy)
    assert "lifting_load" in {one.quantity for one in found}
    assert not [one for one in found if one.is_main]


def test_weights_without_main_results_are_named(
    course: Course, policy: Policy, issued: tuple[Variant, ...]
) -> None:
    found = said(course, replace(policy, main_points={}), issued)
    assert "points.quantity" in {key for key, _ in found}
    assert any("'grip'" in what for _, what in found)


@pytest.mark.parametrize("name", ["grip_force", "beam_deflection"])
def test_a_tolerance_that_is_wide_beside_the_smallest_issued_value_is_named(
    course: Course, policy: Policy, issued: tuple[Variant, ...], name: str
) -> None:
    wide = replace(policy, tolerances={**policy.tolerances, name: Tolerance(0.01, 50.0)})
    [(key, what)] = said(course, wide, issued)
    assert key == f"quantity_tolerance.{name}"
    (variant,) = re.findall(rf"which '{name}' has in variant (\d+) of t.csv", what)
    values = {
        one.id: abs(solve_variant(plan, one.given)[name])
        for one in issued
        if name in (plan := plan_of(course, one.composition)).quantities
    }
    assert values[variant] == min(values.values())


def test_a_floor_that_is_wide_beside_what_is_issued_is_named(
    course: Course, policy: Policy, issued: tuple[Variant, ...]
) -> None:
    wide = replace(policy, floors={**policy.floors, "deg": 5.0})
    found = said(course, wide, issued)
    assert found
    assert {key for key, _ in found} == {"tolerance.floor.deg"}
    assert all("in t.csv: a guess may meet it" in what for _, what in found)


def test_a_floor_of_plain_numbers_is_named_as_the_policy_writes_it(
    course: Course, policy: Policy, issued: tuple[Variant, ...]
) -> None:
    wide = replace(policy, floors={**policy.floors, "": 0.5})
    found = said(course, wide, issued)
    assert {key for key, _ in found} == {'tolerance.floor.""'}
    assert not any(" ," in what for _, what in found)


def test_an_answer_that_is_the_same_in_all_variants_may_earn_little(
    course: Course, policy: Policy, issued: tuple[Variant, ...]
) -> None:
    """An angle that is 0 in all variants of a scheme; a ratio of no given number is exempt."""
    heavy = {**policy.weights, "arm_angle_at_min": 9.0, "velocity_ratio": 9.0}
    found = said(course, replace(policy, weights=heavy), issued)
    assert [key for key, _ in found] == ["weight.quantity.arm_angle_at_min"]
    assert "'rack_parallelogram'" in found[0][1]
