"""Files of one batch that belong together."""

from dataclasses import replace

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.batch.duplicates import doubles
from gripcourse.grading.model import Flag, FlagCode, Report
from gripcourse.grading.unjudged import rejected_report
from gripcourse.submission.model import Rejected
from gripcourse.text.words import message


@pytest.fixture
def blank_report(context: GradingContext) -> Report:
    return rejected_report(Rejected("", "", message("Empty.")), context.register["s01"])


def codes(reports: list[Report]) -> list[list[str]]:
    """The flags that were added, by report."""
    return [[flag.code for flag in one.flags[1:]] for one in marked(reports)]


def marked(reports: list[Report]) -> list[Report]:
    return list((dict(enumerate(reports)) | dict(doubles(reports))).values())


def named(report: Report, file: str, student: str, digest: str) -> Report:
    return replace(report, file=file, student=student, digest=digest)


def test_different_files_of_different_students_are_not_flagged(blank_report: Report) -> None:
    reports = [named(blank_report, f"{n}.xlsx", f"s0{n}", f"d{n}") for n in range(5)]
    assert codes(reports) == [[]] * 5


def test_the_same_bytes_handed_in_twice_by_one_student_are_several_files_only(
    blank_report: Report,
) -> None:
    reports = [named(blank_report, f"{n}.xlsx", "s01", "same") for n in range(2)]
    assert codes(reports) == [["several_files"]] * 2


def test_each_flag_names_the_other_files_and_students(blank_report: Report) -> None:
    reports = [
        named(blank_report, "a.xlsx", "s01", "same"),
        named(blank_report, "b.xlsx", "s01", "other"),
        named(blank_report, "c.xlsx", "s02", "same"),
    ]
    flags = [{flag.code: str(flag.message) for flag in one.flags} for one in marked(reports)]
    assert "b.xlsx" in flags[0]["several_files"]
    assert "a.xlsx" not in flags[0]["several_files"]
    assert "s02" in flags[0]["same_bytes"]
    assert "s01" in flags[2]["same_bytes"]
    assert "same_bytes" not in flags[1]


def test_the_owner_of_a_stolen_file_is_told_as_owner(blank_report: Report) -> None:
    stolen = Flag(FlagCode.ISSUED_TO_OTHER, message("Empty."))
    own = named(blank_report, "a.xlsx", "s01", "same")
    thief = replace(named(blank_report, "b.xlsx", "s02", "same"), flags=(stolen,))
    first, second = marked([own, thief])
    assert first.flags[-1].code is FlagCode.COPIED_FROM
    assert "s02" in str(first.flags[-1].message)
    assert second.flags[-1].code is FlagCode.SAME_BYTES


def test_files_of_nobody_and_files_that_could_not_be_read_are_no_doubles(
    blank_report: Report,
) -> None:
    students = ("", "", "s01", "s02")
    reports = [named(blank_report, f"{n}.xlsx", one, "") for n, one in enumerate(students)]
    assert codes(reports) == [[]] * 4


def test_flags_that_were_there_stay(blank_report: Report) -> None:
    reports = [named(blank_report, f"{n}.xlsx", "s01", "") for n in range(2)]
    assert isinstance(blank_report.flags[0], Flag)
    assert all(one.flags[0] == blank_report.flags[0] for one in marked(reports))


def test_of_a_hundred_files_each_names_a_few_others(blank_report: Report) -> None:
    many = [named(blank_report, f"{n}.xlsx", "s1", str(n)) for n in range(100)]
    flag = marked(many)[50].flags[-1]
    assert flag.message.values["files"] == "0.xlsx, 1.xlsx, 2.xlsx, 3.xlsx, 4.xlsx, … (+94)"
