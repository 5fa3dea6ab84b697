"""What a student may have computed instead of a formula."""

from dataclasses import dataclass

from gripcourse.formula.tree import Formula
from gripcourse.policy.slips import DECLARED
from gripcourse.text.words import Texts

__all__ = ["DECLARED", "Candidate"]


@dataclass(frozen=True, slots=True)
class Candidate:
    """A wrong method of one quantity.

    Attributes:
        id: unique within the quantity; a declared slip's own, else "kind:detail".
        kind: of generic slip, or `DECLARED`.
        formula: what is computed instead, in the same declared unit.
        prior: how common it is, on the scale of the slip policy.
        credit: share of the points for an answer that it explains, 0…1.
        hint: for the student.
    """

    id: str
    kind: str
    formula: Formula
    prior: float
    credit: float
    hint: Texts
