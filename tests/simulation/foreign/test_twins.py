"""Two mistakes that come to one number: names that nobody can tell apart."""

import pytest

from gripcourse.simulation.foreign.kinds import Writing
from gripcourse.simulation.foreign.twins import is_written_as


@pytest.mark.parametrize(
    ("value", "number", "writing", "same"),
    [
        (14437.5, 14400.0, Writing.FIGURES_3, True),  # a tenth, or a digit lost
        (14437.5, 14400.0, Writing.FIGURES_5, False),
        (1344.2, 1344.0, Writing.FIGURES_4, True),
        (1344.2, 1344.0, Writing.MIXED, True),
        (float("nan"), 1.0, Writing.FIGURES_3, False),
    ],
)
def test_a_number_that_was_copied_is_one_as_it_was_written(
    value: float, number: float, writing: Writing, *, same: bool
) -> None:
    assert is_written_as(value, number, writing) is same
