"""No table is written that could not be read again."""

from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.errors import TableError
from gripcourse.machine.table_bounds import LARGEST_TABLE, MOST_CELLS, MOST_OF_WORKBOOK, MOST_ROWS
from gripcourse.variants.model import Variant
from gripcourse.variants.readable import Room, expect_readable
from gripcourse.variants.table import write_table


@pytest.mark.parametrize(
    ("rows", "cells", "size"),
    [(MOST_ROWS + 1, 1, 0), (2, MOST_CELLS + 1, 0), (2, 2, LARGEST_TABLE + 1)],
    ids=["rows", "cells", "bytes"],
)
def test_too_much_is_told_with_its_remedy(rows: int, cells: int, size: int) -> None:
    with pytest.raises(TableError, match="one of fewer variants"):
        expect_readable(Path("t.csv"), rows, 1, Room(cells, MOST_CELLS), size)
    expect_readable(Path("t.csv"), MOST_ROWS, 1, Room(MOST_CELLS, MOST_CELLS), LARGEST_TABLE)


def test_of_a_spreadsheet_that_is_too_large_a_file_of_text_is_advised() -> None:
    with pytest.raises(TableError, match=r"ends in \.csv, of which 1250000 cells are read"):
        expect_readable(Path("t.xlsx"), 2, 1, Room(MOST_OF_WORKBOOK + 1, MOST_OF_WORKBOOK))


@pytest.mark.parametrize("ending", ["csv", "xlsx"])
def test_nothing_is_written_of_a_table_that_is_too_large(
    small_course: Course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ending: str
) -> None:
    variant = Variant("001", next(iter(small_course.schemes)), {}, {})
    monkeypatch.setattr("gripcourse.variants.table.MOST_CELLS", 10)
    monkeypatch.setattr("gripcourse.variants.table_workbook.MOST_OF_WORKBOOK", 10)
    path = tmp_path / f"t.{ending}"
    with pytest.raises(TableError, match="Nothing was written"):
        write_table(path, [replace(variant, id=f"{one:03}") for one in range(20)], small_course)
    assert not list(tmp_path.iterdir())
