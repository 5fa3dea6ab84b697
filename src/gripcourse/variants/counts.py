"""How many variants are drawn of each scheme and of each combination of its options."""

from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np

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

    There may be far more combinations than variants: which of them come is left to chance.
    """
    columns = []
    for name in combinations[0]:
        choices = tuple(dict.fromkeys(options[name] for options in combinations))
        numbers = (np.arange(count) + rng.integers(len(choices))) % len(choices)
        columns.append([choices[number] for number in rng.permutation(numbers)])
    chosen: Counter[tuple[str, ...]] = Counter(zip(*columns, strict=True))
    if not columns:
        chosen[()] = count
    return [chosen[tuple(options.values())] for options in combinations]


def _apportion(count: int, shares: Sequence[float]) -> list[int]:
    """Split a count by shares: whole parts first, the rest to the largest remainders."""
    exact = [count * share / sum(shares) for share in shares]
    parts = [int(one) for one in exact]
    by_rest = sorted(range(len(exact)), key=lambda place: parts[place] - exact[place])
    for place in by_rest[: count - sum(parts)]:
        parts[place] += 1
    return parts
