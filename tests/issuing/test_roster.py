"""A roster is read in three languages, and every wrong row is named."""

from pathlib import Path

import openpyxl
import pytest

from gripcourse.errors import TableError
from gripcourse.issuing.roster import read_roster
from gripcourse.variants.model import Student

HEADER = "student,name,group,email,language,variant"
REFERENCE = Path(__file__).parents[2] / "variants" / "roster.csv"


def write(folder: Path, *lines: str) -> Path:
    path = folder / "roster.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def problems_of(path: Path) -> list[tuple[str, str]]:
    with pytest.raises(TableError) as caught:
        read_roster(path)
    return [
        (str(problem.key), f"{problem.what} {problem.remedy}") for problem in caught.value.problems
    ]


def test_a_row_is_a_student(tmp_path: Path) -> None:
    path = write(tmp_path, HEADER, "popov-im,Попов  Илья,РТК-41,p@example.org,ru,007")
    assert read_roster(path) == (
        Student("popov-im", "Попов Илья", "РТК-41", "p@example.org", "ru", "007"),
    )


@pytest.mark.parametrize(
    ("header", "language"),
    [
        ("Student ID;Full name;Language", "English"),
        ("Номер зачётки;ФИО;Язык", "Русский"),
        ("Номер заліковки;ПІБ;Мова", "українська"),
    ],
)
def test_headings_and_languages_are_understood_in_three_languages(
    tmp_path: Path, header: str, language: str
) -> None:
    (student,) = read_roster(write(tmp_path, header, f"1843;Попов Илья;{language}"))
    assert (student.id, student.name) == ("1843", "Попов Илья")
    assert student.language == {"E": "en", "Р": "ru", "у": "uk"}[language[0]]


def test_only_id_and_name_are_needed(tmp_path: Path) -> None:
    (student,) = read_roster(write(tmp_path, "student,name", "a-1,Anna"))
    assert student == Student("a-1", "Anna", "", "", "", "")


def test_a_spreadsheet_is_a_roster_too(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    book.active.append(["Шифр", "ФИО"])
    book.active.append([184301, "Попов Илья"])
    book.save(tmp_path / "roster.xlsx")
    (student,) = read_roster(tmp_path / "roster.xlsx")
    assert student.id == "184301"


def test_a_letter_written_as_two_signs_becomes_one(tmp_path: Path) -> None:
    (student,) = read_roster(write(tmp_path, "student,name", "и\u0306,Anna"))
    assert student.id == "й"


@pytest.mark.parametrize(
    "id_", ["a/b", "a\\b", "..", ".a", "a b", "a:b", "a*", "con", "NUL.x", "a."]
)
def test_an_id_that_cannot_name_a_folder_is_refused(tmp_path: Path, id_: str) -> None:
    ((key, said),) = problems_of(write(tmp_path, "student,name", f"{id_},Anna"))
    assert key == "row 2, column student"
    assert "cannot name a folder" in said


def test_an_id_as_long_as_a_line_is_refused(tmp_path: Path) -> None:
    ((_, said),) = problems_of(write(tmp_path, "student,name", f"{'a' * 65},Anna"))
    assert "at most 64" in said


def test_all_problems_are_told_at_once(tmp_path: Path) -> None:
    path = write(
        tmp_path,
        HEADER,
        "a,Anna,,,ru,001",
        "A,Boris,,,xx,",
        ",Vera,,,,",
        "d,,,,,001",
    )
    assert [key for key, _ in problems_of(path)] == [
        "row 3, column language",
        "row 4, column student",
        "row 5, column name",
        "row 3, column student",
        "row 5, column variant",
    ]


def test_missing_columns_are_named(tmp_path: Path) -> None:
    keys_and_words = problems_of(write(tmp_path, "student,nme", "a,Anna"))
    assert "Did you mean 'name'" in keys_and_words[0][1]
    assert "no column 'name'" in keys_and_words[1][1]


def test_an_empty_roster_is_a_problem(tmp_path: Path) -> None:
    ((_, said),) = problems_of(write(tmp_path, HEADER))
    assert "no students" in said


def test_the_reference_roster_is_sound() -> None:
    students = read_roster(REFERENCE)
    assert len(students) == 12
    assert {student.language for student in students} == {"", "en", "ru", "uk"}
