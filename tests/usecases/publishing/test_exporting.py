"""What is taken elsewhere is the work that counts."""

import json
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.errors import UsageError
from gripcourse.exports.make_report_result import grades_result
from gripcourse.exports.platforms.works import works_of
from gripcourse.grading.model import Report
from gripcourse.issuing.withdrawal import Join
from gripcourse.text.words import Words
from gripcourse.usecases.grading.batch_tables import json_text
from gripcourse.usecases.grading.grade import REPORTS
from gripcourse.usecases.grading.points_told import points_told
from gripcourse.usecases.grading.unchanged import PrintedBefore
from gripcourse.usecases.publishing.exporting import (
    Results,
    gradescope_file,
    moodle_files,
    open_results,
    table_files,
)
from gripcourse.usecases.publishing.outbox import outbox_folders
from support.reports import perfect, values, variant

if TYPE_CHECKING:
    from support.classroom import Classroom

__all__ = ["perfect", "values", "variant"]


def several(issued: "Classroom", perfect: Report, *counts: bool) -> Results:
    """The results of one student's late works, each with its number as what is left of it."""
    students = {"s01": issued.register["s01"].student}
    made = [replace(perfect, student="s01", file=f"{at}.xlsx") for at, _ in enumerate(counts)]
    grades = grades_result(made, Words("en"))
    reports = [
        replace(one, counts=counting, earned=float(at))
        for at, (one, counting) in enumerate(zip(grades.reports, counts, strict=True))
    ]
    grades = replace(grades, reports=tuple(reports))
    works, notes = works_of(grades, students)
    return Results(issued.course, students, grades, Path("reports"), works, notes)


def test_of_several_works_of_a_student_gradescope_gets_the_one_that_counts(
    issued: "Classroom", perfect: Report, tmp_path: Path
) -> None:
    out = tmp_path / "results.json"
    results = several(issued, perfect, False, True, False)
    gradescope_file(results, "s01", out, published=False)
    assert json.loads(out.read_text(encoding="utf-8"))["score"] == 1


def test_the_folder_of_a_grading_stands_for_its_results(
    issued: "Classroom", perfect: Report, tmp_path: Path
) -> None:
    file = tmp_path / "grades.json"
    file.write_text(json_text([replace(perfect, student="s01")], Words("en")), encoding="utf-8")
    named, whole = (open_results(issued.course.root, one) for one in (file, tmp_path))
    assert whole == named
    assert whole.reports == tmp_path / "reports"


def test_what_is_no_result_is_named_by_its_file(issued: "Classroom", tmp_path: Path) -> None:
    (tmp_path / "other.json").write_text('{"schema": "other/1"}', encoding="utf-8")
    with pytest.raises(UsageError, match=r"other\.json.*other/1"):
        open_results(issued.course.root, tmp_path / "other.json")


def test_tables_of_an_earlier_grading_stay_where_one_cannot_be_written(
    issued: "Classroom", perfect: Report, tmp_path: Path
) -> None:
    results = several(issued, perfect, True)
    (tmp_path / "students.csv").write_bytes(b"of an earlier grading")
    (tmp_path / "items.csv").mkdir()  # where a file can take no place
    with pytest.raises(OSError, match=r"items\.csv"):
        table_files(results, tmp_path, str(tmp_path / "none.sqlite"))
    assert (tmp_path / "students.csv").read_bytes() == b"of an earlier grading"


def test_where_no_rule_says_which_counts_a_person_is_asked(
    issued: "Classroom", perfect: Report, tmp_path: Path
) -> None:
    results, out = several(issued, perfect, True, True), tmp_path / "r.json"
    with pytest.raises(UsageError, match="2 reports to choose from") as caught:
        gradescope_file(results, "", out, published=False)
    assert r"0.xlsx (s01), 1.xlsx (s01)" in str(caught.value)
    assert "Name the student" in str(caught.value)
    with pytest.raises(UsageError, match=r"under \[attempts\] in grader/policy.toml"):
        gradescope_file(results, "s01", out, published=False)


def test_of_works_that_were_graded_before_a_join_the_remedy_is_named(
    issued: "Classroom", perfect: Report, tmp_path: Path
) -> None:
    results = several(issued, perfect, True, True)
    first, second = results.grades.reports
    apart = replace(results.grades, reports=(first, replace(second, student="s02")))
    joined = (Join("s02", "s01", datetime(2026, 12, 1, tzinfo=UTC)),)
    results = replace(results, grades=apart, joins=joined)
    with pytest.raises(UsageError, match="s02 was joined with s01 since: grade again") as caught:
        gradescope_file(results, "s01", tmp_path / "r.json", published=False)
    assert "0.xlsx (s01), 1.xlsx (s02)" in str(caught.value)


def test_a_student_without_a_report_is_named(
    issued: "Classroom", perfect: Report, tmp_path: Path
) -> None:
    with pytest.raises(UsageError, match="There is no report of s09"):
        gradescope_file(several(issued, perfect, True), "s09", tmp_path / "r", published=False)


def test_who_handed_in_nothing_is_named_in_the_results_of_a_batch(issued: "Classroom") -> None:
    lacking = replace(issued.register["s02"].student, email="s02@x.example")
    read = json.loads(json_text([], Words("en"), missing=[lacking]))
    assert read["missing"] == [
        {"student": "s02", "name": lacking.name, "group": lacking.group, "email": "s02@x.example"}
    ]


@pytest.mark.parametrize(("language", "said"), [("en", "points"), ("uk", "балів"), ("", "баллов")])
def test_a_comment_is_in_the_language_of_the_student_it_is_for(
    issued: "Classroom", perfect: Report, tmp_path: Path, language: str, said: str
) -> None:
    results = several(issued, perfect, True)
    reader = replace(results.students["s01"], language=language)
    results = replace(results, students={"s01": reader})
    worksheet = tmp_path / "Grades.csv"
    worksheet.write_text(
        "Identifier,ID number,Grade,Maximum grade,Last modified (grade),Feedback comments\n"
        "Participant 9,s01,,100.00,-,\n",
        encoding="utf-8-sig",
    )
    out = tmp_path / "filled.csv"
    filled, _ = moodle_files(results, worksheet, out, None)
    assert filled.filled == 1
    assert said in out.read_text(encoding="utf-8-sig")


def test_a_letter_without_a_report_promises_none(
    issued: "Classroom", perfect: Report, tmp_path: Path
) -> None:
    results = replace(several(issued, perfect, True), reports=tmp_path)
    report = tmp_path / "s01.pdf"
    report.write_bytes(b"%PDF")
    (folder,), notes = outbox_folders(results, tmp_path / "out")
    with_report = (folder / "message.txt").read_text(encoding="utf-8")
    assert (notes, (folder / "report.pdf").read_bytes()) == ((), b"%PDF")
    report.unlink()
    _, (note,) = outbox_folders(results, tmp_path / "out")
    without = (folder / "message.txt").read_text(encoding="utf-8")
    assert "s01" in str(note)
    assert not (folder / "report.pdf").exists()
    assert with_report.startswith(without.rstrip("\n"))
    assert len(with_report) > len(without)


def test_a_report_of_other_points_than_the_grades_is_taken_nowhere(
    issued: "Classroom", perfect: Report, tmp_path: Path
) -> None:
    report = replace(perfect, student="s01")
    path = tmp_path / REPORTS / "s01.pdf"
    path.parent.mkdir()
    path.write_bytes(b"%PDF")
    printed = PrintedBefore(tmp_path / ".graded" / "printed", "all that documents are made with")
    printed.note(path, "this report", points_told(report, Words("ru")))
    assert printed.stands(path, "this report")
    written = json_text([report], Words("en"))
    (tmp_path / "grades.json").write_text(written, encoding="utf-8")
    results = open_results(issued.course.root, tmp_path)
    (work,) = results.works
    assert results.report_of(work) == path
    later = replace(work, report=replace(work.report, earned=1.0))
    assert results.report_of(later) is None
    path.write_bytes(b"%PDF, by another program")
    assert results.report_of(later) == path
