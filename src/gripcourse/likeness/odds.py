"""The odds that a submission's numbers are those of another student, of the pairs that matter.

Some submissions are compared with the owners of numbers of one table; rows are counted in theirs.
Of a cohort's pairs nearly all share nothing that tells. Which ones may reach the odds that are
told follows from what tells alone; only these are weighed, some at a time, so that room is needed
for the numbers and not for all pairs.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gripcourse.likeness.cells import Bits, Floats, Ints
from gripcourse.likeness.chance import SharedMethods
from gripcourse.likeness.matches import Matches
from gripcourse.likeness.pool import ComparisonPool, PooledPart

_TAKEN = (0.1, 0.3, 0.5, 0.7, 0.9, 0.99)  # shares of the numbers that may have been taken
_SLACK = 1e-6  # of a logarithm: sums in another order
_HITS_AT_ONCE = 100_000
_PAIRS_AT_ONCE = 1_000


@dataclass(frozen=True, slots=True)
class PairMatches:
    """One way to compare some submissions with the owners of a table of numbers.

    Attributes:
        part: numbers of the submissions.
        found: equal numbers.
        chance: (numbers,); that a number meets a certain other one without copying, at least; 1
            where it tells nothing.
        shared: what makes it likelier for certain pairs; None where owners made no mistakes.
    """

    part: PooledPart
    found: Matches
    chance: Floats
    shared: SharedMethods | None = None

    @property
    def pooled(self) -> ComparisonPool:
        """All submissions."""
        return self.part.pooled

    @property
    def owners(self) -> int:
        """How many owners the table has."""
        return self.found.others.values.rows


@dataclass(frozen=True, slots=True)
class _Hits:
    """Equal numbers of certain pairs: the pair's place, the number, and its chance."""

    pair: Ints
    number: Ints
    chance: Floats


def likely_pairs(compared: PairMatches, least: float, answers: int) -> Ints:
    """Return the pairs whose odds may reach some, and perhaps a few that do not.

    What does not tell can only lower the odds, so what tells alone is a bound of them.

    Args:
        compared: what is compared.
        least: logarithm of the odds, before they are divided by the number of comparisons.
        answers: telling numbers that odds must rest on, at least.

    Returns:
        In their order: row of the submission times owners, plus row of the owner.
    """
    begin, row, least = compared.part.begin, compared.part.numbers.row, least - _SLACK
    weight = -np.log(compared.chance)
    most = np.bincount(row - begin, weight)
    telling = np.flatnonzero((weight > 0) & (most[row - begin] >= least))
    mine, theirs = _told_bits(compared, weight > 0, begin), compared.found.others.known
    found = [np.zeros(0, dtype=np.intp)]
    for chosen in _portions(compared, telling):
        number, owner = compared.found.owners(chosen)
        pairs, place = np.unique(
            row[number].astype(np.intp) * compared.owners + owner, return_inverse=True
        )
        likely = np.bincount(place, weight[number], len(pairs)) >= least
        likely &= np.bincount(place, minlength=len(pairs)) >= answers
        of_likely = likely[place]
        place = (np.cumsum(likely) - 1)[place[of_likely]]
        pairs, chance = pairs[likely], compared.chance[number[of_likely]]
        of_row, of_owner = np.divmod(pairs, compared.owners)
        known = _in_common(mine, theirs, of_row - begin, of_owner)
        found.append(pairs[_averaged(place, chance, known) >= least])
    return np.concatenate(found)


def log_odds(compared: PairMatches, pairs: Ints, answers: int) -> Floats:
    """Weigh pairs.

    Args:
        compared: what is compared.
        pairs: as `likely_pairs` returns them.
        answers: telling numbers that odds must rest on, at least.

    Returns:
        (pairs,); natural logarithm of the odds of copying against chance, not yet divided by the
        number of comparisons; −∞ where too few numbers tell anything.
    """
    portions = range(0, len(pairs), _PAIRS_AT_ONCE)
    weighed = [_weighed(compared, pairs[at : at + _PAIRS_AT_ONCE], answers) for at in portions]
    return np.concatenate([np.zeros(0), *weighed])


def rests_on(compared: PairMatches, pair: int) -> tuple[str, ...]:
    """Return the quantities that the odds of a pair rest on, the strongest first."""
    hits, _ = _hits(compared, np.array([pair], dtype=np.intp))
    telling = np.flatnonzero(hits.chance < 1)
    strongest = telling[np.argsort(hits.chance[telling], kind="stable")]
    columns = compared.part.numbers.column[hits.number[strongest]]
    return tuple(compared.pooled.issued.quantities[column] for column in columns)


def _portions(compared: PairMatches, numbers: Ints) -> list[Ints]:
    """Part numbers into those of whole submissions, with so many hits as there is room for."""
    row, found = compared.part.numbers.row[numbers], compared.found
    hits = np.cumsum(found.after[numbers] - found.first[numbers])
    begins = np.where(np.diff(row, prepend=-1) > 0, np.arange(len(row)), 0)
    portion = hits[np.maximum.accumulate(begins)] // _HITS_AT_ONCE
    return np.split(numbers, np.flatnonzero(np.diff(portion)) + 1)


def _told_bits(compared: PairMatches, which: NDArray[np.bool_], begin: int) -> Bits:
    """Return which quantities each submission has some of the numbers of, a bit for each.

    Args:
        compared: what is compared; numbers are in the order of submissions.
        which: (numbers,); whether each counts.
        begin: the first submission that has a number.
    """
    numbers = compared.part.numbers
    row, column = numbers.row[which] - begin, numbers.column[which]
    rows = int(row[-1]) + 1 if len(row) else 0
    told = np.zeros((rows, len(compared.pooled.issued.quantities)), dtype=np.bool_)
    told[row, column] = True
    return np.packbits(told, axis=1)


def _in_common(mine: Bits, theirs: Bits, row: Ints, owner: Ints) -> Floats:
    """Count for pairs how many bits both have."""
    total = np.zeros(len(row))
    for byte in range(mine.shape[1]):
        total += np.bitwise_count(mine[row, byte] & theirs[owner, byte])
    return total


def _averaged(pair: Ints, chance: Floats, known: Floats) -> Floats:
    """Return the logarithm of the odds of pairs, over all shares that may have been taken.

    Args:
        pair: (hits,); the pair of each equal number.
        chance: (hits,); of each without copying.
        known: (pairs,); how many numbers could have been equal.
    """
    total = np.full(len(known), -np.inf)
    for taken in _TAKEN:
        # A number is taken, and then equal; or the student's own, and then equal by chance.
        gain = np.log((1 - taken) + taken / chance) - math.log(1 - taken)
        sums = np.bincount(pair, gain, len(known))
        total = np.logaddexp(total, sums + known * math.log(1 - taken))
    return total - math.log(len(_TAKEN))


def _weighed(compared: PairMatches, pairs: Ints, answers: int) -> Floats:
    hits, known = _hits(compared, pairs)
    telling = np.bincount(hits.pair[hits.chance < 1], minlength=len(pairs))
    total = _averaged(hits.pair, hits.chance, known)
    return np.where(telling >= answers, total, -np.inf)


def _hits(compared: PairMatches, pairs: Ints) -> tuple[_Hits, Floats]:
    """Return all equal numbers of pairs, and how many numbers of each pair can be compared."""
    numbers = compared.part.numbers
    row, owner = np.divmod(pairs, compared.owners)
    first, after = (np.searchsorted(numbers.row, row, side) for side in ("left", "right"))
    count = after - first
    pair = np.repeat(np.arange(len(pairs)), count)
    start = np.repeat(first - np.concatenate(([0], np.cumsum(count)[:-1])), count)
    number = start + np.arange(len(pair))
    theirs = compared.found.others.values.at(owner[pair], numbers.column[number])
    known = np.bincount(pair[np.isfinite(theirs)], minlength=len(pairs)).astype(np.float64)
    same = compared.found.are_same(number, owner[pair])
    pair, number = pair[same], number[same]
    chance = compared.chance[number]
    if compared.shared is not None:
        # What is explained stays so, whoever else has it.
        chance = np.maximum(chance, compared.shared.chance(number, owner[pair]))
    own = compared.pooled.own[compared.part.first + row[pair]]
    family = compared.pooled.issued.family(own, numbers.column[number])
    return _Hits(pair, number, _once_for_each(pair, family, chance)), known


def _once_for_each(pair: Ints, family: NDArray[np.intp], chance: Floats) -> Floats:
    """Let proportional numbers count once for each pair: the strongest of them."""
    telling = np.flatnonzero(chance < 1)
    order = telling[np.lexsort((chance[telling], family[telling], pair[telling]))]
    repeated = np.zeros(len(order), dtype=np.bool_)
    groups = np.stack((pair[order], family[order]))
    repeated[1:] = (groups[:, 1:] == groups[:, :-1]).all(axis=0)
    result = chance.copy()
    result[order[repeated]] = 1.0
    return result
