"""Equal numbers are found by sorting; comparing all with all finds the same."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.likeness.cells import Flags, SparseTable
from gripcourse.likeness.matches import (
    ComparedNumbers,
    Matches,
    Spread,
    in_order,
    last_unit,
    met,
    same_as_issued,
    same_as_typed,
)

ROWS, COLUMNS = 6, 3
SIZES = st.sampled_from([1.0, 1.01, 1.02, 9.99, 10.0, 12.3, -12.3, 250.0, 251.0, 0.05])
TABLES = st.lists(
    st.lists(st.one_of(SIZES, st.just(float("nan"))), min_size=COLUMNS, max_size=COLUMNS),
    min_size=ROWS,
    max_size=ROWS,
)


def numbers(table: list[list[float]]) -> ComparedNumbers:
    values = np.array(table)
    row, column = np.nonzero(np.isfinite(values))
    value = values[row, column]
    return ComparedNumbers(row, column, value, last_unit(value, np.full(len(value), 0.05)))


def all_of(asked: ComparedNumbers) -> Flags:
    return np.ones(len(asked.value), dtype=np.bool_)


@given(typed=TABLES, issued=TABLES)
def test_every_variant_within_one_unit_of_the_last_digit_is_found(
    typed: list[list[float]], issued: list[list[float]]
) -> None:
    asked, values = numbers(typed), np.array(issued)
    others = in_order(SparseTable.of_table(values))
    found = Matches.of(same_as_issued(asked), all_of(asked), others)
    expected = {
        (index, owner)
        for index, (column, value, unit) in enumerate(
            zip(asked.column, asked.value, asked.unit, strict=True)
        )
        for owner in range(ROWS)
        if abs(values[owner, column] - value) <= max(unit, 0.002 * abs(value)) * (1 + 1e-9)
    }
    number, owner = found.owners(np.arange(len(asked.value)))
    assert set(zip(number.tolist(), owner.tolist(), strict=True)) == expected
    every, anybody = (one.ravel() for one in np.indices((len(asked.value), ROWS)))
    same = found.are_same(every, anybody)
    assert set(zip(every[same].tolist(), anybody[same].tolist(), strict=True)) == expected


@given(typed=TABLES)
def test_everybody_else_who_typed_the_same_is_found(typed: list[list[float]]) -> None:
    asked = numbers(typed)
    others = in_order(SparseTable.of_table(np.array(typed)))
    found = Matches.of(same_as_typed(asked), all_of(asked), others)
    number, owner = found.owners(np.arange(len(asked.value)))
    pairs = set(zip(number.tolist(), owner.tolist(), strict=True))
    for one in range(len(asked.value)):
        for two in range(len(asked.value)):
            same = asked.column[one] == asked.column[two] and asked.value[one] == asked.value[two]
            if same and asked.row[one] != asked.row[two]:
                assert (one, asked.row[two]) in pairs


@given(typed=TABLES, issued=TABLES)
def test_a_number_that_is_not_looked_for_is_nobodys(
    typed: list[list[float]], issued: list[list[float]]
) -> None:
    asked, others = numbers(typed), in_order(SparseTable.of_table(np.array(issued)))
    every, which = Matches.of(same_as_issued(asked), all_of(asked), others), asked.column != 1
    some = Matches.of(same_as_issued(asked), which, others)
    assert (some.after - some.first == np.where(which, every.after - every.first, 0)).all()


@given(typed=TABLES, issued=TABLES, after=st.integers(1, ROWS - 1))
def test_as_many_are_counted_in_two_tables_as_in_one(
    typed: list[list[float]], issued: list[list[float]], after: int
) -> None:
    values, sought = np.array(issued), same_as_issued(numbers(typed))
    one, two = (
        met(lambda: iter([sought]), [SparseTable.of_table(part) for part in parts])
        for parts in ([values], [values[:after], values[after:]])
    )
    assert one.same[0].tolist() == two.same[0].tolist()
    assert one.all.tolist() == two.all.tolist() == np.isfinite(values).sum(axis=0).tolist()
    first, last = sought.runs(in_order(SparseTable.of_table(values)))
    assert one.same[0].tolist() == (last - first).tolist()


@given(table=TABLES, after=st.integers(0, ROWS))
def test_numbers_spread_in_two_tables_as_in_one(table: list[list[float]], after: int) -> None:
    values = np.array(table)
    parts = [SparseTable.of_table(part) for part in (values[:after], values[after:])]
    whole, parted = Spread.of([SparseTable.of_table(values)]), Spread.of(parts)
    assert whole.middle.tolist() == parted.middle.tolist()
    assert whole.width.tolist() == parted.width.tolist()


@given(table=TABLES)
def test_numbers_are_found_by_column_and_in_each_by_row(table: list[list[float]]) -> None:
    values, found = np.array(table), SparseTable.of_table(np.array(table))
    begins, order = found.by_column
    for column in range(COLUMNS):
        there = values[:, column]
        mine = found.value[order[begins[column] : begins[column + 1]]]
        assert mine.tolist() == there[np.isfinite(there)].tolist()


@pytest.mark.parametrize(
    ("value", "half", "unit"),
    [
        (12.5, 0.05, 0.1),
        (1843.0, 0.5, 1.0),
        (5.0, 0.5, 0.01),
        (60.0, 0.5, 0.1),
        (-0.37, 0.005, 1e-3),
    ],
)
def test_a_number_counts_as_typed_with_three_figures_at_least(
    value: float, half: float, unit: float
) -> None:
    assert last_unit(np.array([value]), np.array([half]))[0] == pytest.approx(unit)
