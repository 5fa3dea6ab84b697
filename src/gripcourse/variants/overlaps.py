"""Bodies of a machine that stand in each other: the seam to whoever knows the bodies.

Tables know numbers and no shapes. A check of shapes is handed in; it is asked scheme by scheme,
with the values of all its variants at once.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from gripcourse.text.words import Message, Texts, message
from gripcourse.variants.answers import Group
from gripcourse.variants.feasible import Array


@dataclass(frozen=True, slots=True)
class Overlap:
    """The worst pair of bodies of a variant.

    Attributes:
        bodies: what they are called.
        position: of the machine in which they stand in each other, as open.
        depth: how far, mm.
    """

    bodies: tuple[Texts, Texts]
    position: Texts
    depth: float


OverlapCheck: TypeAlias = Callable[[str, Mapping[str, Array]], Sequence[Overlap | None]]
"""Looks at variants of one scheme, whatever their options.

It is given the scheme's id and the SI value of every quantity by id, each of shape (k,), NaN where
the options of a variant do not bring it, and returns the worst overlap of each variant, None where
nothing overlaps.
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
    if not len(wanted):
        return
    columns = {
        name: np.broadcast_to(values, group.family.size)[wanted]
        for name, values in group.values.items()
    }
    found = check(group.family.scheme, columns)
    yield from (
        (int(place), one) for place, one in zip(wanted, found, strict=True) if one is not None
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
