"""A variant, a student, and which variant was issued to whom."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import date
from typing import Protocol, runtime_checkable

from gripcourse.course.composition import Composition


@dataclass(frozen=True, slots=True)
class Variant:
    """The numbers of one individual assignment.

    Attributes:
        id: as the table writes it.
        scheme: id of its kinematic scheme.
        options: what it chooses, by option id.
        given: value of every given quantity, in the declared unit.
    """

    id: str
    scheme: str
    options: Mapping[str, str]
    given: Mapping[str, float]

    @property
    def composition(self) -> Composition:
        """What it has in common with the variants that are computed alike."""
        return Composition.of(self.scheme, self.options)


@dataclass(frozen=True, slots=True)
class Student:
    """A row of the roster.

    Attributes:
        id: key of the student; the learning platform's or the department's.
        name: as it is printed.
        group, email: may be empty.
        language: of the student's documents; empty for the course's.
        variant: fixed by the instructor; empty for the next free one.
    """

    id: str
    name: str
    group: str
    email: str
    language: str
    variant: str


@dataclass(frozen=True, slots=True)
class Issued:
    """One entry of the register: a student, the frozen values, and the signature over both.

    Attributes:
        student: as in the roster when it was issued.
        variant: the values that were issued; later changes of the table do not touch them.
        issued_on: day on which this version was issued first.
        deadline: last day for handing in, None for none.
        signature: hexadecimal HMAC over the course, the student, the variant and the version.
        version: counts what the student was issued, from 1; the last one counts.
        why: it was issued anew; empty for a first version.
        issued_by: who issued it anew; empty for a first version.
        declarations: fingerprint of the course's declarations then; empty where it was not kept.
        issued_as: id under which it was issued, where that was joined with the student's; else
            empty.
        left: why the student is no longer in the course; empty for who is.
        joined: the same person as listed under ids that were joined with the student's.
        own_deadline: what `deadline` is without those, where that is another day; else None.
    """

    student: Student
    variant: Variant
    issued_on: date
    deadline: date | None
    signature: str
    version: int = 1
    why: str = ""
    issued_by: str = ""
    declarations: str = ""
    issued_as: str = ""
    left: str = ""
    joined: tuple[Student, ...] = ()
    own_deadline: date | None = None

    @property
    def signed_for(self) -> str:
        """The id that workbook, sheet and signature bear."""
        return self.issued_as or self.student.id


@runtime_checkable
class KnowsNames(Protocol):
    """What was issued to students, where names take less time than all the rest."""

    def names(self) -> Iterator[tuple[str, str]]:
        """Yield the id and the name of each student."""


def names_of(issued: Mapping[str, Issued]) -> Iterator[tuple[str, str]]:
    """Yield the id and the name of each student to whom something was issued."""
    if isinstance(issued, KnowsNames):
        return issued.names()
    return ((student, one.student.name) for student, one in issued.items())
