"""How a drawing went: what was tried, and why candidates were refused."""

from collections.abc import Iterable
from dataclasses import dataclass

from gripcourse.text.words import Message


@dataclass(frozen=True, slots=True)
class Refusal:
    """How often candidates were refused for a reason; one candidate may have several."""

    what: Message
    count: int


@dataclass(frozen=True, slots=True)
class Tally:
    """How drawing went for one scheme.

    Attributes:
        scheme: its id.
        tried: candidates judged.
        sound: candidates that can be solved and are no doubles.
        refusals: the reasons for the others, the most frequent first.
        set_aside: why the further condition refused candidates that can be solved.
    """

    scheme: str
    tried: int
    sound: int
    refusals: tuple[Refusal, ...]
    set_aside: tuple[Refusal, ...]

    @property
    def acceptance(self) -> float:
        """Share of the candidates that can be solved, 0 to 1."""
        return self.sound / self.tried


def summed(refusals: Iterable[Refusal]) -> tuple[Refusal, ...]:
    """Add up what was refused for the same reason."""
    counts: dict[str, Refusal] = {}
    for one in refusals:
        earlier = counts.get(str(one.what))
        total = one.count + (earlier.count if earlier else 0)
        counts[str(one.what)] = Refusal(one.what, total)
    return tuple(counts.values())


def by_count(refusals: Iterable[Refusal]) -> tuple[Refusal, ...]:
    """Sort by count, the most frequent first; what never happened is left out."""
    return tuple(sorted((one for one in refusals if one.count), key=lambda one: -one.count))
