"""All that students were issued, as works are compared with it: a row for each version.

Whoever copies has the numbers of the sheet that lay beside him, be it replaced or not.
"""

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import TypeAlias

from gripcourse.batch.context import GradingContext, declarations_of
from gripcourse.course.model import Course
from gripcourse.grading.made_for import versions_of
from gripcourse.grading.model import Report
from gripcourse.likeness.model import ComparedWork
from gripcourse.likeness.works import work_of
from gripcourse.machine.shelf import Viewed
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued, Variant
from gripcourse.workbook.names import AUTHOR

JudgedBy: TypeAlias = tuple[str, int, str]
"""What a work was judged by: student, place among the student's versions, declarations."""


@dataclass(frozen=True, slots=True)
class ComparedVersions:
    """What everybody was issued, in rows: the last versions first, then those that they replaced.

    Attributes:
        context: the course, its policy, the register.
        students: of the first rows: each computed by today's declarations.
        replaced: the rows after these: other versions, or the same by other declarations.
        row: which of the student's rows has what a work was judged by; without those of students
            who have one row.
    """

    context: GradingContext
    students: Sequence[str]
    replaced: Sequence[JudgedBy]
    row: Mapping[JudgedBy, int]

    @classmethod
    def of(cls, context: GradingContext, judged: Iterable[JudgedBy] = ()) -> "ComparedVersions":
        """Put all versions into rows; of equal ones a student has one.

        Args:
            context: the course, its policy, the register.
            judged: what works were judged by: rarely by declarations that are not their version's.
        """
        replaced, row = list[JudgedBy](), dict[JudgedBy, int]()
        asked: dict[str, list[JudgedBy]] = {}
        for one in judged:
            asked.setdefault(one[0], []).append(one)
        for student in context.earlier:
            versions = versions_of(student, context.register, context.earlier)
            last = len(versions) - 1
            own = (
                (student, place, declarations_of(one, context))
                for place, one in enumerate(versions[:last])
            )
            known: list[tuple[Variant, str]] = []
            for one in chain([(student, last, "")], own, asked.get(student, ())):
                numbers = versions[one[1]].variant, one[2]
                if numbers not in known:
                    known.append(numbers)
                    if len(known) > 1:
                        replaced.append(one)
                row.setdefault(one, known.index(numbers))
        return cls(context, tuple(context.register), replaced, row)

    @property
    def variants(self) -> Sequence[tuple[str, Variant]]:
        """The variants, each with its owner."""
        register, count = self.context.register, len(self.students)

        def variant(row: int) -> tuple[str, Variant]:
            if row < count:
                return self.students[row], register[self.students[row]].variant
            student, place, _ = self.replaced[row - count]
            return student, _versions(student, self.context)[place].variant

        return Viewed(range(count + len(self.replaced)), variant)

    def name(self, row: int) -> Message | None:
        """Say which version of a student's a row is; None where the student has one row."""
        count = len(self.students)
        if row >= count:
            student, place, _ = self.replaced[row - count]
        elif any(self.students[row] == one for one, *_ in self.replaced):
            student, place = self.students[row], -1
        else:
            return None
        issued = _versions(student, self.context)[place]
        if issued.issued_as:
            return message(
                "{student} (issued as {id}, version {version})",
                student=student,
                id=issued.issued_as,
                version=issued.version,
            )
        return message("{student} (version {version})", student=student, version=issued.version)

    @property
    def declared(self) -> Mapping[int, Course]:
        """By row, the declarations that it is computed by where these are not today's."""
        rows = enumerate(self.replaced, start=len(self.students))
        return {row: self.context.declared[name] for row, (*_, name) in rows if name}

    @property
    def about(self) -> str:
        """What tells which rows there are beside those of students who were issued to once."""
        return _digest(chain([issued_again(self.context)], self.replaced))

    def work(self, report: Report) -> ComparedWork:
        """Return the numbers of a judged submission, to be compared."""
        if report.student not in self.context.earlier:
            return work_of(report, self.context.register[report.student], AUTHOR)
        versions = _versions(report.student, self.context)
        made_for = versions[_made_for(report, versions)]
        row = self.row[judged_by(report, self.context)]
        return work_of(report, made_for, AUTHOR, row)


def issued_again(context: GradingContext) -> str:
    """Return a digest of all that students were issued to whom something was issued twice."""
    return _digest(_versions(student, context) for student in context.earlier)


def judged_by(report: Report, context: GradingContext) -> JudgedBy:
    """Return what a work of a student who was issued to several times was judged by."""
    versions = _versions(report.student, context)
    declarations = report.declarations if report.declarations in context.declared else ""
    return report.student, _judged(report, versions), declarations


def _digest(parts: Iterable[object]) -> str:
    digest = hashlib.sha256()
    for one in parts:
        digest.update(f"{one!r}\n".encode())
    return digest.hexdigest()


def _versions(student: str, context: GradingContext) -> tuple[Issued, ...]:
    return versions_of(student, context.register, context.earlier)


def _judged(report: Report, versions: Sequence[Issued]) -> int:
    """Return the place of the version whose values a work was judged by; the last for none."""
    wanted = report.version, report.variant
    found = (at for at, one in enumerate(versions) if (one.version, one.variant.id) == wanted)
    return next(found, len(versions) - 1)


def _made_for(report: Report, versions: Sequence[Issued]) -> int:
    """Return the place of the version that a workbook was made for.

    It is another one than it was judged by where the best of several counts, all of one sheet.
    """
    judged = _judged(report, versions)
    own = versions[judged].issued_as
    wanted = own, report.made_for
    found = (at for at, one in enumerate(versions) if (one.issued_as, one.version) == wanted)
    return next(found, judged)
