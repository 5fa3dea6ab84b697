"""Which attempts and marks are new, and the numbers that they get. Pure."""

from collections.abc import Collection, Container, Sequence
from dataclasses import replace

from gripcourse.gradebook.model import Attempt, Mark, says_the_same


def new_attempts(
    attempts: Sequence[Attempt], known: Sequence[Attempt], undone: Collection[int]
) -> tuple[Attempt, ...]:
    """Number the attempts that differ from what stands for the same bytes.

    Args:
        attempts: as they were graded.
        known: all attempts of their students.
        undone: numbers of the regrades that were taken back.
    """
    last: dict[str, int] = {}
    last_of_bytes: dict[tuple[str, str], Attempt] = {}
    for one in known:
        last[one.student] = max(last.get(one.student, 0), one.number)
        if one.regrade not in undone:
            last_of_bytes[one.student, one.digest] = one
    fresh: list[Attempt] = []
    for one in attempts:
        before = last_of_bytes.get((one.student, one.digest))
        if before is not None and says_the_same(before, one):
            continue
        last[one.student] = last.get(one.student, 0) + 1
        fresh.append(replace(one, number=last[one.student]))
        last_of_bytes[one.student, one.digest] = fresh[-1]
    return tuple(fresh)


def new_marks(
    marks: Sequence[Mark], known: Sequence[Mark], disputed: Container[tuple[str, str]]
) -> tuple[Mark, ...]:
    """Number the marks that differ from the one that counts.

    Args:
        marks: as they were entered.
        known: all marks of their students, as they were kept.
        disputed: student and quantity of what has several marks: there the same one once more
            says which of them counts.
    """
    counting: dict[tuple[str, str], Mark] = {}
    for one in known:
        before = counting.get((one.student, one.quantity))
        if before is None or before.number < one.number:
            counting[one.student, one.quantity] = one
    fresh: list[Mark] = []
    for one in marks:
        before = counting.get((one.student, one.quantity))
        number = before.number if before else 0
        same = before is not None and replace(one, number=number, marked_at=before.marked_at)
        if same == before and (one.student, one.quantity) not in disputed:
            continue
        fresh.append(replace(one, number=number + 1))
        counting[one.student, one.quantity] = fresh[-1]
    return tuple(fresh)
