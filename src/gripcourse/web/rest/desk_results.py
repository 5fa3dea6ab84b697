"""What the server tells programs of instructors; see `results`."""

from dataclasses import dataclass
from datetime import datetime
from typing import ClassVar

from gripcourse.web.rest.results import ReceiptResult, RequestResult


@dataclass(frozen=True, slots=True)
class SessionResult:
    """An instructor is signed in.

    Attributes:
        session: token for the other calls of the desk.
        name: who it is; what is done is kept with it.
        hours: how long it is good for.
    """

    SCHEMA: ClassVar[str] = "gripcourse/session/1"

    session: str
    name: str
    hours: int


@dataclass(frozen=True, slots=True)
class PublicationResult:
    """Results were published, or the last publication was withdrawn.

    Attributes:
        number: counts both from 1.
        published: false for a withdrawal.
        by: who did it.
        why: may be empty.
        at: when.
    """

    SCHEMA: ClassVar[str] = "gripcourse/publication/1"

    number: int
    published: bool
    by: str
    why: str
    at: datetime


@dataclass(frozen=True, slots=True)
class MemberResult:
    """A student of the group.

    Attributes:
        student, name, group, variant: as they were issued.
        last: when the last file came; null for none.
        late: whether it came after the last day.
        files, checks: how many.
        requests: for another look that no mark of the item has answered since.
        points: of the file that counts, before lateness and with marks of persons; null for none.
        earned: what lateness leaves of them, which counts; null for none.
    """

    student: str
    name: str
    group: str
    variant: str
    last: datetime | None
    late: bool
    files: int
    checks: int
    requests: int
    points: float | None
    earned: float | None


@dataclass(frozen=True, slots=True)
class GroupResult:
    """The group, or those who are looked for.

    Attributes:
        everybody: how many students there are.
        handed_in: how many of them handed in something.
        groups: names of the groups.
        members: who is looked for, by group and name.
        publication: what students see; null for nothing.
    """

    SCHEMA: ClassVar[str] = "gripcourse/group/1"

    everybody: int
    handed_in: int
    groups: tuple[str, ...]
    members: tuple[MemberResult, ...]
    publication: PublicationResult | None


@dataclass(frozen=True, slots=True)
class LoggedCheckResult:
    """A self-check.

    Attributes:
        number: counts the student's checks from 1.
        digest: SHA-256 of the file, hexadecimal.
        compared: whether it was told if numbers fit each other.
        at: when.
    """

    number: int
    digest: str
    compared: bool
    at: datetime


@dataclass(frozen=True, slots=True)
class AttemptResult:
    """A file that was graded.

    Attributes:
        number: counts the student's attempts from 1.
        judged: false where it could not be graded.
        points, max_points: without marks of persons.
        digest: SHA-256 of the file, hexadecimal.
        at: when.
    """

    number: int
    judged: bool
    points: float
    max_points: float
    digest: str
    at: datetime


@dataclass(frozen=True, slots=True)
class MarkResult:
    """A mark of a person.

    Attributes:
        quantity: id of the item.
        credit: share of its points; null where earlier marks are withdrawn.
        marker: who decided.
        comment: for the student.
        at: when.
    """

    quantity: str
    credit: float | None
    marker: str
    comment: str
    at: datetime


@dataclass(frozen=True, slots=True)
class StudentRecordResult:
    """What a student did, and what was found.

    Attributes:
        member: the row of the group.
        hand_ins: receipts.
        checks: all self-checks.
        attempts: files that were graded.
        marks: of persons, oldest first.
        requests: for another look.
        report: whether the student sees a printed report.
    """

    SCHEMA: ClassVar[str] = "gripcourse/student/1"

    member: MemberResult
    hand_ins: tuple[ReceiptResult, ...]
    checks: tuple[LoggedCheckResult, ...]
    attempts: tuple[AttemptResult, ...]
    marks: tuple[MarkResult, ...]
    requests: tuple[RequestResult, ...]
    report: bool
