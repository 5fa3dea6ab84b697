"""The table of grades: one row for each file and for each student without one.

Decimal points and commas between cells in every language, so that a program reads it the same
everywhere.
"""

from collections.abc import Collection, Container, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC
from itertools import chain
from types import MappingProxyType
from typing import Final

from gripcourse.documents.report.mistakes import is_anothers, mistakes_in
from gripcourse.documents.report.standing import earned_percent_of, percent_of, standing_of
from gripcourse.documents.report.totals import totals_of
from gripcourse.exports.csv_text import number_cell, table_lines, text_cell
from gripcourse.grading.folded import Derivation, derived
from gripcourse.grading.model import Finding, Report
from gripcourse.policy.scales import Scale, certain_grade
from gripcourse.text.words import Words
from gripcourse.variants.model import Student

_NOBODY: Mapping[str, Student] = MappingProxyType({})
NOT_HANDED_IN = "not_handed_in"
"""Stands for the flags of who handed nothing in."""


@dataclass(frozen=True, slots=True)
class Called:
    """What grades are called: a column for each scale, in one language."""

    scales: tuple[Scale, ...]
    words: Words


_TIMED = ("earned", "earned_percent", "attempt", "counts", "handed_in", "days_late")
_PLAIN = Called((), Words("en"))


def grades_text(
    reports: Sequence[Report],
    students: Mapping[str, Student] = _NOBODY,
    called: Called = _PLAIN,
) -> str:
    """Return the table of the grades of a batch; see `grades_lines`."""
    return "".join(grades_lines(reports, students, called))


def grades_lines(
    reports: Sequence[Report],
    students: Mapping[str, Student] = _NOBODY,
    called: Called = _PLAIN,
    left: Container[str] = (),
) -> Iterator[str]:
    """Return the lines of the table of the grades of a batch.

    A file that could not be judged has its row with empty points: it is not a zero.

    Args:
        reports: of the batch, in the order of the rows.
        students: everybody to whom something was issued, by id; who has no file among the reports
            has a row all the same, without points.
        called: the scales; a grade that points which wait for a person decide is left empty.
        left: students who are no longer in the course: nobody waits for their works.
    """
    timed, handed_in, sections = False, set[str](), dict[str, None]()
    for one in reports:
        timed |= one.timing is not None
        handed_in.add(one.student)
        sections.update(dict.fromkeys(derived(one.findings, FOUND).points))
    header = (
        *("student", "name", "group", "email", "variant"),
        *("score", "max_score", "percent", "open_points"),
        *(one.id for one in called.scales),
        *(_TIMED if timed else ()),
        *sections,
        *("slips", "flags", "file"),
    )
    # Cells of one row at a time: those of all take ten times the room of the table.
    rows = (
        _row(report, students.get(report.student), called, tuple(sections), timed=timed)
        for report in reports
    )
    lacking = (
        _missing_row(student, len(header))
        for id_, student in students.items()
        if id_ not in handed_in and id_ not in left
    )
    return table_lines(header, chain(rows, lacking))


def _missing_row(student: Student, width: int) -> tuple[str, ...]:
    known = tuple(map(text_cell, (student.id, student.name, student.group, student.email)))
    return (*known, *("",) * (width - len(known) - 2), NOT_HANDED_IN, "")


def _row(
    report: Report,
    student: Student | None,
    called: Called,
    sections: Sequence[str],
    *,
    timed: bool,
) -> tuple[str, ...]:
    flags = "; ".join(dict.fromkeys(flag.code for flag in report.flags))
    before = (
        *map(
            text_cell,
            (
                report.student,
                report.name,
                "" if student is None else student.group,
                "" if student is None else student.email,
                report.variant,
            ),
        ),
        *_points(report),
        *_grades(report, called),
        *(_timing(report) if timed else ()),
    )
    found = derived(report.findings, FOUND)
    points: Mapping[str, str] = found.points if report.judged else {}
    after = ("" if is_anothers(report) else found.slips, flags, report.file)
    return (*before, *(points.get(name, "") for name in sections), *map(text_cell, after))


def _points(report: Report) -> tuple[str, str, str, str]:
    if not report.judged:
        return ("", "", "", "")
    percent = percent_of(report)
    return (
        number_cell(report.score),
        number_cell(report.max_score),
        "" if percent is None else number_cell(percent),
        number_cell(report.open_points),
    )


def _grades(report: Report, called: Called) -> tuple[str, ...]:
    """Return the grades that are certain: a platform takes a cell as it stands."""
    if not report.judged:
        return ("",) * len(called.scales)
    standing = standing_of(report)
    return tuple(text_cell(certain_grade(scale, standing, called.words)) for scale in called.scales)


def _timing(report: Report) -> tuple[str, ...]:
    """Return what lateness leaves of the points, and which attempt it is; times are in UTC."""
    timing = report.timing
    if timing is None:
        return ("",) * len(_TIMED)
    percent = earned_percent_of(report)
    return (
        number_cell(report.earned) if report.judged else "",
        number_cell(percent) if report.judged and percent is not None else "",
        f"{timing.number}/{timing.of}",
        "1" if timing.counts else "0",
        "" if timing.handed_in is None else f"{timing.handed_in.astimezone(UTC):%Y-%m-%dT%H:%MZ}",
        "" if timing.is_unknown else str(timing.days_late),
    )


@dataclass(frozen=True, slots=True)
class FoundCells:
    """Cells that follow from the findings of a work.

    Attributes:
        points: of each section.
        slips: that were recognised, as `quantity=slip`, each once, where they were made.
    """

    points: Mapping[str, str]
    slips: str


def _found(findings: Collection[Finding]) -> FoundCells:
    totals = totals_of(findings)
    slips = (f"{one.quantity}={one.slip}" for one in mistakes_in(findings) if one.slip)
    return FoundCells(
        points={section: number_cell(total.points) for section, total in totals.items()},
        slips="; ".join(slips),
    )


FOUND: Final = Derivation("cells", _found)
"""What a row says of findings."""
