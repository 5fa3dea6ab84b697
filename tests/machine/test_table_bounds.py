"""A table that a person made may be large, and no larger."""

from pathlib import Path

import pytest

from gripcourse.machine.content import NamedBytes
from gripcourse.machine.table_bounds import (
    LARGEST_TABLE,
    MOST_CELLS,
    MOST_COLUMNS,
    MOST_OF_WORKBOOK,
    MOST_ROWS,
    ROWS_OF_A_SPREADSHEET,
    RoomForCells,
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


def test_a_workbook_has_room_for_fewer_cells_than_text() -> None:
    room, row = RoomForCells(), list[str]()
    for _ in range(MOST_OF_WORKBOOK // MOST_COLUMNS):
        row = []
        room.put("x", MOST_COLUMNS, row)
        assert len(row) == MOST_COLUMNS
    room.put("y", 1, row)
    assert row[0] == "y"
    with pytest.raises(TooLargeTableError):
        room.put("x", 1, [])


def test_a_workbook_has_room_for_so_many_rows_and_columns() -> None:
    room = RoomForCells()
    with pytest.raises(TooLargeTableError):
        room.put("x", MOST_COLUMNS + 1, [])
    for _ in range(MOST_ROWS):
        room.take_row()
    with pytest.raises(TooLargeTableError):
        room.take_row()


def test_letters_of_a_workbook_are_as_many_as_of_a_file_of_text() -> None:
    room, text = RoomForCells(), "x" * (LARGEST_TABLE // 2)
    room.put(text, 1, [])
    room.put(text, 1, [])
    with pytest.raises(TooLargeTableError):
        room.put("x", 1, [])


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
