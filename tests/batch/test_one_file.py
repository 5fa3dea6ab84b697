"""One file, whatever it is: a report, never an exception."""

import io
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.batch.one_file import grade_file, judge_read
from gripcourse.grading.model import KnownBy, Outcome
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.submission.model import Identity
from gripcourse.submission.raw import RawCell, RawWorkbook
from gripcourse.text.words import Words
from gripcourse.workbook.write import answer_workbook


def archive() -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as made:
        made.writestr("чертёж.txt", "no workbook")
    return stream.getvalue()


PROTECTED = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + "EncryptedPackage".encode("utf-16-le")

BAD_FILES = {
    "empty": b"",
    "text": "масса 60 кг; G = 900 Н\n".encode(),
    "cp1251 text": "масса;60\n".encode("cp1251"),
    "zip": archive(),
    "half a zip": archive()[:40],
    "password": PROTECTED,
    "pdf": b"%PDF-1.7\n",
}


@pytest.mark.parametrize("content", BAD_FILES.values(), ids=list(BAD_FILES))
def test_a_file_that_is_no_workbook_is_rejected_with_a_reason_for_its_student(
    context: GradingContext, tmp_path: Path, content: bytes
) -> None:
    file = tmp_path / "s01.xlsx"
    file.write_bytes(content)
    report = grade_file(file, context)
    assert [flag.code for flag in report.flags] == ["rejected"]
    assert report.student == "s01"
    assert not report.judged
    assert str(report.flags[0].message)


def test_a_protected_workbook_is_told_from_other_files(
    context: GradingContext, tmp_path: Path
) -> None:
    file = tmp_path / "s01.xlsx"
    file.write_bytes(PROTECTED)
    assert "password" in str(grade_file(file, context).flags[0].message)


@pytest.fixture(scope="module")
def issued_workbook(context: GradingContext, plan: Plan) -> bytes:
    return answer_workbook(plan, context.register["s02"], context.course, Words("ru"))


def test_an_untouched_workbook_is_blank_and_belongs_to_its_student(
    context: GradingContext, tmp_path: Path, issued_workbook: bytes
) -> None:
    file = tmp_path / "ответы.xlsx"
    file.write_bytes(issued_workbook)
    report = grade_file(file, context)
    assert report.student == "s02"
    assert report.flags == ()
    assert {one.outcome for one in report.findings} == {Outcome.BLANK, Outcome.MANUAL}


def test_a_workbook_of_formulas_without_stored_results_is_not_judged(
    context: GradingContext, plan: Plan
) -> None:
    issued = context.register["s02"]
    cell = RawCell(None, "General", error=False, formula="=1+1", cell="A1")
    answers = {one.id: cell for one in plan.answered}
    identity = Identity("s02", issued.variant.id, plan.scheme.id, plan.options, issued.signature)
    raw = RawWorkbook("s02.xlsx", "", identity, "", {}, answers, ())
    report = judge_read(raw, issued, context)
    assert [flag.code for flag in report.flags] == ["unreadable"]
    assert not report.judged
    assert "cannot be read" in str(report.remarks[0])
    some = dict(list(answers.items())[: len(answers) // 11])
    number = replace(cell, value=1.0, formula="")
    assert judge_read(
        replace(raw, answers=dict.fromkeys(answers, number) | some), issued, context
    ).judged
    assert not judge_read(replace(raw, answers=some), issued, context).judged


def test_a_workbook_handed_in_under_another_s_name_goes_to_a_person(
    context: GradingContext, tmp_path: Path, issued_workbook: bytes
) -> None:
    file = tmp_path / "s05.xlsx"
    file.write_bytes(issued_workbook)
    report = grade_file(file, context)
    assert (report.student, report.judged) == ("", False)
    assert [flag.code for flag in report.flags] == ["who_handed_in"]


def test_what_a_person_says_of_a_file_goes_before_everything(
    context: GradingContext, tmp_path: Path, issued_workbook: bytes
) -> None:
    file = tmp_path / "s07.xlsx"
    file.write_bytes(issued_workbook)
    decided = replace(context, whose={str(file): "s05"})
    report = grade_file(file, decided)
    assert (report.student, report.judged) == ("s05", True)
    assert report.known_by is KnownBy.PERSON
    assert [flag.code for flag in report.flags] == ["issued_to_other"]


def test_a_workbook_of_nobody_on_the_register_waits_for_a_person(
    context: GradingContext, tmp_path: Path, issued_workbook: bytes
) -> None:
    file = tmp_path / "ответы.xlsx"
    file.write_bytes(issued_workbook)
    others = {name: one for name, one in context.register.items() if name != "s02"}
    report = grade_file(file, GradingContext(context.course, context.policy, others))
    assert [flag.code for flag in report.flags] == ["unknown_student"]
    assert not report.judged


def test_the_plan_is_of_the_issued_variant_whatever_the_workbook_says(
    context: GradingContext, plan: Plan, tmp_path: Path
) -> None:
    pneumatic = make_plan(context.course, plan.scheme.id, {**plan.options, "drive": "pneumatic"})
    file = tmp_path / "s02.xlsx"
    file.write_bytes(
        answer_workbook(pneumatic, context.register["s02"], context.course, Words("ru"))
    )
    assert grade_file(file, context).options == plan.options
