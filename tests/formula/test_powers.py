"""A column and each of its numbers come to the same bits, by the instructions of any processor."""

import math

import numpy as np
import pytest

from gripcourse.formula.compiled import of_arrays, of_numbers
from gripcourse.formula.parse import parse

MANY = 4099  # by wide instructions, and a rest
_DRAWN = np.random.default_rng(11)
BASES = np.concatenate([
    [math.nan, 0.0, -0.0, 1.0, -1.0, 1e-300, 1e200, -1e200],
    _DRAWN.uniform(-3, 3, MANY), _DRAWN.uniform(0, 1e-3, MANY), _DRAWN.uniform(0, 1e6, MANY),
])  # fmt: skip
OTHERS = _DRAWN.uniform(-2, 2, BASES.size)


@pytest.mark.parametrize(
    "formula",
    [
        *(f"base**{exponent}" for exponent in ("2", "3", "4", "5", "0.09", "1.5", "5.25588", "0")),
        "base**-2", "base**other", "other**base", "2**base", "atan2(base, other)",
        "hypot(base, other)", "sin(base)*exp(-other)", "cbrt(base)", "log(base)", "acos(base)",
    ],
)  # fmt: skip
def test_a_column_has_the_bits_of_its_numbers(formula: str) -> None:
    node = parse(formula)
    with np.errstate(all="ignore"):
        column = np.broadcast_to(
            of_arrays(node)({"base": BASES, "other": OTHERS}, {}, None), BASES.shape
        )
    by_itself = of_numbers(node)
    for base, other, expected in zip(BASES.tolist(), OTHERS.tolist(), column.tolist(), strict=True):
        found = by_itself({"base": base, "other": other}, {})
        assert found == expected or (math.isnan(found) and math.isnan(expected)), (base, other)
