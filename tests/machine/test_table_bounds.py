"""A table that a person made may be large, and no larger."""

from pathlib import Path

import pytest

from gripcourse.machine.content import NamedBytes
from gripcourse.machine.table_bounds import (
    LARGEST_TABLE,
    MOST_CELLS,
    MOST_COLUMNS,
    MOST_ROWS,
    ROWS_OF_A_SPREADSHEET,
    TooLargeTableError,
    around,
    content_of_table,
    within_bounds,
)

WIDE = ("x",) * MOST_COLUMNS


def passed(rows: list[tuple[str, ...]]) -> int:
    return sum(1 for _ in within_bounds(rows))


def test_a_table_up_to_its_bounds_is_passed_on() -> None:
    assert passed([("x",)] * MOST_ROWS) == MOST_ROWS
    assert passed([WIDE] * (MOST_CELLS // MOST_COLUMNS)) == MOST_CELLS // MOST_COLUMNS


@pytest.mark.parametrize(
    "rows",
    [
        [("x",)] * (MOST_ROWS + 1),
        [(*WIDE, "x")],
        [WIDE] * (MOST_CELLS // MOST_COLUMNS + 1),
        [()] * (ROWS_OF_A_SPREADSHEET + 1),
    ],
    ids=["rows", "columns", "cells", "blank rows"],
)
def test_a_table_beyond_one_of_them_is_not(rows: list[tuple[str, ...]]) -> None:
    with pytest.raises(TooLargeTableError):
        passed(rows)


def test_as_many_blank_rows_as_a_spreadsheet_has_are_no_rows() -> None:
    assert passed([()] * ROWS_OF_A_SPREADSHEET) == ROWS_OF_A_SPREADSHEET


def test_a_file_that_is_too_large_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    with path.open("wb") as stream:
        stream.truncate(LARGEST_TABLE + 1)
    for source in (path, NamedBytes("table.csv", bytes(LARGEST_TABLE + 1))):
        with pytest.raises(TooLargeTableError):
            content_of_table(source)


@pytest.mark.parametrize("place", [0, 150_000, 2_999_999])
def test_a_letter_is_in_what_its_encoding_is_told_by(place: int) -> None:
    content = b"a" * place + b"\xff" + b"a" * (3_000_000 - place)
    assert b"\xff" in around(content, place)
    assert len(around(content, place)) < 300_000
