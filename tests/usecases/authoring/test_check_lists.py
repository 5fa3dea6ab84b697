"""Lists that an instructor keeps in the course folder are checked together, before they count."""

from dataclasses import replace
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.usecases.authoring.check_lists import list_problems


def test_roster_and_deadlines_are_judged_at_once_by_row_and_column(
    course: Course, tmp_path: Path
) -> None:
    mine = replace(course, root=tmp_path)
    lists = tmp_path / "variants"
    lists.mkdir()
    assert list_problems(mine, None) == []
    (lists / "roster.csv").write_text("student,name,language\ns01,,ru\ns01,Анна,zz\n")
    (lists / "deadlines.csv").write_text("student,deadline\ns01,31.11.2026\n,soon\n")
    found = list_problems(mine, None)
    assert [(one.file, str(one.key)) for one in found] == [
        ("variants/roster.csv", "row 2, column name"),
        ("variants/roster.csv", "row 3, column language"),
        ("variants/roster.csv", "row 3, column student"),
        ("variants/deadlines.csv", "row 2, column deadline"),
        ("variants/deadlines.csv", "row 3, column deadline"),
    ]
    assert all(str(one.remedy) for one in found)


def test_before_anything_is_issued_the_roster_says_who_there_is(
    course: Course, tmp_path: Path
) -> None:
    lists = tmp_path / "variants"
    lists.mkdir()
    (lists / "roster.csv").write_text("student,name\ns01,Анна\n", encoding="utf-8")
    (lists / "deadlines.csv").write_text("Студент,Срок\ns10,1.12.2026\n", encoding="utf-8")
    (problem,) = list_problems(replace(course, root=tmp_path), None)
    assert str(problem.key) == "row 2, column Студент"
    assert "s01" in str(problem.remedy)
