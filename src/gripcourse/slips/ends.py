"""Quantities at other ends of a range: called the same, or of which the greatest was taken."""

from collections.abc import Iterator, Mapping

from gripcourse.course.quantity import Quantity
from gripcourse.formula.tree import Call, Name
from gripcourse.policy.slips import GenericSlip, SlipKind


def other_ends(name: str, slip: GenericSlip) -> Iterator[str]:
    """Yield the ids that are a name with its ending changed for the other of a pair."""
    for pair in slip.pairs:
        for one, another in (pair, pair[::-1]):
            other = name.removesuffix(one) + another
            if name.endswith(one) and other != name:
                yield other


def taken_among(name: str, quantities: Mapping[str, Quantity], slip: GenericSlip) -> Iterator[str]:
    """Yield the ids among which a quantity is the greatest or the least, as at the ends of a range.

    Whoever takes another of them has not taken the greatest, though all were computed rightly.
    """
    formula = quantities[name].formula if name in quantities else None
    tree = formula.tree if formula is not None else None
    if (
        slip.kind is SlipKind.WRONG_END
        and isinstance(tree, Call)
        and tree.function in {"max", "min"}
        and all(isinstance(one, Name) for one in tree.arguments)
    ):
        yield from (one.id for one in tree.arguments if isinstance(one, Name))
