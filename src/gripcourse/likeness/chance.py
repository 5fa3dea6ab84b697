"""How likely numbers meet without copying: by chance, by a slip, by the same mistake."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from gripcourse.likeness.cells import Floats, Ints
from gripcourse.likeness.matches import Matches, OrderedValues, density
from gripcourse.likeness.model import Chances
from gripcourse.likeness.pool import ComparisonPool, PooledPart

_SAME_RATIO: Final = 1e-3  # relative: as exactly as people type


def chance_of(part: PooledPart, found: Matches, chances: Chances) -> Floats:
    """Return how likely each number meets a certain other one without copying.

    Returns:
        (numbers,); 1 for what is explained.
    """
    pooled, numbers = part.pooled, part.numbers
    near = density(numbers, pooled.spread) * found.window
    wrong = np.maximum(np.maximum(near, found.share), chances.least)
    discrete = pooled.issued.discrete[numbers.column]
    wrong = np.where(discrete, np.maximum(wrong, chances.discrete), wrong)
    made = part.slip >= 0
    chance = wrong.copy()
    chance[made] = np.maximum(wrong[made], np.maximum(pooled.common[part.slip[made]], chances.slip))
    result: Floats = np.where(part.explained, 1.0, np.minimum(chance, 1.0))
    return result


@dataclass(frozen=True, slots=True)
class CommonMistakes:
    """How common the mistake is that makes each number that nothing explains.

    Attributes:
        number: these numbers of a cohort, in their order.
        likely: of each, that another makes the same mistake.
    """

    number: Ints
    likely: Floats

    def part(self, part: PooledPart) -> "SharedMethods":
        """Return the same for some of the numbers."""
        likely = np.zeros(len(part.explained))
        begin, end = np.searchsorted(self.number, (part.which.start, part.which.stop))
        likely[self.number[begin:end] - part.which.start] = self.likely[begin:end]
        return SharedMethods(part, likely)


@dataclass(frozen=True, slots=True)
class SharedMethods:
    """How likely two students make the same mistake, where it gives them the same number.

    Attributes:
        part: some numbers of a cohort.
        likely: (numbers,); that another makes the same mistake; 0 for what is explained.
    """

    part: PooledPart
    likely: Floats

    def chance(self, number: Ints, owner: Ints) -> Floats:
        """Return it for pairs of a number and a submission; 0 where they would differ."""
        pooled, numbers = self.part.pooled, self.part.numbers
        column, values = numbers.column[number], pooled.issued.values
        right = values.at(pooled.own[numbers.row[number]], column)
        theirs = values.at(pooled.own[owner], column)
        shared = np.isclose(right, theirs, rtol=1e-6, atol=0.0)
        return np.where(shared, self.likely[number], 0.0)


def common_mistakes(
    pooled: ComparisonPool, typed: OrderedValues, chances: Chances
) -> CommonMistakes:
    """Find out how common each mistake is among those who answered its quantity.

    Args:
        pooled: the numbers.
        typed: the same, in order.
        chances: what counts as coincidence.
    """
    wrong = np.flatnonzero(~pooled.explained).astype(np.int32)
    likely = np.zeros(len(wrong))
    # One quantity after the other: all of them at once would take as much room again.
    for column in np.unique(pooled.typed.key[wrong] % pooled.typed.columns).tolist():
        mine = typed.places(column)
        right = pooled.issued.values.at(pooled.own[typed.owner(mine)], np.array(column))
        with np.errstate(divide="ignore", invalid="ignore"):
            common = _commonness(pooled.typed.value[mine] / right)
        unknown = ~pooled.explained[mine]
        likely[np.searchsorted(wrong, mine[unknown])] = common[unknown]
    return CommonMistakes(wrong, np.maximum(likely, chances.shared, out=likely))


def _commonness(ratio: Floats) -> Floats:
    """Return which part of a quantity's numbers is off by the same ratio, but for this one."""
    result = np.zeros(len(ratio))
    mine = np.flatnonzero(np.isfinite(ratio))
    ordered = np.sort(ratio[mine])
    reach = np.abs(ratio[mine]) * _SAME_RATIO
    low = np.searchsorted(ordered, ratio[mine] - reach, "left")
    high = np.searchsorted(ordered, ratio[mine] + reach, "right")
    result[mine] = (high - low - 1) / max(len(mine), 1)
    return result
