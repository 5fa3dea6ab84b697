"""Evidence that a submission holds another student's numbers.

Each number of a submission is either the student's own or, with some probability, taken from one
certain other student. What is right, or follows from the student's own numbers, says nothing; a
recognised slip says as much as it is rare in the cohort; what nothing explains says as much as it
is unlikely to meet the other's number by chance. The odds of all numbers are multiplied, averaged
over how much may have been taken, and divided by the number of comparisons.
"""

import math
from collections import defaultdict
from collections.abc import Container, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, repeat

import numpy as np

from gripcourse.likeness.cells import Floats, Ints
from gripcourse.likeness.chance import CommonMistakes, chance_of, common_mistakes
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import (
    Matches,
    Met,
    OrderedValues,
    Sought,
    in_order,
    met,
    same_as_issued,
    same_as_typed,
)
from gripcourse.likeness.model import Chances, ComparedWork, Evidence, NumberKind
from gripcourse.likeness.odds import PairMatches, likely_pairs, log_odds, rests_on
from gripcourse.likeness.pool import ComparisonPool, PooledPart, PooledWorks, pool
from gripcourse.policy.model import LikenessRule

_LARGEST = 700.0  # logarithm of the largest odds that are told
_ITSELF = 1  # of those who have the same issued number, whom the number is about
_BOTH = 2  # of those who typed the same


def find_evidence(
    works: Iterable[ComparedWork],
    issued: IssuedValues,
    rule: LikenessRule,
    chances: Chances | None = None,
) -> tuple[Evidence, ...]:
    """Find what is alike beyond chance.

    Args:
        works: the submissions, each asked for once; several of one student are not compared with
            each other.
        issued: the right values of every issued variant; its owners are student ids.
        rule: from which odds on evidence is told.
        chances: what counts as coincidence.

    Returns:
        For each submission at most the other variant that fits it best, and all students whose
        answers are the same, by odds; then common authors.
    """
    known, authors = set(issued.owners), Authors()

    def usable() -> Iterator[ComparedWork]:
        for work in works:
            authors.add(work.student, work.creator)
            if work.student in known:
                yield work

    pooled = pool(usable(), issued)
    creators = tuple(same_creators(authors, rule))
    if rule.odds == 0 or not pooled.students:
        return creators
    asked = _Asked(pooled, rule, chances or Chances())
    taken = tuple(taken_from_issued(asked))
    pairs = {(one.student, owner) for one in taken for owner in one.owners}
    variants = [asked.evidence(NumberKind.OTHER_VARIANT, one.student, one.best) for one in taken]
    alike = same_answers(asked)
    return (*variants, *owners_of_copies(pairs, alike), *creators)


@dataclass(frozen=True, slots=True)
class _Asked:
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
        return math.log(max(1, submissions * (len(self.pooled.issued.owners) + submissions - 2)))

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
        return Evidence(kind, (student, *others), odds, likest[0].rests_on)


@dataclass(frozen=True, slots=True)
class Likest:
    """What a submission is like.

    Attributes:
        log: logarithm of the odds, before they are divided.
        owner: whose numbers they are.
        rests_on: quantities that the odds rest on, the strongest first; of the likest alone.
    """

    log: float
    owner: str
    rests_on: tuple[str, ...] = ()


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


def taken_from_issued(asked: _Asked) -> Iterator[TakenNumbers]:
    """Yield what submissions have in common with the right values of other students' variants."""
    pooled, moved = asked.pooled, asked.chances.moved

    def portions() -> Iterator[Sought]:
        return (
            same_as_issued(part.numbers, one).some(~part.explained)
            for part in pooled.parts()
            for one in moved
        )

    counted = met(portions, pooled.issued.values)
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
    asked: _Asked, part: PooledPart, others: OrderedValues, counted: Met, portion: int
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
    asked: _Asked,
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
    pairs = _likely(asked, compared)
    row, owner = np.divmod(pairs, compared[0].owners)
    other = first + owner != pooled.own[part.first + row]
    row, owner, pairs = row[other], owner[other], pairs[other]
    each = np.stack([log_odds(one, pairs, asked.answers) for one in compared])
    logs = _of_all(each)
    for place in np.flatnonzero(logs >= asked.least).tolist():
        submission, name = int(part.first + row[place]), owners[first + int(owner[place])]
        before = found.get(submission)
        if before is None or logs[place] > before.best.log:
            nearest = compared[int(np.argmax(each[:, place]))]
            best = Likest(float(logs[place]), name, rests_on(nearest, int(pairs[place])))
            if before is None:
                before = found[submission] = TakenNumbers(pooled.students[submission], best)
            before.best = best
        before.owners.append(name)


def owners_of_copies(
    pairs: Container[tuple[str, str]], alike: Iterable[Evidence]
) -> Iterator[Evidence]:
    """Tell who has the same answers as another, and whose own they are.

    Where the other's numbers are those of this student's variant, and not the other way round,
    this student is the owner and no suspect.

    Args:
        pairs: of a student and another one whose variant the student's numbers fit.
        alike: who has the same answers.
    """
    for one in alike:
        student, *others = one.students
        copies = [
            other for other in others if (other, student) in pairs and (student, other) not in pairs
        ]
        rest = [other for other in others if other not in copies]
        if copies:
            yield replace(one, kind=NumberKind.COPIED_FROM, students=(student, *copies))
        if rest:
            yield replace(one, students=(student, *rest))


def same_answers(asked: _Asked) -> Iterator[Evidence]:
    """Yield for each submission those in which the same numbers were typed beyond chance."""
    pooled, moved = asked.pooled, asked.chances.typed

    def portions() -> Iterator[Sought]:
        return (
            same_as_typed(part.numbers, one).some(~part.explained)
            for part in pooled.parts()
            for one in moved
        )

    counted = met(portions, (works.typed for works in pooled.works))
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
    asked: _Asked, works: PooledWorks, counted: Met, mistakes: CommonMistakes
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
    asked: _Asked, compared: Sequence[PairMatches], first: int, found: dict[int, list[Likest]]
) -> None:
    """Keep the submissions of a table that are like others beyond chance.

    Args:
        asked: for what.
        compared: every way in which they were compared.
        first: the table's first submission among all.
        found: by submission, what was found so far; it is added to.
    """
    pooled, part, owners = asked.pooled, compared[0].part, compared[0].owners
    pairs = _likely(asked, compared)
    row, other = np.divmod(pairs, owners)
    pairs = pairs[pooled.own[part.first + row] != pooled.own[first + other]]
    each = np.stack([log_odds(one, pairs, asked.answers) for one in compared])
    logs = _of_all(each)
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


def _likely(asked: _Asked, compared: Sequence[PairMatches]) -> Ints:
    """Return the pairs whose odds may be told after any of the comparisons."""
    found = [likely_pairs(one, asked.least, asked.answers) for one in compared]
    return np.asarray(np.unique(np.concatenate(found)))


def _of_all(each: Floats) -> Floats:
    """Return logarithms of odds over all comparisons, from those of each.

    Nobody knows beforehand whether numbers were moved: all comparisons count alike.
    """
    return np.asarray(np.logaddexp.reduce(each) - math.log(len(each)))


@dataclass(frozen=True, slots=True)
class Authors:
    """Whom workbooks name as their authors.

    Attributes:
        students: everybody whose workbook was looked at.
        named: by author, whatever the case of the letters, the students and the name as it is
            written in the first workbook of each.
    """

    students: set[str] = field(default_factory=set)
    named: dict[str, dict[str, str]] = field(default_factory=dict)

    def add(self, student: str, creator: str) -> None:
        """Take down whom a student's workbook names."""
        self.students.add(student)
        name = " ".join(creator.split())
        if name:
            self.named.setdefault(name.casefold(), {}).setdefault(student, name)


def same_creators(authors: Authors, rule: LikenessRule) -> Iterator[Evidence]:
    """Yield the few students whose workbooks name one author; many share a computer room."""
    everybody = len(authors.students)
    for same in authors.named.values():
        if 1 < len(same) <= rule.same_creator and len(same) < everybody:
            for student, name in same.items():
                others = (one for one in same if one != student)
                odds = everybody / len(same)
                yield Evidence(NumberKind.SAME_CREATOR, (student, *others), odds, (name,))
