import inspect

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.formula import boxes, rules
from gripcourse.formula.functions import (
    FUNCTIONS,
    SLACK,
    Array,
    Column,
    Function,
    at_least,
    interpolate,
    lookup,
    nearest,
)
from gripcourse.formula.tree import Call, Number
from gripcourse.text.units import dimension

# Two columns of the same rows: sizes need not be in order, what is looked up is.
SERIES = Column(np.array([10.0, 30.0, 20.0, 40.0]), np.array([1.0, 2.0, 4.0, 8.0]))
NAN = float("nan")


def _one(compute: object, value: float, column: Column = SERIES) -> float:
    assert callable(compute)
    return float(compute((np.asarray(value),), column))


@pytest.mark.parametrize(
    ("value", "size"),
    [
        (0.0, 10.0),
        (-5.0, 10.0),
        (1.0, 10.0),
        (1.0 + 0.5 * SLACK, 10.0),
        (1.0 + 2 * SLACK, 30.0),
        (3.0, 20.0),
        (8.0, 40.0),
        (8.0 * (1 + 0.5 * SLACK), 40.0),
        (8.1, NAN),
        (NAN, NAN),
    ],
)
def test_at_least_is_the_first_row_not_below_and_nothing_above_the_last(
    value: float, size: float
) -> None:
    assert _one(at_least, value) == pytest.approx(size, nan_ok=True)


@pytest.mark.parametrize(
    ("value", "size"),
    [
        (-9.0, 10.0),
        (1.4, 10.0),
        (1.5, 10.0),  # equally near: the lower
        (1.5 + SLACK / 4, 10.0),
        (1.6, 30.0),
        (2.9, 30.0),
        (3.1, 20.0),
        (800.0, 40.0),
        (NAN, NAN),
    ],
)
def test_nearest_is_the_row_with_the_least_difference(value: float, size: float) -> None:
    assert _one(nearest, value) == pytest.approx(size, nan_ok=True)


@pytest.mark.parametrize(
    ("size", "value"),
    [
        (10.0, 1.0),
        (20.0, 4.0),
        (20.0 * (1 + 0.5 * SLACK), 4.0),
        (20.1, NAN),
        (0.0, NAN),
        (NAN, NAN),
    ],
)
def test_lookup_is_the_row_of_that_size_and_no_other(size: float, value: float) -> None:
    assert _one(lookup, size) == pytest.approx(value, nan_ok=True)


def test_the_first_of_two_rows_of_one_size_counts() -> None:
    twice = Column(np.array([5.0, 5.0]), np.array([1.0, 2.0]))
    assert _one(lookup, 5.0, twice) == 1.0


# A table that is read between its rows: sizes in order, values as they come.
TABLE = Column(np.array([1.0, 2.0, 4.0]), np.array([10.0, 30.0, 20.0]))


@pytest.mark.parametrize(
    ("size", "value"),
    [
        (1.0, 10.0),
        (1.5, 20.0),
        (2.0, 30.0),
        (3.0, 25.0),
        (4.0, 20.0),
        (4.0 * (1 + 0.5 * SLACK), 20.0),
        (1.0 - 0.5 * SLACK, 10.0),
        (0.9, NAN),
        (4.1, NAN),
        (NAN, NAN),
    ],
)
def test_interpolate_goes_straight_from_row_to_row_and_not_beyond(
    size: float, value: float
) -> None:
    assert _one(interpolate, size, TABLE) == pytest.approx(value, nan_ok=True)


_values = st.lists(st.floats(0.01, 1e4), min_size=1, max_size=12, unique=True).map(sorted)


@given(_values, st.floats(0.001, 2e4))
def test_catalogue_functions_agree_with_their_definitions(
    values: list[float], wanted: float
) -> None:
    sizes = [float(index) for index in range(len(values))]
    column = Column(np.array(sizes), np.array(values))
    above = [s for s, v in zip(sizes, values, strict=True) if v >= wanted - SLACK * abs(wanted)]
    assert _one(at_least, wanted, column) == pytest.approx(min(above, default=NAN), nan_ok=True)
    distance = abs(values[int(_one(nearest, wanted, column))] - wanted)
    assert distance <= min(abs(v - wanted) for v in values) + SLACK * wanted
    for size, value in zip(sizes, values, strict=True):
        assert _one(lookup, size, column) == value


@given(st.lists(st.floats(-50, 50), min_size=1, max_size=20))
def test_many_values_are_looked_up_as_one_by_one(wanted: list[float]) -> None:
    together = at_least((np.array(wanted),), SERIES)
    alone = [_one(at_least, value) for value in wanted]
    np.testing.assert_array_equal(together, alone)


def test_a_direction_that_is_none_has_no_angle() -> None:
    compute = FUNCTIONS["atan2"].compute
    rise, run = np.array([0.0, 1.0, -1.0]), np.array([0.0, 0.0, -1.0])
    expected = [NAN, np.pi / 2, -3 * np.pi / 4]
    np.testing.assert_allclose(compute((rise, run), None), expected)


def test_every_function_is_known_by_its_own_name_and_takes_a_sensible_number_of_values() -> None:
    for name, function in FUNCTIONS.items():
        assert function.name == name
        assert 1 <= function.least <= function.most
        assert callable(function.compute)


def test_another_function_needs_one_record() -> None:
    """A contact pressure, say, that no spreadsheet computes."""

    def compute(arguments: tuple[Array, ...], _column: Column | None) -> Array:
        force, radius = arguments
        return np.asarray(force / radius**2)

    hertz = Function(
        "hertz",
        2,
        2,
        reads_column=False,
        compute=compute,
        rule=rules.of_units(("N", "m"), "Pa"),
        form=boxes.word("H"),
        excel=None,
    )
    call = Call("hertz", (Number(1.0, "1"), Number(2.0, "2")))
    measured = hertz.rule(call, (dimension("N"), dimension("mm")), None)
    assert measured == dimension("MPa")
    assert float(hertz.compute((np.array(8.0), np.array(2.0)), None)) == 2.0
    assert set(inspect.signature(Function).parameters) >= {"compute", "rule", "form", "excel"}
