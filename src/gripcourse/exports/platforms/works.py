"""The graded works of a batch, and the rows of a platform's table, as they are compared."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from types import MappingProxyType
from typing import Final

from gripcourse.exports.report_result import GradesResult, ReportResult
from gripcourse.grading.platforms import PlatformPart, platform_part
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Student

_NOBODY: Final[Mapping[str, Sequence[Student]]] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class GradedWork:
    """A judged work that counts.

    Attributes:
        report: what it came to.
        email: of the student, as the roster has it; empty for none.
        part: what a platform wrote into the path of the file; None for nothing.
        other_keys: ids and addresses under which the student was listed a second time.
    """

    report: ReportResult
    email: str
    part: PlatformPart | None
    other_keys: frozenset[str] = frozenset()

    @property
    def points(self) -> float:
        """Points so far, after lateness: what waits for a person has none yet."""
        return self.report.points_that_count or 0.0

    @property
    def total(self) -> float:
        """Points that the whole assignment has."""
        return (self.report.max_score or 0.0) + self.report.open_points

    @property
    def share(self) -> float:
        """Share of the whole that was earned so far, 0 to 1."""
        return min(max(self.points / self.total, 0.0), 1.0) if self.total else 0.0

    @property
    def said(self) -> str:
        """Who it is, for a sentence."""
        return f"{self.report.student} {self.report.name}".strip()


@dataclass(frozen=True, slots=True)
class PlatformRow:
    """Who a row of a platform's table is about.

    Attributes:
        line: number of the row, as a spreadsheet program counts.
        number: the platform's own; empty for none.
        keys: cells that may be an id or an address.
        name: empty for none.
    """

    line: int
    number: str
    keys: tuple[str, ...]
    name: str


def works_of(
    grades: GradesResult,
    students: Mapping[str, Student],
    joined: Mapping[str, Sequence[Student]] = _NOBODY,
) -> tuple[tuple[GradedWork, ...], tuple[Message, ...]]:
    """Return the work of each student that counts, and notes on those of whom none does.

    Args:
        grades: of a batch.
        students: of the register, by id.
        joined: by id, the same person as listed under ids that were joined with it.
    """
    persons = {one.id: person for person, others in joined.items() for one in others}
    judged: dict[str, list[ReportResult]] = {}
    for report in grades.reports:
        if report.judged and report.student and report.counts is not False:
            student = persons.get(report.student, report.student)
            judged.setdefault(student, []).append(report)
    works, notes = [], []
    for student, reports in judged.items():
        points = {(one.score, one.earned, one.max_score, one.open_points) for one in reports}
        if len(points) > 1:
            notes.append(_several(student, reports))
            continue
        known = students.get(student)
        part = next(filter(None, (platform_part(one.file) for one in reports)), None)
        other_keys = {key for one in joined.get(student, ()) for key in (one.id, one.email)} - {""}
        email = "" if known is None else known.email
        works.append(GradedWork(reports[0], email, part, frozenset(other_keys)))
    return tuple(works), tuple(notes)


def _several(student: str, reports: Iterable[ReportResult]) -> Message:
    return message(
        "{student} handed in several works with different points, so no grade is written: {files}.",
        student=student,
        files=", ".join(PurePath(one.file).name for one in reports),
    )
