"""A roster is read in three languages, and every wrong row is named."""

from pathlib import Path

import openpyxl
import pytest

from gripcourse.errors import TableError
from gripcourse.issuing.roster import read_roster
from gripcourse.machine.content import NamedBytes
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
    assert read_roster(path).students == (
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
    (student,) = read_roster(write(tmp_path, header, f"1843;Попов Илья;{language}")).students
    assert (student.id, student.name) == ("1843", "Попов Илья")
    assert student.language == {"E": "en", "Р": "ru", "у": "uk"}[language[0]]


def test_only_id_and_name_are_needed(tmp_path: Path) -> None:
    (student,) = read_roster(write(tmp_path, "student,name", "a-1,Anna")).students
    assert student == Student("a-1", "Anna", "", "", "", "")


def test_a_spreadsheet_is_a_roster_too(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    book.active.append(["Шифр", "ФИО"])
    book.active.append([184301, "Попов Илья"])
    book.save(tmp_path / "roster.xlsx")
    (student,) = read_roster(tmp_path / "roster.xlsx").students
    assert student.id == "184301"


def test_a_letter_written_as_two_signs_becomes_one(tmp_path: Path) -> None:
    (student,) = read_roster(write(tmp_path, "student,name", "и\u0306,Anna")).students
    assert student.id == "й"


@pytest.mark.parametrize("id_", ["../b", "..", ".a", "a:b", "a*", "con", "NUL.x", "a."])
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
        "row 5, column name",
        "row 3, column student",
        "row 5, column variant",
    ]


def test_a_list_without_names_is_refused_with_what_may_have_been_meant(tmp_path: Path) -> None:
    ((_, said),) = problems_of(write(tmp_path, "student,nme", "a,Anna"))
    assert "no column 'name'" in said
    assert "Did you mean 'nme'" in said


OFFICE = (
    "Министерство образования;;;",
    "Список студентов, группа РТК-41;;;",
    ";;;",
    "№ п/п;ФИО;Группа;Форма обучения",
    "1;Попов Илья Михайлович;РТК-41;бюджет",
    "2;Ёлкина Анна;РТК-41;контракт",
)


@pytest.mark.parametrize(
    "encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1251", "koi8_u", "mac_cyrillic"]
)
def test_an_office_list_is_taken_as_it_is(tmp_path: Path, encoding: str) -> None:
    text = "\r\n".join(OFFICE).replace("№", "N" if encoding == "koi8_u" else "№")
    path = tmp_path / "list.csv"
    path.write_bytes(text.encode(encoding))
    roster = read_roster(path)
    assert [(one.id, one.name, one.group) for one in roster.students] == [
        ("попов-илья-михайлович", "Попов Илья Михайлович", "РТК-41"),
        ("ёлкина-анна", "Ёлкина Анна", "РТК-41"),
    ]
    said = " ".join(map(str, roster.notes))
    assert "Форма обучения" in said
    assert "no ids for 2 students" in said
    assert ("read as" in said) == (encoding in {"cp1251", "koi8_u", "mac_cyrillic"})


@pytest.mark.parametrize("encoding", ["cp1251", "koi8_u", "mac_cyrillic"])
@pytest.mark.parametrize("line_end", ["\r", "\n"])
@pytest.mark.parametrize(
    "names", [["Ким Лев"], ["Ґалаґан Євген", "Їжак Олена"], ["ЯШИН ЭДУАРД", "Щукина Юлия"]]
)
def test_the_names_of_a_short_list_tell_its_code_page(
    encoding: str, line_end: str, names: list[str]
) -> None:
    text = line_end.join(["ФИО;Группа", *(f"{one};РТК-41" for one in names), ""])
    roster = read_roster(NamedBytes("list.csv", text.encode(encoding)))
    assert [one.name for one in roster.students] == names


@pytest.mark.parametrize(
    "text", ["фио;группа\nяшин лев;ртк-41\n", "ФИО;Группа\n“Яшин” Лев;РТК-41\n", "name\nМьller\n"]
)
def test_what_windows_saved_is_not_taken_for_a_macs(text: str) -> None:
    content = text.encode("cp1251")
    roster = read_roster(NamedBytes("list.csv", content))
    assert "mac_cyrillic" not in " ".join(map(str, roster.notes))


def test_a_title_row_of_a_spreadsheet_is_passed_over(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    for row in (["Список групи РТК-41"], [], ["№ з/п", "Прізвище", "Ім'я", "По батькові", "Пошта"]):
        book.active.append(row)
    book.active.append([1, "Їжак", "Олена", "Іванівна", "o.yizhak@example.org"])
    book.save(tmp_path / "roster.xlsx")
    (student,) = read_roster(tmp_path / "roster.xlsx").students
    assert (student.id, student.name) == ("o.yizhak", "Їжак Олена Іванівна")


def test_a_platforms_list_of_participants_is_a_roster(tmp_path: Path) -> None:
    header = "First name,Last name,ID number,Email address,Groups"
    path = write(tmp_path, header, "Anna,Berg,,a.berg@example.org,RTK-41", "Ivan,Orlov,77,,")
    assert [(one.id, one.name) for one in read_roster(path).students] == [
        ("a.berg", "Berg Anna"),
        ("77", "Orlov Ivan"),
    ]


def test_an_id_once_made_is_kept_though_mail_or_list_change(tmp_path: Path) -> None:
    first = read_roster(write(tmp_path, "name,group,email", "Anna Berg,A,", "Ivan Orlov,A,i@x.org"))
    assert [one.id for one in first.students] == ["anna-berg", "i"]
    later = write(tmp_path, "name,group,email", "Ivan Orloff,B,i@x.org", "Anna  Berg,A,ab@x.org")
    assert [one.id for one in read_roster(later, first.students).students] == ["i", "anna-berg"]


def test_made_ids_are_told_apart_and_namesakes_are_asked_about(tmp_path: Path) -> None:
    path = write(tmp_path, "name,group", "Anna Berg,A", "Anna Berg,B")
    assert [one.id for one in read_roster(path).students] == ["anna-berg", "anna-berg-2"]
    ((key, said),) = problems_of(write(tmp_path, "name,group", "Anna Berg,A", "anna berg,A"))
    assert key == "row 3"
    assert "no id tells both apart" in said


def test_names_that_an_old_code_page_damaged_are_named(tmp_path: Path) -> None:
    path = write(tmp_path, "student,name", "1,Дем?яненко Марія", "2,Коваль Іван")
    (note,) = read_roster(path).notes
    assert "was lost when the list was saved: Дем?яненко Марія. Save" in str(note)


def test_an_empty_roster_is_a_problem(tmp_path: Path) -> None:
    ((_, said),) = problems_of(write(tmp_path, HEADER))
    assert "no students" in said


def test_the_reference_roster_is_sound() -> None:
    students = read_roster(REFERENCE).students
    assert len(students) == 12
    assert {student.language for student in students} == {"", "en", "ru", "uk"}


def test_an_address_or_a_group_of_two_lines_becomes_one() -> None:
    table = b'student,name,group,email\ns1,Anna,"G\n1","a@b\nBcc: x@y"\n'
    (student,) = read_roster(NamedBytes("roster.csv", table)).students
    assert (student.group, student.email) == ("G 1", "a@b Bcc: x@y")


@pytest.mark.parametrize("second", ["\u0455\u043e1", "S\uff4f1", "s\u043e1"])
def test_ids_that_look_alike_are_refused(tmp_path: Path, second: str) -> None:
    [(place, said)] = problems_of(write(tmp_path, HEADER, "so1,A,,,,", f"{second},B,,,,"))
    assert place == "row 3, column student"
    assert "looks like 'so1' in row 2" in said


@pytest.mark.parametrize(
    ("row", "column", "most"),
    [
        ("a,{long},,,,", "name", 255),
        ("a,B,{long},,,", "group", 100),
        ("a,B,,{long},,", "email", 254),
        ("a,B,,,,{long}", "variant", 64),
    ],
)
def test_what_no_page_has_room_for_is_refused(
    tmp_path: Path, row: str, column: str, most: int
) -> None:
    sign = "@" if column == "email" else "\u0416"
    longest = row.format(long=sign * most)
    assert read_roster(write(tmp_path, HEADER, longest)).students
    [(place, said)] = problems_of(write(tmp_path, HEADER, row.format(long=sign * 10_000)))
    assert place == f"row 2, column {column}"
    assert f"10000 signs; {most} at most" in said


def test_numbered_rows_of_a_form_that_name_nobody_are_passed_over(tmp_path: Path) -> None:
    file = tmp_path / "form.csv"
    file.write_text("№ п/п;ФИО;Группа\n1;Иванова Анна;РТК-41\n2;;\n3;;\n", encoding="utf-8")
    roster = read_roster(file)
    assert [one.name for one in roster.students] == ["Иванова Анна"]
    assert "Rows that name nobody were passed over: 3, 4." in map(str, roster.notes)


@pytest.mark.parametrize("encoding", ["utf-8", "cp1251"])
def test_a_list_that_is_mostly_of_columns_nobody_needs_has_headings(
    tmp_path: Path, encoding: str
) -> None:
    lines = (
        "Деканат машиностроительного факультета;;;;;",
        "Список студентов группы РТК-41 на 2026/27 учебный год;;;;;",
        "№ п/п;Ф.И.О.;Зачётная книжка №;Основа;Общежитие;Примечание",
        "1;Абдуллаева Гюзель Рашидовна;;бюджет;;",
        "2;Зайцев Артём Ёлкович;;контракт;;староста",
    )
    path = tmp_path / "roster.csv"
    path.write_text("\n".join(lines), encoding=encoding)
    roster = read_roster(path)
    assert [(one.name, one.group) for one in roster.students] == [
        ("Абдуллаева Гюзель Рашидовна", "РТК-41"),
        ("Зайцев Артём Ёлкович", "РТК-41"),
    ]


@pytest.mark.parametrize(
    ("header", "row", "where"),
    [
        ("Student ID;Full name;Group", ";Popov Ilya;B-2", "row, in the column 'Student ID'"),
        ("№ зачётки;ФИО;Группа", ";Popov Ilya;B-2", "row, in the column '№ зачётки'"),
        ("Full name;Group", "Popov Ilya;B-2", "add a column 'id' to the list"),
        ("ПІБ;Група", "Popov Ilya;B-2", "add a column 'код студента' to the list"),
    ],
)
def test_it_is_said_under_which_heading_an_id_tells_who_it_is(
    tmp_path: Path, header: str, row: str, where: str
) -> None:
    known = Student("7", "Popov Ilya", "B-1", "", "", "")
    with pytest.raises(TableError) as caught:
        read_roster(write(tmp_path, header, row), [known])
    (problem,) = caught.value.problems
    assert where in str(problem.remedy)
    assert "write the id 7" in str(problem.remedy)
    column = str(problem.remedy).split("'")[1]
    answered = write(tmp_path, f"{column};Full name;Group", "7;Popov Ilya;B-2")
    assert read_roster(answered, [known]).students[0].id == "7"
