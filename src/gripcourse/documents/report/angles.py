"""Which angles of a formula count as numbers, so that people have to put them in in radians.

In `l·sin θ` an angle may be in degrees, as it may in `θ = α + β`. In `s = R·(θ₁ − θ₂)` it may not:
there an angle stands for the ratio of an arc to its radius.
"""

from collections.abc import Iterator, Mapping
from typing import Final

from gripcourse.course.quantity import Quantity
from gripcourse.formula.functions import FUNCTIONS
from gripcourse.formula.tree import Call, Formula, Name, Negation, Node, Operation, names

_ANGLES: Final = frozenset({"deg", "rad"})
_TAKE_ANGLES: Final = frozenset({"sin", "cos", "tan"})
_KEEP_ANGLES: Final = frozenset({"abs", "min", "max"})


def in_radians(
    quantity: Quantity, formula: Formula, quantities: Mapping[str, Quantity]
) -> frozenset[str]:
    """Return the names of a formula whose angles count as plain numbers.

    Args:
        quantity: what the formula computes.
        formula: of the quantity; an empirical one says itself in which units its numbers enter.
        quantities: declarations of the names.
    """
    if formula.units:
        return frozenset()
    angles = {name for name in formula.names if quantities[name].unit in _ANGLES}
    return frozenset(_counted(formula.tree, angles, angular=quantity.unit in _ANGLES))


def _counted(node: Node, angles: set[str], *, angular: bool) -> Iterator[str]:
    """Yield the angles that count as numbers where a node's own value is an angle, or is not."""
    match node:
        case Name(name) if name in angles and not angular:
            yield name
        case Negation(operand):
            yield from _counted(operand, angles, angular=angular)
        case Operation("<" | "<=" | ">" | ">=" | "==", left, right):
            # Two angles are compared as angles: `λ < ρ`.
            compared = all(angles.issuperset(names(side)) for side in (left, right))
            for side in (left, right):
                yield from _counted(side, angles, angular=compared)
        case Operation(_, left, right):
            yield from _counted(left, angles, angular=angular)
            yield from _counted(right, angles, angular=angular)
        case Call(function, arguments):
            # A table is entered with an angle as it is.
            reads_table = FUNCTIONS[function].reads_column
            inside = reads_table or function in _TAKE_ANGLES
            inside = inside or (angular and function in _KEEP_ANGLES)
            for argument in arguments:
                yield from _counted(argument, angles, angular=inside)
        case _:
            return
