"""What the server tells programs, in the versioned forms of `exports.plain`.

Nothing stands here that a page would not show.
"""

from dataclasses import dataclass
from datetime import date, datetime
from typing import ClassVar


@dataclass(frozen=True, slots=True)
class ReceiptResult:
    """A receipt: the file is kept.

    Attributes:
        student: the id under which it was handed in; where that was joined with the student's,
            `of` with this id asks for it.
        number: counts the files of that id from 1.
        name: as the student calls it.
        size: in bytes.
        digest: SHA-256 of its bytes, hexadecimal.
        received: when it was safe on the disk.
        late: whether the last day for handing in was over.
        workbook: whether it is a workbook by its content; false for drawings too.
        code: of the receipt; the course's instructors can verify it.
    """

    SCHEMA: ClassVar[str] = "gripcourse/receipt/1"

    student: str
    number: int
    name: str
    size: int
    digest: str
    received: datetime
    late: bool
    workbook: bool
    code: str


@dataclass(frozen=True, slots=True)
class GivenResult:
    """A given number of the assignment.

    Attributes:
        quantity: id.
        symbol, title: as the sheet writes them.
        value: in its unit.
        unit: empty for a plain number.
    """

    quantity: str
    symbol: str
    title: str
    value: float
    unit: str


@dataclass(frozen=True, slots=True)
class StatusResult:
    """A student's assignment and what was done for it.

    Attributes:
        course: its title.
        student, name, group, variant: as they were issued.
        scheme: its title.
        task: in a sentence.
        deadline: last day for handing in; null for none.
        given: the given data.
        compares: whether a check also tells whether numbers fit each other.
        checks_left: how often that will be told.
        checks_most: how often in all.
        hand_ins: receipts, oldest first.
        published: whether results can be seen.
    """

    SCHEMA: ClassVar[str] = "gripcourse/status/1"

    course: str
    student: str
    name: str
    group: str
    variant: str
    scheme: str
    task: str
    deadline: date | None
    given: tuple[GivenResult, ...]
    compares: bool
    checks_left: int
    checks_most: int
    hand_ins: tuple[ReceiptResult, ...]
    published: bool


@dataclass(frozen=True, slots=True)
class RequestResult:
    """Somebody asks for an answer to be looked at again.

    Attributes:
        student: id.
        item: id of the quantity.
        sentence: as it was written.
        at: when.
    """

    SCHEMA: ClassVar[str] = "gripcourse/request/1"

    student: str
    item: str
    sentence: str
    at: datetime


@dataclass(frozen=True, slots=True)
class RequestsResult:
    """All requests of the group.

    Attributes:
        requests: by student, oldest first.
    """

    SCHEMA: ClassVar[str] = "gripcourse/requests/1"

    requests: tuple[RequestResult, ...]


@dataclass(frozen=True, slots=True)
class ItemPointsResult:
    """Points of one answer.

    Attributes:
        quantity: id.
        title: what it is.
        points, max_points: earned and possible.
    """

    quantity: str
    title: str
    points: float
    max_points: float


@dataclass(frozen=True, slots=True)
class PublishedResult:
    """What a student is told after publication; how each answer was judged is in the report.

    Attributes:
        student: id.
        judged: false where the file could not be graded; the report says why.
        score, max_score: in points, before lateness and without what waits for a person; null
            where not judged.
        open_points: points of what waits for a person.
        items: points of each answer, before lateness.
        earned: points that count: what lateness leaves of the score; null where not judged.
        report: whether there is a printed report.
        requests: what the student asked to be looked at again.
    """

    SCHEMA: ClassVar[str] = "gripcourse/published/1"

    student: str
    judged: bool
    score: float | None
    max_score: float | None
    open_points: float
    items: tuple[ItemPointsResult, ...]
    report: bool
    requests: tuple[RequestResult, ...]
    earned: float | None
