"""Shares of a count with what chance can do to them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Protocol, Self, TypeVar

_Z = 1.959963984540054  # of the normal distribution, for 95 %


@dataclass(frozen=True, slots=True)
class Rate:
    """A share of a count.

    Attributes:
        hits, total: counts.
        at_most, at_least: what is required of the share; None for nothing.
    """

    hits: int
    total: int
    at_most: float | None = None
    at_least: float | None = None

    def __add__(self, other: "Rate") -> "Rate":
        """Count two samples together; what is required is the same of both."""
        return replace(self, hits=self.hits + other.hits, total=self.total + other.total)

    @property
    def share(self) -> float:
        """The share, 0…1; NaN of nothing."""
        return self.hits / self.total if self.total else math.nan

    @property
    def required(self) -> bool:
        """Whether anything is required of it."""
        return self.at_most is not None or self.at_least is not None

    @property
    def reached(self) -> bool:
        """Whether the share is as required; a share of nothing misses nothing."""
        if not self.total:
            return True
        too_large = self.at_most is not None and self.share > self.at_most
        too_small = self.at_least is not None and self.share < self.at_least
        return not (too_large or too_small)

    @property
    def interval(self) -> tuple[float, float]:
        """The interval that holds the true share with 95 %; E. B. Wilson, 1927."""
        if not self.total:
            return (0.0, 1.0)
        total, z = self.total, _Z
        middle = (self.share + z**2 / (2 * total)) / (1 + z**2 / total)
        half = (
            z
            / (1 + z**2 / total)
            * math.sqrt(self.share * (1 - self.share) / total + z**2 / (4 * total**2))
        )
        low = middle - half if self.hits else 0.0
        high = middle + half if self.hits < total else 1.0
        return (low, high)


class Addable(Protocol):
    """Whatever two samples of can be counted together."""

    def __add__(self, other: Self, /) -> Self:
        """Count two samples together."""


_Key = TypeVar("_Key")
_Counted = TypeVar("_Counted", bound=Addable)


def added(one: Mapping[_Key, _Counted], other: Mapping[_Key, _Counted]) -> dict[_Key, _Counted]:
    """Count two samples together, name by name, where either may lack some."""
    total = dict(one)
    for name, counted in other.items():
        total[name] = total[name] + counted if name in total else counted
    return total
