"""Submissions in which the same numbers were typed."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import chain, repeat

import numpy as np

from gripcourse.likeness.asked import AskedNumbers, Likest, either_likely, of_all
from gripcourse.likeness.chance import CommonMistakes, chance_of, common_mistakes
from gripcourse.likeness.matches import Matches, Met, SoughtNumbers, in_order, met, same_as_typed
from gripcourse.likeness.model import Evidence, NumberKind
from gripcourse.likeness.odds import PairMatches, log_odds, rests_on
from gripcourse.likeness.persons import RepeatedValues
from gripcourse.likeness.pool import PooledWorks

_BOTH = 2  # of those who typed the same: the one whom a number is about, and the other of a pair


def same_answers(asked: AskedNumbers) -> Iterator[Evidence]:
    """Yield for each submission those in which the same numbers were typed beyond chance."""
    pooled, moved = asked.pooled, asked.chances.typed

    def portions() -> Iterator[SoughtNumbers]:
        return (
            same_as_typed(part.numbers, one).some(~part.explained)
            for part in pooled.parts()
            for one in moved
        )

    repeated = RepeatedValues.of((works.typed for works in pooled.works), pooled.submitter)
    counted = met(portions, (works.typed for works in pooled.works), repeated)
    mistakes = common_mistakes(pooled, asked.chances)
    found: dict[int, list[Likest]] = defaultdict(list)
    first = 0
    for works in pooled.works:
        compared = _compared_with_typed(asked, works, counted, mistakes)
        for one in compared:
            _keep_alike(asked, one, first, found)
        first += len(works.own)
    for row in sorted(found):
        likest = sorted(found[row], key=lambda one: -one.log)
        yield asked.evidence(NumberKind.SAME_ANSWERS, pooled.students[row], *likest)


def _compared_with_typed(
    asked: AskedNumbers, works: PooledWorks, counted: Met, mistakes: CommonMistakes
) -> Iterator[tuple[PairMatches, ...]]:
    """Compare submissions with what was typed in those of a table: exactly, and moved a little."""
    others, right, ways = in_order(works.typed), works.of_right, asked.chances.typed
    for number, part in enumerate(asked.pooled.parts()):
        unknown, compared = ~part.explained, list[PairMatches]()
        methods = mistakes.shared(number, part, right)
        for way, moved in enumerate(ways):
            sought = same_as_typed(part.numbers, moved)
            share = counted.share(number * len(ways) + way, sought.some(unknown), _BOTH)
            chance = chance_of(part, sought, share, asked.chances)
            found = Matches.of(sought, unknown, others)
            compared.append(PairMatches(part, found, chance, methods))
        yield tuple(compared)


def _keep_alike(
    asked: AskedNumbers, compared: Sequence[PairMatches], first: int, found: dict[int, list[Likest]]
) -> None:
    """Keep the submissions of a table that are like others beyond chance.

    Args:
        asked: for what.
        compared: every way in which they were compared.
        first: the table's first submission among all.
        found: by submission, what was found so far; it is added to.
    """
    pooled, part, owners = asked.pooled, compared[0].part, compared[0].owners
    pairs = either_likely(asked, compared)
    row, other = np.divmod(pairs, owners)
    pairs = pairs[pooled.submitter[part.first + row] != pooled.submitter[first + other]]
    each = np.stack([log_odds(one, pairs, asked.answers) for one in compared])
    logs = of_all(each)
    told = logs >= asked.least
    pairs, each, logs = pairs[told], each[:, told], logs[told]
    row, other = np.divmod(pairs, owners)
    for one in np.unique(row):
        mine = np.flatnonzero(row == one)
        strongest = mine[np.argsort(-logs[mine], kind="stable")]
        best = int(strongest[0])
        names = rests_on(compared[int(np.argmax(each[:, best]))], int(pairs[best]))
        found[int(part.first + one)] += (
            Likest(float(logs[place]), pooled.students[first + int(other[place])], told)
            for place, told in zip(strongest, chain((names,), repeat(())), strict=False)
        )
