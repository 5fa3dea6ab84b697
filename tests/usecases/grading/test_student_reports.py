"""A report that cannot be laid out is an incident of its student, never a lost batch."""

import csv
import importlib
import io
from collections.abc import Callable, Iterator
from dataclasses import replace
from datetime import date
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

import pytest
from pypdf import PdfReader

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.cli.grading_text import grading_text, problems_text
from gripcourse.grading.model import Report
from gripcourse.text.words import Words
from gripcourse.usecases.grading.grade import GradingOutcome, write_results
from gripcourse.usecases.grading.student_reports import LayOut, Printing, write_reports
from gripcourse.variants.model import Student

if TYPE_CHECKING:
    from support.classroom import Classroom

GRADED_ON = date(2026, 12, 2)
COHORT = "gripcourse.usecases.grading.cohort_print.cohort_pdf"
# What goes wrong with whose report, in one batch: the others have theirs, whatever it is.
FATES = {"s02": "refused", "s05": "died", "s06": "exhausted"}
LUCKY = {"s01", "s03", "s04"}


@pytest.fixture(scope="module")
def fake() -> Iterator[ModuleType]:
    """What goes wrong in another process, which gets this path too."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(Path(__file__).parent))
        yield importlib.import_module("fake_documents")


@pytest.fixture(scope="module")
def small(issued: "Classroom") -> "Classroom":
    return issued.with_its_scheme()


@pytest.fixture(scope="module")
def reports(issued: "Classroom") -> list[Report]:
    """One report each, none of them with a finding: what is in a report is no matter here."""
    return [
        Report(
            file=f"inbox/{entry.student.id}.xlsx",
            student=entry.student.id,
            name=entry.student.name,
            variant=entry.variant.id,
            scheme=entry.variant.scheme,
            options=entry.variant.options,
            language=entry.student.language,
            score=10.0,
            max_score=100.0,
            open_points=0.0,
            flags=(),
            findings=(),
            remarks=(),
            judged=True,
            digest="",
        )
        for entry in issued.register.values()
    ]


def results(
    reports: list[Report], context: GradingContext, out: Path, lay_out: LayOut, workers: int = 0
) -> GradingOutcome:
    graded = [Graded(report, "") for report in reports]
    return write_results(graded, context, out, GRADED_ON, workers, lambda _: None, lay_out=lay_out)


def names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


@pytest.fixture(scope="module")
def batch(
    fake: ModuleType,
    reports: list[Report],
    small: "Classroom",
    tmp_path_factory: pytest.TempPathFactory,
) -> tuple[GradingOutcome, Path]:
    """Six students' results, three of whom have reports that cannot be laid out."""
    out = tmp_path_factory.mktemp("results")
    more = [
        replace(reports[-1], student=name, file=f"inbox/{name}.xlsx")
        for name in ("s04", "s05", "s06")
    ]
    return results([*reports, *more], small.context, out, fake.meet_their_fates, 1), out


def test_the_others_have_their_reports_whole_and_nothing_else_is_left(
    fake: ModuleType, batch: tuple[GradingOutcome, Path]
) -> None:
    outcome, out = batch
    whole = {f"{student}.pdf" for student in LUCKY}
    assert names(out / "reports") == whole
    assert {path.read_bytes() for path in (out / "reports").iterdir()} == {fake.PAGE}
    assert {path.name for path in outcome.written.values()} == whole
    summaries = {"reports", "cohort.pdf", "files.csv", "grades.csv", "grades.json"}
    assert names(out) == summaries | {"incidents.log"}


def test_the_incident_is_named_wherever_somebody_may_look(
    fake: ModuleType, batch: tuple[GradingOutcome, Path]
) -> None:
    outcome, out = batch
    assert outcome.needs_person
    by_student = {one.student: [flag.code for flag in one.flags] for one in outcome.reports}
    assert by_student == {
        student: [] if student in LUCKY else ["report_incident"] for student in {*LUCKY, *FATES}
    }
    log = (out / "incidents.log").read_text(encoding="utf-8")
    summary = grading_text(outcome, out, Words("en"))
    assert str(out / "incidents.log") in summary
    for student, number in incidents(outcome).items():
        assert f"incident {number}: report of inbox/{student}.xlsx" in log
        assert f"could not be laid out (incident {number})" in summary
    for said in (fake.REFUSED, "MemoryError", "died"):
        assert said in log
    assert "Nothing handed in" not in summary
    absent = tuple(Student(f"s{number}", f"Name {number}", "", "", "", "") for number in range(12))
    summary = grading_text(replace(outcome, missing=absent), out, Words("en"))
    assert "Nothing handed in (12): Name 0, Name 1," in summary
    assert "Name 9, …" in summary
    namesakes = [replace(one, name="Ivan Ivanov") for one in absent[:2]]
    alone = replace(absent[2], name=outcome.reports[0].name)
    summary = grading_text(replace(outcome, missing=(*namesakes, alone)), out, Words("en"))
    who = f"Ivan Ivanov (s0), Ivan Ivanov (s1), {outcome.reports[0].name} (s2)."
    assert f"Nothing handed in (3): {who}" in summary
    places = [f"{name}/РГР 1/Version 1/a.xlsx" for name in ("Anna", "Boris")]
    alike = [replace(outcome.reports[0], file=place, flags=()) for place in places]
    summary = grading_text(replace(outcome, reports=alike), out, Words("en"))
    assert all(name in summary for name in ("Anna/", "Boris/"))
    table = (out / "grades.csv").read_text(encoding="utf-8-sig")
    flags = {row["student"]: row["flags"] for row in csv.DictReader(io.StringIO(table))}
    assert {flags[student] for student in FATES} == {"report_incident"}


def incidents(outcome: GradingOutcome) -> dict[str, str]:
    """Return the number of the incident of each student who has one."""
    return {
        one.student: str(flag.message.values["number"])
        for one in outcome.reports
        for flag in one.flags
    }


def test_the_report_on_the_batch_names_the_incidents(batch: tuple[GradingOutcome, Path]) -> None:
    outcome, out = batch
    pages = PdfReader(out / "cohort.pdf").pages
    text = "".join(page.extract_text() for page in pages)
    assert [number for number in incidents(outcome).values() if number not in text] == []


@pytest.mark.parametrize("way", ["hang_at_s02", "hang_deaf_at_s02"])
def test_a_report_that_takes_too_long_is_stopped(
    fake: ModuleType, reports: list[Report], small: "Classroom", tmp_path: Path, way: str
) -> None:
    printing = Printing(small.course, small.policy, GRADED_ON, seconds=2)
    done: list[Path] = []
    outcomes = write_reports(reports, printing, tmp_path, 1, done.append, getattr(fake, way))
    assert [isinstance(one, Path) for one in outcomes] == [
        report.student != "s02" for report in reports
    ]
    assert names(tmp_path) == {"s01.pdf", "s03.pdf"}
    assert sorted(done) == sorted(Path(report.file) for report in reports)


def test_a_report_of_an_earlier_run_does_not_stand_for_one_that_failed(
    fake: ModuleType,
    reports: list[Report],
    issued: "Classroom",
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(COHORT, fake.cohort_page)
    old = tmp_path / "reports" / "s02.pdf"
    old.parent.mkdir()
    old.write_bytes(b"%PDF of another mark")
    results(reports, issued.context, tmp_path, fake.refuse_s02)
    assert not old.exists()


def test_grades_are_written_though_the_report_on_the_batch_fails(
    fake: ModuleType, reports: list[Report], issued: "Classroom", tmp_path: Path
) -> None:
    root = tmp_path / "broken"
    (root / "templates").mkdir(parents=True)
    (root / "templates" / "cohort.html.j2").write_text("{{ 1 / 0 }}", encoding="utf-8")
    context = replace(issued.context, course=replace(issued.course, root=root))
    plain = [one for one in reports if one.student != "s02"]
    outcome = results(plain, context, tmp_path / "out", fake.refuse_s02)
    assert outcome.cohort is None
    assert outcome.needs_person
    tables = {"files.csv", "grades.csv", "grades.json"}
    assert names(tmp_path / "out") == tables | {"reports", "incidents.log"}
    said = grading_text(outcome, tmp_path / "out", Words("en"))
    assert "could not be laid out. templates/cohort.html.j2: line 1" in said


def test_who_asks_for_silence_still_learns_what_failed_and_what_waits(
    fake: ModuleType, reports: list[Report], issued: "Classroom", tmp_path: Path
) -> None:
    outcome = results(reports, issued.context, tmp_path, fake.refuse_s02)
    failed, waits, trace = problems_text(outcome, tmp_path, Words("en")).splitlines()
    assert "could not be laid out" in failed
    assert "wait for a person: 1." in waits
    assert "incidents.log" in trace


def test_a_student_whose_scheme_is_gone_has_an_incident(
    reports: list[Report], issued: "Classroom", tmp_path: Path
) -> None:
    """With the real layout: what it makes of an option that does not exist."""
    broken = [replace(one, options={"drive": "steam"}) for one in reports if one.student == "s02"]
    printing = Printing(issued.course, issued.policy, GRADED_ON)
    (lost,) = write_reports(broken, printing, tmp_path, 1, lambda _: None)
    assert "steam" in getattr(lost, "trace", "")


def test_a_killed_issue_of_one_student_is_named_and_leaves_nothing_half(
    fake: ModuleType, classroom: "Classroom"
) -> None:
    issue: Callable[..., object] = fake.issue_and_die_at_s02
    issuing = classroom.with_its_scheme().issue(issue_one=issue)
    by_student = {one.student: one for one in issuing.handouts}
    assert [bool(one.faults) for one in by_student.values()] == [False, True, False]
    assert "s02" in str(by_student["s02"].faults[0])
    made = {str(path.relative_to(classroom.order.out)) for path in classroom.order.out.rglob("*.*")}
    assert made == {
        f"{student}/{name}"
        for student in ("s01", "s03")
        for name in (f"assignment_{student}.pdf", f"{student}.xlsx")
    }
