"""What the server tells programs of items that a person marks; see `results`."""

from dataclasses import dataclass
from typing import ClassVar

from gripcourse.web.rest.results import ReceiptResult, RequestResult


@dataclass(frozen=True, slots=True)
class WaitingResult:
    """An item that a person looks at.

    Attributes:
        student: id.
        name: as the roster writes it.
        item: id of the quantity.
        title: what it is.
        again: whether it was marked before its file or its result changed.
    """

    student: str
    name: str
    item: str
    title: str
    again: bool


@dataclass(frozen=True, slots=True)
class MarkingResult:
    """Everything that waits for a person.

    Attributes:
        items: by student, in the order of the assignment.
    """

    SCHEMA: ClassVar[str] = "gripcourse/marking/1"

    items: tuple[WaitingResult, ...]


@dataclass(frozen=True, slots=True)
class LevelResult:
    """A step on which a line of a rubric may stand.

    Attributes:
        credit: share of the line's points, 0 to 1.
        text: when it is given.
    """

    credit: float
    text: str


@dataclass(frozen=True, slots=True)
class RubricLineResult:
    """One thing that a person looks at.

    Attributes:
        id: of the line.
        share: of the item's points, 0 to 1.
        text: what is asked for.
        levels: the only credits that may be given; empty where any from 0 to 1 may.
    """

    id: str
    share: float
    text: str
    levels: tuple[LevelResult, ...]


@dataclass(frozen=True, slots=True)
class ItemResult:
    """An item to mark.

    Attributes:
        waiting: the item.
        seen: of its marks up to now; goes back with the mark.
        rubric: lines; empty where the share of the points is said at once.
        hand_ins: files of the student.
        requests: for another look at this item.
    """

    SCHEMA: ClassVar[str] = "gripcourse/item/1"

    waiting: WaitingResult
    seen: str
    rubric: tuple[RubricLineResult, ...]
    hand_ins: tuple[ReceiptResult, ...]
    requests: tuple[RequestResult, ...]
