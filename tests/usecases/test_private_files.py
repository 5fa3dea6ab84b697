"""Names, marks and solutions are written for their owner alone, and nothing in them runs."""

import ast
import csv
import io
import json
import os
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from openpyxl import load_workbook

from gripcourse.batch.graded import Graded
from gripcourse.exports.make_report_result import grades_result
from gripcourse.exports.platforms.works import works_of
from gripcourse.gradebook.checks import CheckLedger, take_one
from gripcourse.grading.model import Report
from gripcourse.text.shown import one_line
from gripcourse.text.words import Words
from gripcourse.usecases.grading.grade import write_results
from gripcourse.usecases.grading.student_reports import Printing, write_reports
from gripcourse.usecases.issuing.printing import joined, print_sheets
from gripcourse.usecases.publishing.exporting import (
    Results,
    canvas_file,
    gradescope_file,
    moodle_files,
    moodle_questions,
    table_files,
)
from gripcourse.usecases.publishing.outbox import outbox_folders
from gripcourse.usecases.serving.links import PersonalLink, write_links
from gripcourse.variants.model import Issued
from support.reports import perfect, values, variant
from support.tables import formulas_in

if TYPE_CHECKING:
    from support.classroom import Classroom

__all__ = ["perfect", "values", "variant"]

SOURCES = Path(__file__).parents[2] / "src" / "gripcourse"
NOW = datetime(2026, 12, 2, tzinfo=UTC)
EVERYBODY = 0o077
# Who writes what everybody may read, and what that is. Anything else is private.
FOR_EVERYBODY = {
    "usecases/authoring/reference.py": "the reference of formulas",
    "usecases/authoring/atlas.py": "pictures of the schemes",
    "usecases/authoring/schema.py": "JSON Schemas",
    "usecases/solving/draw.py": "drawings of a variant, without a name",
    "usecases/solving/audit.py": "numbers of a table of variants",
    "usecases/measuring/tolerance.py": "numbers of a policy",
    "usecases/measuring/virtual.py": "mistakes of students who do not exist",
    "usecases/authoring/init.py": "a new course; its key is made elsewhere",
    "variants/table.py": "a table of variants, without names",
    "simulation/record.py": "what students did who do not exist",
    "simulation/tolerance_policy.py": "a policy",
    "cli/demo/run.py": "an empty mark of the demo",
}
TEXTS = {
    "formula": "=cmd|'/C calc'!A0",
    "second_cell": "a;=cmd|'/C calc'!A0\tb",
    "second_line": "Anna\n=1+1\r\nBcc: x@y.z\u2028Subject: z",
    "markup": '"><img src=x onerror=y></p><script>',
    "terminal": "\x00\x1b[2Jcod\u202exslx.exe",
    "long": "\u0416" * 10_000,
}


def writing_calls() -> Iterator[tuple[str, int, bool]]:
    """Yield the module and line of each call that writes a file, and whether it is private."""
    for path in sorted(SOURCES.rglob("*.py")):
        module = path.relative_to(SOURCES).as_posix()
        if module == "machine/files.py":
            continue
        source = path.read_text(encoding="utf-8")
        for node in ast.walk(ast.parse(source)) if "write_" in source else ():
            match node:
                case ast.Call(func=ast.Name(id="write_bytes" | "write_text"), keywords=keywords):
                    yield module, node.lineno, any(map(_says_private, keywords))


def _says_private(keyword: ast.keyword) -> bool:
    match keyword:
        case ast.keyword(arg="private", value=ast.Constant(value=True)):
            return True
    return False


def test_every_writer_is_private_or_named_with_what_everybody_may_read() -> None:
    calls = list(writing_calls())
    assert len(calls) > 30
    open_ones = {module for module, _, private in calls if not private}
    assert open_ones == set(FOR_EVERYBODY)


@pytest.fixture
def batch(issued: "Classroom", perfect: Report) -> Callable[[str], Results]:
    """Make the results of somebody who is called so, whose file is, and who typed it."""

    def make(text: str) -> Results:
        student = replace(issued.register["s01"].student, name=text, group=text, email=text)
        findings = tuple(replace(one, typed=text) for one in perfect.findings)
        report = replace(perfect, student="s01", name=text, file=text, findings=findings)
        words = Words("en")
        grades = grades_result([report], words)
        works, notes = works_of(grades, {"s01": student})
        return Results(issued.course, {"s01": student}, grades, Path("reports"), works, notes)

    return make


MOODLE = """\
Identifier,"Full name",Username,Status,Grade,"Maximum grade","Grade can be changed",\
"Last modified (grade)","Feedback comments"
"Participant 12",Anna,s01,Submitted,,100.00,Yes,,
"""
CANVAS = """\
Student,ID,SIS User ID,SIS Login ID,Section,Task (9876)
    Points Possible,,,,,50.00
Anna,501,s01,x,G,
"""


def exported(results: Results, folder: Path) -> None:
    """Write whatever can be made of results for a platform, a table or people."""
    source = folder.parent
    for name, text in (("moodle", MOODLE), ("canvas", CANVAS)):
        (source / f"{name}.csv").write_text(text, encoding="utf-8")
    moodle_files(results, source / "moodle.csv", folder / "moodle.csv", folder / "feedback.zip")
    canvas_file(results, source / "canvas.csv", "", folder / "canvas.csv")
    gradescope_file(results, "", folder / "results.json", published=True)
    table_files(results, folder / "tables", str(folder / "none.sqlite"))
    table_files(results, folder / "tables.xlsx", str(folder / "none.sqlite"))
    outbox_folders(results, folder / "outbox")


def linked(issued: Issued, folder: Path) -> None:
    write_links([PersonalLink(issued, "https://x/s/y/", NOW)], folder / "links.csv")


def files_below(folder: Path) -> list[Path]:
    return [path for path in sorted(folder.rglob("*")) if path.is_file()]


@pytest.fixture
def nothing_masked() -> Iterator[None]:
    """Let new files be as open as the program asks for."""
    before = os.umask(0)
    yield
    os.umask(before)


@pytest.mark.usefixtures("nothing_masked")
def test_what_has_names_or_marks_is_for_its_owner_alone(
    batch: Callable[[str], Results],
    issued: "Classroom",
    perfect: Report,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    out, reports = tmp_path / "out", tmp_path / "reports"
    printing = Printing(issued.course, issued.policy, NOW.date())
    report = replace(perfect, student="s01")
    pdf = joined([])
    write_reports([report], printing, reports, 0, lambda _: None, lambda *_: pdf)
    exported(replace(batch("Anna"), reports=reports), out)
    moodle_questions(issued.course, issued.order.table, ["001"], out / "q.xml", Words("en"))
    linked(issued.register["s01"], out)
    take_one(CheckLedger(out / "ledger", "s01"), 3)
    monkeypatch.setattr("gripcourse.usecases.grading.cohort_print.cohort_pdf", lambda *_: pdf)
    graded, day = [Graded(report, "")], NOW.date()
    write_results(
        graded, issued.context, out / "graded", day, 0, lambda _: None, lay_out=lambda *_: pdf
    )
    monkeypatch.setattr("gripcourse.usecases.issuing.printing.handout_list", lambda *_: pdf)
    print_sheets([], issued.course, out, out / "print.pdf", NOW.date())
    files = [*files_below(out), *files_below(reports)]
    assert len(files) == 25
    assert [one for one in files if one.stat().st_mode & EVERYBODY] == []


Taken = Callable[[str], tuple[list[str], int]]


@pytest.fixture
def taken(batch: Callable[[str], Results], issued: "Classroom", tmp_path: Path) -> Taken:
    """Take everything elsewhere for somebody who is called so; what runs, and what shows it."""

    def take(text: str) -> tuple[list[str], int]:
        out, mine = tmp_path / "out", issued.register["s01"]
        student = replace(mine.student, name=text, group=text, email=text)
        exported(batch(text), out)
        linked(replace(mine, student=student), out)
        judged = [judged_file(path, text) for path in files_below(out)]
        return [fault for faults, _ in judged for fault in faults], sum(seen for _, seen in judged)

    return take


def judged_file(path: Path, text: str) -> tuple[list[str], bool]:
    """Tell what a file would let run, and whether the text is seen in it."""
    data, end = path.read_bytes(), one_line(text)[-9:]
    match path.suffix:
        case ".csv":
            table = data.decode("utf-8-sig")
            unsafe = [*formulas_in(table), *re.findall("\x1b", table)]
            return [f"{path.name}: {one}" for one in unsafe], end in table
        case ".xlsx":
            cells = [cell for sheet in load_workbook(path) for row in sheet for cell in row]
            run = [f"{path.name}: {one.coordinate}" for one in cells if one.data_type == "f"]
            return run, any(end in str(one.value) for one in cells)
        case ".txt":
            written = data.decode()
            # Each is on one line: nobody adds a heading to a letter.
            added = [one for one in written.splitlines() if one.startswith(("Bcc", "=1"))]
            return [*added, *re.findall("\x1b", written)], end in written
        case ".json":
            json.loads(data)
    return [], False


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_nothing_runs_in_what_is_taken_elsewhere(text: str, taken: Taken, tmp_path: Path) -> None:
    faults, seen = taken(text)
    assert faults == []
    assert seen >= 4
    moodle = (tmp_path / "out" / "moodle.csv").read_text(encoding="utf-8")
    comment = list(csv.reader(io.StringIO(moodle)))[1][-1]
    assert set(re.findall(r"</?(\w+)", comment)) == {"p", "br"}


@pytest.mark.parametrize(
    ("escape", "text"),
    [
        ("exports.results_tables.text_cell", "formula"),
        ("usecases.publishing.outbox.text_cell", "second_cell"),
        ("usecases.serving.links.text_cell", "formula"),
        ("usecases.serving.links.text_cell", "terminal"),
        ("text.words.one_line", "second_line"),
        ("text.words.one_line", "terminal"),
    ],
)
def test_an_escape_that_is_left_out_is_noticed(
    escape: str, text: str, taken: Taken, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(f"gripcourse.{escape}", str)
    assert taken(TEXTS[text])[0]
