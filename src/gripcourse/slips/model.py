"""What a student may have computed instead of a formula."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Self

from gripcourse.formula.tree import Formula
from gripcourse.policy.slips import DECLARED
from gripcourse.slips.hints import Hint
from gripcourse.text.words import Texts

__all__ = ["DECLARED", "NOT_STEPPED_UP", "USED", "Candidate", "SlipId"]

USED = "used"
"""Kind of the slips where another number than the given or found one was used."""

NOT_STEPPED_UP = "not_stepped_up"
"""Kind of the slip of staying at a size that is large enough and fails the choice's condition."""


@dataclass(frozen=True, slots=True, order=True)
class SlipId:
    """A slip, unique within the quantity that it was made in.

    Attributes:
        kind: of generic slip, `DECLARED`, `USED`, or `NOT_STEPPED_UP`.
        detail: a declared slip's or an erratum's own id; of a number used wrongly, and of a size
            that was not stepped up, the id of its quantity; else what the kind changed in the
            formula.
    """

    kind: str
    detail: str

    def __reduce__(self) -> "tuple[type[SlipId], tuple[str, str]]":
        # As messages: half the time that dataclasses take of themselves.
        return SlipId, (self.kind, self.detail)

    @classmethod
    def declared(cls, id_: str) -> Self:
        """Return the slip, or the erratum, that a formula declares under an id."""
        return cls(DECLARED, id_)

    @classmethod
    def used(cls, quantity: str) -> Self:
        """Return the slip of using another number for a quantity."""
        return cls(USED, quantity)

    @classmethod
    def not_stepped_up(cls, quantity: str) -> Self:
        """Return the slip of staying at a size of a choice that has to step up."""
        return cls(NOT_STEPPED_UP, quantity)

    @classmethod
    def parse(cls, written: str) -> Self:
        """Read what `str` wrote: `kind:detail`, or a declared slip's own id."""
        kind, colon, detail = written.partition(":")
        return cls(kind, detail) if colon else cls.declared(written)

    def __str__(self) -> str:
        """As it stands in files."""
        return self.detail if self.kind == DECLARED else f"{self.kind}:{self.detail}"


@dataclass(frozen=True, slots=True)
class Candidate:
    """A wrong method of one quantity.

    Attributes:
        id: its name, and of what kind it is.
        formula: what is computed instead, in the same declared unit.
        prior: how common it is, on the scale of the slip policy.
        credit: share of the points for an answer that it explains, 0…1.
        said: the hint for the student, not yet in words.
    """

    id: SlipId
    formula: Formula
    prior: float
    credit: float
    said: Hint = field(compare=False)

    @property
    def kind(self) -> str:
        """Of generic slip, or `DECLARED`."""
        return self.id.kind

    @property
    def hint(self) -> Texts:
        """For the student, in each language."""
        return self.said.say()

    def hint_after(self, others: Iterable[Self]) -> Texts:
        """For the student who has read the hints of others, of the same calculation."""
        return self.said.say({name for one in others for name in one.said.introduced})
