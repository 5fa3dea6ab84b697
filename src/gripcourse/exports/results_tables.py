"""Results as tables for other programs: one by student, one by section, one by quantity.

Who has not handed in has a row. A text that a spreadsheet program would run as a formula does not:
in CSV it begins with an apostrophe, in a workbook it is stored as text.
"""

import io
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

from gripcourse.exports.csv_text import text_cell
from gripcourse.exports.grades import NOT_HANDED_IN
from gripcourse.exports.report_result import FindingResult, GradesResult, ReportResult
from gripcourse.text.shown import shown
from gripcourse.variants.model import Student

if TYPE_CHECKING:
    import pandas as pd

Cells: TypeAlias = Mapping[str, Any]


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
    rows = {
        "students": [
            *(_student(one, students) for one in grades.reports),
            *({**_known(one), "flags": NOT_HANDED_IN} for one in missing),
        ],
        "sections": [row for one in grades.reports for row in _sections(one)],
        "quantities": [_quantity(one, found) for one in grades.reports for found in one.findings],
    }
    return {name: pd.DataFrame.from_records([dict(one) for one in found])
            for name, found in rows.items()}  # fmt: skip


def csv_tables(tables: "Mapping[str, pd.DataFrame]") -> dict[str, bytes]:
    """Return each table as CSV by the name of its file."""
    # The byte order mark is what tells Excel that the Cyrillic is UTF-8.
    return {
        f"{name}.csv": _texts(table, text_cell)
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
        for name, table in tables.items():
            _texts(table, shown).to_excel(writer, sheet_name=name, index=False)
            writer.sheets[name].freeze_panes(1, 0)
            writer.sheets[name].autofit()
    return stream.getvalue()


def _texts(table: "pd.DataFrame", change: Callable[[str], str]) -> "pd.DataFrame":
    return table.map(lambda cell: change(cell) if isinstance(cell, str) else cell)


def _known(student: Student) -> Cells:
    return {"student": student.id, "name": student.name, "group": student.group,
            "email": student.email}  # fmt: skip


def _student(report: ReportResult, students: Mapping[str, Student]) -> Cells:
    known = students.get(report.student)
    return {
        "student": report.student,
        "name": report.name,
        "group": "" if known is None else known.group,
        "email": "" if known is None else known.email,
        "variant": report.variant,
        "scheme": report.scheme,
        "score": report.score,
        "max_score": report.max_score,
        "open_points": report.open_points if report.judged else None,
        "earned": report.earned,
        "days_late": report.days_late,
        "counts": report.counts,
        "flags": "; ".join(dict.fromkeys(one.code for one in report.flags)),
        "file": report.file,
    }


def _sections(report: ReportResult) -> Iterator[Cells]:
    for section in dict.fromkeys(one.section for one in report.findings):
        inside = [one for one in report.findings if one.section == section]
        closed = [one for one in inside if not _waits(one)]
        yield {
            "student": report.student,
            "variant": report.variant,
            "section": section,
            "points": sum(one.points for one in closed),
            "max_points": sum(one.max_points for one in closed),
            "open_points": sum(one.max_points for one in inside if _waits(one)),
            "file": report.file,
        }


def _quantity(report: ReportResult, found: FindingResult) -> Cells:
    return {
        "student": report.student,
        "variant": report.variant,
        "section": found.section,
        "quantity": found.quantity,
        "outcome": found.outcome.value,
        "typed": found.typed,
        "given": found.given,
        "reference": found.reference,
        "expected": found.expected,
        "band": found.band,
        "points": found.points,
        "max_points": found.max_points,
        "slip": found.slip,
        "roots": "; ".join(found.roots),
        "decided_by": "" if found.decision is None else found.decision.marker,
        "file": report.file,
    }


def _waits(finding: FindingResult) -> bool:
    return finding.outcome.traits.waits and finding.decision is None
