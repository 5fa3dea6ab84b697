"""How offices write lists without thinking of a program: merged headings, groups, ids."""

import io
from collections.abc import Sequence
from datetime import date

import openpyxl
import pytest

from gripcourse.errors import TableError
from gripcourse.issuing.roster import Roster, read_roster
from gripcourse.machine.content import NamedBytes


def listed(*lines: str, encoding: str = "utf-8") -> Roster:
    return read_roster(NamedBytes("list.csv", "\n".join(lines).encode(encoding)))


def workbook(
    *rows: Sequence[str | int | date],
    merged: str = "",
    hidden: int = 0,
    hidden_column: str = "",
    shown_as: str = "",
) -> NamedBytes:
    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    for row in rows:
        sheet.append(list(row))
    if merged:
        sheet.merge_cells(merged)
    if hidden:
        sheet.row_dimensions[hidden].hidden = True
    if hidden_column:
        sheet.column_dimensions[hidden_column].hidden = True
    for cell in next(sheet.iter_cols(max_col=1)):
        cell.number_format = shown_as or cell.number_format
    content = io.BytesIO()
    book.save(content)
    return NamedBytes("list.xlsx", content.getvalue())


def people(roster: Roster) -> list[tuple[str, str]]:
    return [(one.name, one.group) for one in roster.students]


def said(roster: Roster) -> str:
    return "\n".join(map(str, roster.notes))


def problem_in(*lines: str) -> str:
    with pytest.raises(TableError) as raised:
        listed(*lines)
    return str(raised.value)


@pytest.mark.parametrize("heading", ["ФИО", "Студент", "Прізвище, ім'я, по батькові здобувача"])
def test_a_heading_merged_over_the_parts_of_names_heads_whole_names(heading: str) -> None:
    roster = read_roster(
        workbook(
            ["№", heading, "", "", "Группа"],
            [1, "Лук’янчук", "Олег", "Петрович", "РТК-41"],
            [2, "Лук’янчук", "Анна", "", "РТК-41"],
            merged="B1:D1",
        )
    )
    assert [one.name for one in roster.students] == ["Лук’янчук Олег Петрович", "Лук’янчук Анна"]
    assert "stand in 3 columns" in said(roster)


def test_marks_in_a_column_without_heading_are_no_part_of_a_name() -> None:
    roster = listed("ФИО;;Группа", "Иванов Иван;Болеет;A", "Петров;н;A", "Яшин Лев;+;A")
    assert [one.name for one in roster.students] == ["Иванов Иван", "Петров", "Яшин Лев"]


@pytest.mark.parametrize("title", [";РТК-31;", "РТК-31;;", "3 курс, гр. 1;;", ";311;"])
def test_a_title_that_is_a_group_alone_is_that_of_the_people_below(title: str) -> None:
    group = {"3 курс, гр. 1;;": ""}.get(title, title.strip(";"))
    roster = listed("№;ФИО;№ зачётки", title, "1;Иванов Иван;001", "2;Яшин Лев;002")
    assert people(roster) == [("Иванов Иван", group), ("Яшин Лев", group)]


def test_groups_alone_in_rows_go_before_the_column_of_groups_nowhere() -> None:
    roster = listed("ФИО;Группа;Почта", "РТК-31;;", "Иванов Иван;A;i@x.ua", "Яшин Лев;B;j@x.ua")
    assert people(roster) == [("Иванов Иван", "A"), ("Яшин Лев", "B")]


def test_titles_of_subgroups_and_forms_are_nobody_and_told() -> None:
    roster = listed(
        "ФИО;Почта", "Группа РТК-31;", "1 подгруппа;", "Иванов Иван;i@x.ua", "Контракт;",
        "Яшин Лев;j@x.ua",
    )  # fmt: skip
    assert people(roster) == [("Иванов Иван", "РТК-31"), ("Яшин Лев", "РТК-31")]
    assert "3 (1 подгруппа), 5 (Контракт)" in said(roster)


def test_a_surname_alone_is_a_person_where_all_names_stand_alone() -> None:
    assert [one.name for one in listed("ФИО", "Иванов", "Яшин Лев").students] == [
        "Иванов",
        "Яшин Лев",
    ]


def test_of_two_columns_of_ids_the_one_that_tells_all_apart_is_used() -> None:
    roster = listed(
        "Username;ID number;Last name;First name", "ivan;;Иванов;Иван", "lev;0042;Яшин;Лев"
    )
    assert [one.id for one in roster.students] == ["ivan", "lev"]
    assert "'Username' was used, and not 'ID number'" in said(roster)


def test_an_id_with_strokes_and_blanks_is_kept_as_a_folder_is_called() -> None:
    roster = listed(
        "ФИО;№ зачётки", "Иванов Иван;20-МР/031", "Яшин Лев;КВ 123", "Попов Ян;'\u200b007"
    )
    assert [one.id for one in roster.students] == ["20-МР-031", "КВ-123", "007"]
    assert "20-МР-031 (20-МР/031)" in said(roster)


def test_an_id_has_the_noughts_that_its_format_shows() -> None:
    roster = read_roster(workbook(["№ зачётки", "ФИО"], [123, "Иванов Иван"], shown_as="000000"))
    assert [one.id for one in roster.students] == ["000123"]


@pytest.mark.parametrize(("column", "heading"), [("B", "Группа"), ("C", "Почта"), ("D", "")])
def test_hidden_columns_that_hold_anything_are_read_and_named(column: str, heading: str) -> None:
    roster = read_roster(
        workbook(
            ["ФИО", "Группа", "Почта"],
            ["Иванов Иван", "A", "i@x.example"],
            ["Яшин Лев", "B", "l@x.example"],
            hidden_column=column,
        )
    )
    assert people(roster) == [("Иванов Иван", "A"), ("Яшин Лев", "B")]
    note = f"columns that are hidden in the sheet 'Sheet' were read like all others: {heading}."
    assert (note in said(roster)) == bool(heading)


def test_hidden_rows_are_read_and_named() -> None:
    roster = read_roster(
        workbook(["ФИО", "Группа"], ["Иванов Иван", "A"], ["Яшин Лев", "B"], hidden=2)
    )
    assert people(roster) == [("Иванов Иван", "A"), ("Яшин Лев", "B")]
    assert "hidden in the sheet 'Sheet' were read like all others: 2." in said(roster)


def test_a_formula_without_result_is_nobodys_name() -> None:
    assert "result is not stored" in problem_in("ФИО;Группа", '=B2&" "&C2;A')


def test_a_group_that_became_a_day_is_a_problem() -> None:
    with pytest.raises(TableError, match="The cell holds the day 2026-11-10"):
        read_roster(workbook(["ФИО", "Группа"], ["Иванов Иван", date(2026, 11, 10)]))


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_text_of_two_bytes_a_letter_needs_no_mark(encoding: str) -> None:
    roster = listed("ФИО|Группа", "Щукин Эльдар|РТК-41", encoding=encoding)
    assert people(roster) == [("Щукин Эльдар", "РТК-41")]


@pytest.mark.parametrize(
    "heading",
    [
        "Обучающийся", "Фамилия Имя Отчество слушателя", "Прізвище та ім'я студента",
        "ПІБ здобувача освіти", "student_name",
    ],
)  # fmt: skip
def test_whose_names_they_are_may_stand_in_the_heading(heading: str) -> None:
    (student,) = listed(f"№;{heading};Назва групи", "1;Яшин Лев;A").students
    assert (student.name, student.group) == ("Яшин Лев", "A")


class TestWhoHasLeft:
    """A mark of an office is told by name; it takes an assignment from nobody."""

    @pytest.mark.parametrize(
        ("heading", "marked", "others"),
        [
            ("Отчислен", "да", ["нет", ""]),
            ("Отчислен", "01.09.2026", ["-", ""]),
            ("Відраховано", "так", ["ні", ""]),
            ("Статус", "Отчислен", ["Является студентом", ""]),
            ("Стан", "відраховано", ["навчається", ""]),
        ],
    )
    def test_it_is_named_and_taken_over(
        self, heading: str, marked: str, others: Sequence[str]
    ) -> None:
        roster = listed(
            f"ФИО;Группа;{heading}",
            f"Иванова Анна;A;{others[0]}",
            f"Петров Пётр;A;{marked}",
            f"Ким Лев;A;{others[1]}",
        )
        assert len(roster.students) == 3
        assert f"taken over all the same: 3 (Петров Пётр {heading}: {marked})." in said(roster)

    def test_of_many_the_first_are_named(self) -> None:
        names = (f"Иванова {letter}нна;{letter};да" for letter in "АБВГДЕЖЗИКЛМ")
        told = said(listed("ФИО;Группа;Отчислен", *names))
        assert "Лнна" not in told
        assert "(Иванова Кнна Отчислен: да), …. Delete" in told

    def test_a_list_in_which_everybody_stays_says_nothing(self) -> None:
        roster = listed("ФИО;Группа;Отчислен", "Иванова Анна;A;нет", "Ким Лев;A")
        assert "who have left" not in said(roster)
