"""Evidence that a submission holds another student's numbers.

Each number of a submission is either the student's own or, with some probability, taken from one
certain other student. What is right, or follows from the student's own numbers, says nothing; a
recognised slip says as much as it is rare in the cohort; what nothing explains says as much as it
is unlikely to meet the other's number by chance. The odds of all numbers are multiplied, averaged
over how much may have been taken, and divided by the number of comparisons.
"""

from collections.abc import Container, Iterable, Iterator
from dataclasses import dataclass, field, replace

from gripcourse.likeness.alike import same_answers
from gripcourse.likeness.asked import AskedNumbers
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.model import Chances, ComparedWork, Evidence, NumberKind
from gripcourse.likeness.pool import pool
from gripcourse.likeness.taken import taken_from_issued
from gripcourse.policy.model import LikenessRule


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
        issued: the right values of every issued variant; its owners are student ids, of which one
            has a row for each version that was issued.
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

    chances = chances or Chances()
    pooled = pool(usable(), issued, max(chances.moved))
    creators = tuple(same_creators(authors, rule))
    if rule.odds == 0 or not pooled.students:
        return creators
    asked = AskedNumbers(pooled, rule, chances)
    taken = tuple(taken_from_issued(asked))
    pairs = {(one.student, owner) for one in taken for owner in one.owners}
    variants = [asked.evidence(NumberKind.OTHER_VARIANT, one.student, one.best) for one in taken]
    alike = same_answers(asked)
    return (*variants, *owners_of_copies(pairs, alike), *creators)


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
