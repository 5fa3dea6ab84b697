"""Functions of single numbers give the same bits as their array forms."""

import itertools
import math
import warnings

import numpy as np
import pytest

from gripcourse.formula.functions import FUNCTIONS, SLACK, Column
from gripcourse.formula.single import SINGLE

COLUMN = Column(np.asarray([10.0, 30.0, 20.0, 40.0]), np.asarray([1.0, 2.0, 4.0, 1000.0]))
_DRAWN = np.random.default_rng(7)
NUMBERS = (
    math.nan, 0.0, -0.0, 1.0, -1.0, 1 + 1e-15, 0.5, -0.5, 2.0, 30.0, 30 * (1 + SLACK / 2), 1000.0,
    1000 * (1 + 2 * SLACK), 1e-300, 1.7e308, -1.7e308,
    *_DRAWN.uniform(-1, 1, 60).tolist(), *_DRAWN.uniform(-1000, 1000, 60).tolist(),
)  # fmt: skip


@pytest.mark.parametrize("name", SINGLE)
def test_a_function_of_single_numbers_gives_the_bits_of_its_array_form(name: str) -> None:
    record = FUNCTIONS[name]
    columns = (COLUMN,) if record.reads_column else ()
    for numbers in itertools.islice(itertools.product(NUMBERS, repeat=record.least), 900):
        with np.errstate(all="ignore"):
            arrays = tuple(map(np.asarray, numbers))
            expected = np.float64(record.compute(arrays, COLUMN if columns else None))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            found = SINGLE[name](*numbers, *columns)
        assert type(found) is float, numbers
        same = np.float64(found).tobytes() == expected.tobytes()
        assert same or (math.isnan(found) and not np.isfinite(expected)), (numbers, found, expected)
