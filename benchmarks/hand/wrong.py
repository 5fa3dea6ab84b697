"""What a mistake is: a step, or several alike, done in another way than the right one."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from hand.notebook import Notebook, Step

ENDS: Final = ("at_max", "at_min")
POSITIONS: Final = ("open", "at_max", "at_min")


@dataclass(frozen=True)
class Mistake:
    """A mistake of a student's.

    Attributes:
        what: is done wrong, for the table.
        steps: what is written instead, by the quantity in whose step it is done.
    """

    what: str
    steps: Mapping[str, Step]


def mistake(what: str, **steps: Step) -> Mistake:
    """Return a mistake made in the named steps."""
    return Mistake(what, steps)


def alike(
    what: str,
    prefix: str,
    ends: tuple[str, ...],
    step: Callable[[Notebook, str], float],
) -> Mistake:
    """Return a mistake made in the same way at several positions."""

    def at(end: str) -> Step:
        return lambda n, _: step(n, end)

    return Mistake(what, {f"{prefix}_{end}": at(end) for end in ends})


def times(factor: float) -> Step:
    """Return a step that comes to a multiple of what is right."""
    return lambda _, right: right * factor


def row_below(table: str, column: str = "") -> Step:
    """Return a step that takes the entry one row before the right one; there is none of the first.

    A step raises ValueError where the right entry is the first.
    """

    def step(n: Notebook, right: float) -> float:
        sizes = n.sheet.table(table).column(column)
        place = sizes.index(right)
        if not place:
            raise ValueError(right)
        return sizes[place - 1]

    return step


def row_beside(table: str, column: str) -> Step:
    """Return a step that takes the entry of the row before; of the first row, of the next."""

    def step(n: Notebook, right: float) -> float:
        sizes = n.sheet.table(table).column(column)
        return sizes[sizes.index(right) - 1] if right != sizes[0] else sizes[1]

    return step
