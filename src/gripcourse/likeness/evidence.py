"""Evidence that a submission holds another student's numbers.

Each number of a submission is either the student's own or, with some probability, taken from one
certain other student. What is right, or follows from the student's own numbers, says nothing; a
recognised slip says as much as it is rare in the cohort; what nothing explains says as much as it
is unlikely to meet the other's number by chance. The odds of all numbers are multiplied, averaged
over how much may have been taken, and divided by the number of comparisons.
"""

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.matches import Floats, same_as_issued, same_as_typed
from gripcourse.likeness.model import Chances, ComparedWork, Evidence, NumberKind
from gripcourse.likeness.odds import Compared, compare, rests_on
from gripcourse.likeness.pool import ComparisonPool, chance_of, pool, where_right_is_shared
from gripcourse.policy.model import LikenessRule

_LARGEST = 700.0  # logarithm of the largest odds that are told


def find_evidence(
    works: Sequence[ComparedWork],
    issued: IssuedValues,
    rule: LikenessRule,
    chances: Chances | None = None,
) -> tuple[Evidence, ...]:
    """Find what is alike beyond chance.

    Args:
        works: the submissions; several of one student are not compared with each other.
        issued: the right values of every issued variant; its owners are student ids.
        rule: from which odds on evidence is told.
        chances: what counts as coincidence.

    Returns:
        For each submission at most the other variant that fits it best, and all students whose
        answers are the same, by odds; then common authors.
    """
    known = set(issued.owners)
    usable = [work for work in works if work.student in known]
    creators = tuple(same_creators(works, rule))
    if rule.odds == 0 or not usable:
        return creators
    pooled = pool(usable, issued)
    chosen = chances or Chances()
    fits = _fits(pooled, rule, chosen)
    alike = tuple(same_answers(pooled, rule, chosen))
    return (
        *other_variants(pooled, rule, fits),
        *owners_of_copies(pooled, rule, fits, alike),
        *creators,
    )


@dataclass(frozen=True, slots=True)
class _Fit:
    """How well each submission fits each other student's variant: exactly, and moved a little.

    Attributes:
        found: the comparisons of each reach.
        logs: (submissions, owners); of the odds over both; −∞ for a student's own variant.
    """

    found: tuple[Compared, ...]
    logs: Floats


def _fits(pooled: ComparisonPool, rule: LikenessRule, chances: Chances) -> _Fit:
    found = []
    present = np.isfinite(pooled.issued.values)
    for moved in chances.moved:
        hits = same_as_issued(pooled.numbers, pooled.issued.values, moved)
        chance = chance_of(pooled, hits, chances)
        found.append(compare(pooled, hits, chance, present, rule.answers))
    # Nobody knows beforehand whether numbers were moved: both count alike.
    logs = np.logaddexp.reduce([one.logs for one in found]) - math.log(len(found))
    logs[np.arange(len(logs)), pooled.own] = -np.inf
    return _Fit(tuple(found), logs)


def other_variants(pooled: ComparisonPool, rule: LikenessRule, fits: _Fit) -> Iterator[Evidence]:
    """Yield for each submission the variant of another student that it fits beyond chance."""
    best = np.argmax(fits.logs, axis=1)
    for row in np.flatnonzero(np.max(fits.logs, axis=1) >= _least(pooled, rule)):
        students = (pooled.students[row], pooled.issued.owners[best[row]])
        nearest = max(fits.found, key=lambda one: float(one.logs[row, best[row]]))
        names = rests_on(pooled, nearest, int(row), int(best[row]))
        odds = _odds(pooled, float(fits.logs[row, best[row]]))
        yield Evidence(NumberKind.OTHER_VARIANT, students, odds, names)


def owners_of_copies(
    pooled: ComparisonPool, rule: LikenessRule, fits: _Fit, alike: Iterable[Evidence]
) -> Iterator[Evidence]:
    """Tell who has the same answers as another, and whose own they are.

    Where the other's numbers are those of this student's variant, and not the other way round,
    this student is the owner and no suspect.
    """
    told = np.argwhere(fits.logs >= _least(pooled, rule))
    taken = {(pooled.students[row], pooled.issued.owners[owner]) for row, owner in told}
    for one in alike:
        student, *others = one.students
        copies = [
            other for other in others if (other, student) in taken and (student, other) not in taken
        ]
        rest = [other for other in others if other not in copies]
        if copies:
            yield replace(one, kind=NumberKind.COPIED_FROM, students=(student, *copies))
        if rest:
            yield replace(one, students=(student, *rest))


def same_answers(
    pooled: ComparisonPool, rule: LikenessRule, chances: Chances
) -> Iterator[Evidence]:
    """Yield for each submission those in which the same numbers were typed beyond chance."""
    numbers = pooled.numbers
    present = np.zeros((len(pooled.students), len(pooled.issued.quantities)), dtype=np.bool_)
    present[numbers.row, numbers.column] = True
    hits = same_as_typed(numbers, *present.shape)
    alone = chance_of(pooled, hits, chances)
    # What is explained stays so, whoever else has it.
    chance = np.maximum(alone, where_right_is_shared(pooled, hits, chances))
    found = compare(pooled, hits, chance, present, rule.answers)
    students = np.array(pooled.students)
    logs = np.where(students[:, None] == students[None, :], -np.inf, found.logs)
    for row in np.flatnonzero(np.max(logs, axis=1) >= _least(pooled, rule)):
        told = np.flatnonzero(logs[row] >= _least(pooled, rule))
        strongest = told[np.argsort(-logs[row, told], kind="stable")]
        others = dict.fromkeys(pooled.students[one] for one in strongest)
        names = rests_on(pooled, found, int(row), int(strongest[0]))
        odds = _odds(pooled, float(logs[row, strongest[0]]))
        yield Evidence(NumberKind.SAME_ANSWERS, (pooled.students[row], *others), odds, names)


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
