"""Results as tables for other programs: one by student, one by section, one by quantity.

Who has not handed in has a row in each table, without points. Scales stand as they were called
when the work was graded. A text that a spreadsheet program would run as a formula does not: in CSV
it begins with an apostrophe, in a workbook it is stored as text.
"""

import io
import math
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

from gripcourse.exports.csv_text import rounded_points, text_cell
from gripcourse.exports.grades import NOT_HANDED_IN
from gripcourse.exports.report_result import FindingResult, GradesResult, ReportResult
from gripcourse.machine.spreadsheet.table_page import set_no_moment, set_table_page
from gripcourse.text.shown import shown
from gripcourse.variants.model import Student

if TYPE_CHECKING:
    import pandas as pd

Cells: TypeAlias = Mapping[str, Any]

_WHO = ("student", "name", "group", "email", "variant")
_STUDENTS = (
    *(*_WHO, "scheme", "score", "max_score", "percent", "open_points"),
    *("earned", "earned_percent", "days_late", "counts", "flags", "file"),
)
_SECTIONS = (*_WHO, "section", "points", "max_points", "open_points", "file")
_QUANTITIES = (
    *(*_WHO, "section", "quantity", "outcome", "typed", "given", "reference", "expected"),
    *("band", "points", "max_points", "slip", "roots", "decided_by", "file"),
)
_FIGURES = 10


def results_tables(
    grades: GradesResult, students: Mapping[str, Student]
) -> "dict[str, pd.DataFrame]":
    """Return the tables `students`, `sections` and `quantities`; headings are ids.

    Args:
        grades: of a batch.
        students: of the register, by id.
    """
    import pandas as pd  # noqa: PLC0415 (400 ms)

    handed_in = {one.student for one in grades.reports}
    missing = [one for id_, one in students.items() if id_ not in handed_in]
    scales = tuple(dict.fromkeys(name for one in grades.reports for name in one.scales))
    rows = {
        "students": [
            *(_student(one, students) for one in grades.reports),
            *({**_known(one), "flags": NOT_HANDED_IN} for one in missing),
        ],
        "sections": [
            *(row for one in grades.reports for row in _sections(one, students)),
            *map(_known, missing),
        ],
        "quantities": [
            *(_quantity(one, found, students) for one in grades.reports for found in one.findings),
            *({**_known(one), "outcome": NOT_HANDED_IN} for one in missing),
        ],
    }
    before = _STUDENTS.index("earned")
    columns = {
        "students": (*_STUDENTS[:before], *scales, *_STUDENTS[before:]),
        "sections": _SECTIONS,
        "quantities": _QUANTITIES,
    }
    # As objects: beside an empty cell, pandas would make 0.0 late days of 0.
    return {
        name: pd.DataFrame(
            [[one.get(column) for column in columns[name]] for one in found],
            columns=list(columns[name]),
            dtype=object,
        )
        for name, found in rows.items()
    }


def csv_tables(tables: "Mapping[str, pd.DataFrame]") -> dict[str, bytes]:
    """Return each table as CSV by the name of its file."""
    # The byte order mark is what tells Excel that the Cyrillic is UTF-8.
    return {
        f"{name}.csv": _cells(table, text_cell, _number)
        .to_csv(index=False, lineterminator="\r\n")
        .encode("utf-8-sig")
        for name, table in tables.items()
    }


def workbook(tables: "Mapping[str, pd.DataFrame]") -> bytes:
    """Return all tables as one workbook, a sheet each."""
    import pandas as pd  # noqa: PLC0415 (as above)

    stream = io.BytesIO()
    plain = {"strings_to_formulas": False, "strings_to_urls": False}
    with pd.ExcelWriter(stream, engine="xlsxwriter", engine_kwargs={"options": plain}) as writer:
        set_no_moment(writer.book)
        for name, table in tables.items():
            _cells(table, shown, lambda value: float(_number(value))).to_excel(
                writer, sheet_name=name, index=False
            )
            sheet = writer.sheets[name]
            sheet.freeze_panes(1, 0)
            sheet.autofit()
            set_table_page(sheet)
    return stream.getvalue()


def _cells(
    table: "pd.DataFrame", text: Callable[[str], str], number: Callable[[float], object]
) -> "pd.DataFrame":
    """Change every text and every number; empty cells stay empty."""

    def changed(cell: object) -> object:
        if isinstance(cell, str):
            return text(cell)
        if isinstance(cell, bool) or not isinstance(cell, int | float) or not math.isfinite(cell):
            return cell
        return number(cell)

    return table.astype(object).map(changed)


def _number(value: float) -> str:
    """Leave out the last figures, which only the order of adding up put there."""
    return f"{value:.{_FIGURES}g}"


def _known(student: Student | None) -> Cells:
    if student is None:
        return {}
    return {"student": student.id, "name": student.name, "group": student.group,
            "email": student.email}  # fmt: skip


def _whose(report: ReportResult, students: Mapping[str, Student]) -> Cells:
    own = {"student": report.student, "variant": report.variant, "file": report.file}
    return {**_known(students.get(report.student)), **own}


def _student(report: ReportResult, students: Mapping[str, Student]) -> Cells:
    return {
        **_whose(report, students),
        "name": report.name,
        "scheme": report.scheme,
        "score": _points(report.score),
        "max_score": _points(report.max_score),
        "percent": _points(report.percent),
        "open_points": _points(report.open_points) if report.judged else None,
        **report.scales,
        "earned": _points(report.earned),
        "earned_percent": _points(report.earned_percent),
        "days_late": report.days_late,
        "counts": None if report.counts is None else int(report.counts),
        "flags": "; ".join(dict.fromkeys(one.code for one in report.flags)),
    }


def _sections(report: ReportResult, students: Mapping[str, Student]) -> Iterator[Cells]:
    for section in dict.fromkeys(one.section for one in report.findings):
        inside = [one for one in report.findings if one.section == section]
        closed = [one for one in inside if not _waits(one)]
        yield {
            **_whose(report, students),
            "section": section,
            "points": _points(sum(one.points for one in closed)),
            "max_points": _points(sum(one.max_points for one in closed)),
            "open_points": _points(sum(one.max_points for one in inside if _waits(one))),
        }


def _quantity(report: ReportResult, found: FindingResult, students: Mapping[str, Student]) -> Cells:
    return {
        **_whose(report, students),
        "section": found.section,
        "quantity": found.quantity,
        "outcome": found.outcome.value,
        "typed": found.typed,
        "given": found.given,
        "reference": found.reference,
        "expected": found.expected,
        "band": found.band,
        "points": _points(found.points),
        "max_points": _points(found.max_points),
        "slip": found.slip,
        "roots": "; ".join(found.roots),
        "decided_by": "" if found.decision is None else found.decision.marker,
    }


def _points(value: float | None) -> float | None:
    return None if value is None else rounded_points(value)


def _waits(finding: FindingResult) -> bool:
    return finding.outcome.traits.waits and finding.decision is None
