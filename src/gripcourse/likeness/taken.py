"""Submissions that hold the right numbers of another student's variant."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from gripcourse.likeness.asked import AskedNumbers, Likest, either_likely, of_all
from gripcourse.likeness.chance import chance_of
from gripcourse.likeness.matches import (
    Matches,
    Met,
    OrderedValues,
    SoughtNumbers,
    in_order,
    met,
    same_as_issued,
)
from gripcourse.likeness.odds import PairMatches, log_odds, rests_on
from gripcourse.likeness.persons import RepeatedValues
from gripcourse.likeness.pool import PooledPart

_ITSELF = 1  # of those who have the same issued number, whom the number is about


@dataclass(slots=True)
class TakenNumbers:
    """Other students whose variants one submission fits beyond chance.

    Attributes:
        student: of the submission.
        best: the one that it fits best.
        owners: all of them.
    """

    student: str
    best: Likest
    owners: list[str] = field(default_factory=list)


def taken_from_issued(asked: AskedNumbers) -> Iterator[TakenNumbers]:
    """Yield what submissions have in common with the right values of other students' variants."""
    pooled, moved = asked.pooled, asked.chances.moved

    def portions() -> Iterator[SoughtNumbers]:
        return (
            same_as_issued(part.numbers, one).some(~part.explained)
            for part in pooled.parts()
            for one in moved
        )

    repeated = RepeatedValues.of(pooled.issued.values, pooled.person)
    counted = met(portions, pooled.issued.values, repeated)
    found: dict[int, TakenNumbers] = {}
    first = 0
    for table in pooled.issued.values:
        others = in_order(table)
        for number, part in enumerate(pooled.parts()):
            compared = _compared_with_issued(asked, part, others, counted, number * len(moved))
            _keep_taken(asked, part, compared, first, found)
        first += table.rows
    yield from (found[row] for row in sorted(found))


def _compared_with_issued(
    asked: AskedNumbers, part: PooledPart, others: OrderedValues, counted: Met, portion: int
) -> tuple[PairMatches, ...]:
    """Compare submissions with the right values of a table: exactly, and moved a little."""
    unknown, compared = ~part.explained, list[PairMatches]()
    for way, moved in enumerate(asked.chances.moved):
        sought = same_as_issued(part.numbers, moved)
        share = counted.share(portion + way, sought.some(unknown), _ITSELF)
        chance = chance_of(part, sought, share, asked.chances)
        compared.append(PairMatches(part, Matches.of(sought, unknown, others), chance))
    return tuple(compared)


def _keep_taken(
    asked: AskedNumbers,
    part: PooledPart,
    compared: Sequence[PairMatches],
    first: int,
    found: dict[int, TakenNumbers],
) -> None:
    """Keep the owners of a table whose variants submissions fit beyond chance.

    Args:
        asked: for what.
        part: numbers of the submissions.
        compared: every way in which they were compared.
        first: row of the table's first owner among all.
        found: by submission, what was found so far; it is added to.
    """
    pooled, owners = asked.pooled, asked.pooled.issued.owners
    pairs = either_likely(asked, compared)
    row, owner = np.divmod(pairs, compared[0].owners)
    other = pooled.person[first + owner] != pooled.submitter[part.first + row]
    row, owner, pairs = row[other], owner[other], pairs[other]
    each = np.stack([log_odds(one, pairs, asked.answers) for one in compared])
    logs = of_all(each)
    for place in np.flatnonzero(logs >= asked.least).tolist():
        submission, theirs = int(part.first + row[place]), first + int(owner[place])
        name = owners[theirs]
        before = found.get(submission)
        if before is None or logs[place] > before.best.log:
            nearest = compared[int(np.argmax(each[:, place]))]
            strongest = rests_on(nearest, int(pairs[place]))
            best = Likest(float(logs[place]), name, strongest, theirs)
            if before is None:
                before = found[submission] = TakenNumbers(pooled.students[submission], best)
            before.best = best
        before.owners.append(name)
