"""Lists as offices and platforms write them: what is no person is left out and named."""

import unicodedata
from collections.abc import Sequence
from pathlib import Path

import openpyxl
import pytest

from gripcourse.errors import TableError
from gripcourse.issuing.roster import Roster, read_roster
from gripcourse.machine.content import NamedBytes
from gripcourse.variants.model import Student


def listed(*lines: str, encoding: str = "utf-8") -> Roster:
    return read_roster(NamedBytes("list.csv", "\n".join(lines).encode(encoding)))


def names(roster: Roster) -> list[str]:
    return [one.name for one in roster.students]


def said(roster: Roster) -> str:
    return "\n".join(map(str, roster.notes))


def test_sums_and_signatures_of_an_office_are_nobody() -> None:
    roster = listed(
        "Список студентов группы РК5-71Б;;;;",
        "№ п/п;ФИО;№ зачётной книжки;Группа;E-mail",
        "1;Ёлкин Артём;20Р341;РК5-71Б;elkin@x.example",
        "2;Иванов Иван;20Р342;РК5-71Б;IVANOV@X.EXAMPLE",
        ";;;;",
        "Всего: 2 чел.;;;;",
        ";;Декан факультета;;Петров С.С.",
        encoding="cp1251",
    )
    assert names(roster) == ["Ёлкин Артём", "Иванов Иван"]
    assert "6 (Всего: 2 чел.), 7 (Декан факультета Петров С.С.)" in said(roster)


@pytest.mark.parametrize(
    "last", [";Итого: 2;", "Всего;2;", "Итого:;;2", ";Куратор: Сидоров А.А.;", ";—;", ";РАЗОМ;2"]
)
def test_the_row_below_the_last_name_is_nobody(last: str) -> None:
    roster = listed("№;ФИО;Группа", "1;Иванов Иван;A", "2;Петров Пётр;A", last)
    assert names(roster) == ["Иванов Иван", "Петров Пётр"]
    assert "passed over: 4 (" in said(roster)


def test_the_rows_below_the_headings_of_a_platforms_gradebook_are_nobody() -> None:
    roster = listed(
        "Last Name,First Name,Email Address,Homework 1",
        "Points,,,100",
        "Class Average,,,90",
        "Page,Larry,page@x.example,90",
    )
    assert names(roster) == ["Page Larry"]
    assert "2 (Points), 3 (Class Average)" in said(roster)


@pytest.mark.parametrize(
    ("written", "language"), [("рус", "ru"), ("Рус.", "ru"), ("англ.", "en"), ("укр", "uk")]
)
def test_a_language_may_be_shortened(written: str, language: str) -> None:
    (student,) = listed("ФИО;Язык", f"Иванов Иван;{written}").students
    assert student.language == language


@pytest.mark.parametrize(
    "line",
    [
        "Декан ________ Смирнов А.В.;",
        "Dean ........... Smith;",
        "Head of department: K. Doe;",
        "Староста группы: Иванов;",
        "Подпись преподавателя;",
        "Дата: 01.09.2026;",
        "Викладач ______;",
        "Страница 2;",
        "стор. 2;",
        "* академический отпуск;",
    ],
)
def test_a_line_of_a_form_below_the_names_is_nobody(line: str) -> None:
    roster = listed("ФИО;Группа", "Иванов Иван;A", line)
    assert names(roster) == ["Иванов Иван"]
    assert "passed over: 3 (" in said(roster)


def test_running_numbers_before_all_names_are_no_part_of_them() -> None:
    numbered = listed("ФИО;Группа", "1. Иванов Иван;A", "2) Петров Пётр;A")
    assert names(numbered) == ["Иванов Иван", "Петров Пётр"]
    assert names(listed("ФИО", "1. Иванов Иван", "Петров Пётр"))[0] == "1. Иванов Иван"


def test_what_is_no_mail_address_is_left_out_and_told() -> None:
    roster = listed("ФИО;E-mail", "Иванов Иван;нет", "Петров Пётр;нет", "Цой Ян;tsoi@x.example")
    assert [one.email for one in roster.students] == ["", "", "tsoi@x.example"]
    assert [one.id for one in roster.students] == ["иванов-иван", "петров-пётр", "tsoi"]
    assert "no mail addresses and were left out: нет." in said(roster)


@pytest.mark.parametrize("heading", ["Номер варіанту", "№ варіанту"])
def test_either_genitive_of_a_variant_heads_its_column(heading: str) -> None:
    assert listed(f"ПІБ;{heading}", "Іванко Іван;007").students[0].variant == "007"


@pytest.mark.parametrize("name", ["Всего Анна", "Староста Иван", "Total Ivan", "Декан Олег"])
def test_a_surname_that_is_such_a_word_stays(name: str) -> None:
    assert names(listed("ФИО;Группа", f"{name};A")) == [name]


def test_a_person_without_a_running_number_stays() -> None:
    assert len(listed("№;ФИО", "1;Иванов Иван", ";Петров Пётр").students) == 2


def test_an_id_without_a_name_is_no_sum_but_a_mistake() -> None:
    with pytest.raises(TableError, match="no name"):
        listed("Шифр;ФИО", "s1;Иванов Иван", "s2;")


def test_headings_that_are_repeated_on_the_next_page_are_nobody() -> None:
    roster = listed("№;ФИО;E-mail", "1;Иванов;i@x", "Группа 72;;", "№;ФИО;E-mail", "1;Ким;k@x")
    assert names(roster) == ["Иванов", "Ким"]
    assert "4 (№ ФИО E-mail)" in said(roster)


def test_the_export_of_canvas_is_a_list_of_people() -> None:
    roster = listed(
        "Student,ID,SIS User ID,Section",
        "    Points Possible,,,",
        '"Иванов, Иван",101,a1,A',
        '"Student, Test",102,,A',
    )
    assert roster.students == (Student("101", "Иванов, Иван", "A", "", "", ""),)


@pytest.mark.parametrize(
    ("row", "id_", "name"),
    [("Иванов Иван;A", "иванов-иван", "Иванов Иван"), ("1;s1;Иванов", "s1", "Иванов")],
)
def test_students_are_names_or_ids_as_the_list_has_them(row: str, id_: str, name: str) -> None:
    heading = "Студент;Группа" if row.count(";") == 1 else "№;Студент;ФИО"
    (student,) = listed(heading, row).students
    assert (student.id, student.name) == (id_, name)


def test_a_list_without_headings_says_so() -> None:
    with pytest.raises(TableError, match="No row of the roster has headings") as caught:
        listed("Петрова Ольга;A-1", "Сидоров Пётр;A-1")
    assert len(caught.value.problems) == 1


def test_two_with_one_mail_address_are_named_by_it() -> None:
    with pytest.raises(TableError, match="has the mail address IVANOV@X"):
        listed("ФИО;E-mail", "Иванов;ivanov@x", "Петров;IVANOV@X")


@pytest.mark.parametrize("sign", "'’‘ʼ`´")
@pytest.mark.parametrize("form", ["NFC", "NFD"])
def test_whoever_is_written_with_another_apostrophe_is_known(sign: str, form: str) -> None:
    known = Student("oz", "Знам'янський Олексій", "МТ-21", "", "", "")
    written = unicodedata.normalize(form, f"Знам{sign}янський Олексій".upper())
    content = f"ПІБ;Група\n{written};МТ–21\n".encode()
    (student,) = read_roster(NamedBytes("list.csv", content), [known]).students
    assert student.id == "oz"


class TestSpreadsheets:
    def saved(self, folder: Path, book: openpyxl.Workbook) -> Roster:
        book.save(folder / "list.xlsx")
        return read_roster(folder / "list.xlsx")

    def test_a_merged_cell_is_of_all_its_rows(self, tmp_path: Path) -> None:
        book = openpyxl.Workbook()
        sheet = book.active
        for row in (("Группа", "ФИО"), ("71", "Егорова Алла"), (None, "Жуков Лев"), ("72", "Ким")):
            sheet.append(row)
        sheet.merge_cells("A2:A3")
        roster = self.saved(tmp_path, book)
        assert [one.group for one in roster.students] == ["71", "71", "72"]

    def test_headings_of_two_rows_are_read_where_the_lower_is_filled(self, tmp_path: Path) -> None:
        book = openpyxl.Workbook()
        sheet = book.active
        for row in (
            ("ВЕДОМОСТЬ", None, None),
            ("№", "Студент", None),
            (None, "Фамилия", "Имя"),
            (1, "Ли", "Цзин"),
            ("Итого", 1, None),
        ):
            sheet.append(row)
        for merged in ("A1:C1", "A2:A3", "B2:C2"):
            sheet.merge_cells(merged)
        assert names(self.saved(tmp_path, book)) == ["Ли Цзин"]

    def of_sheets(self, folder: Path, **sheets: Sequence[Sequence[object]]) -> Roster:
        """Read a workbook of these sheets; `_` in a title stands for a stroke."""
        book = openpyxl.Workbook()
        del book["Sheet"]
        for title, rows in sheets.items():
            sheet = book.create_sheet(title.replace("_", "-"))
            for row in rows:
                sheet.append(row)
        return self.saved(folder, book)

    def test_the_sheet_with_headings_is_read_and_the_others_are_named(self, tmp_path: Path) -> None:
        roster = self.of_sheets(
            tmp_path,
            Титул=[("Список групп факультета",)],
            РК5_71=[("ФИО",), ("Иванов Иван",)],
            Часы=[("Группа", "Часы"), ("РК5-71", 12)],
        )
        assert roster.students == (Student("иванов-иван", "Иванов Иван", "", "", "", ""),)
        assert "only the sheet 'РК5-71' was read; there is also: Титул, Часы." in said(roster)

    def test_each_sheet_with_names_is_a_group(self, tmp_path: Path) -> None:
        book = openpyxl.Workbook()
        book.create_sheet("Титул", 0).append(["Список групп факультета"])
        for title in ("РК5-71", "РК5-72"):
            book.create_sheet(title).append(["ФИО"])
            book[title].append([f"Студент {title}"])
        del book["Sheet"]
        book.create_sheet("Черновик").sheet_state = "hidden"
        book["Черновик"].append(["ФИО"])
        roster = self.saved(tmp_path, book)
        assert [(one.name, one.group) for one in roster.students] == [
            ("Студент РК5-71", "РК5-71"),
            ("Студент РК5-72", "РК5-72"),
        ]
        assert (
            "a list was read from each of the sheets РК5-71 (1), РК5-72 (1);"
            " no list is: Титул." in said(roster)
        )
        assert "the titles of sheets: РК5-71, РК5-72." in said(roster)

    def test_sheets_may_have_other_columns_and_say_the_group_themselves(
        self, tmp_path: Path
    ) -> None:
        roster = self.of_sheets(
            tmp_path,
            Дневное=[("№", "ФИО", "Группа"), (1, "Иванов Иван", "РК5-71"), ("Итого", 1, None)],
            Вечернее=[("Группа РК5-75В",), ("Фамилия", "Имя", "Почта"), ("Ким", "Лев", "k@x")],
            Лист3=[("ФИО",), ("Ли Цзин",)],
            Пусто=[("ФИО",)],
        )
        assert [(one.id, one.group) for one in roster.students] == [
            ("иванов-иван", "РК5-71"),
            ("k", "РК5-75В"),
            ("ли-цзин", ""),
        ]
        assert "passed over: 3 [Дневное] (Итого)" in said(roster)

    def test_one_id_on_two_sheets_is_refused_by_both_their_names(self, tmp_path: Path) -> None:
        rows = [("Шифр", "ФИО"), ("11", "Иванов Иван")]
        with pytest.raises(TableError) as caught:
            self.of_sheets(tmp_path, РК5_71=rows, РК5_72=rows)
        (problem,) = caught.value.problems
        assert str(problem.key) == "row 2 [РК5-72], column Шифр"
        assert "is in row 2 [РК5-71] already" in str(problem.what)

    def test_sheets_without_anybody_are_refused(self, tmp_path: Path) -> None:
        with pytest.raises(TableError, match="headings but no students"):
            self.of_sheets(tmp_path, РК5_71=[("ФИО",)], РК5_72=[("ФИО",)])


def test_whoever_teaches_is_on_a_platforms_list_and_gets_no_variant() -> None:
    roster = listed(
        "First Name,Last Name,SID,Email,Role,Sections",
        "Anna,Berg,a1,a@x.example,Student,RTK-41",
        "Ivan,Orlov,,i@x.example,Instructor,",
        "Olga,Kim,k1,k@x.example,TA,RTK-41",
        "Lev,Lee,l1,l@x.example,,RTK-42",
    )
    assert [one.id for one in roster.students] == ["a1", "l1"]
    assert "not a student's were passed over: 3 (Orlov Ivan Instructor), 4 (Kim Olga TA)." in said(
        roster
    )


@pytest.mark.parametrize(
    ("role", "stays"),
    [("Студент", True), ("Учитель", False), ("Староста", True), ("Студент, Ассистент", True)],
)
def test_only_a_known_role_of_staff_leaves_anybody_out(role: str, stays: bool) -> None:  # noqa: FBT001
    roster = listed("ФИО;Роли", f"Иванов Иван;{role}", "Ким Лев;студент")
    assert ("Иванов Иван" in names(roster)) is stays


def test_a_group_in_a_row_of_its_own_is_that_of_the_people_below() -> None:
    roster = listed(
        "№;ФИО;Зач. кн. №",
        ";Группа РТК-41;",
        "1;Иванов Иван;11",
        "2;Петров Пётр;12",
        "Группа: РТК-42;;",
        "1;Иванов Иван;13",
        "Примечание: группа переведена на очную форму;;",
    )
    assert [(one.id, one.group) for one in roster.students] == [
        ("11", "РТК-41"),
        ("12", "РТК-41"),
        ("13", "РТК-42"),
    ]
    assert "they stand above the names: РТК-41, РТК-42." in said(roster)


@pytest.mark.parametrize(
    ("title", "group"),
    [
        ("Список студентов группы РТК-41 на 01.09.2026;;", "РТК-41"),
        ("Список групи: 341-а;;", "341-а"),
        ("Группы РТК-41 и группы РТК-42;;", ""),
        ("Список учебной группы по захватам;;", ""),
    ],
)
def test_the_title_of_a_list_names_the_one_group_of_all(title: str, group: str) -> None:
    roster = listed(title, "№;ФИО;Почта", "1;Иванов Иван;i@x")
    assert [one.group for one in roster.students] == [group]


def test_a_column_of_groups_goes_before_what_stands_above() -> None:
    roster = listed("Список группы РТК-41;;", "ФИО;Группа", "Иванов Иван;РТК-42", "Петров Пётр;")
    assert [one.group for one in roster.students] == ["РТК-42", ""]


class TestAGroupBesideTheFirstOfEach:
    """What was a merged cell is one written cell and blank ones below it in a file of text."""

    def test_it_is_that_of_the_rows_below(self) -> None:
        people = [f"{row};Студент {chr(0x410 + row)};" for row in range(7)]
        people[0] += "РТК-41"
        people[4] += "РТК-42"
        roster = listed("Список;;", "№;ФИО;Группа", *people, "Всего: 7;;")
        assert [one.group for one in roster.students] == ["РТК-41"] * 4 + ["РТК-42"] * 3
        assert "rows below: РТК-41 (3–6), РТК-42 (7–9)." in said(roster)

    def test_a_group_that_goes_on_overleaf_is_one(self) -> None:
        roster = listed("ФИО;Группа", "А;1", "Б;", "В;", "Г;1", "Д;", "Е;", "Ж;2", "З;", "И;")
        assert [one.group for one in roster.students] == ["1"] * 6 + ["2"] * 3
        assert "1 (2–7), 2 (8–10)" in said(roster)

    def test_each_sheet_has_its_own(self, tmp_path: Path) -> None:
        book = openpyxl.Workbook()
        for title, group in (("A", "41"), ("B", "42")):
            sheet = book.create_sheet(title)
            for row in (("ФИО", "Группа"), (f"{title} А", group), (f"{title} Б",), (f"{title} В",)):
                sheet.append(row)
        del book["Sheet"]
        book.save(tmp_path / "list.xlsx")
        roster = read_roster(tmp_path / "list.xlsx")
        assert [one.group for one in roster.students] == ["41"] * 3 + ["42"] * 3
        assert "41 (2 [A]–4 [A])" in said(roster)

    @pytest.mark.parametrize(
        "groups",
        [
            ("1", "1", "1", "", "1", "1", "", "", ""),  # one of many is in none
            ("1", "", "2", "", "1", "", "", "", ""),  # in the order of names
            ("", "", "1", "", "", "", "", "", ""),  # nobody knows whose the first are
            ("1", "", "", "2", ""),  # two people, or one and one without a group
        ],
    )
    def test_where_it_may_be_meant_nobody_gets_a_group_and_it_is_told(
        self, groups: Sequence[str]
    ) -> None:
        rows = [f"Студент {chr(0x410 + at)};{group}" for at, group in enumerate(groups)]
        roster = listed("ФИО;Группа", *rows)
        assert tuple(one.group for one in roster.students) == tuple(groups)
        blank = ", ".join(str(at + 2) for at, group in enumerate(groups) if not group)
        assert f"No group is written in the rows: {blank}." in said(roster)


@pytest.mark.parametrize(
    "heading",
    ["Фамилия И. О.", "Ф. И.О. студента", "Прізвище ім\u2019я, по батькові", "ПІБ здобувача:"],
)
def test_dots_and_commas_of_a_heading_do_not_count(heading: str) -> None:
    assert names(listed(f"{heading};Группа", "Иванов Иван;1")) == ["Иванов Иван"]


def test_whoever_was_listed_without_a_group_keeps_the_id_when_the_list_names_one() -> None:
    known = [Student("7", "Иванов Иван", "", "", "", "")]
    content = "Группа РТК-41;\nФИО;Почта\nИванов Иван;i@x\n".encode()
    roster = read_roster(NamedBytes("list.csv", content), known)
    assert [one.id for one in roster.students] == ["7"]
    content = "ФИО;Группа\nИванов Иван;1\nИванов Иван;2\n".encode()
    with pytest.raises(TableError) as raised:
        read_roster(NamedBytes("list.csv", content), known)
    assert [str(one.key) for one in raised.value.problems] == ["row 2", "row 3"]


@pytest.mark.parametrize(
    "row", ["Староста;Абрамова Мария;", ";Староста Абрамова М.Ю.;", "Староста;Абрамова М.Ю.;Р-1"]
)
def test_who_is_named_below_a_numbered_list_is_nobody_on_it(row: str) -> None:
    roster = listed("№ п/п;ФИО;Группа", "1;Абрамова Мария;Р-1", "2;Староста Олег;Р-1", row)
    assert names(roster) == ["Абрамова Мария", "Староста Олег"]


def test_a_remark_in_brackets_is_no_part_of_a_name_and_a_former_surname_is() -> None:
    roster = listed(
        "№;Студент (ФИО);Гр.",
        "1;Бойко Ірина (староста);А-1",
        "2;Петрова (Сидорова) Анна;А-1",
        "3;Орлова Ольга (Иванова);А-1",
    )
    assert names(roster) == ["Бойко Ірина", "Петрова (Сидорова) Анна", "Орлова Ольга (Иванова)"]
    assert {one.group for one in roster.students} == {"А-1"}
    assert "was left out: Бойко Ірина (староста). Look" in said(roster)
