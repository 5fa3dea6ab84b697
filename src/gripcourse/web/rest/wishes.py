"""What programs send: bodies in JSON, and what a table is searched by."""

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class RegradeWish:
    """An answer should be looked at again.

    Attributes:
        item: id of the quantity, as the results name it.
        sentence: what should be looked at.
    """

    item: str
    sentence: str


@dataclass(frozen=True, slots=True)
class PublishingReason:
    """Why something is done.

    Attributes:
        why: in a few words; it is kept.
    """

    why: str = ""


@dataclass(frozen=True, slots=True)
class RegradingWish:
    """A regrade should count.

    Attributes:
        seen: of what would change, as it was shown.
        why: the reason; it is kept.
        allow_lower: whether results that students were told may get worse.
    """

    seen: str
    why: str
    allow_lower: bool = False


@dataclass(frozen=True, slots=True)
class UndoingWish:
    """The last regrade should be taken back.

    Attributes:
        why: the reason; it is kept.
        allow_lower: whether results that students were told since may get worse.
    """

    why: str = ""
    allow_lower: bool = False


@dataclass(frozen=True, slots=True)
class MarkWish:
    """What a person decides about an item.

    Attributes:
        seen: of the marks up to now, as the item said it.
        lines: share of its points that each line of the rubric earns, by line.
        credit: share of the item's points, where there is no rubric; null for none.
        comment: for the student.
        override: whether the automatic result is to be overruled.
        withdraw: whether the marks of this item are to count no longer.
    """

    seen: str
    lines: Mapping[str, float] = field(default_factory=dict)
    credit: float | None = None
    comment: str = ""
    override: bool = False
    withdraw: bool = False
