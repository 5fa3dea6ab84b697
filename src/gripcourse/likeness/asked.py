"""What is asked of the numbers of a cohort, and how several comparisons of one pair count."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.likeness.cells import Floats, Ints
from gripcourse.likeness.model import Chances, Evidence, NumberKind
from gripcourse.likeness.odds import PairMatches, likely_pairs
from gripcourse.likeness.pool import ComparisonPool
from gripcourse.policy.model import LikenessRule

_LARGEST = 700.0  # logarithm of the largest odds that are told


@dataclass(frozen=True, slots=True)
class AskedNumbers:
    """What is asked of the numbers of a cohort.

    Attributes:
        pooled: the numbers.
        rule: from which odds on evidence is told.
        chances: what counts as coincidence.
    """

    pooled: ComparisonPool
    rule: LikenessRule
    chances: Chances

    @property
    def comparisons(self) -> float:
        """The logarithm of how many variants and submissions were compared with submissions."""
        submissions = len(self.pooled.students)
        return math.log(max(1, self.pooled.variants + submissions * (submissions - 1)))

    @property
    def least(self) -> float:
        """The logarithm of the odds that are told, before they are divided."""
        return math.log(self.rule.odds) + self.comparisons

    @property
    def answers(self) -> int:
        """How many telling numbers odds must rest on."""
        return max(self.rule.answers, 1)

    def evidence(self, kind: NumberKind, student: str, *likest: "Likest") -> Evidence:
        """Tell what a submission is like; the first is the likest, on whose numbers it rests."""
        odds = math.exp(min(likest[0].log - self.comparisons, _LARGEST))
        others = dict.fromkeys(one.owner for one in likest)
        return Evidence(kind, (student, *others), odds, likest[0].rests_on, likest[0].row)


@dataclass(frozen=True, slots=True)
class Likest:
    """What a submission is like.

    Attributes:
        log: logarithm of the odds, before they are divided.
        owner: whose numbers they are.
        rests_on: quantities that the odds rest on, the strongest first; of the likest alone.
        row: of the issued values, where it is a variant that the submission is like.
    """

    log: float
    owner: str
    rests_on: tuple[str, ...] = ()
    row: int | None = None


def either_likely(asked: AskedNumbers, compared: Sequence[PairMatches]) -> Ints:
    """Return the pairs whose odds may be told after any of the comparisons."""
    found = [likely_pairs(one, asked.least, asked.answers) for one in compared]
    return np.asarray(np.unique(np.concatenate(found)))


def of_all(each: Floats) -> Floats:
    """Return logarithms of odds over all comparisons, from those of each.

    Nobody knows beforehand whether numbers were moved: all comparisons count alike.
    """
    return np.asarray(np.logaddexp.reduce(each) - math.log(len(each)))
