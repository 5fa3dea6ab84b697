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

from gripcourse.batch.one_file import GradingContext
from gripcourse.course.quantity import Kind
from gripcourse.demo.students import blank, correct
from gripcourse.errors import UsageError
from gripcourse.exports.report_result import GradesResult
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.usecases.grade import GradingOutcome, find_files, grade, json_text, write_results
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom


GRADED_ON = date(2026, 12, 2)


def nothing(_: Path) -> None:
    """Show no progress."""


def run(
    context: GradingContext, paths: Sequence[Path], out: Path, workers: int = 2
) -> GradingOutcome:
    files = find_files(paths)
    return write_results(
        grade(files, context, workers, nothing), context, out, GRADED_ON, workers, nothing
    )


@pytest.fixture(scope="module")
def inbox(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A right workbook, one with an early slip, a copied one; and what people hand in beside."""
    folder = tmp_path_factory.mktemp("inbox")
    issued.hand_in("s01", correct, folder / "s01.xlsx")
    platform = folder / "Шевченко Оксана_s02_assignsubmission_file"
    issued.hand_in("s02", forget_one_jaw, platform / "ответы.xlsx")
    shutil.copy(folder / "s01.xlsx", folder / "s03.xlsx")
    (folder / "чертёж.pdf").write_bytes(b"%PDF-1.7")
    (folder / "~$s01.xlsx").write_bytes(b"lock")
    (folder / ".hidden.xlsx").write_bytes(b"")
    return folder


@pytest.fixture(scope="module")
def rough_inbox(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A text, an empty file, a student's two files, a folder called like a workbook."""
    folder = tmp_path_factory.mktemp("rough")
    issued.hand_in("s01", correct, folder / "s01.xlsx")
    issued.hand_in("s02", correct, folder / "s02.xlsx")
    (folder / "s02_исправлено.xlsx").write_bytes(b"")
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
    return run(context, [rough_inbox], out, workers=1), out


@pytest.fixture(scope="module")
def graded(issued: "Classroom", inbox: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("graded")
    run(issued.context, [inbox], out)
    return out


def grades(out: Path) -> dict[str, dict[str, str]]:
    text = (out / "grades.csv").read_text(encoding="utf-8-sig")
    return {row["student"]: row for row in csv.DictReader(io.StringIO(text))}


class TestFindFiles:
    def test_workbooks_of_a_folder_are_found_and_nothing_else(self, inbox: Path) -> None:
        names = [str(path.relative_to(inbox)) for path in find_files([inbox])]
        platform = "Шевченко Оксана_s02_assignsubmission_file/ответы.xlsx"
        assert names == ["s01.xlsx", "s03.xlsx", platform]

    def test_a_folder_called_like_a_workbook_is_a_folder(self, rough_inbox: Path) -> None:
        names = [path.name for path in find_files([rough_inbox / "каталог.xlsx"])]
        assert names == ["s03.xlsx"]

    def test_a_file_named_twice_is_graded_once(self, inbox: Path) -> None:
        assert len(find_files([inbox / "s01.xlsx", inbox, inbox / "s01.xlsx"])) == 3

    def test_a_file_that_is_named_is_taken_whatever_its_suffix(self, inbox: Path) -> None:
        assert find_files([inbox / "чертёж.pdf"]) == [inbox / "чертёж.pdf"]

    def test_all_paths_that_are_not_there_are_named_at_once(self, tmp_path: Path) -> None:
        with pytest.raises(UsageError) as caught:
            find_files([tmp_path / "a.xlsx", tmp_path / "b"])
        assert [problem.file for problem in caught.value.problems] == [
            str(tmp_path / "a.xlsx"),
            str(tmp_path / "b"),
        ]

    def test_a_folder_without_workbooks_is_refused(self, tmp_path: Path) -> None:
        (tmp_path / "заметки.txt").write_text("…", encoding="utf-8")
        with pytest.raises(UsageError, match="no workbook"):
            find_files([tmp_path])


class TestResults:
    def test_everybody_has_a_report_and_the_batch_its_summaries(self, graded: Path) -> None:
        made = {str(path.relative_to(graded)) for path in graded.rglob("*") if path.is_file()}
        assert made == {
            "grades.csv",
            "grades.json",
            "cohort.pdf",
            "reports/s01.pdf",
            "reports/s02.pdf",
            "reports/s03.pdf",
        }

    def test_each_student_gets_what_the_answers_are_worth(self, graded: Path) -> None:
        rows = grades(graded)
        assert float(rows["s01"]["percent"]) == 100
        assert 80 < float(rows["s02"]["percent"]) < 100
        assert float(rows["s03"]["percent"]) < 50
        assert rows["s03"]["flags"] == "issued_to_other; same_bytes; other_variant; same_answers"
        assert rows["s01"]["flags"] == "same_bytes"
        assert rows["s02"]["group"] == "РТК-41"

    def test_grading_again_gives_the_same_bytes(
        self, issued: "Classroom", inbox: Path, graded: Path, tmp_path: Path
    ) -> None:
        run(issued.context, [inbox], tmp_path, workers=1)
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
            "s02_исправлено.xlsx": False,
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
        assert names["s02_исправлено.xlsx"] == "s02-2.pdf"

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
        assert [one["student"] for one in files] == ["s01", "s03", "s02"]
        for one in files:
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
        graded = grade([rough_inbox / "текст.xlsx"], issued.context, 1, nothing)
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
        (graded,) = grade([slip], issued.context, 1, nothing)
        quantity = issued.plan("s02").quantities["grip_force"]
        hint = next(one.hint for one in quantity.slips if one.id == "one_jaw_only")
        for language in LANGUAGES:
            (one,) = json.loads(json_text([graded.report], Words(language)))["reports"]
            findings = {each["quantity"]: each for each in one["findings"]}
            assert hint.of(language) in findings["grip_force"]["message"]
