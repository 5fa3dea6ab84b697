"""Calculations as people do them, on the worked example of the guide."""

from dataclasses import replace

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.policy.model import Policy
from gripcourse.simulation.arithmetic import Hand
from gripcourse.simulation.calculation import Calculation, Deviation, by_formula, calculate
from gripcourse.simulation.model import ActionKind
from gripcourse.simulation.places import Effect, effect, make_ground
from gripcourse.slips.candidates import candidates_of
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant


def hand(figures: int = 10, *, cuts: bool = False, keeps: bool = False) -> Hand:
    return Hand(
        np.asarray(figures), np.asarray(cuts), np.asarray(keeps), np.asarray(np.pi), constants={}
    )


@pytest.fixture
def given(plan: Plan) -> dict[str, float]:
    assert plan.scheme.example is not None
    return {one.id: plan.scheme.example.given[one.id] for one in plan.givens}


def typed(done: Calculation) -> dict[str, float]:
    return {name: float(step.typed) for name, step in done.steps.items()}


def test_who_writes_every_figure_gets_the_reference(plan: Plan, given: dict[str, float]) -> None:
    found = typed(calculate(plan, given, hand(), {}))
    reference = solve_variant(plan, given)
    assert found == pytest.approx({name: reference[name] for name in found}, rel=1e-8)


def test_the_next_step_is_computed_with_what_was_written(
    plan: Plan, given: dict[str, float]
) -> None:
    found = typed(calculate(plan, given, hand(3), {}))
    known = {**given, **found}
    for quantity in plan.answered:
        if quantity.kind is Kind.FORMULA:
            alone = {name: value for name, value in known.items() if name != quantity.id}
            right = solve_variant(plan, alone)[quantity.id]
            assert found[quantity.id] == float(f"{right:.2e}"), quantity.id


def test_a_calculator_loses_nothing_on_the_way(plan: Plan, given: dict[str, float]) -> None:
    found = typed(calculate(plan, given, hand(3, keeps=True), {}))
    reference = solve_variant(plan, given)
    for quantity in plan.answered:
        if quantity.kind is Kind.FORMULA:
            assert found[quantity.id] == float(f"{reference[quantity.id]:.2e}"), quantity.id


def test_a_size_is_taken_from_the_series_for_the_students_own_number(
    plan: Plan, given: dict[str, float]
) -> None:
    found = calculate(plan, given, hand(3), {})
    bore, required = found.steps["bore"].typed, found.steps["bore_required"].typed
    assert bore >= required
    assert float(bore) == pytest.approx(solve_variant(plan, {**given, "bore": bore})["bore"])


def test_constants_and_pi_are_the_students_own(plan: Plan, given: dict[str, float]) -> None:
    own = replace(hand(), pi=np.asarray(3.14), constants={"gravity": np.asarray(9.8)})
    shortened, exact = calculate(plan, given, own, {}), calculate(plan, given, hand(), {})
    ratio = shortened.steps["lifting_load"].typed / exact.steps["lifting_load"].typed
    assert 9.8 / 9.81 < float(ratio) < 1  # the acceleration of the lift is added to gravity
    assert float(shortened.values["gravity"]) == 9.8


def test_a_slip_changes_its_own_step_and_what_follows(
    plan: Plan, policy: Policy, given: dict[str, float]
) -> None:
    slips = candidates_of(plan, "drive_force", policy.slips)
    slip = next(one for one in slips if one.kind == "power_of_ten")
    right = calculate(plan, given, hand(), {})
    wrong = calculate(plan, given, hand(), {"drive_force": Deviation(ActionKind.SLIP, slip)})
    changed = {name for name in right.steps if typed(right)[name] != typed(wrong)[name]}
    assert "drive_force" in changed
    assert "bore_required" in changed
    assert "grip_force" not in changed
    assert float(wrong.steps["drive_force"].right) == float(right.steps["drive_force"].right)


def test_who_types_another_unit_goes_on_with_the_right_number(
    plan: Plan, policy: Policy, given: dict[str, float]
) -> None:
    unit = next(
        one for one in candidates_of(plan, "drive_force", policy.slips) if str(one.id) == "unit:kN"
    )
    right = typed(calculate(plan, given, hand(), {}))
    bare = typed(
        calculate(plan, given, hand(), {"drive_force": Deviation(ActionKind.BARE_UNIT, unit)})
    )
    assert bare.pop("drive_force") == pytest.approx(right.pop("drive_force") / 1000)
    assert bare == right


def test_who_rounds_a_size_down_takes_the_next_smaller_one(
    plan: Plan, given: dict[str, float]
) -> None:
    done = calculate(plan, given, hand(), {"bore": Deviation(ActionKind.ROUNDED_DOWN)})
    sizes = plan.columns[plan.quantities["bore"].choice.column].sizes  # type: ignore[union-attr]
    right, taken = float(done.steps["bore"].right), float(done.steps["bore"].typed)
    below = sizes[sizes < right / 1000 * 0.999]
    assert taken == pytest.approx(1000 * below.max())


def test_nothing_lies_below_the_smallest_size(plan: Plan, given: dict[str, float]) -> None:
    light = {**given, "mass": 1e-3}
    done = calculate(plan, light, hand(), {"bore": Deviation(ActionKind.ROUNDED_DOWN)})
    assert np.isnan(done.steps["bore"].typed)


def test_many_variants_are_computed_at_once(plan: Plan, given: dict[str, float]) -> None:
    masses = np.array([given["mass"], 0.9 * given["mass"]])
    both = calculate(plan, {**given, "mass": masses}, hand(4), {})
    for number, mass in enumerate(masses):
        alone = calculate(plan, {**given, "mass": mass}, hand(4), {})
        for name, step in both.steps.items():
            many = np.broadcast_to(step.typed, (2,))
            assert float(many[number]) == float(alone.steps[name].typed), name


def test_what_another_honest_reading_gives_is_told_from_nothing_right(
    course: Course, policy: Policy
) -> None:
    """The moment at the hub instead of at the sector: no place for a slip that comes to it."""
    example = course.schemes["worm_sector"].example
    assert example is not None
    plan = make_plan(course, "worm_sector", example.options)
    given = {one.id: float(example.given[one.id]) for one in plan.givens}
    ground = make_ground(plan, policy, lambda _: (), hand(), given, 2.0)
    done = calculate(plan, given, hand(), {})
    [other] = plan.quantities["lever_bending_moment"].alternatives
    name, step = "lever_bending_moment", done.steps["lever_bending_moment"]
    read = by_formula(plan, plan.quantities[name], other.formula, done.values, hand())
    for value, seen in ((read, Effect.HIDDEN), (1.1 * read, Effect.APART)):
        typed_so = replace(done, steps={**done.steps, name: replace(step, typed=value)})
        assert effect(ground, name, typed_so) is seen
    assert float(read) > 1.05 * float(step.right)


def test_a_second_mistake_that_undoes_the_first_is_told_from_nothing_right(
    plan: Plan, given: dict[str, float], policy: Policy
) -> None:
    """Nobody sees a wrong force in what was computed with the right one, wherever it came from."""
    ground = make_ground(plan, policy, lambda _: (), hand(), given, 2.0)
    right = calculate(plan, given, hand(), {})
    name = "lifting_load"
    wrong = right.steps[name].typed / 2
    copied = Deviation(ActionKind.COPIED, copied=float(wrong))
    done = calculate(plan, given, hand(), {name: copied})
    assert float(done.steps["grip_force"].right) < 0.6 * float(right.steps["grip_force"].right)
    for times, seen in ((2.0, Effect.HIDDEN), (3.0, Effect.APART)):
        step = replace(done.steps["grip_force"], typed=times * done.steps["grip_force"].right)
        typed_so = replace(done, steps={**done.steps, "grip_force": step})
        assert effect(ground, "grip_force", typed_so) is seen
