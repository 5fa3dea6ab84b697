"""Which attempts and marks are new, and the numbers that they get. Pure."""

from collections.abc import Collection, Container, Iterable, Mapping, Sequence
from dataclasses import replace

from gripcourse.gradebook.model import Attempt, Mark, says_the_same


def new_attempts(
    attempts: Sequence[Attempt], known: Sequence[Attempt], undone: Collection[int]
) -> tuple[Attempt, ...]:
    """Number the attempts that differ from what stands for the same bytes.

    Args:
        attempts: as they were graded.
        known: all attempts of their students, under whatever id they are kept.
        undone: numbers of the regrades that were taken back.
    """
    last: dict[str, int] = {}
    last_of_bytes: dict[tuple[str, str], Attempt] = {}
    for one in known:
        kept_under, number = one.key
        last[kept_under] = max(last.get(kept_under, 0), number)
        if one.regrade not in undone and not one.outranked:
            last_of_bytes[one.student, one.digest] = one
    fresh: list[Attempt] = []
    for one in attempts:
        before = last_of_bytes.get((one.student, one.digest))
        if before is not None and says_the_same(before, one):
            continue
        # A work stays under the id under which it is known.
        placed = one if before is None else replace(one, kept_as=before.kept_as)
        kept_under, _ = placed.key
        last[kept_under] = last.get(kept_under, 0) + 1
        fresh.append(replace(placed, number=last[kept_under]))
        last_of_bytes[one.student, one.digest] = fresh[-1]
    return tuple(fresh)


def new_marks(
    marks: Sequence[Mark],
    known: Iterable[Mark],
    counting: Mapping[tuple[str, str], Mark],
    disputed: Container[tuple[str, str]],
) -> tuple[Mark, ...]:
    """Number the marks that differ from the one that counts.

    Args:
        marks: as they were entered.
        known: all marks that are kept under the same ids.
        counting: by student and quantity, the mark that counts.
        disputed: student and quantity of what has several marks: there the same one once more
            says which of them counts.
    """
    numbers: dict[tuple[str, str], int] = {}
    for one in known:
        key = one.kept_under, one.quantity
        numbers[key] = max(numbers.get(key, 0), one.number)
    last = dict(counting)
    fresh: list[Mark] = []
    for one in marks:
        item, key = (one.student, one.quantity), (one.kept_under, one.quantity)
        before = last.get(item)
        if before is not None and item not in disputed and _says_the_same(before, one):
            continue
        numbers[key] = numbers.get(key, 0) + 1
        fresh.append(replace(one, number=numbers[key]))
        last[item] = fresh[-1]
    return tuple(fresh)


def _says_the_same(before: Mark, one: Mark) -> bool:
    return replace(one, number=before.number, marked_at=before.marked_at) == before
