"""Grading a batch: reports, grades and what a person must look at."""

import csv
import io
import json
import shutil
from collections.abc import Sequence
from dataclasses import replace
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.cli.demo.students import blank, correct
from gripcourse.course.quantity import Kind
from gripcourse.exports.report_result import GradesResult
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.usecases.grading.batch_tables import json_text
from gripcourse.usecases.grading.collect import collect
from gripcourse.usecases.grading.grade import GradingOutcome, grade, write_results
from support.classroom import forget_one_jaw
from support.pages import no_pages, not_laid_out

if TYPE_CHECKING:
    from support.classroom import Classroom


GRADED_ON = date(2026, 12, 2)


def nothing(_: Path) -> None:
    """Show no progress."""


def run(
    context: GradingContext, paths: Sequence[Path], out: Path, workers: int = 0
) -> GradingOutcome:
    found = collect(paths)
    return write_results(
        grade(found.files, context, workers, nothing),
        context,
        out,
        GRADED_ON,
        0,
        nothing,
        passed_over=found.passed_over,
    )


@pytest.fixture(scope="module")
def inbox(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A right workbook, one with an early slip, a stranger's; and what people hand in beside."""
    folder = tmp_path_factory.mktemp("inbox")
    issued.hand_in("s01", correct, folder / "s01.xlsx")
    platform = folder / "Шевченко Оксана_s02_assignsubmission_file"
    issued.hand_in("s02", forget_one_jaw, platform / "ответы.xlsx")
    shutil.copy(folder / "s01.xlsx", folder / "s03.xlsx")
    (folder / "чертёж.pdf").write_bytes(b"%PDF-1.7")
    (folder / "~$s01.xlsx").write_bytes(b"lock")
    (folder / ".hidden.xlsx").write_bytes(b"")
    (folder / "работа.zip").write_bytes(b"PK")
    return folder


@pytest.fixture(scope="module")
def rough_inbox(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A text, an empty file, a student's two files, a folder called like a workbook."""
    folder = tmp_path_factory.mktemp("rough")
    issued.hand_in("s01", correct, folder / "s01.xlsx")
    issued.hand_in("s02", correct, folder / "s02.xlsx")
    later = folder / "Шевченко Оксана_s02_assignsubmission_file"
    later.mkdir()
    (later / "исправлено.xlsx").write_bytes(b"")
    (folder / "текст.xlsx").write_text("F = 3900 Н", encoding="utf-8")
    directory = folder / "каталог.xlsx"
    directory.mkdir()
    issued.hand_in("s03", blank, directory / "s03.xlsx")
    return folder


@pytest.fixture(scope="module")
def rough(
    issued: "Classroom", rough_inbox: Path, tmp_path_factory: pytest.TempPathFactory
) -> tuple[GradingOutcome, Path]:
    """Graded by a register that knows a scheme for s01 that the course has no longer."""
    out = tmp_path_factory.mktemp("rough_graded")
    entry = issued.register["s01"]
    lost = replace(entry, variant=replace(entry.variant, scheme="four_bar"))
    context = replace(issued.context, register={**issued.register, "s01": lost})
    with no_pages():
        return run(context, [rough_inbox], out), out


@pytest.fixture(scope="module")
def graded(issued: "Classroom", inbox: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("graded")
    with not_laid_out():
        run(issued.context, [inbox], out, workers=1)
    return out


def grades(out: Path) -> dict[str, dict[str, str]]:
    text = (out / "grades.csv").read_text(encoding="utf-8-sig")
    return {row["student"]: row for row in csv.DictReader(io.StringIO(text))}


class TestResults:
    def test_everybody_has_a_report_and_the_batch_its_summaries(self, graded: Path) -> None:
        made = {str(path.relative_to(graded)) for path in graded.rglob("*") if path.is_file()}
        assert made == {
            "files.csv",
            "grades.csv",
            "grades.json",
            "cohort.pdf",
            "reports/s01.pdf",
            "reports/s02.pdf",
        }

    def test_each_student_gets_what_the_answers_are_worth(self, graded: Path) -> None:
        rows = grades(graded)
        assert float(rows["s01"]["percent"]) == 100
        assert 80 < float(rows["s02"]["percent"]) < 100
        assert rows["s01"]["flags"] == ""
        assert rows["s02"]["group"] == "РТК-41"

    def test_a_stranger_s_file_changes_nobody_s_mark_and_does_not_vanish(
        self, graded: Path
    ) -> None:
        rows = grades(graded)
        assert (rows["s03"]["score"], rows["s03"]["flags"]) == ("", "not_handed_in")
        assert Path(rows[""]["file"]).name == "s03.xlsx"
        assert rows[""]["score"] == ""
        assert rows[""]["flags"] == "who_handed_in; same_bytes"

    def test_every_file_that_was_found_is_accounted_for(self, graded: Path) -> None:
        text = (graded / "files.csv").read_text(encoding="utf-8-sig")
        table = list(csv.DictReader(io.StringIO(text)))
        fates = {Path(row["file"]).name: (row["fate"], row["why"]) for row in table}
        assert fates == {
            "s01.xlsx": ("graded", ""),
            "s03.xlsx": ("to_a_person", "who_handed_in"),
            "ответы.xlsx": ("graded", ""),
            ".hidden.xlsx": ("not_looked_at", "hidden"),
            "чертёж.pdf": ("not_looked_at", "other"),
            "работа.zip": ("not_looked_at", "archive"),
            "~$s01.xlsx": ("not_looked_at", "lock_file"),
        }
        plain = json.loads((graded / "grades.json").read_text(encoding="utf-8"))
        assert [one["file"] for one in plain["files"]] == [row["file"] for row in table]
        assert all(row["message"] for row in table if row["fate"] != "graded")

    def test_reports_that_a_run_did_not_renew_are_named_and_stay(
        self, issued: "Classroom", inbox: Path, tmp_path: Path
    ) -> None:
        old = tmp_path / "reports" / "s09.pdf"
        old.parent.mkdir()
        old.write_bytes(b"%PDF-")
        with no_pages():
            outcome = run(issued.context, [inbox / "s01.xlsx"], tmp_path)
        assert outcome.left_over == (old,)
        assert old.is_file()

    def test_grades_alone_print_nothing_and_are_the_same(
        self, issued: "Classroom", graded: Path, inbox: Path, tmp_path: Path
    ) -> None:
        (tmp_path / "cohort.pdf").write_bytes(b"%PDF-")
        found = collect([inbox])
        outcome = write_results(
            grade(found.files, issued.context, 0, nothing),
            issued.context,
            tmp_path,
            GRADED_ON,
            0,
            nothing,
            passed_over=found.passed_over,
            lay_out=None,
        )
        assert outcome.written == {}
        assert outcome.left_over == (tmp_path / "cohort.pdf",)
        for name in ("grades.csv", "grades.json", "files.csv"):
            assert (tmp_path / name).read_bytes() == (graded / name).read_bytes()

    def test_grading_again_gives_the_same_bytes(
        self, issued: "Classroom", inbox: Path, graded: Path, tmp_path: Path
    ) -> None:
        with not_laid_out():
            run(issued.context, [inbox], tmp_path)
        for path in sorted(graded.rglob("*.*")):
            assert (tmp_path / path.relative_to(graded)).read_bytes() == path.read_bytes(), path

    def test_files_that_cannot_be_judged_stop_nobody_and_are_no_zeros(
        self, rough: tuple[GradingOutcome, Path]
    ) -> None:
        outcome, out = rough
        judged = {Path(one.file).name: one.judged for one in outcome.reports}
        assert judged == {
            "s01.xlsx": False,
            "s02.xlsx": True,
            "исправлено.xlsx": False,
            "текст.xlsx": False,
            "s03.xlsx": True,
        }
        assert outcome.needs_person
        rows = grades(out)
        assert rows["s03"]["score"] == "0"
        assert rows["s01"]["score"] == rows["s01"]["percent"] == ""

    def test_two_files_of_a_student_get_a_report_each(
        self, rough: tuple[GradingOutcome, Path]
    ) -> None:
        outcome, _ = rough
        names = {Path(file).name: path.name for file, path in outcome.written.items()}
        assert names["s02.xlsx"] == "s02.pdf"
        assert names["исправлено.xlsx"] == "s02-2.pdf"

    def test_a_report_that_cannot_be_made_is_an_incident_of_that_student(
        self, rough: tuple[GradingOutcome, Path]
    ) -> None:
        outcome, out = rough
        first = next(one for one in outcome.reports if one.student == "s01")
        assert {flag.code for flag in first.flags} == {"incident", "report_incident"}
        assert "four_bar" in (out / "incidents.log").read_text(encoding="utf-8")
        made = {path.name for path in (out / "reports").iterdir()}
        assert made == {"s02.pdf", "s02-2.pdf", "s03.pdf"}


class TestJson:
    FILE_KEYS = ("file", "student", "variant", "score", "max_score", "flags", "findings")
    FINDING_KEYS = (
        *("quantity", "section", "outcome", "given", "reference", "expected"),
        *("points", "max_points", "message"),
    )

    def test_every_file_has_its_findings(self, graded: Path, issued: "Classroom") -> None:
        grades = json.loads((graded / "grades.json").read_text(encoding="utf-8"))
        assert GradesResult.from_dict(grades).to_dict() == grades
        files = grades["reports"]
        assert [one["student"] for one in files] == ["s01", "", "s02"]
        for one in (each for each in files if each["judged"]):
            assert set(self.FILE_KEYS) <= set(one)
            plan = issued.plan(one["student"])
            marked = {q.id for q in (*plan.answered, *plan.manual)}
            assert {finding["quantity"] for finding in one["findings"]} == marked
            for finding in one["findings"]:
                assert set(self.FINDING_KEYS) <= set(finding)

    def test_it_is_strict_json(self, graded: Path) -> None:
        def refuse(constant: str) -> None:
            raise AssertionError(constant)

        text = (graded / "grades.json").read_text(encoding="utf-8")
        assert json.loads(text, parse_constant=refuse)

    def test_values_are_in_declared_units_and_add_up(
        self, graded: Path, issued: "Classroom"
    ) -> None:
        first = json.loads((graded / "grades.json").read_text(encoding="utf-8"))["reports"][0]
        findings = {one["quantity"]: one for one in first["findings"]}
        force = findings["grip_force"]
        assert force["outcome"] == "correct"
        assert force["given"] == pytest.approx(force["reference"])
        assert force["given"] == pytest.approx(force["expected"])
        assert first["score"] == pytest.approx(
            sum(one["points"] for one in findings.values() if one["outcome"] != "manual")
        )
        manual = [q.id for q in issued.plan("s01").answered if q.kind is Kind.MANUAL]
        assert all(findings[name]["given"] is None for name in manual)

    def test_a_file_that_could_not_be_judged_has_no_score(
        self, issued: "Classroom", rough_inbox: Path
    ) -> None:
        graded = grade([rough_inbox / "текст.xlsx"], issued.context, 0, nothing)
        (one,) = json.loads(json_text([graded[0].report], Words("en")))["reports"]
        assert one["score"] is None
        assert one["max_score"] is None
        assert one["findings"] == []
        assert [flag["code"] for flag in one["flags"]] == ["rejected"]
        assert one["flags"][0]["message"]

    def test_declared_texts_are_in_the_readers_language(
        self, issued: "Classroom", inbox: Path
    ) -> None:
        slip = inbox / "Шевченко Оксана_s02_assignsubmission_file" / "ответы.xlsx"
        (graded,) = grade([slip], issued.context, 0, nothing)
        quantity = issued.plan("s02").quantities["grip_force"]
        hint = next(one.hint for one in quantity.slips if one.id == "one_jaw_only")
        for language in LANGUAGES:
            (one,) = json.loads(json_text([graded.report], Words(language)))["reports"]
            findings = {each["quantity"]: each for each in one["findings"]}
            assert hint.of(language) in findings["grip_force"]["message"]
