"""Results as tables: everybody has a row, and nothing in a cell runs."""

import csv
import io
import re
from dataclasses import replace

import pytest
from openpyxl import load_workbook

from gripcourse.exports.make_report_result import grades_result
from gripcourse.exports.report_result import GradesResult
from gripcourse.exports.results_tables import csv_tables, results_tables, workbook
from gripcourse.grading.model import Report
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.variants.model import Student

HOSTILE = "=1+1|cmd"
STUDENTS = {id_: Student(id_, HOSTILE, "РТ-41", f"{id_}@uni", "", "") for id_ in ("s017", "s018")}


@pytest.fixture
def grades(perfect: Report, policy: Policy) -> GradesResult:
    report = replace(perfect, name=HOSTILE)
    return grades_result([report], Words("ru"), scales=policy.scales)


def test_csv_has_everybody_and_runs_nothing(grades: GradesResult) -> None:
    tables = {
        name: list(csv.DictReader(io.StringIO(data.decode("utf-8-sig"), newline="")))
        for name, data in csv_tables(results_tables(grades, STUDENTS)).items()
    }
    students = tables["students.csv"]
    assert [(one["student"], one["flags"]) for one in students] == [
        ("s017", ""),
        ("s018", "not_handed_in"),
    ]
    assert {one["name"] for one in students} == {f"'{HOSTILE}"}
    assert all(one["email"].endswith("@uni") for table in ("students", "sections", "quantities")
               for one in tables[f"{table}.csv"])  # fmt: skip
    first = {name: students[0][name] for name in ("percent", "mark", "ects", "days_late", "counts")}
    assert first == {"percent": "100", "mark": "5", "ects": "A", "days_late": "0", "counts": "1"}
    printed = re.compile(r"-?\d+(\.\d{1,4})?")
    for table in ("students", "sections", "quantities"):
        assert all(printed.fullmatch(one[name]) for one in tables[f"{table}.csv"]
                   for name in one if name.endswith("points") and one[name])  # fmt: skip
    (report,) = grades.reports
    for name in ("sections.csv", "quantities.csv"):
        *found, missing = tables[name]
        assert {one["student"] for one in found} == {"s017"}
        assert sum(float(one["points"]) for one in found) == pytest.approx(report.score, abs=0.01)
        assert (missing["student"], missing["email"], missing["points"]) == ("s018", "s018@uni", "")
    assert missing["outcome"] == "not_handed_in"


def test_a_workbook_holds_texts_and_no_formulas(grades: GradesResult) -> None:
    book = load_workbook(io.BytesIO(workbook(results_tables(grades, STUDENTS))))
    assert book.sheetnames == ["students", "sections", "quantities"]
    cells = [cell for sheet in book for row in sheet.iter_rows() for cell in row]
    assert "f" not in {cell.data_type for cell in cells}
    assert HOSTILE in {cell.value for cell in cells}
