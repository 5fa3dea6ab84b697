"""Files that could not be judged are no zeros."""

from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.model import Report
from gripcourse.grading.unjudged import (
    incident_report,
    rejected_report,
    unknown_student_report,
    unreadable_report,
)
from gripcourse.submission.model import Rejected
from gripcourse.text.words import message

if TYPE_CHECKING:
    from conftest import Case

REASON = message("The file is empty: it has no bytes.")


def reports(case: "Case") -> list[Report]:
    return [
        rejected_report(Rejected("inbox/s01.xlsx", "d" * 64, REASON), case.issued),
        rejected_report(Rejected("inbox/x.xlsx", "d" * 64, REASON), None),
        unknown_student_report("inbox/x.xlsx", "s99", "d" * 64),
        incident_report("inbox/s01.xlsx", "0badf00d", case.issued),
    ]


def test_nothing_is_marked_and_a_flag_says_why(hydraulic: "Case") -> None:
    for report in reports(hydraulic):
        assert not report.judged
        assert report.findings == ()
        assert report.max_score == 0
        assert len(report.flags) == 1


def test_each_reason_has_its_flag(hydraulic: "Case") -> None:
    codes = [report.flags[0].code for report in reports(hydraulic)]
    assert codes == ["rejected", "rejected", "unknown_student", "incident"]


def test_the_student_is_named_where_the_path_names_one(hydraulic: "Case") -> None:
    students = [report.student for report in reports(hydraulic)]
    assert students == ["s01", "", "", "s01"]


def test_a_rejected_file_says_its_reason_and_keeps_its_digest(hydraulic: "Case") -> None:
    report = reports(hydraulic)[0]
    assert report.flags[0].message == REASON
    assert report.digest == "d" * 64


def test_the_student_is_told_what_only_the_student_can_mend(hydraulic: "Case") -> None:
    rejected, _, unknown, incident = reports(hydraulic)
    assert rejected.remarks == (REASON,)
    assert (unknown.remarks, incident.remarks) == ((), ())


def test_an_incident_has_its_number(hydraulic: "Case") -> None:
    assert "0badf00d" in str(reports(hydraulic)[3].flags[0].message)


@pytest.mark.parametrize(
    ("student", "said"),
    [
        ("s99", "The register has no student 's99'."),
        ("", "Neither the file's name nor the workbook says whose it is."),
    ],
)
def test_an_unknown_student_and_an_unnamed_one_are_told_apart(student: str, said: str) -> None:
    report = unknown_student_report("inbox/x.xlsx", student, "")
    assert str(report.flags[0].message) == said


def test_each_reason_why_cells_cannot_be_read_names_the_cells(hydraulic: "Case") -> None:
    names = list(hydraulic.answers)[:4]
    read = hydraulic.submission(dict.fromkeys(names, "?"))
    cells = ("1. Схема!E11", "2. Привод!E7", "1. Схема!E8", "2. Привод!E9")
    unread = {
        name: replace(read.answers[name], cell=cell)
        for name, cell in zip(names, cells, strict=True)
    }
    unread[names[3]] = replace(unread[names[3]], remarks=(message("One number, please."),))
    report = unreadable_report(replace(read, answers=unread), hydraulic.issued)
    assert [str(one) for one in report.remarks[1:]] == [
        "1. Схема!E8, E11; 2. Привод!E7: A number is needed here.",
        "2. Привод!E9: One number, please.",
    ]


def test_of_many_cells_that_cannot_be_read_the_first_ones_are_named(hydraulic: "Case") -> None:
    unread = hydraulic.submission(dict.fromkeys(hydraulic.answers, "?"))
    (said,) = unreadable_report(unread, hydraulic.issued).remarks[1:]
    assert str(said).count(", ") == 12
    assert ", …: " in str(said)
