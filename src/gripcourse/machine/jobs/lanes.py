"""Jobs that wait for workers: those of a kind for the same one, as far as that keeps all busy.

What a worker makes once of a kind of jobs it has for the next of them. Where jobs came as they lie,
each worker would meet every kind, and make for itself what the others make too.
"""

from array import array
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, TypeAlias

KindOf: TypeAlias = Callable[[Any], Hashable | None]
"""Tells of which kind a job with an item is, None for none that is known; it may be mistaken."""


@dataclass(slots=True)
class JobsLeft:
    """Jobs that nobody has begun: each item is asked for when its turn comes, and not held here.

    Attributes:
        items: of all jobs.
        numbers: of those that waited at first, in the order in which they are taken.
        lanes: of each worker, or of all together, where in `numbers` its jobs begin and end.
    """

    items: Sequence[Any]
    numbers: Sequence[int]
    lanes: list[tuple[int, int]]

    @classmethod
    def of(
        cls,
        items: Sequence[Any],
        numbers: Sequence[int],
        kind_of: KindOf | None = None,
        lanes: int = 1,
    ) -> "JobsLeft":
        """Let jobs wait.

        Args:
            items: of all jobs, these and others.
            numbers: of those that wait.
            kind_of: jobs of a kind are taken one after the other; None for as they come.
            lanes: how many workers have jobs of their own.
        """
        ordered = numbers if kind_of is None else _by_kind(items, numbers, kind_of)
        ends = [len(ordered) * lane // lanes for lane in range(lanes + 1)]
        return cls(items, ordered, list(pairwise(ends)))

    def __len__(self) -> int:
        return sum(end - start for start, end in self.lanes)

    def take(self, lane: int) -> tuple[int, Any]:
        """Take the next job of a lane, its number and its item; an empty one helps the longest.

        From there it takes the last: of its kind no other may be begun yet.
        """
        start, end = self.lanes[lane]
        if start < end:
            self.lanes[lane] = start + 1, end
            place = start
        else:
            longest = max(range(len(self.lanes)), key=lambda one: _length(self.lanes[one]))
            start, end = self.lanes[longest]
            self.lanes[longest] = start, end - 1
            place = end - 1
        number = self.numbers[place]
        return number, self.items[number]

    def left(self) -> Sequence[int]:
        """Return the numbers of the jobs that still wait."""
        return [number for start, end in self.lanes for number in self.numbers[start:end]]


def _length(lane: tuple[int, int]) -> int:
    start, end = lane
    return end - start


def _by_kind(items: Sequence[Any], numbers: Sequence[int], kind_of: KindOf) -> "array[int]":
    """Return numbers with those of a kind together, and those of no kind at the end."""
    of_kind: dict[Hashable, array[int]] = {}
    for number in numbers:
        of_kind.setdefault(kind_of(items[number]), array("q")).append(number)
    unknown = of_kind.pop(None, array("q"))
    return sum(of_kind.values(), array("q")) + unknown
