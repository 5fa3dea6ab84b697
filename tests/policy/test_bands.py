"""How far an answer may be from what it is compared with."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.course.quantity import Kind, Tolerance
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.policy.bands import FLOOR_SHARE, band, bands, tolerance_of, within
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan


def test_far_from_zero_the_relative_part_counts(plan: Plan, policy: Policy) -> None:
    assert band(plan.quantities["grip_force"], -3900, policy) == pytest.approx(39)


def test_near_zero_the_absolute_part_counts(plan: Plan, policy: Policy) -> None:
    width = band(plan.quantities["arm_angle_at_min"], 0.0, policy)
    assert width == pytest.approx(policy.floors["deg"])
    assert width > 0


def test_a_policys_band_of_a_quantity_goes_before_its_declaration(
    plan: Plan, policy: Policy
) -> None:
    force = replace(plan.quantities["grip_force"], tolerance=Tolerance(0.03, 5.0))
    assert tolerance_of(force, policy) == Tolerance(0.03, 5.0)
    own = replace(policy, tolerances={"grip_force": Tolerance(0.002, 0.0)})
    assert tolerance_of(force, own) == Tolerance(0.002, policy.floors["N"])


def test_an_entry_of_a_series_has_no_band_but_floating_point(plan: Plan, policy: Policy) -> None:
    assert band(plan.quantities["bore"], 63, policy) < 0.001


@pytest.mark.parametrize(
    ("text", "exact"),
    [
        ('lookup("bore.rod", bore)', True),
        ('lookup("bore.rod", at_least("bore.bore", bore_required))', True),
        ('min(lookup("bore.rod", bore), lookup("bore.thread", bore))', True),
        ('interpolate("bore.rod", bore)', False),
        ('2*lookup("bore.rod", bore)', False),
    ],
)
def test_what_is_read_between_entries_of_a_table_has_the_band_of_a_computed_value(
    plan: Plan, policy: Policy, text: str, *, exact: bool
) -> None:
    formula = Formula(text, parse(text), {})
    rod = replace(plan.quantities["rod"], kind=Kind.PICK, choice=None, formula=formula)
    assert rod.exact is exact
    width = 40e-6 if exact else 40 * policy.tolerance.relative
    assert band(rod, 40, policy) == pytest.approx(width)
    assert bands(rod, np.array([0.04]), policy) == pytest.approx(width / 1000)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_what_is_no_number_matches_nothing(value: float) -> None:
    assert not within(value, value, 1.0)
    assert not within(1.0, value, math.inf)
    assert not within(value, 1.0, 1.0)


@given(
    expected=st.floats(-1e6, 1e6, allow_nan=False),
    width=st.floats(1e-3, 1e3),
    share=st.floats(0, 3),
)
def test_inside_is_up_to_the_edge_and_no_farther(
    expected: float, width: float, share: float
) -> None:
    value = expected + share * width
    distance = abs(value - expected)
    if distance <= width:
        assert within(value, expected, width)
    if distance > width * (1 + 1e-8):
        assert not within(value, expected, width)


def test_a_floor_is_small_beside_a_value_that_cannot_be_zero(plan: Plan, policy: Policy) -> None:
    stress = plan.quantities["bearing_stress"]
    assert policy.floors["MPa"] > 0.006
    assert band(stress, 0.015, policy) < 0.006
    widths = bands(stress, np.array([0.015e6, 100e6]), policy)
    assert widths.tolist() == pytest.approx([FLOOR_SHARE * 0.015e6, 1e6])
