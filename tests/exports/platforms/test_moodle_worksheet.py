"""Moodle's worksheet comes back as it was, with grades that its import reads in every language."""

import csv
import io
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.errors import UsageError
from gripcourse.exports.platforms.comment import comment_html
from gripcourse.exports.platforms.moodle_comment import beside_others, grade_with
from gripcourse.exports.platforms.moodle_feedback import feedback_zip
from gripcourse.exports.platforms.moodle_words import HEADINGS, MoodleColumn
from gripcourse.exports.platforms.moodle_worksheet import (
    fill_worksheet,
    read_worksheet,
    to_choose,
)
from gripcourse.exports.platforms.works import GradedWork
from gripcourse.machine.content import NamedBytes
from gripcourse.text.words import Words

Works = Callable[[dict[str, str]], tuple[GradedWork, ...]]
ZIP = "РГР.zip/Ольга Иванова_{}_assignsubmission_file/s.xlsx"
EN = """\
Identifier,"Full name","Email address",Status,Grade,"Maximum grade","Grade can be changed",\
"Last modified (submission)","Last modified (grade)","Feedback comments"
"Participant 12","Ольга Иванова",other@mail.com,"Submitted for grading -  - ",,100.00,Yes,\
"Saturday, 21 November 2026, 8:07 AM",-,
"Participant 3","Іван ОКовальчук",kovalchuk@uni.ua,"Submitted for grading -  - ",,100.00,Yes,\
"Saturday, 21 November 2026, 8:07 AM","Saturday, 21 November 2026, 8:09 AM","<p>a,
b</p>"
"Participant 44","Nobody Here",nobody@uni.ua,"No submission -  - ",,100.00,Yes,-,-,
"""
RU = """\
Идентификатор,"Полное имя","Адрес электронной почты",Статус,Оценка,"Максимальная оценка",\
"Оценка может быть изменена","Последнее изменение (ответ)","Последнее изменение (оценка)",\
"Отзыв в виде комментария"
Участник12,"Ольга Иванова",o@mail.com,Статус,"60,25","100,00",Да,-,\
"суббота, 21 ноября 2026, 08:07",
"""
UK = """\
Ідентифікатор;"Повна назва";Статус;Оцінка;"Максимальна оцінка";"Оцінка може бути змінена";\
"Востаннє змінювалося (оцінка)";"Відгук - коментарем"
Учасник12;"Іванова Ольга";Статус;;"50,00";Так;"Saturday 21 November 2026 08:07 PM";
Учасник3;"ОКовальчук Іван";Статус;;"50,00";Ні;-;
"""


def sheet(text: str, encoding: str = "utf-8-sig") -> NamedBytes:
    return NamedBytes("Grades.csv", text.encode(encoding))


def filled(source: NamedBytes, works: tuple[GradedWork, ...]) -> bytes:
    return fill_worksheet(read_worksheet(source), works, lambda _: "ok").content


def rows(content: bytes, encoding: str = "utf-8-sig", separator: str = ",") -> list[dict[str, str]]:
    text = io.StringIO(content.decode(encoding), newline="")
    return list(csv.DictReader(text, delimiter=separator))


def test_only_grade_and_comment_are_filled_in(works: Works) -> None:
    content = filled(sheet(EN), works({ZIP.format(12): "s17"}))
    before, after = rows(sheet(EN).data), rows(content)
    changed = {
        (number, name)
        for number, (old, new) in enumerate(zip(before, after, strict=True))
        for name in old
        if old[name] != new[name]
    }
    assert changed == {(0, "Grade"), (0, "Feedback comments")}
    assert after[0]["Feedback comments"] == beside_others("", "ok", after[0]["Grade"])
    assert 0 < float(after[0]["Grade"]) <= 100


def graded_row(grade: str, comment: str) -> NamedBytes:
    """Make a worksheet in which somebody has a grade and a comment already."""
    cells = '"Submitted for grading -  - ",{},100.00,Yes,"Saturday, 21 November 2026, 8:07 AM",-,{}'
    return sheet(EN.replace(cells.format("", "\n"), cells.format(grade, f"{comment}\n"), 1))


def test_a_mark_of_which_a_site_keeps_the_class_alone_is_ours_all_the_same() -> None:
    ours = beside_others("<p>See me.</p>", "ok", "12.00")
    kept = ours.replace(' data-grade="12.00"', "")
    assert grade_with(kept) == ""
    assert beside_others(kept, "ok", "12.00") == ours


def test_what_a_person_wrote_beside_a_grade_stays(works: Works) -> None:
    source = graded_row("", "<p>Draw the jaws anew.</p>")
    found = works({ZIP.format(12): "s17"})
    (first, *_) = rows(filled(source, found))
    again = sheet(filled(source, found).decode("utf-8-sig"))
    (second, *_) = rows(fill_worksheet(read_worksheet(again), found, lambda _: "better").content)
    assert first["Feedback comments"].startswith("<p>Draw the jaws anew.</p><p ")
    assert second["Feedback comments"] == first["Feedback comments"].replace("ok", "better")


def test_a_grade_that_a_person_gave_in_moodle_is_named_before_it_is_replaced(
    works: Works,
) -> None:
    found = works({ZIP.format(12): "s17"})
    typed = fill_worksheet(read_worksheet(graded_row("88.50", "")), found, lambda _: "ok")
    (said,) = typed.notes
    assert "88.50" in Words("en").say(said)
    (row, *_) = rows(typed.content)
    # Another mark for the same work: what stands there is what came from here.
    ours = beside_others("", "ok", "12.00").replace('"', '""')
    assert fill_worksheet(read_worksheet(graded_row("12.00", f'"{ours}"')), found, str).notes == ()
    ours = beside_others("", "ok", row["Grade"]).replace('"', '""')
    later = graded_row("95.00", f'"{ours}"')
    (said,) = fill_worksheet(read_worksheet(later), found, lambda _: "ok").notes
    assert "95.00" in Words("en").say(said)


def test_a_row_without_a_work_stays_byte_for_byte(works: Works) -> None:
    content = filled(sheet(EN), works({ZIP.format(12): "s17"}))
    before, after = sheet(EN).data, content
    rest = before[before.index(b'"Participant 3"') :]
    assert after.endswith(rest)
    assert after.startswith(before[: before.index(b'"Participant 12"')])


def test_a_row_is_known_by_number_address_or_name(works: Works) -> None:
    found = works({ZIP.format(12): "s17", "x/s18.xlsx": "s18"})
    grades = [row["Grade"] != "" for row in rows(filled(sheet(EN), found))]
    assert grades == [True, True, False]


def test_a_russian_worksheet_gets_a_point_and_a_date_that_moodle_reads(works: Works) -> None:
    (row,) = rows(filled(sheet(RU), works({ZIP.format(12): "s17"})))
    assert "." in row["Оценка"]
    assert "," not in row["Оценка"]
    assert row["Последнее изменение (оценка)"] == "2026-11-21 08:07"
    assert row["Максимальная оценка"] == "100,00"


@pytest.mark.parametrize("encoding", ["cp1251", "koi8_u", "mac_cyrillic", "utf-8", "utf-16"])
def test_encoding_and_separator_stay(works: Works, encoding: str) -> None:
    found = works({ZIP.format(12): "s17", "x/s18.xlsx": "s18"})
    result = fill_worksheet(read_worksheet(sheet(UK, encoding)), found, lambda _: "ok")
    first, second = rows(result.content, encoding, ";")
    assert 0 < float(first["Оцінка"]) <= 50
    assert first["Востаннє змінювалося (оцінка)"] == "2026-11-21 20:07"
    assert second["Оцінка"] == ""
    assert ["cannot be changed" in str(note) for note in result.notes] == [True]


@pytest.mark.parametrize("encoding", ["cp1251", "cp866", "koi8_u", "mac_cyrillic"])
def test_the_code_page_of_the_shortest_worksheet_is_told_by_its_headings(encoding: str) -> None:
    worksheet = read_worksheet(sheet("Идентификатор;Оценка;Последнее изменение (оценка)", encoding))
    assert (worksheet.language, worksheet.table.separator) == ("ru", ";")


def test_what_a_spreadsheet_program_made_of_a_worksheet_has_to_be_chosen_in_moodle() -> None:
    assert to_choose(read_worksheet(sheet(EN))) is None
    said = to_choose(read_worksheet(sheet(UK, "cp1251")))
    assert said is not None
    assert "the separator ; and the encoding CP1251" in Words("en").say(said)


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_of_another_language_the_headings_are_told_and_not_the_separator(separator: str) -> None:
    """Else a name or a number with a comma in it makes rows of other cells than the headings."""
    german = separator.join(["ID", "Vollständiger Name", "Bewertung", "Bestwertung"])
    row = separator.join(["Teilnehmer/in12", '"Müller, Anna"', '"60,25"', '"100,00"'])
    with pytest.raises(UsageError) as refused:
        read_worksheet(sheet(f"{german}\n{row}\n"))
    first = str(refused.value.problems[0].what)
    assert "'Identifier' / 'Идентификатор' / 'Ідентифікатор'" in first
    assert first.endswith("ID, Vollständiger Name, Bewertung, Bestwertung.")


def test_an_unknown_heading_is_named(works: Works) -> None:
    with pytest.raises(UsageError) as refused:
        filled(sheet(EN.replace("Identifier", "Kennung")), works({}))
    assert "'Identifier' / 'Идентификатор' / 'Ідентифікатор'" in str(refused.value)
    assert "Kennung" in str(refused.value)


@pytest.mark.parametrize(
    ("text", "other", "heading"),
    [(EN, "Status", "Grade"), (RU, "Статус", "Оценка"), (UK, "Статус", "Оцінка")],
)
def test_two_columns_of_one_heading_are_refused(text: str, other: str, heading: str) -> None:
    assert read_worksheet(sheet(text))
    with pytest.raises(UsageError, match=f"Two columns are called '{heading}'"):
        read_worksheet(sheet(text.replace(other, heading, 1)))


def test_two_rows_of_one_student_are_refused(works: Works) -> None:
    twice = EN.replace("other@mail.com", "kovalchuk@uni.ua")
    with pytest.raises(UsageError, match="Rows 2, 3 are all of s18"):
        filled(sheet(twice), works({"x/s18.xlsx": "s18"}))
    with pytest.raises(UsageError, match="have the same number 12"):
        filled(sheet(EN.replace("Participant 3", "Participant 12")), works({}))


def test_a_work_from_anothers_account_gets_no_grade(works: Works) -> None:
    found = works({"Ольга Иванова_12_assignsubmission_file/s.xlsx": "s18"})
    result = fill_worksheet(read_worksheet(sheet(EN)), found, lambda _: "")
    assert result.filled == 0
    assert "under another account" in str(result.notes[0])


def test_the_number_of_a_team_is_not_that_of_a_participant(works: Works, tmp_path: Path) -> None:
    """Teams and participants are numbered apart: team 12 is not Participant 12."""
    text = EN.replace("other@mail.com", "-")
    found = works({"Бригада 5_12_assignsubmission_file/s.xlsx": "s18"})
    result = fill_worksheet(read_worksheet(sheet(text)), found, lambda _: "")
    assert [row["Grade"] != "" for row in rows(result.content)] == [False, True, False]
    report = tmp_path / "s18.pdf"
    report.write_bytes(b"%PDF")
    packed, notes = feedback_zip(result, lambda _: report, Words("ru"))
    with zipfile.ZipFile(io.BytesIO(packed)) as archive:
        assert archive.namelist() == []
    assert ["s18 О'Ковальчук Іван handed in with a team" in str(note) for note in notes] == [True]


@pytest.mark.parametrize("name", ["Participant", "Участник", "Учасник"])
def test_a_number_alone_tells_whose_a_row_is_where_names_are_hidden(
    works: Works, name: str
) -> None:
    found = works({f"{name}_44_assignsubmission_file/s.xlsx": "s17"})
    assert [row["Grade"] != "" for row in rows(filled(sheet(EN), found))] == [False, False, True]


def test_a_name_that_the_student_chose_is_no_number_of_moodle(works: Works) -> None:
    found = works({"mail/rgr_44_2_final.xlsx": "s18"})
    assert [row["Grade"] != "" for row in rows(filled(sheet(EN), found))] == [False, True, False]


def test_what_many_share_tells_nobody(works: Works) -> None:
    """A group may be called as a student: of three in group s18 none is s18 for that."""
    text = EN.replace(",Status,", ",Group,Status,").replace('"Submitted for', 's18,"Submitted for')
    text = text.replace('"No submission', 's18,"No submission')
    assert [
        row["Grade"] != "" for row in rows(filled(sheet(text), works({"s18.xlsx": "s18"})))
    ] == [
        False,
        True,
        False,
    ]


def test_what_a_student_typed_takes_nobody_elses_grade(works: Works) -> None:
    text = EN.replace('"Last modified (grade)"', '"Online text","Last modified (grade)"')
    first, *others = text.splitlines(keepends=True)
    typed = "".join(others).replace('8:07 AM",', '8:07 AM",kovalchuk@uni.ua,', 1)
    typed = typed.replace('8:07 AM","Sat', '8:07 AM",,"Sat').replace("Yes,-,-", "Yes,-,,-")
    found = works({ZIP.format(3).replace("Ольга Иванова", "Іван ОКовальчук"): "s18"})
    result = fill_worksheet(read_worksheet(sheet(first + typed)), found, lambda _: "")
    assert (result.filled, result.notes) == (1, ())


def test_who_is_not_in_the_worksheet_is_named(works: Works) -> None:
    result = fill_worksheet(read_worksheet(sheet(EN)), works({"s19.xlsx": "s19"}), lambda _: "")
    assert [str(one) for one in result.notes] == [
        "s19 =Петров Пётр is not in the platform's table."
    ]


def test_a_worksheet_that_says_no_maximum_is_filled_by_our_points_and_that_is_told(
    works: Works,
) -> None:
    """Moodle leaves out without a word what is above the maximum that it knows."""
    text = EN.replace('"Maximum grade"', '"Höchstpunktzahl"')
    result = fill_worksheet(
        read_worksheet(sheet(text)), works({ZIP.format(12): "s17"}), lambda _: ""
    )
    assert result.filled == 1
    assert "no column 'Maximum grade': grades are of" in str(result.notes[0])


def test_a_scale_of_words_is_refused(works: Works) -> None:
    with pytest.raises(UsageError, match="a scale of words"):
        filled(sheet(EN.replace("100.00", "A B C")), works({ZIP.format(12): "s17"}))


SCALE = EN.replace('"Maximum grade"', "Scale").replace("100.00", '"not passed\nGood\nexcellent"')


def called(work: GradedWork, scales: dict[str, str], waiting: float = 0.0) -> GradedWork:
    """The same work as a policy with scales calls it."""
    return replace(work, report=replace(work.report, scales=scales, open_points=waiting))


def test_a_scale_of_words_is_filled_with_the_word_that_the_policy_has_too(works: Works) -> None:
    (work,) = works({ZIP.format(12): "s17"})
    found = fill_worksheet(
        read_worksheet(sheet(SCALE)),
        [called(work, {"ects": "B", "national": "good", "percent": "81"})],
        lambda _: "ok",
    )
    assert [row["Grade"] for row in rows(found.content)] == ["Good", "", ""]
    assert (found.filled, found.updates, found.notes) == (1, 1, ())


def test_before_all_points_are_given_there_is_no_word(works: Works) -> None:
    (work,) = works({ZIP.format(12): "s17"})
    found = fill_worksheet(
        read_worksheet(sheet(SCALE)), [called(work, {"national": ""}, 8.0)], lambda _: "ok"
    )
    assert found.content == sheet(SCALE).data
    assert "no grade in words" in str(found.notes[0])


@pytest.mark.parametrize(
    "scales", [{}, {"ects": "B"}, {"national": "good", "other": "excellent"}], ids=len
)
def test_a_word_that_is_not_certain_is_refused_with_both_scales(
    works: Works, scales: dict[str, str]
) -> None:
    (work,) = works({ZIP.format(12): "s17"})
    with pytest.raises(UsageError, match="not passed; Good; excellent"):
        fill_worksheet(read_worksheet(sheet(SCALE)), [called(work, scales)], lambda _: "")


MARKING = {
    "en": ("Marker", "Marking workflow state", "Due date", "Override - Due date"),
    "ru": ("Оценщик", "Состояние поэтапного оценивания", "Срок сдачи", "Переопределение"),
    "uk": ("Оцінювач", "Стан оцінювання", "Кінцевий термін", "Перевизначення"),
}
OTHERS = ('"Ткач, О. ""Лев"""', '"In marking"', "  -  ", '"<b>a;b\tc</b>"')


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("language", MARKING)
@pytest.mark.parametrize("number", ["60.25", "60,25"])
def test_marking_columns_and_every_other_byte_stay_as_they_stood(
    works: Works, separator: str, language: str, number: str
) -> None:
    words = HEADINGS[language]
    person = {"en": "Participant 12", "ru": "Участник12", "uk": "Учасник12"}[language]
    head = [words[MoodleColumn.IDENTIFIER], f'"{words[MoodleColumn.NAME]}"', MARKING[language][0]]
    head += [words[MoodleColumn.GRADE], words[MoodleColumn.MAXIMUM], *MARKING[language][1:]]
    head += [words[MoodleColumn.GRADED_AT], words[MoodleColumn.COMMENT]]
    before = [f'"{person}"', '"Ольга Иванова"', OTHERS[0], f'"{number}"', '"100,00"']
    before += [*OTHERS[1:], "-", '"old, text"']
    text = separator.join(head) + "\r\n" + separator.join(before) + "\r\n"
    content = filled(sheet(text), works({ZIP.format(12): "s17"})).decode("utf-8-sig")
    grade = f"{works({ZIP.format(12): 's17'})[0].share * 100:.2f}"
    comment = beside_others("old, text", "ok", grade).replace('"', '""')
    after = [*before[:3], grade, *before[4:-1], f'"{comment}"']
    assert content == separator.join(head) + "\r\n" + separator.join(after) + "\r\n"


@pytest.mark.parametrize("maximum", ["nan", "1e999", "0", "-5", "inf"])
def test_a_maximum_of_which_there_is_no_part_is_refused(works: Works, maximum: str) -> None:
    with pytest.raises(UsageError, match="no points"):
        filled(sheet(EN.replace("100.00", maximum)), works({ZIP.format(12): "s17"}))


def test_a_comment_is_html_without_line_ends(works: Works, course: Course) -> None:
    (work,) = works({ZIP.format(12): "s17"})
    said = comment_html(work, course, Words("ru"))
    assert "\n" not in said
    assert said.count("<br>") >= len(course.sections) - 1
    assert all(section.title.of("ru") in said for section in course.sections[:2])


def test_the_names_in_the_zip_of_reports_are_those_that_moodle_takes(
    works: Works, tmp_path: Path
) -> None:
    report = tmp_path / "s17.pdf"
    report.write_bytes(b"%PDF")
    found = works({ZIP.format(12): "s17"})
    source = sheet(EN.replace("Ольга Иванова", "Ольга_Иванова"))
    result = fill_worksheet(read_worksheet(source), found, lambda _: "")
    packed, notes = feedback_zip(result, lambda _: report, Words("ru"))
    with zipfile.ZipFile(io.BytesIO(packed)) as archive:
        (info,) = archive.infolist()
        assert archive.read(info) == b"%PDF"
    assert info.flag_bits & 1 << 11
    person, _, rest = info.filename.partition("_")
    number, plugin, kind = rest.split("/")[0].split("_")
    assert (person, number, plugin, kind) == ("Ольга Иванова", "12", "assignfeedback", "file")
    assert notes == ()


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"Identifier," + b"a" * 200_000, "cannot be told apart"),
        (b"\xef\xbb\xbfIdentifier\xff\xfe,x", "no table of text"),
        (b"\xff\xfea\0b", "no table of text"),
        (b"\xff\xfe\0\xd8a\0", "no table of text"),
    ],
    ids=["a very long cell", "a mark of UTF-8 alone", "UTF-16 cut short", "half a sign"],
)
def test_what_is_no_text_is_refused_by_name(data: bytes, said: str) -> None:
    with pytest.raises(UsageError, match=f"^work.csv.*{said}"):
        read_worksheet(NamedBytes("work.csv", data))


def test_where_nobody_could_be_looked_for_by_name_it_is_said(works: Works) -> None:
    found = works({"elsewhere/s17.xlsx": "s17"})
    source = read_worksheet(sheet(EN.replace("Full name", "Name and surname")))
    result = fill_worksheet(source, found, lambda _: "")
    assert (result.filled, len(result.notes)) == (0, 2)
    assert "has no column 'Full name'" in str(result.notes[0])


def test_a_report_that_no_number_leads_to_is_said_not_to_be_in_the_zip(
    works: Works, tmp_path: Path
) -> None:
    report = tmp_path / "s17.pdf"
    report.write_bytes(b"%PDF")
    source = read_worksheet(sheet(EN.replace("Participant 12", "Participant")))
    result = fill_worksheet(source, works({"elsewhere/s17.xlsx": "s17"}), lambda _: "")
    assert result.filled == 1
    _, (note,) = feedback_zip(result, lambda _: report, Words("en"))
    assert "the worksheet has no number of this row" in str(note)
    _, (note,) = feedback_zip(result, lambda _: None, Words("en"))
    assert "grade again and let reports be written" in str(note)


def test_a_worksheet_of_more_rows_than_any_course_has_students_is_told_so() -> None:
    long = EN + EN.splitlines(keepends=True)[-1] * 200_001
    with pytest.raises(UsageError, match="at most 200000 rows"):
        read_worksheet(sheet(long))
