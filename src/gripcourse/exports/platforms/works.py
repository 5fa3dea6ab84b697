"""The graded works of a batch, and which row of a platform's table is whose.

Platforms number people by themselves, and names are not unique: a row is a student's where the
platform's own number in the path of the work says so, else the id or the address, else a name that
occurs only once on both sides. Where two of these disagree, nobody's grade is written. A number
counts with the name beside it: a team's folder bears the number of the team, which may be that of a
stranger among the people.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from types import MappingProxyType
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.exports.report_result import GradesResult, ReportResult
from gripcourse.grading.platforms import PlatformPart, platform_part, words_of
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


@dataclass(frozen=True, slots=True)
class Matching:
    """Which row is whose.

    Attributes:
        works: by the line of the row.
        notes: works that have no row, each with the reason.
    """

    works: Mapping[int, GradedWork]
    notes: tuple[Message, ...]


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


def match(works: Sequence[GradedWork], rows: Sequence[PlatformRow], file: str) -> Matching:
    """Tell which row is whose; see the module.

    Args:
        works: that count.
        rows: of the table.
        file: the table, for what is said of it.

    Raises:
        UsageError: two rows are of one person, or two works belong to one row.
    """
    problems = list(_doubled(rows, file))
    found: dict[int, list[GradedWork]] = {}
    notes = []
    for work in works:
        surest = [_by_number(work, rows), _by_key(work, rows)]
        lines = {row.line for group in surest for row in group}
        if not lines:
            lines = {row.line for row in _by_name(work, rows, works)}
        if len(lines) == 1:
            found.setdefault(lines.pop(), []).append(work)
        elif surest[0] and surest[1]:
            notes.append(_disputed(work, lines))
        elif lines:
            problems.append(_two_rows(file, work, lines))
        else:
            notes.append(_absent(work))
    problems += [_two_works(file, line, of) for line, of in found.items() if len(of) > 1]
    if problems:
        raise UsageError(problems)
    return Matching({line: one for line, (one,) in found.items()}, tuple(notes))


def is_of_team(work: GradedWork, row: PlatformRow) -> bool:
    """Tell whether a work lay where its platform puts the works of a team.

    Args:
        work: of a student.
        row: of the same student.
    """
    part = work.part
    return part is not None and not part.joined and not _is_of_person(part, work, row)


def _is_of_person(part: PlatformPart, work: GradedWork, row: PlatformRow) -> bool:
    return part.stands_for(row.name, work.report.name)


def _by_number(work: GradedWork, rows: Iterable[PlatformRow]) -> list[PlatformRow]:
    part = work.part
    if part is None or not part.identifier:
        return []
    return [row for row in rows if row.number == part.identifier and _is_of_person(part, work, row)]


def _by_key(work: GradedWork, rows: Iterable[PlatformRow]) -> list[PlatformRow]:
    own = {work.report.student, work.email} - {""}
    # Who has two accounts there, too, gets the grade by the one whose id is kept.
    return _with_any(own, rows) or _with_any(work.other_keys, rows)


def _with_any(keys: Iterable[str], rows: Iterable[PlatformRow]) -> list[PlatformRow]:
    wanted = {key.casefold() for key in keys}
    return [row for row in rows if wanted & {key.strip().casefold() for key in row.keys}]


def _by_name(
    work: GradedWork, rows: Iterable[PlatformRow], works: Iterable[GradedWork]
) -> list[PlatformRow]:
    own = sorted(words_of(work.report.name))
    namesakes = [one for one in works if sorted(words_of(one.report.name)) == own]
    found = [row for row in rows if own and sorted(words_of(row.name)) == own]
    return found if len(found) == len(namesakes) == 1 else []


def _doubled(rows: Iterable[PlatformRow], file: str) -> Iterator[Problem]:
    lines: dict[str, int] = {}
    for row in rows:
        if row.number and (first := lines.setdefault(row.number, row.line)) != row.line:
            what = message(
                "Rows {first} and {second} have the same number {number}.",
                first=first,
                second=row.line,
                number=row.number,
            )
            yield Problem(file, "", what, _again())


def _two_rows(file: str, work: GradedWork, lines: Iterable[int]) -> Problem:
    what = message(
        "Rows {lines} are all of {student}.",
        lines=", ".join(map(str, sorted(lines))),
        student=work.said,
    )
    return Problem(file, "", what, _again())


def _two_works(file: str, line: int, works: Iterable[GradedWork]) -> Problem:
    what = message(
        "The works of {students} belong to the same row {line}.",
        students=", ".join(one.said for one in works),
        line=line,
    )
    remedy = message("Correct the ids and addresses of the roster, or fill in this row by hand.")
    return Problem(file, "", what, remedy)


def _again() -> Message:
    return message("Export the table from the platform again and leave its rows as they are.")


def _several(student: str, reports: Iterable[ReportResult]) -> Message:
    return message(
        "{student} handed in several works with different points, so no grade is written: {files}.",
        student=student,
        files=", ".join(PurePath(one.file).name for one in reports),
    )


def _disputed(work: GradedWork, lines: Iterable[int]) -> Message:
    return message(
        "The work of {student} was handed in under another account: rows {lines}. No grade is"
        " written.",
        student=work.said,
        lines=", ".join(map(str, sorted(lines))),
    )


def _absent(work: GradedWork) -> Message:
    return message("{student} is not in the platform's table.", student=work.said)
