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


def small_table(data: bytes, texts: bytes = b"") -> bytes:
    """Return a workbook of one sheet without looks."""
    space = b'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'
    office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    relations = "<Relationships>{}</Relationships>".format
    relation = '<Relationship Id="{0}" Type="{1}/{0}" Target="{2}"/>'.format
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as target:
        target.writestr(
            "_rels/.rels", relations(relation("officeDocument", office, "xl/workbook.xml"))
        )
        target.writestr(
            "xl/_rels/workbook.xml.rels",
            relations(
                relation("worksheet", office, "worksheets/sheet1.xml")
                + relation("sharedStrings", office, "sharedStrings.xml")
            ),
        )
        target.writestr(
            "xl/workbook.xml",
            b"<workbook "
            + space
            + b'><sheets><sheet name="S" r:id="worksheet" xmlns:r="'
            + office.encode()
            + b'"/></sheets></workbook>',
        )
        target.writestr(
            SHEET, b"<worksheet " + space + b"><sheetData>" + data + b"</sheetData></worksheet>"
        )
        target.writestr("xl/sharedStrings.xml", b"<sst " + space + b">" + texts + b"</sst>")
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
    with pytest.raises(TableError, match="at most 200000 rows, 2000 columns and 200000 cells"):
        read_sheet(path)


MANY = b"".join(b'<row><c t="s"><v>0</v></c></row>' for _ in range(200))
LONG = b"<si><t>" + b"a" * 100_000 + b"</t></si>"


def test_a_long_text_that_many_cells_share_is_as_much_as_they_show(tmp_path: Path) -> None:
    """A text of a megabyte in each of many cells would take more memory than there is."""
    path = tmp_path / "t.xlsx"
    path.write_bytes(small_table(MANY, LONG))
    with pytest.raises(TableError, match="save it as “CSV UTF-8”, of which 1250000 cells are read"):
        read_sheet(path)


@pytest.mark.parametrize(
    "data",
    [
        b"<row><c><v>6<x/>0</v></c></row>",
        b"<row><c><v>6</v><v>7</v></c></row>",
        b'<row><c t="inlineStr"><is><t>An<x/>na</t></is></c></row>',
        b"<row><c><v>6</v></c><row><c><v>7</v></c></row></row>",
        b"<x><row><c><v>6</v></c></row></x>",
        (
            b'<AlternateContent xmlns="urn:other"><Choice><row><c><v>6</v></c></row></Choice>'
            b"</AlternateContent>"
        ),
    ],
    ids=[
        *("an element in a number", "two values", "an element in a text"),
        *("a row in a row", "a row elsewhere", "rows for some programs"),
    ],
)
def test_what_programs_read_in_several_ways_is_refused(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "t.xlsx"
    path.write_bytes(small_table(b"<row><c><v>1</v></c></row>" + data))
    with pytest.raises(TableError, match="damaged"):
        read_sheet(path)


def test_cells_and_texts_of_another_namespace_are_none(tmp_path: Path) -> None:
    data = b"<row><c><v>1</v></c><y:c xmlns:y='urn:y'><y:v>2</y:v></y:c></row>"
    path = tmp_path / "t.xlsx"
    path.write_bytes(small_table(data))
    assert read_sheet(path).header == ("1",)


def test_a_merged_range_shows_in_rows_that_only_have_a_look(tmp_path: Path) -> None:
    rows = b'<row><c><v>1</v></c></row><row><c s="0"/><c><v>2</v></c></row><row><c s="0"/></row>'
    merged = b'</sheetData><mergeCells><mergeCell ref="A1:A4"/></mergeCells><sheetData>'
    path = tmp_path / "t.xlsx"
    path.write_bytes(small_table(rows + merged))
    assert [row.cells for row in read_sheet(path).rows] == [("1", "2"), ("1", "")]


def test_two_thousand_attributes_are_read_and_two_hundred_thousand_are_not(tmp_path: Path) -> None:
    path = tmp_path / "t.xlsx"
    for count, is_read in ((2_000, True), (200_000, False)):
        attributes = b" ".join(b'a%d=""' % one for one in range(count))
        path.write_bytes(small_table(b"<row><c " + attributes + b"><v>1</v></c></row>"))
        if is_read:
            assert read_sheet(path).header == ("1",)
        else:
            with pytest.raises(TableError):
                read_sheet(path)


def test_the_sign_that_gives_most_headings_separates_whatever_a_title_holds(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    path.write_text("Group 1; mechanics, evening\nstudent,name\ns01,Ann\n", encoding="utf-8")
    sheet = read_sheet(path, {"student", "name"}.__contains__)
    assert sheet.header == ("student", "name")
    assert [row.cells for row in sheet.rows] == [("s01", "Ann")]


def test_letters_of_an_office_behind_a_long_beginning_without_any_are_read(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    path.write_bytes(b"student;name\n" + b"s01;Ann\n" * 50_000 + "s02;Иванов\n".encode("cp1251"))
    assert read_sheet(path).rows[-1].cells == ("s02", "Иванов")


def test_many_blank_rows_that_were_given_a_look_are_no_rows(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    path.write_bytes(b"student;name\ns01;Ann\n" + b";\n" * 250_000)
    assert [row.cells for row in read_sheet(path).rows] == [("s01", "Ann")]
