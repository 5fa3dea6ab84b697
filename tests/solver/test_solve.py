"""One function computes, judges and asks what-if: a known value replaces the formula's."""

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from gripcourse.course.model import Course, WorkedExample
from gripcourse.course.quantity import Convention, Kind, Rounding
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.sizes import entry, reference_rounding
from gripcourse.solver.solve import evaluate, from_si, solve_variant, to_si

SCHEME = "rack_parallelogram"


def downstream(plan: Plan, name: str) -> set[str]:
    """Every quantity that a quantity's value reaches, itself included."""
    reached = {name}
    for other in plan.quantities:
        if reached & set(plan.inputs[other]):
            reached.add(other)
    return reached


def test_a_known_value_replaces_the_formula_downstream(plan: Plan, example: WorkedExample) -> None:
    right = solve_variant(plan, example.given)
    student = solve_variant(plan, {**example.given, "pitch_radius": 40.0})
    assert student["pitch_radius"] == 40.0
    assert student["force_ratio_at_min"] == pytest.approx(2 * 150 / 40)
    assert student["drive_force"] == pytest.approx(right["drive_force"] * 51 / 40)
    untouched = set(right) - downstream(plan, "pitch_radius")
    assert {name: student[name] for name in untouched} == {name: right[name] for name in untouched}


def test_a_virtual_student_is_judged_by_own_numbers(plan: Plan, example: WorkedExample) -> None:
    known = to_si(plan, {**example.given, "grip_force": 4000.0, "drive_force": 1000.0})
    evaluation = evaluate(plan, known)
    assert evaluation.values["drive_force"] == 1000.0
    assert evaluation.computed["grip_force"] == pytest.approx(3900.0)
    assert evaluation.computed["drive_force"] == pytest.approx(4000 * 300 / 51)
    assert evaluation.computed["bore_required"] == pytest.approx(
        math.sqrt(4 * 1000 / (math.pi * 10e6 * 0.8091))
    )


def test_nan_means_that_a_value_was_not_supplied(plan: Plan, example: WorkedExample) -> None:
    known = to_si(plan, example.given)
    blank = dict.fromkeys((one.id for one in plan.answered), math.nan)
    assert from_si(plan, evaluate(plan, known | blank).values) == solve_variant(plan, example.given)


def test_a_missing_given_takes_only_what_needs_it(plan: Plan, example: WorkedExample) -> None:
    incomplete = {name: value for name, value in example.given.items() if name != "mass"}
    values = solve_variant(plan, incomplete)
    lost = {name for name, value in values.items() if math.isnan(value)}
    assert lost == downstream(plan, "mass") - {one.id for one in plan.manual}
    assert "jaw_travel" not in lost


def test_a_value_outside_a_formulas_domain_is_no_value(plan: Plan, example: WorkedExample) -> None:
    values = solve_variant(plan, {**example.given, "arm_length": 80.0})  # the travel is 90
    assert math.isnan(values["arm_angle_open"])
    assert math.isnan(values["stroke_required"])
    assert values["grip_force"] == pytest.approx(3900)


def test_a_choice_beyond_its_series_is_no_value(plan: Plan, example: WorkedExample) -> None:
    values = solve_variant(plan, {**example.given, "bore_required": 2000.0})
    assert math.isnan(values["bore"])


def test_arrays_and_single_numbers_agree(plan: Plan, example: WorkedExample) -> None:
    masses = [10.0, 60.0, 80.0]
    singles = [solve_variant(plan, {**example.given, "mass": mass}) for mass in masses]
    together = evaluate(plan, {**to_si(plan, example.given), "mass": np.array(masses)}).values
    for name, values in together.items():
        spread = np.broadcast_to(values, (3,))
        alone = [to_si(plan, {name: single[name]})[name] for single in singles]
        assert np.allclose(spread, alone, rtol=1e-12, atol=1e-15), name


def test_a_hole_in_an_array_is_filled_by_the_formula(plan: Plan, example: WorkedExample) -> None:
    known = {**to_si(plan, example.given), "grip_force": np.array([4000.0, math.nan])}
    values = evaluate(plan, known).values
    assert values["grip_force"] == pytest.approx([4000.0, 3900.0])
    assert values["gear_torque"] == pytest.approx([600.0, 585.0])


def test_a_constant_can_be_replaced(plan: Plan, example: WorkedExample) -> None:
    bare = {name: value for name, value in example.given.items() if name != "gravity"}
    assert solve_variant(plan, bare)["grip_force"] == pytest.approx(3850.6)  # method E16
    assert solve_variant(plan, {**bare, "gravity": 10.0})["grip_force"] == pytest.approx(3900)


def test_every_quantity_but_the_manual_ones_has_a_value(plan: Plan, example: WorkedExample) -> None:
    values = solve_variant(plan, example.given)
    manual = {one.id for one in plan.manual}
    assert values.keys() == plan.quantities.keys() - manual
    assert all(math.isfinite(value) for value in values.values())


def test_conventions_differ_where_the_guide_errs(
    course: Course, plan: Plan, example: WorkedExample
) -> None:
    guide = make_plan(course, SCHEME, plan.options, Convention.AS_PRINTED)
    right, printed = solve_variant(plan, example.given), solve_variant(guide, example.given)
    differing = {
        name for name in ("jaw_width_required", "module_required", "force_ratio", "pin_diameter",
                          "bearing_stress") if right[name] != pytest.approx(printed[name])
    }  # fmt: skip
    assert len(differing) == 5
    assert right["jaw_travel"] == printed["jaw_travel"]


def test_a_source_may_round_a_choice_otherwise(
    course: Course, plan: Plan, example: WorkedExample
) -> None:
    pin = plan.quantities["pin_diameter_first"]
    assert reference_rounding(pin, Convention.CORRECTED) is Rounding.UP
    assert reference_rounding(pin, Convention.AS_PRINTED) is Rounding.NEAREST
    bore = plan.quantities["bore"]
    assert reference_rounding(bore, Convention.AS_PRINTED) is Rounding.UP
    guide = make_plan(course, SCHEME, plan.options, Convention.AS_PRINTED)
    assert solve_variant(plan, example.given)["pin_diameter"] == 12
    assert solve_variant(guide, example.given)["pin_diameter"] == 10


def test_declared_units_come_back_as_they_were(plan: Plan, example: WorkedExample) -> None:
    values = solve_variant(plan, example.given)
    assert {name: values[name] for name in example.given} == example.given
    assert values["bore"] == 63
    assert values["arm_angle_open"] == pytest.approx(math.degrees(math.asin(0.6)))


def test_what_floating_point_leaves_of_a_zero_is_zero(plan: Plan, example: WorkedExample) -> None:
    given = {**example.given, "diameter_max": 118.0, "diameter_min": 28.0, "release_travel": 4.0}
    raw = evaluate(plan, to_si(plan, given)).values["arm_angle_at_min"]
    assert raw != 0
    assert solve_variant(plan, given)["arm_angle_at_min"] == 0


@given(value=st.floats(-1e9, 1e9, allow_nan=False), data=st.data())
def test_units_there_and_back_change_nothing(plan: Plan, value: float, data: st.DataObject) -> None:
    name = data.draw(st.sampled_from([*plan.quantities]))
    there = to_si(plan, {name: value})
    assert from_si(plan, there)[name] == pytest.approx(value, rel=1e-13, abs=1e-12)


def series(plan: Plan) -> NDArray[np.float64]:
    choice = plan.quantities["bore"].choice
    assert choice is not None
    return plan.columns[choice.column].sizes


@given(required=st.floats(1e-3, 0.79))
def test_a_chosen_size_is_the_smallest_that_suffices(plan: Plan, required: float) -> None:
    choice = plan.quantities["bore"].choice
    assert choice is not None
    chosen = float(entry(plan, choice, Rounding.UP, np.array(required)))
    assert chosen >= required * (1 - 1e-9)
    assert not any(required <= size < chosen for size in series(plan))


@given(required=st.floats(1e-3, 2.0))
def test_the_nearest_size_has_no_nearer_neighbour(plan: Plan, required: float) -> None:
    choice = plan.quantities["bore"].choice
    assert choice is not None
    chosen = float(entry(plan, choice, Rounding.NEAREST, np.array(required)))
    distances = np.abs(series(plan) - required)
    assert abs(chosen - required) <= distances.min() + 1e-9 * required


@given(data=st.data())
def test_what_is_not_downstream_never_changes(
    plan: Plan, example: WorkedExample, data: st.DataObject
) -> None:
    name = data.draw(st.sampled_from([one.id for one in plan.answered]))
    factor = data.draw(st.floats(0.5, 2.0))
    right = solve_variant(plan, example.given)
    changed = solve_variant(plan, {**example.given, name: right[name] * factor})
    untouched = sorted(set(right) - downstream(plan, name))
    assert [changed[one] for one in untouched] == [right[one] for one in untouched]


@given(data=st.data())
def test_supplying_what_is_computed_anyway_changes_nothing(
    plan: Plan, example: WorkedExample, data: st.DataObject
) -> None:
    names = data.draw(st.sets(st.sampled_from([one.id for one in plan.answered])))
    first = evaluate(plan, to_si(plan, example.given)).values
    known = {**to_si(plan, example.given), **{name: first[name] for name in names}}
    again = evaluate(plan, known).values
    assert all(np.array_equal(again[name], first[name]) for name in first)


@given(factor=st.floats(0.1, 10.0))
def test_forces_are_proportional_to_the_mass(
    plan: Plan, example: WorkedExample, factor: float
) -> None:
    one = solve_variant(plan, example.given)
    other = solve_variant(plan, {**example.given, "mass": 60 * factor})
    for name in ("lifting_load", "grip_force", "gear_torque", "jaw_pin_force"):
        assert other[name] == pytest.approx(one[name] * factor, rel=1e-12)
    assert other["jaw_travel"] == one["jaw_travel"]


def test_a_plan_without_a_formula_of_a_quantity_has_no_value_of_it(
    plan: Plan, example: WorkedExample
) -> None:
    bare = dataclasses.replace(plan.quantities["pin_length"], formula=None, kind=Kind.GIVEN)
    changed = dataclasses.replace(plan, quantities={**plan.quantities, "pin_length": bare})
    values = solve_variant(changed, example.given)
    assert math.isnan(values["pin_length"])
    assert math.isnan(values["bearing_stress"])
