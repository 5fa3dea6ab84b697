"""Many numbers find their places in a series as one does."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula.places import places

MANY = 3000


@given(
    st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=90).map(sorted),
    st.floats(-1e3, 1e3),
    st.floats(1e-3, 1e3),
    st.integers(0, 2**32),
)
def test_places_are_those_of_a_search(
    series: list[float], middle: float, spread: float, seed: int
) -> None:
    entries = np.array(series)
    numbers = np.random.default_rng(seed).normal(middle, spread, MANY)
    numbers[::7] = np.resize(entries, numbers[::7].size)  # an entry is not below itself
    assert np.array_equal(places(entries, numbers), np.searchsorted(entries, numbers))


@pytest.mark.parametrize("count", [1, MANY])
def test_numbers_have_their_places_beside_what_is_no_number(count: int) -> None:
    entries = np.array([1.0, 2.0, 5.0])
    numbers = np.resize([1.5, np.nan, 9.0], count)
    there = ~np.isnan(numbers)
    assert np.array_equal(places(entries, numbers)[there], np.resize([1, 3, 3], count)[there])


def test_one_number_has_one_place() -> None:
    assert places(np.array([1.0, 2.0]), np.asarray(1.5)) == 1
