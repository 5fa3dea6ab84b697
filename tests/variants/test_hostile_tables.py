"""A spreadsheet that an instructor gives as a table is refused or read, and nothing else."""

import io
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from openpyxl import Workbook

from gripcourse.errors import TableError
from gripcourse.variants.sheet import read_sheet

SHEET = "xl/worksheets/sheet1.xml"
FAR = range(3, 3_004)  # rows of two thousand cells, if each is as wide as its last


@pytest.fixture(scope="module")
def table() -> bytes:
    book = Workbook()
    sheet = book.active
    assert sheet is not None
    sheet.append(["student", "name"])
    sheet.append(["s01", "Анна"])
    stream = io.BytesIO()
    book.save(stream)
    return stream.getvalue()


def patched(table: bytes, part: str, change: Callable[[bytes], bytes]) -> bytes:
    stream = io.BytesIO()
    with (
        zipfile.ZipFile(io.BytesIO(table)) as source,
        zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as target,
    ):
        for name in source.namelist():
            data = source.read(name)
            target.writestr(name, change(data) if name == part else data)
    return stream.getvalue()


def inside(addition: bytes) -> Callable[[bytes], bytes]:
    return lambda part: part.replace(b"</sheetData>", addition + b"</sheetData>")


HOSTILE = {
    "not XML": (SHEET, lambda _: b"<worksheet"),
    "a shared text that is not there": (
        SHEET,
        inside(b'<row r="3"><c r="A3" t="s"><v>99</v></c></row>'),
    ),
    "a style that is not there": (SHEET, inside(b'<row r="3"><c r="A3" s="9"><v>1</v></c></row>')),
    "a cell in the last column": (SHEET, inside(b'<row r="3"><c r="XFD3"><v>1</v></c></row>')),
    "an entity": (
        SHEET,
        lambda part: b'<!DOCTYPE x [<!ENTITY a "b">]>' + part[part.index(b"<worksheet") :],
    ),
    "no sheets": ("xl/workbook.xml", lambda _: b"<workbook/>"),
    "too much": (SHEET, lambda part: part + b" " * 65_000_000),
}


@pytest.mark.parametrize(("part", "change"), HOSTILE.values(), ids=list(HOSTILE))
def test_what_no_spreadsheet_program_writes_is_refused_with_a_sentence(
    table: bytes, tmp_path: Path, part: str, change: Callable[[bytes], bytes]
) -> None:
    path = tmp_path / "t.xlsx"
    path.write_bytes(patched(table, part, change))
    with pytest.raises(TableError):
        read_sheet(path)


@pytest.mark.parametrize(
    "addition",
    [
        b'<row r="2000000000"/>',
        b'<row r="1048576"><c r="A1048576"><v>1</v></c></row>',
    ],
)
def test_a_far_row_costs_nothing(table: bytes, tmp_path: Path, addition: bytes) -> None:
    path = tmp_path / "t.xlsx"
    path.write_bytes(patched(table, SHEET, inside(addition)))
    assert read_sheet(path).rows[0].cells == ("s01", "Анна")


@pytest.mark.parametrize(
    "rows",
    [
        b'<row r="3"><c r="BXY3"><v>1</v></c></row>',
        b"".join(b'<row r="%d"><c r="BXX%d"><v>1</v></c></row>' % (row, row) for row in FAR),
    ],
    ids=["a column too far", "cells too far to the right in many rows"],
)
def test_far_cells_are_told_by_how_large_a_table_may_be(
    table: bytes, tmp_path: Path, rows: bytes
) -> None:
    path = tmp_path / "t.xlsx"
    path.write_bytes(patched(table, SHEET, inside(rows)))
    with pytest.raises(TableError, match="at most 200000 rows, 2000 columns and 6000000 cells"):
        read_sheet(path)


def test_letters_of_an_office_behind_a_long_beginning_without_any_are_read(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    path.write_bytes(b"student;name\n" + b"s01;Ann\n" * 50_000 + "s02;Иванов\n".encode("cp1251"))
    assert read_sheet(path).rows[-1].cells == ("s02", "Иванов")


def test_many_blank_rows_that_were_given_a_look_are_no_rows(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    path.write_bytes(b"student;name\ns01;Ann\n" + b";\n" * 250_000)
    assert [row.cells for row in read_sheet(path).rows] == [("s01", "Ann")]
