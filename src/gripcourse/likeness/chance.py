"""How likely numbers meet without copying: by chance, by a slip, by the same mistake."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from gripcourse.likeness.cells import Floats, Ints, SparseTable
from gripcourse.likeness.matches import Met, SoughtNumbers, density, met
from gripcourse.likeness.model import Chances
from gripcourse.likeness.persons import RepeatedValues
from gripcourse.likeness.pool import ComparisonPool, PooledPart

_SAME_RATIO: Final = 1e-3  # relative: as exactly as people type


def chance_of(part: PooledPart, sought: SoughtNumbers, share: Floats, chances: Chances) -> Floats:
    """Return how likely each number meets a certain other one without copying.

    Args:
        part: some numbers of a cohort.
        sought: the same, as others have them.
        share: (numbers that nothing explains,); part of all others that have the same.
        chances: what counts as coincidence.

    Returns:
        (numbers,); 1 for what is explained.
    """
    pooled, numbers, unknown = part.pooled, part.numbers, ~part.explained
    common = np.zeros(len(unknown))
    common[unknown] = share
    near = density(numbers, pooled.spread) * sought.window
    wrong = np.maximum(np.maximum(near, common), chances.least)
    discrete = pooled.issued.discrete[numbers.column]
    wrong = np.where(discrete, np.maximum(wrong, chances.discrete), wrong)
    made = part.slip >= 0
    chance = wrong.copy()
    chance[made] = np.maximum(wrong[made], np.maximum(pooled.common[part.slip[made]], chances.slip))
    result: Floats = np.where(part.explained, 1.0, np.minimum(chance, 1.0))
    return result


@dataclass(frozen=True, slots=True)
class SharedMethods:
    """How likely two students make the same mistake, where it gives them the same number.

    Attributes:
        part: some numbers of a cohort.
        likely: (numbers,); that another makes the same mistake; 0 for what is explained.
        others: the right numbers of other submissions (rows), of their own variants.
    """

    part: PooledPart
    likely: Floats
    others: SparseTable

    def chance(self, number: Ints, owner: Ints) -> Floats:
        """Return it for pairs of a number and another submission; 0 where they would differ."""
        theirs = self.others.at(owner, self.part.numbers.column[number])
        shared = np.isclose(self.part.right[number], theirs, rtol=1e-6, atol=0.0)
        return np.where(shared, self.likely[number], 0.0)


@dataclass(frozen=True, slots=True)
class CommonMistakes:
    """How common each mistake is among those who answered its quantity.

    Attributes:
        met: how many are off by the same ratio.
        chances: what counts as coincidence.
    """

    met: Met
    chances: Chances

    def shared(self, portion: int, part: PooledPart, others: SparseTable) -> SharedMethods:
        """Return what makes some numbers likelier for certain pairs.

        Args:
            portion: place of the part among all.
            part: these numbers.
            others: the right numbers of other submissions.
        """
        likely, (unknown, sought) = np.zeros(len(part.explained)), _ratios(part)
        likely[~part.explained] = self.chances.shared
        # Of those that are off by the same ratio the number itself is one.
        likely[unknown] = np.maximum(self.met.share(portion, sought, 1), self.chances.shared)
        return SharedMethods(part, likely, others)


def common_mistakes(pooled: ComparisonPool, chances: Chances) -> CommonMistakes:
    """Find out how common each mistake is among those who answered its quantity.

    Args:
        pooled: the numbers.
        chances: what counts as coincidence.
    """

    def portions() -> Iterator[SoughtNumbers]:
        return (_ratios(part)[1] for part in pooled.parts())

    repeated = RepeatedValues.of((one.ratios for one in pooled.works), pooled.submitter)
    return CommonMistakes(met(portions, (one.ratios for one in pooled.works), repeated), chances)


def _ratios(part: PooledPart) -> tuple[Ints, SoughtNumbers]:
    """Return by how much the numbers that nothing explains are larger than the right ones.

    Returns:
        Their places among the numbers, without those that no right one belongs to; and the ratios.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = part.numbers.value / part.right
    which = np.flatnonzero(~part.explained & np.isfinite(ratio))
    reach = np.abs(ratio[which]) * _SAME_RATIO
    return which, SoughtNumbers(part.numbers.column[which], ratio[which], reach)
