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
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

import numpy as np

from gripcourse.likeness.cells import Floats, Ints
from gripcourse.likeness.chance import SharedMethods, chance_of, common_mistakes
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import OrderedValues, in_order, same_as_issued, same_as_typed
from gripcourse.likeness.model import Chances, ComparedWork, Evidence, NumberKind
from gripcourse.likeness.odds import PairMatches, likely_pairs, log_odds, rests_on
from gripcourse.likeness.pool import ComparisonPool, PooledPart, pool
from gripcourse.likeness.typed_numbers import none_typed
from gripcourse.policy.model import LikenessRule

_LARGEST = 700.0  # logarithm of the largest odds that are told
_AT_ONCE: Final = 100  # submissions: what comparing needs besides the numbers is room for these


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
    known = set(issued.owners)
    named: list[ComparedWork] = []
    nothing = none_typed()

    def usable() -> Iterator[ComparedWork]:
        for work in works:
            named.append(replace(work, numbers=nothing))
            if work.student in known:
                yield work

    pooled = pool(usable(), issued)
    creators = tuple(same_creators(named, rule))
    if rule.odds == 0 or not pooled.students:
        return creators
    chosen = chances or Chances()
    variants, pairs = _of_issued(pooled, rule, chosen)
    alike = _of_typed(pooled, rule, chosen)
    return (*variants, *owners_of_copies(pairs, alike), *creators)


def _of_issued(
    pooled: ComparisonPool, rule: LikenessRule, chances: Chances
) -> tuple[list[Evidence], set[tuple[str, str]]]:
    """Find the other variants that submissions fit, and all pairs of a student and an owner."""
    ordered = in_order(pooled.issued.values)
    found: list[Evidence] = []
    pairs: set[tuple[str, str]] = set()
    for part in _parts(pooled):
        taken = taken_from_issued(part, ordered, rule, chances)
        found += other_variants(pooled, taken)
        pairs |= {
            (pooled.students[row], pooled.issued.owners[owner])
            for row, owner in zip(taken.row, taken.owner, strict=True)
        }
    return found, pairs


def _of_typed(pooled: ComparisonPool, rule: LikenessRule, chances: Chances) -> list[Evidence]:
    """Find the submissions in which the same numbers were typed."""
    ordered = in_order(pooled.typed)
    mistakes = common_mistakes(pooled, ordered, chances)
    return [
        one
        for part in _parts(pooled)
        for one in same_answers(part, ordered, mistakes.part(part), rule, chances)
    ]


def _parts(pooled: ComparisonPool) -> Iterator[PooledPart]:
    """Part the numbers into those of so many submissions as there is room to compare at a time."""
    key, columns = pooled.typed.key, pooled.typed.columns
    rows = np.array([*range(0, len(pooled.students), _AT_ONCE), len(pooled.students)])
    begins = np.searchsorted(key, (rows * columns).astype(key.dtype))
    yield from (pooled.part(slice(begin, end)) for begin, end in pairwise(begins.tolist()))


@dataclass(frozen=True, slots=True)
class TakenNumbers:
    """The submissions that fit another student's variant beyond chance.

    Attributes:
        compared: how they were compared: exactly, and moved a little.
        row, owner: of each pair, by submission.
        each: (comparisons, pairs); logarithms of the odds.
        logs: (pairs,); over all comparisons.
    """

    compared: tuple[PairMatches, ...]
    row: Ints
    owner: Ints
    each: Floats
    logs: Floats


def taken_from_issued(
    part: PooledPart, issued: OrderedValues, rule: LikenessRule, chances: Chances
) -> TakenNumbers:
    """Compare submissions with the right values of all other students' variants."""
    pooled, wrong = part.pooled, ~part.explained
    least, answers = _least(pooled, rule), max(rule.answers, 1)
    found = [same_as_issued(part.numbers, wrong, issued, moved) for moved in chances.moved]
    compared = tuple(PairMatches(part, one, chance_of(part, one, chances)) for one in found)
    likely = [likely_pairs(one, least, answers) for one in compared]
    pairs = np.unique(np.concatenate(likely))
    row, owner = np.divmod(pairs, len(pooled.issued.owners))
    other = owner != pooled.own[row]
    each = np.stack([log_odds(one, pairs[other], answers) for one in compared])
    logs = _of_all(each)
    told = logs >= least
    return TakenNumbers(compared, row[other][told], owner[other][told], each[:, told], logs[told])


def other_variants(pooled: ComparisonPool, taken: TakenNumbers) -> Iterator[Evidence]:
    """Yield for each submission the variant of another student that it fits beyond chance."""
    for row in np.unique(taken.row):
        mine = np.flatnonzero(taken.row == row)
        best = int(mine[np.argmax(taken.logs[mine])])
        owner = int(taken.owner[best])
        nearest = taken.compared[int(np.argmax(taken.each[:, best]))]
        names = rests_on(nearest, int(row) * nearest.owners + owner)
        students = (pooled.students[row], pooled.issued.owners[owner])
        odds = _odds(pooled, float(taken.logs[best]))
        yield Evidence(NumberKind.OTHER_VARIANT, students, odds, names)


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


def same_answers(
    part: PooledPart,
    typed: OrderedValues,
    methods: SharedMethods,
    rule: LikenessRule,
    chances: Chances,
) -> Iterator[Evidence]:
    """Yield for each submission those in which the same numbers were typed beyond chance."""
    pooled = part.pooled
    least, answers = _least(pooled, rule), max(rule.answers, 1)
    wrong = ~part.explained
    found = [same_as_typed(part.numbers, wrong, typed, moved) for moved in chances.typed]
    compared = [PairMatches(part, one, chance_of(part, one, chances), methods) for one in found]
    likely = [likely_pairs(one, least, answers) for one in compared]
    pairs = np.unique(np.concatenate(likely))
    row, other = np.divmod(pairs, len(pooled.students))
    pairs = pairs[pooled.own[row] != pooled.own[other]]
    each = np.stack([log_odds(one, pairs, answers) for one in compared])
    logs = _of_all(each)
    pairs, each, logs = pairs[logs >= least], each[:, logs >= least], logs[logs >= least]
    row, other = np.divmod(pairs, len(pooled.students))
    for one in np.unique(row):
        mine = np.flatnonzero(row == one)
        strongest = mine[np.argsort(-logs[mine], kind="stable")]
        others = dict.fromkeys(pooled.students[place] for place in other[strongest])
        best = int(strongest[0])
        nearest = compared[int(np.argmax(each[:, best]))]
        names = rests_on(nearest, int(pairs[best]))
        odds = _odds(pooled, float(logs[best]))
        yield Evidence(NumberKind.SAME_ANSWERS, (pooled.students[one], *others), odds, names)


def _of_all(each: Floats) -> Floats:
    """Return logarithms of odds over all comparisons, from those of each.

    Nobody knows beforehand whether numbers were moved: all comparisons count alike.
    """
    return np.asarray(np.logaddexp.reduce(each) - math.log(len(each)))


def same_creators(works: Sequence[ComparedWork], rule: LikenessRule) -> Iterator[Evidence]:
    """Yield the few students whose workbooks name one author; many share a computer room."""
    students: dict[str, dict[str, str]] = defaultdict(dict)
    for work in works:
        name = " ".join(work.creator.split())
        if name:
            students[name.casefold()].setdefault(work.student, name)
    everybody = len({work.student for work in works})
    for same in students.values():
        if 1 < len(same) <= rule.same_creator and len(same) < everybody:
            for student, name in same.items():
                others = (one for one in same if one != student)
                odds = everybody / len(same)
                yield Evidence(NumberKind.SAME_CREATOR, (student, *others), odds, (name,))


def _odds(pooled: ComparisonPool, log: float) -> float:
    return math.exp(min(log - _comparisons(pooled), _LARGEST))


def _least(pooled: ComparisonPool, rule: LikenessRule) -> float:
    """Return the logarithm of the odds that are told, before they are divided."""
    return math.log(rule.odds) + _comparisons(pooled)


def _comparisons(pooled: ComparisonPool) -> float:
    """Return the logarithm of how many variants and submissions were compared with submissions."""
    submissions = len(pooled.students)
    return math.log(max(1, submissions * (len(pooled.issued.owners) + submissions - 2)))
