"""A work whose formulas store no results is computed by LibreOffice, or judged by nobody."""

import io
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest
from openpyxl import load_workbook

from gripcourse.batch.one_file import GradingContext
from gripcourse.batch.run import grade_files
from gripcourse.batch.second_look import made_by_office
from gripcourse.course.quantity import Kind
from gripcourse.grading.unjudged import rejected_report
from gripcourse.machine.office import office_command
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Rejected, WhyRefused
from gripcourse.text.words import Words
from gripcourse.workbook.write import answer_workbook


def linked(context: GradingContext, plan: Plan, student: str) -> bytes:
    """Fill in right answers as formulas; the library that saves them stores no results."""
    issued = context.register[student]
    book = load_workbook(
        io.BytesIO(answer_workbook(plan, issued, context.course, Words("ru"))), keep_links=False
    )
    values = solve_variant(plan, issued.variant.given)
    for one in plan.answered:
        [(sheet, address)] = book.defined_names[f"answer.{one.id}"].destinations
        right = values[one.id]
        typed = '"да"' if right else '"нет"'
        book[sheet][address.replace("$", "")].value = (
            f"={typed}" if one.kind is Kind.VERDICT else f"=2*{right!r}/2"
        )
    stream = io.BytesIO()
    book.save(stream)
    return stream.getvalue()


@pytest.mark.office
def test_what_stores_no_results_or_has_another_format_is_computed_and_judged(
    context: GradingContext, plan: Plan, tmp_path: Path
) -> None:
    path, other = tmp_path / "s01.xlsx", tmp_path / "s02.ods"
    path.write_bytes(linked(context, plan, "s01"))
    other.with_suffix(".xlsx").write_bytes(linked(context, plan, "s02"))
    office = office_command()
    assert office is not None
    profile = (tmp_path / "profile").as_uri()
    command = [office, f"-env:UserInstallation={profile}", "--headless", "--convert-to", "ods"]
    subprocess.run(  # noqa: S603 (a found program)
        [*command, "--outdir", str(tmp_path), str(other.with_suffix(".xlsx"))],
        check=True,
        capture_output=True,
        timeout=120,
    )
    graded = grade_files([path, other], replace(context, office=office), 1)
    assert [one.report.file for one in graded] == [str(path), str(other)]
    for one in graded:
        assert one.report.judged
        assert one.report.score == one.report.max_score > 0
    said = [str(one.report.remarks) for one in graded]
    assert "LibreOffice computed" in said[0]
    assert "converted" in said[1]


def test_without_it_nobody_judges_them(context: GradingContext, plan: Plan, tmp_path: Path) -> None:
    path = tmp_path / "s01.xlsx"
    path.write_bytes(linked(context, plan, "s01"))
    (alone,) = grade_files([path], context, 0)
    assert alone.report.lacks_results
    assert not alone.report.judged
    assert alone.report.max_score == 0


def test_without_the_program_and_for_other_files_nothing_is_made(tmp_path: Path) -> None:
    old = rejected_report(Rejected.because("a.xls", "", WhyRefused.OLD_FORMAT), None)
    damaged = rejected_report(Rejected.because("a.xlsx", "", WhyRefused.DAMAGED), None)
    files = [tmp_path / "a.xls", tmp_path / "b.xlsx"]
    assert made_by_office(files, [old, damaged], None, "ru") == {}
    assert made_by_office(files, [old, damaged], "true", "ru") == {}
