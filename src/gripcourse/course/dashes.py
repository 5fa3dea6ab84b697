"""Dashes in names: a formula takes one for a minus sign, its author means a part of a name."""

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import Final

from gripcourse.formula.tree import Span

_DASHED: Final = re.compile(r"[^\W\d]\w*(?:-\w+)+")


@dataclass(frozen=True, slots=True)
class DashedName:
    """A difference without spaces that is a known name but for its dashes.

    Attributes:
        name: the known name.
        span: of the difference in the formula.
    """

    name: str
    span: Span

    def holds(self, span: Span) -> bool:
        """Tell whether a piece of the formula is a part of it."""
        return self.span[0] <= span[0] and span[1] <= self.span[1]


def without_dashes(identifier: str) -> str:
    """Return the name that whoever wrote an id with dashes can use in formulas."""
    return identifier.replace("-", "_")


def dashed_names(text: str, usable: Collection[str]) -> Iterator[DashedName]:
    """Yield the names in a formula that are written with dashes.

    Args:
        text: of the formula.
        usable: the names that it may use. A difference of these is what it seems.
    """
    for found in _DASHED.finditer(text):
        name = without_dashes(found[0])
        if name in usable and not all(one in usable for one in found[0].split("-")):
            yield DashedName(name, found.span())
