"""The odds that a submission's numbers are those of each other student, all pairs at once."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.matches import Floats, Matches
from gripcourse.likeness.pool import ComparisonPool

_TAKEN = (0.1, 0.3, 0.5, 0.7, 0.9, 0.99)  # shares of the numbers that may have been taken


@dataclass(frozen=True, slots=True)
class Compared:
    """All submissions against all owners of numbers.

    Attributes:
        logs: (submissions, owners); natural logarithm of the odds of copying against chance, not
            yet divided by the number of comparisons; −∞ where too few numbers tell anything.
        hits: equal numbers.
        chance: (hits,); probability of each without copying; 1 where it tells nothing.
    """

    logs: Floats
    hits: Matches
    chance: Floats


def compare(
    pooled: ComparisonPool, hits: Matches, chance: Floats, present: NDArray[np.bool_], answers: int
) -> Compared:
    """Weigh every pair of a submission and an owner.

    Args:
        pooled: the submissions.
        hits: numbers that an owner has too.
        chance: of each hit without copying.
        present: (owners, quantities); whether an owner has a number of the quantity.
        answers: telling hits that odds must rest on, at least.
    """
    numbers, owners = pooled.numbers, len(present)
    shape = (len(pooled.students), owners)
    chance = _once_for_each_family(pooled, hits, chance)
    pair = numbers.row[hits.number] * owners + hits.owner
    typed = np.zeros((shape[0], present.shape[1]))
    typed[numbers.row, numbers.column] = 1.0
    compared = typed @ present.T.astype(np.float64)
    total = np.full(shape, -np.inf)
    for taken in _TAKEN:
        # A number is taken, and then equal; or the student's own, and then equal by chance.
        gain = np.log((1 - taken) + taken / chance) - math.log(1 - taken)
        sums = np.bincount(pair, gain, shape[0] * owners).reshape(shape)
        total = np.logaddexp(total, sums + compared * math.log(1 - taken))
    telling = np.bincount(pair[chance < 1], minlength=shape[0] * owners).reshape(shape)
    logs = np.where(telling >= max(answers, 1), total - math.log(len(_TAKEN)), -np.inf)
    return Compared(logs, hits, chance)


def rests_on(pooled: ComparisonPool, found: Compared, row: int, owner: int) -> tuple[str, ...]:
    """Return the quantities that the odds of a pair rest on, the strongest first."""
    hits, chance = found.hits, found.chance
    same = (pooled.numbers.row[hits.number] == row) & (hits.owner == owner)
    telling = np.flatnonzero(same & (chance < 1))
    strongest = telling[np.argsort(chance[telling], kind="stable")]
    columns = pooled.numbers.column[hits.number[strongest]]
    return tuple(pooled.issued.quantities[column] for column in columns)


def _once_for_each_family(pooled: ComparisonPool, hits: Matches, chance: Floats) -> Floats:
    """Let proportional numbers count once for each pair: the strongest of them."""
    row = pooled.numbers.row[hits.number]
    column = pooled.numbers.column[hits.number]
    family = pooled.issued.families[pooled.own[row], column]
    telling = np.flatnonzero(chance < 1)
    keys = (chance[telling], family[telling], hits.owner[telling], row[telling])
    order = telling[np.lexsort(keys)]
    groups = np.stack((row[order], hits.owner[order], family[order]))
    repeated = np.zeros(len(order), dtype=np.bool_)
    repeated[1:] = (groups[:, 1:] == groups[:, :-1]).all(axis=0)
    result = chance.copy()
    result[order[repeated]] = 1.0
    return result
