"""What a generator of slips may look at, and what it makes of a formula."""

from collections.abc import Mapping
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import TypeAlias

from gripcourse.course.model import Catalogue
from gripcourse.course.quantity import Quantity
from gripcourse.formula.evaluate import Column
from gripcourse.formula.tree import Formula, Name, Node
from gripcourse.policy.slips import GenericSlip

# A declaration stands for itself; so do a number or several, a unit, a piece of the formula.
Place: TypeAlias = Quantity | Node | float | tuple[float, ...] | str

Found: TypeAlias = tuple[Node, tuple[str, Mapping[str, Place]]]
"""What may stand in the place of a node, with its detail and places."""


@dataclass(frozen=True, slots=True)
class Surroundings:
    """A formula with what a generator may look at.

    Attributes:
        quantities: what the formula names, what has the same name but for its end, and what reads
            the same column of a catalogue; by id.
        columns, catalogues: of the course.
        independent: ids of the quantities that are not computed from this one, as far as any of
            them may be taken for another.
    """

    quantities: Mapping[str, Quantity]
    columns: Mapping[str, Column]
    catalogues: Mapping[str, Catalogue]
    quantity: Quantity
    formula: Formula
    slip: GenericSlip
    independent: frozenset[str]

    def named(self, node: Node) -> Quantity | None:
        """Return the quantity that a node names, if it is one that this kind concerns."""
        if not isinstance(node, Name) or node.id not in self.quantities:
            return None
        return self.quantities[node.id] if self.concerns(node.id) else None

    def concerns(self, name: str) -> bool:
        """Tell whether this kind concerns the quantity of an id."""
        return not self.slip.names or any(fnmatchcase(name, p) for p in self.slip.names)

    def dimensionless(self, node: Node) -> Quantity | None:
        """Return the plain number that a node names: a factor such as an efficiency."""
        found = self.named(node)
        return found if found is not None and found.unit in {"", "%"} else None


@dataclass(frozen=True, slots=True)
class Rewritten:
    """A tree with one slip in it, and what fills the places of its hint.

    Attributes:
        practical: whether the tree gives what numbers in practical units come to, not those of SI.
    """

    detail: str
    tree: Node
    places: Mapping[str, Place]
    practical: bool = False
