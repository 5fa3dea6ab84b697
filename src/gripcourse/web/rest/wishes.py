"""What programs send: bodies in JSON, and what a table is searched by."""

from dataclasses import dataclass


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
