"""A table of marks: rows and columns as a person fills them in, every fault with its cell."""

from pathlib import Path

import pytest
from openpyxl import Workbook

from gripcourse.errors import TableError
from gripcourse.gradebook.table import read_marks
from gripcourse.machine.content import NamedBytes
from gripcourse.policy.rubric_load import TABLE_COLUMNS
from gripcourse.text.words import Texts

TEXT = Texts({"en": "Sizes fit", "ru": "Размеры, верные", "uk": "Розміри збігаються"})
LINES = {"sizes": [TEXT], "assembly": [], "standards": [], "symbols": []}
TABLE = """\
student;quantity;sizes;assembly;standards;symbols;comment
s01;drawing;1;0,5;0.25;;Масштаб?
s01;diagram;;;;1;
s02;drawing;0;0;0;;
"""


def written(folder: Path, text: str, encoding: str = "utf-8-sig") -> Path:
    path = folder / "marks.csv"
    path.write_bytes(text.encode(encoding))
    return path


def problems(folder: Path, text: str) -> list[tuple[str, str]]:
    path = written(folder, text)
    with pytest.raises(TableError) as caught:
        read_marks(path, LINES)
    assert {problem.file for problem in caught.value.problems} == {str(path)}
    assert all(str(problem.remedy) for problem in caught.value.problems)
    return [(str(problem.key), str(problem.what)) for problem in caught.value.problems]


class TestReading:
    def test_each_row_is_an_item_with_the_lines_that_it_fills(self, tmp_path: Path) -> None:
        table = read_marks(written(tmp_path, TABLE), LINES)
        assert [one.row for one in table.rows] == [2, 3, 4]
        drawing, diagram, second = (one.draft for one in table.rows)
        assert (drawing.student, drawing.quantity) == ("s01", "drawing")
        assert drawing.lines == {"sizes": 1.0, "assembly": 0.5, "standards": 0.25}
        assert drawing.comment == "Масштаб?"
        assert diagram.lines == {"symbols": 1.0}
        assert second.lines == {"sizes": 0.0, "assembly": 0.0, "standards": 0.0}

    def test_headings_may_be_of_any_language_below_a_title(self, tmp_path: Path) -> None:
        text = (
            "Оценки РГР;;;;;\n"
            "Студент;ФИО;Пункт;Размеры, верные;Комментарий;Баллы\n"
            "s01;Анна;drawing;0,5;Масштаб?;\n"
            "s02;Борис;drawing;много;;\n"
        )
        assert problems(tmp_path, text) == [
            ("row 4, column Размеры, верные", "'много' is no number.")
        ]
        (row,) = read_marks(written(tmp_path, text.replace("много", "")), LINES).rows
        assert (row.row, row.draft.lines, row.draft.comment) == (3, {"sizes": 0.5}, "Масштаб?")

    def test_bytes_are_read_as_their_file_is(self, tmp_path: Path) -> None:
        path = written(tmp_path, TABLE)
        sent = read_marks(NamedBytes("mine.csv", path.read_bytes()), LINES)
        assert sent.rows == read_marks(path, LINES).rows
        assert sent.file == "mine.csv"

    def test_a_decimal_comma_in_quotation_marks_is_read_between_commas(
        self, tmp_path: Path
    ) -> None:
        text = 'student,quantity,sizes,points\ns01,drawing,"0,5","12,25"\n'
        (row,) = read_marks(written(tmp_path, text), LINES).rows
        assert (row.draft.lines, row.draft.points) == ({"sizes": 0.5}, 12.25)

    def test_rows_that_give_nothing_are_left_out_and_counted(self, tmp_path: Path) -> None:
        table = read_marks(written(tmp_path, f"{TABLE}s03;drawing;;;;;\n"), LINES)
        assert (len(table.rows), table.empty) == (3, 1)

    def test_a_comment_or_a_zero_is_not_nothing(self, tmp_path: Path) -> None:
        text = "student;quantity;points;comment\ns01;a;0;\ns01;b;;почему?\n"
        table = read_marks(written(tmp_path, text), LINES)
        assert (len(table.rows), table.empty) == (2, 0)

    @pytest.mark.parametrize(("cell", "meant"), [("yes", True), ("Да", True), ("", False)])
    def test_an_override_is_said_in_words(self, tmp_path: Path, cell: str, *, meant: bool) -> None:
        text = f"student;quantity;points;override\ns01;bore;1;{cell}\n"
        (row,) = read_marks(written(tmp_path, text), LINES).rows
        assert row.draft.override is meant

    def test_a_spreadsheet_is_read_as_well(self, tmp_path: Path) -> None:
        book = Workbook()
        sheet = book.active
        assert sheet is not None
        for cells in (("student", "quantity", "credit"), ("s01", "stroke", 0.5)):
            sheet.append(cells)
        book.save(tmp_path / "marks.xlsx")
        (row,) = read_marks(tmp_path / "marks.xlsx", LINES).rows
        assert row.draft.credit == 0.5


class TestFaults:
    def test_cells_are_named_by_row_and_column_all_at_once(self, tmp_path: Path) -> None:
        text = (
            "student;quantity;sizes;points;override\n"
            "s01;drawing;viel;;\n"
            ";drawing;1;;\n"
            "s02;;1;;\n"
            "s03;drawing;1;12 P;maybe\n"
        )
        assert problems(tmp_path, text) == [
            ("row 2, column sizes", "'viel' is no number."),
            ("row 3, column student", "The cell is empty."),
            ("row 4, column quantity", "The cell is empty."),
            ("row 5, column points", "'12 P' is no number."),
            ("row 5, column override", "'maybe' is neither yes nor no."),
        ]

    def test_an_item_twice_names_the_first_row(self, tmp_path: Path) -> None:
        text = "student;quantity;points\ns01;a;1\ns02;a;1\ns01;a;2\n"
        assert problems(tmp_path, text) == [
            ("row 4, column quantity", "Row 2 marks the same item.")
        ]

    @pytest.mark.parametrize(
        ("header", "key", "what"),
        [
            ("quantity;points", "row 1, column student", "The column 'student' is missing."),
            ("student;points", "row 1, column quantity", "The column 'quantity' is missing."),
            ("student;quantity;size", "row 1, column size", "No rubric has a line 'size'."),
            (
                "student;quantity;sizes;sizes",
                "row 1, column sizes",
                "Two columns are called 'sizes'.",
            ),
        ],
    )
    def test_headings_are_checked_first(
        self, tmp_path: Path, header: str, key: str, what: str
    ) -> None:
        assert problems(tmp_path, f"{header}\ns01;drawing;1;1\n")[0] == (key, what)

    def test_an_unquoted_decimal_comma_is_noticed_by_the_cell_too_many(
        self, tmp_path: Path
    ) -> None:
        found = problems(tmp_path, "student,quantity,sizes\ns01,drawing,0,5\n")
        assert found == [("row 1, column D", "The column has cells, but no heading.")]

    def test_a_file_that_is_none_is_refused(self, tmp_path: Path) -> None:
        with pytest.raises(TableError, match="no such file"):
            read_marks(tmp_path / "marks.csv", LINES)


def test_no_line_of_a_rubric_can_be_taken_for_another_column() -> None:
    assert not set(LINES) & set(TABLE_COLUMNS)
