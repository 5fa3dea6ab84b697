"""The table of grades: one row for each file, for a spreadsheet program or a learning platform.

UTF-8 with a byte order mark, so that Excel reads Cyrillic; decimal points and commas between cells
in every language, so that a program reads it the same everywhere.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

from gripcourse.documents.report.mistakes import mistakes_of
from gripcourse.documents.report.totals import section_totals
from gripcourse.exports.csv_text import number_cell, table_text, text_cell
from gripcourse.grading.model import Report
from gripcourse.machine.files import write_bytes

_NO_GROUPS: Mapping[str, str] = MappingProxyType({})


def grades_csv(
    reports: Iterable[Report], path: Path, groups: Mapping[str, str] = _NO_GROUPS
) -> None:
    """Write the grades of a batch.

    A file that could not be judged has its row with empty points: it is not a zero.

    Args:
        reports: of the batch, in the order of the rows.
        path: file to write, whole or not at all; only its owner may read it.
        groups: group of each student by id, where the roster knows it.

    Raises:
        OSError: the file cannot be written.
    """
    # The byte order mark is what tells Excel that the Cyrillic is UTF-8.
    write_bytes(path, grades_text(tuple(reports), groups).encode("utf-8-sig"), private=True)


def grades_text(reports: Sequence[Report], groups: Mapping[str, str] = _NO_GROUPS) -> str:
    """Return the table as text; see `grades_csv`."""
    sections = tuple(
        dict.fromkeys(finding.section for report in reports for finding in report.findings)
    )
    header = (
        *("student", "name", "group", "variant"),
        *("score", "max_score", "percent", "open_points"),
        *sections,
        *("slips", "flags", "file"),
    )
    return table_text(header, (_row(report, sections, groups) for report in reports))


def _row(report: Report, sections: tuple[str, ...], groups: Mapping[str, str]) -> tuple[str, ...]:
    flags = "; ".join(dict.fromkeys(flag.code for flag in report.flags))
    return (
        *map(
            text_cell, (report.student, report.name, groups.get(report.student, ""), report.variant)
        ),
        *_points(report),
        *_section_points(report, sections),
        text_cell("; ".join(_slips(report))),
        text_cell(flags),
        text_cell(report.file),
    )


def _points(report: Report) -> tuple[str, str, str, str]:
    if not report.judged:
        return ("", "", "", "")
    percent = number_cell(100 * report.score / report.max_score) if report.max_score else ""
    return (
        number_cell(report.score),
        number_cell(report.max_score),
        percent,
        number_cell(report.open_points),
    )


def _section_points(report: Report, sections: tuple[str, ...]) -> tuple[str, ...]:
    if not report.judged:
        return ("",) * len(sections)
    totals = section_totals(report)
    return tuple(
        number_cell(totals[section].points) if section in totals else "" for section in sections
    )


def _slips(report: Report) -> Iterator[str]:
    """Yield the recognised slips as `quantity=slip`, each once, where they were made."""
    for mistake in mistakes_of(report):
        if mistake.slip:
            yield f"{mistake.quantity}={mistake.slip}"
