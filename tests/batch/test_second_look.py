"""A work whose formulas store no results is computed by LibreOffice, or judged by nobody."""

import io
import re
import subprocess
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from openpyxl import load_workbook

from gripcourse.batch.context import GradingContext
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.batch.run import grade_files, is_found_out
from gripcourse.batch.second_look import MadeByOffice, made_by_office, needs_second_look
from gripcourse.course.quantity import Kind
from gripcourse.grading.model import FlagCode
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


def forged(data: bytes) -> bytes:
    """Store a seven beside every formula, whatever it comes to."""
    stream = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as source, zipfile.ZipFile(stream, "w") as target:
        for name in source.namelist():
            part = source.read(name)
            target.writestr(name, re.sub(rb"(</f>)<v ?/?>(</v>)?", rb"\1<v>7</v>", part))
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
    lying = tmp_path / "s03.xlsx"
    lying.write_bytes(forged(linked(context, plan, "s03")))
    asked = replace(context, office=office, recalculate=True)
    *graded, forger = grade_files([path, other, lying], asked, 1)
    [flag] = [one for one in forger.report.flags if one.code is FlagCode.RESULTS_DIFFER]
    assert "7 → " in str(flag.message)
    assert not forger.report.unverified
    assert forger.report.score < forger.report.max_score / 2
    assert [one.report.file for one in graded] == [str(path), str(other)]
    for one in graded:
        assert FlagCode.RESULTS_DIFFER not in {flag.code for flag in one.report.flags}
        assert one.report.judged
        assert one.report.score == one.report.max_score > 0
    said = [str(one.report.remarks) for one in graded]
    assert "LibreOffice computed" in said[0]
    assert "converted" in said[1]


def test_a_work_that_cannot_be_recalculated_is_flagged_where_somebody_asked(
    context: GradingContext, plan: Plan, tmp_path: Path
) -> None:
    path = tmp_path / "s01.xlsx"
    path.write_bytes(forged(linked(context, plan, "s01")))
    codes = []
    for recalculate in (False, True):
        asked = replace(context, office="true", recalculate=recalculate)
        (one,) = grade_files([path], asked, 1)
        codes.append({flag.code for flag in one.report.flags})
    assert codes[1] - codes[0] == {FlagCode.NOT_RECALCULATED}


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
    files = {0: tmp_path / "a.xls"}
    assert needs_second_look(old, recalculate=True)
    assert not needs_second_look(damaged, recalculate=True)
    assert made_by_office(files, {0: old}, "true", "ru") == MadeByOffice({}, frozenset())


def test_what_libreoffice_gave_up_is_not_tried_again(
    context: GradingContext, plan: Plan, tmp_path: Path
) -> None:
    path, tried = tmp_path / "s01.xlsx", tmp_path / "tried"
    path.write_bytes(linked(context, plan, "s01"))
    office = tmp_path / "office"
    office.write_text(f"#!/bin/sh\necho >>{tried}\n", encoding="utf-8")
    office.chmod(0o755)
    asked = replace(context, office=str(office))
    kept = KeptReports(tmp_path / "kept", {})
    first, again = (grade_files([path], asked, 1, kept=kept)[0] for _ in range(2))
    assert tried.read_text(encoding="utf-8") == "\n"
    assert (first.taken_over, again.taken_over) == (False, True)
    assert again.report.unopened
    assert is_found_out(again.report, asked, 1)
    assert again.report.flags == first.report.flags
