"""Tables are read as people save them."""

import subprocess
import zipfile
from dataclasses import replace
from datetime import date, datetime
from pathlib import Path

import openpyxl
import pytest
import xlsxwriter

from gripcourse.errors import TableError
from gripcourse.machine.office import office_command
from gripcourse.variants.sheet import SheetRow, column_name, read_sheet


def write(path: Path, text: str, encoding: str = "utf-8") -> Path:
    path.write_bytes(text.encode(encoding))
    return path


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_marks_and_line_ends_do_not_matter(tmp_path: Path, encoding: str, end: str) -> None:
    sheet = read_sheet(write(tmp_path / "t.csv", f"id,масса{end}1,60{end}", encoding))
    assert sheet.header == ("id", "масса")
    assert sheet.rows == (SheetRow(2, ("1", "60")),)


@pytest.mark.parametrize("sign", [",", ";", "\t"])
def test_the_separator_is_taken_from_the_headings(tmp_path: Path, sign: str) -> None:
    sheet = read_sheet(write(tmp_path / "t.csv", f"id{sign}m\n1{sign}60\n"))
    assert sheet.rows == (SheetRow(2, ("1", "60")),)
    assert sheet.decimal_comma == (sign != ",")


def test_a_comma_in_a_heading_does_not_separate_where_semicolons_do(tmp_path: Path) -> None:
    sheet = read_sheet(write(tmp_path / "t.csv", "Масса, кг;Трение\n60,5;0,15\n"))
    assert sheet.header == ("Масса, кг", "Трение")
    assert sheet.rows[0].cells == ("60,5", "0,15")


def test_quoted_cells_keep_separators_and_line_breaks(tmp_path: Path) -> None:
    sheet = read_sheet(write(tmp_path / "t.csv", 'id,name\n1,"A, B"\n2,"C\nD"\n3,E\n'))
    assert [row.cells[1] for row in sheet.rows] == ["A, B", "C\nD", "E"]
    assert [row.number for row in sheet.rows] == [2, 3, 4]


def test_blank_rows_are_left_out_and_the_others_keep_their_numbers(tmp_path: Path) -> None:
    sheet = read_sheet(write(tmp_path / "t.csv", "id,m\n1,60\n\n,\n2,70\n\n"))
    assert [row.number for row in sheet.rows] == [2, 5]


def test_short_and_long_rows_are_kept_whole(tmp_path: Path) -> None:
    sheet = read_sheet(write(tmp_path / "t.csv", "id,m\n1\n2,70,extra\n"))
    assert sheet.header == ("id", "m", "")
    assert [row.cells for row in sheet.rows] == [("1", "", ""), ("2", "70", "extra")]
    assert column_name(2, sheet.header) == "C"


def test_a_word_for_nothing_stays_a_word(tmp_path: Path) -> None:
    sheet = read_sheet(write(tmp_path / "t.csv", "id,m\n1,NA\n2,nan\n"))
    assert [row.cells[1] for row in sheet.rows] == ["NA", "nan"]


@pytest.mark.parametrize("position", [0, 25, 26, 701, 702])
def test_a_column_without_heading_has_its_letter(position: int) -> None:
    expected = openpyxl.utils.get_column_letter(position + 1)
    assert column_name(position, ("",) * 703) == expected


def test_a_folder_is_told_from_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(TableError, match="a folder, not a file"):
        read_sheet(tmp_path)


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("missing.csv", None, "no such file"),
        ("t.docx", b"x", "Save it as .csv"),
        ("t.xls", "ФИО\tГруппа\n".encode("cp1251"), "ends with .csv"),
        ("t.xls", b"<html><table><tr><td>name</td></tr></table>", "is a web page"),
        (
            "t.xls",
            b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + "EncryptedPackage".encode("utf-16-le"),
            "Remove the password",
        ),
        ("t.ods", b"", "has no bytes"),
        ("t.csv", b"id\n\xff\0m\n", "line 2"),
        ("t.csv", b"\xff\xfei", "CSV UTF-8"),
        ("t.csv", b"", "is blank"),
        ("t.csv", b'id,m\n1,"60\n', "never closed"),
        ("t.csv", b"a" + b",a" * 5000 + b"\nb" * 5000, "at most 200000 rows"),
        ("t.csv", b"a" + b",a" * 1800 + b"\nb" * 5000, "1801 columns wide"),
        ("t.csv", b"a\n" * 200_001, "at most 200000 rows"),
        ("t.xlsx", b"\0no spreadsheet", "save it again as .xlsx"),
        ("t.xlsx", b"", "has no bytes"),
    ],
)
def test_a_file_that_is_no_table_is_one_clear_problem(
    tmp_path: Path, name: str, content: bytes | None, said: str
) -> None:
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(TableError) as caught:
        read_sheet(path)
    (problem,) = caught.value.problems
    assert problem.file == str(path)
    assert said in f"{problem.what} {problem.remedy}"


def test_numbers_of_a_spreadsheet_keep_all_their_digits(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.append(["id", "m", "f"])
    sheet.append([7, 60.0, 0.123456789012345])
    book.save(tmp_path / "t.xlsx")
    assert read_sheet(tmp_path / "t.xlsx").rows == (SheetRow(2, ("7", "60", "0.123456789012345")),)


def test_errors_dates_and_truth_of_a_spreadsheet_are_not_blank(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    book.active.append(["a", "b", "c"])
    book.active.append(["#DIV/0!", datetime(2026, 5, 1), True])  # noqa: DTZ001 - as Excel has it
    book.save(tmp_path / "t.xlsx")
    assert read_sheet(tmp_path / "t.xlsx").rows[0].cells == (
        "#DIV/0!",
        "2026-05-01T00:00:00",
        "True",
    )


def test_a_formula_without_a_stored_result_is_not_blank(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    book.active.append(["a", "b"])
    book.active.append([60, "=A2*2"])
    book.save(tmp_path / "t.xlsx")
    assert read_sheet(tmp_path / "t.xlsx").rows[0].cells == ("60", "=A2*2")


def test_a_formula_with_a_stored_result_is_that_result(tmp_path: Path) -> None:
    with xlsxwriter.Workbook(str(tmp_path / "t.xlsx")) as book:
        sheet = book.add_worksheet()
        sheet.write_row(0, 0, ["a", "b"])
        sheet.write_number(1, 0, 60)
        sheet.write_formula(1, 1, "=A2*2", None, 120)
    assert read_sheet(tmp_path / "t.xlsx").rows[0].cells == ("60", "120")


@pytest.mark.office
@pytest.mark.parametrize("ending", ["ods", "xls"])
def test_a_table_of_another_format_is_read_as_libreoffice_opens_it(
    tmp_path: Path, ending: str
) -> None:
    book = openpyxl.Workbook()
    book.active.append(["Фамилия", "Масса, кг", "Дата"])
    book.active.append(["О'Хара", 60.25, date(2026, 9, 1)])
    hidden = book.create_sheet("черновик")
    hidden.append(["никто"])
    hidden.sheet_state = "hidden"
    book.save(tmp_path / "t.xlsx")
    office, profile = office_command(), (tmp_path / "profile").as_uri()
    assert office is not None
    subprocess.run(  # noqa: S603 (a found program)
        [
            *(office, f"-env:UserInstallation={profile}", "--headless", "--convert-to", ending),
            *("--outdir", str(tmp_path), str(tmp_path / "t.xlsx")),
        ],
        check=True,
        capture_output=True,
        timeout=120,
    )
    assert read_sheet(tmp_path / f"t.{ending}") == replace(
        read_sheet(tmp_path / "t.xlsx"), file=str(tmp_path / f"t.{ending}")
    )


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("t.ods", None, "an OpenDocument file, .ods"),
        ("t.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "the old format .xls"),
    ],
)
def test_without_libreoffice_it_is_said_what_the_table_is_and_how_to_save_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, content: bytes | None, said: str
) -> None:
    monkeypatch.setattr("gripcourse.variants.spreadsheet.office_command", lambda: None)
    if content is None:
        with zipfile.ZipFile(tmp_path / name, "w") as archive:
            archive.writestr("mimetype", "application/vnd.oasis.opendocument.spreadsheet")
            archive.writestr("content.xml", "<content/>")
    else:
        (tmp_path / name).write_bytes(content)
    with pytest.raises(TableError, match=said) as caught:
        read_sheet(tmp_path / name)
    assert "Save it as .xlsx, or install LibreOffice" in str(caught.value)
