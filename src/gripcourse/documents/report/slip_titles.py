"""What slips are called, for people who never saw their ids."""

from collections.abc import Mapping
from dataclasses import dataclass

from gripcourse.course.quantity import Quantity
from gripcourse.policy.model import Policy
from gripcourse.slips.model import DECLARED, SlipId
from gripcourse.text.words import Words, message


@dataclass(frozen=True, slots=True)
class SlipTitles:
    """Titles of slips.

    Attributes:
        quantities: that slips are declared with, by id.
        policy: titles of the kinds of generic slips.
        words: of the reader.
    """

    quantities: Mapping[str, Quantity]
    policy: Policy
    words: Words

    def of(self, quantity: str, written: str) -> str:
        """Return the title of a slip of a quantity: its hint where the course declares it.

        An erratum keeps its number, which stands in the list of errata.
        """
        declared = self.quantities.get(quantity)
        for slip in declared.slips if declared else ():
            if slip.id == written:
                return slip.hint.of(self.words.language).rstrip(".")
        kind = SlipId.parse(written).kind
        return written if kind == DECLARED else self.of_kind(kind)

    def of_kind(self, kind: str) -> str:
        """Return the title of a kind; a kind without one is what a course declares itself."""
        for one, slip in self.policy.slips.kinds.items():
            if one.value == kind:
                return slip.title.of(self.words.language)
        return self.words.say(message("declared by the course"))
