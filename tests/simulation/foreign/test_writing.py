"""What a student writes down of a number that a mistake has made very large."""

import numpy as np
import pytest

from gripcourse.simulation.foreign.kinds import Writing
from gripcourse.simulation.foreign.writing import written


@pytest.mark.parametrize("writing", list(Writing))
def test_what_no_calculator_shows_decimals_of_is_written_in_full(writing: Writing) -> None:
    text = written(2.5e40, writing, np.random.default_rng(1))
    assert float(text) == pytest.approx(2.5e40)


def test_decimals_that_end_in_zeros_belong_to_the_number() -> None:
    assert written(14.5, Writing.TWO_DECIMALS, np.random.default_rng(1)) == "14.50"
