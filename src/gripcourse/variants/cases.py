"""The combinations of options that a space mixes, each looked into only when it is wanted.

A scheme may have thousands of combinations, of which a table needs a few dozen.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Self

from gripcourse.variants.constraint import Constraint
from gripcourse.variants.ranges import Follower

_REMEMBERED = 256


@dataclass(frozen=True, slots=True)
class SpaceCase:
    """One combination of options and what may be drawn for it.

    Attributes:
        options: choice by option id.
        given: allowed values of the given quantities, in their declared units, ascending.
        followers: the given quantities that another one decides.
        constraints: what a variant must satisfy besides being solvable.
    """

    options: Mapping[str, str]
    given: Mapping[str, tuple[float, ...]]
    followers: Mapping[str, Follower]
    constraints: tuple[Constraint, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Cases:
    """The cases of a space, in order.

    Attributes:
        combinations: the options of each case.
        case: makes the case of a place; the latest are remembered.
    """

    combinations: tuple[Mapping[str, str], ...]
    case: Callable[[int], SpaceCase]

    @classmethod
    def made_by(
        cls,
        combinations: Iterable[Mapping[str, str]],
        make: Callable[[Mapping[str, str]], SpaceCase],
    ) -> Self:
        """Make cases by what makes one of its options."""
        listed = tuple(combinations)
        return cls(listed, lru_cache(_REMEMBERED)(lambda place: make(listed[place])))

    @classmethod
    def of(cls, cases: Sequence[SpaceCase]) -> Self:
        """Make cases of those that are there already."""
        return cls(tuple(case.options for case in cases), cases.__getitem__)

    def __len__(self) -> int:
        return len(self.combinations)

    def __getitem__(self, place: int) -> SpaceCase:
        return self.case(place)

    def __iter__(self) -> Iterator[SpaceCase]:
        return map(self.case, range(len(self)))

    def with_options(self, options: Mapping[str, str]) -> SpaceCase | None:
        """Return the case of these options, None where they are not mixed."""
        places = (place for place, one in enumerate(self.combinations) if one == options)
        place = next(places, None)
        return None if place is None else self.case(place)
