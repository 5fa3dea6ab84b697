"""How many variants are drawn of each scheme and of each combination of its options."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from gripcourse.variants.space import Space


def counts_of(spaces: Sequence[Space], count: int, rng: np.random.Generator) -> list[int]:
    """Split a count among the cases of all spaces, in their order."""
    parts = _apportion(count, [space.weight for space in spaces])
    spread = (
        _spread(space.cases.combinations, part, rng)
        for space, part in zip(spaces, parts, strict=True)
    )
    return [wanted for one in spread for wanted in one]


def _spread(
    combinations: Sequence[Mapping[str, str]], count: int, rng: np.random.Generator
) -> list[int]:
    """Split a count among the combinations of options, each choice of an option alike often.

    There may be far more combinations than variants, and rules may leave some choices fewer
    combinations than others. So each next one is that whose choices have come least often so far;
    where several are, the one that came least often itself, then chance decides.
    """
    codes, sizes = _numbered(combinations)
    used = np.zeros(len(combinations), dtype=np.intp)
    taken = [np.zeros(size) for size in sizes]
    for _ in range(count):
        cost = sum(
            (one[codes[:, at]] * len(one) for at, one in enumerate(taken)), np.zeros(len(used))
        )
        chosen = int(np.argmin(cost + (used + rng.random(len(used))) / (count + 1)))
        used[chosen] += 1
        for at, one in enumerate(taken):
            one[codes[chosen, at]] += 1
    return [int(one) for one in used]


def _numbered(
    combinations: Sequence[Mapping[str, str]],
) -> tuple[NDArray[np.intp], tuple[int, ...]]:
    """Number the choices of each option; shape (combinations, options), and how many there are."""
    codes = np.zeros((len(combinations), len(combinations[0])), dtype=np.intp)
    sizes = []
    for at, name in enumerate(combinations[0]):
        numbers = {
            choice: number
            for number, choice in enumerate(dict.fromkeys(one[name] for one in combinations))
        }
        codes[:, at] = [numbers[one[name]] for one in combinations]
        sizes.append(len(numbers))
    return codes, tuple(sizes)


def _apportion(count: int, shares: Sequence[float]) -> list[int]:
    """Split a count by shares: whole parts first, the rest to the largest remainders."""
    exact = [count * share / sum(shares) for share in shares]
    parts = [int(one) for one in exact]
    by_rest = sorted(range(len(exact)), key=lambda place: parts[place] - exact[place])
    for place in by_rest[: count - sum(parts)]:
        parts[place] += 1
    return parts
