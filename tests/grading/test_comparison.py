"""Nothing is accepted that was not computed."""

import math
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.comparison import NOWHERE, ExpectedRange
from gripcourse.grading.model import Outcome
from gripcourse.policy.bands import within

if TYPE_CHECKING:
    from conftest import Case

NUMBERS = [-1e9, 0.0, 1.0, 3.14, math.inf, math.nan]


@pytest.mark.parametrize("typed", NUMBERS)
@pytest.mark.parametrize(
    "expected",
    [
        NOWHERE,
        ExpectedRange(1.0, math.nan, 2.0),
        ExpectedRange(1.0, 0.5, math.nan),
        ExpectedRange(math.nan, math.nan, 2.0),
    ],
)
def test_no_number_follows_from_what_has_no_value(typed: float, expected: ExpectedRange) -> None:
    assert math.isnan(expected.nearest(typed))
    assert not within(typed, expected.nearest(typed), 1e30)


@pytest.mark.parametrize("typed", NUMBERS)
def test_no_number_lies_in_a_band_that_has_no_width(typed: float) -> None:
    assert not within(typed, 1.0, math.nan)
    assert not within(math.nan, 1.0, 1.0)


@pytest.mark.parametrize(("typed", "nearest"), [(0.0, 1.0), (1.5, 1.5), (7.0, 2.0)])
def test_the_nearest_point_of_a_range_is_in_it(typed: float, nearest: float) -> None:
    assert ExpectedRange(1.4, 1.0, 2.0).nearest(typed) == nearest


def test_zero_is_what_the_cosine_of_a_right_angle_comes_to(drawn: "tuple[Case, ...]") -> None:
    """After a mistake of the angle: floating point makes 6e-16 of it, beside a ratio of ten."""
    case = next(one for one in drawn if one.plan.scheme.id == "rack_parallelogram")
    follows = case.following(arm_angle_at_min=90.0)
    found = case.findings({**follows, "arm_angle_at_min": 90.0, "force_ratio_at_min": 0.0})
    assert found["force_ratio_at_min"].outcome is Outcome.CARRIED
