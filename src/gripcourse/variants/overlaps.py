"""Bodies of a gripper that stand in each other: the seam to whoever knows the bodies.

Tables know numbers and no shapes. A check of shapes is handed in; it is asked composition by
composition, with the values of all variants of one at once.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from gripcourse.course.composition import Composition
from gripcourse.text.words import Message, Texts, message
from gripcourse.variants.answers import Group
from gripcourse.variants.feasible import Array


@dataclass(frozen=True, slots=True)
class Overlap:
    """The worst pair of bodies of a variant.

    Attributes:
        bodies: what they are called.
        position: of the gripper in which they stand in each other, as open.
        depth: how far, mm.
    """

    bodies: tuple[Texts, Texts]
    position: Texts
    depth: float


OverlapCheck: TypeAlias = Callable[[Composition, Mapping[str, Array]], Sequence[Overlap | None]]
"""Looks at variants of one composition.

It is given the SI value of every quantity by id, each of shape (k,), and returns the worst overlap
of each variant, None where nothing overlaps.
"""


def overlaps_of(
    group: Group, places: Sequence[int], check: OverlapCheck
) -> Iterator[tuple[int, Overlap]]:
    """Yield the places of a group whose variants have bodies that stand in each other.

    Args:
        group: solved variants.
        places: of those that are looked at.
        check: what knows the bodies.
    """
    wanted = np.asarray(places, dtype=np.intp)
    numbers = group.family.numbers[wanted]
    for number in np.unique(numbers):
        at = wanted[numbers == number]
        columns = {
            one.quantity.id: group.values[one.quantity.id][at]
            for one in group.family.members
            if number in one.numbers and one.quantity.id in group.values
        }
        found = check(group.family.compositions[number], columns)
        yield from (
            (int(place), one) for place, one in zip(at, found, strict=True) if one is not None
        )


def overlap_in_short(one: Overlap) -> Message:
    """Name the bodies, for counting."""
    first, second = one.bodies
    return message("{first} and {second} stand in each other", first=first, second=second)


def overlap_text(one: Overlap) -> Message:
    """Say which bodies stand in each other, where and how far."""
    first, second = one.bodies
    return message(
        "{first} and {second} stand in each other by {depth} mm ({position})",
        first=first,
        second=second,
        depth=round(one.depth, 1),
        position=one.position,
    )
