"""Numbers laid side by side in portions are the same numbers."""

import random
from typing import Any

import pytest
from numpy.typing import NDArray

from gripcourse.course.model import Course
from gripcourse.likeness.issued import IssuedValues, issued_values
from gripcourse.likeness.model import ComparedWork
from gripcourse.likeness.pool import ComparisonPool, pool
from gripcourse.likeness.typed_numbers import Typed, TypedNumbers
from gripcourse.machine.resources import course_root
from gripcourse.slips.model import SlipId
from gripcourse.variants.table import read_table

SLIPS = (None, None, SlipId("factor", "2"), SlipId("factor", "3"))
NUMBERS = (0.0, -0.0, 1.5, 1.5, 2.0, -3.25, float("nan"), float("inf"))


@pytest.fixture(scope="module")
def issued(course: Course) -> IssuedValues:
    drawn = read_table(course_root() / "variants" / "tables" / "main.csv", course)[:3]
    return issued_values(course, [(one.id, one) for one in drawn])


def work(student: str, issued: IssuedValues, chance: random.Random) -> ComparedWork:
    """A work of any numbers: of no quantity, of one twice, and some that fill cells."""
    names = chance.sample(list(issued.columns), chance.randint(0, 25))
    typed = [
        Typed(
            quantity=name,
            value=chance.choice((*NUMBERS, chance.lognormvariate(0, 3))),
            half_unit=chance.choice((0.0, 0.05, 0.5)),
            explained=chance.random() < 0.3,
            slip=chance.choice(SLIPS),
        )
        for name in (*names, *names[:1], "nobodys")
    ]
    return ComparedWork(student, TypedNumbers.of(typed), "")


@pytest.mark.parametrize("at_once", [1, 2, 7])
def test_it_does_not_matter_how_many_are_looked_into_together(
    issued: IssuedValues, at_once: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    chance = random.Random(7)  # noqa: S311 (not for secrets)
    works = [work(chance.choice(issued.owners), issued, chance) for _ in range(40)]
    whole = pool(works, issued)
    monkeypatch.setattr("gripcourse.likeness.pool._AT_ONCE", at_once)
    parts = pool(works, issued)
    assert whole.students == parts.students == tuple(one.student for one in works)
    for one, other in zip(everything(whole), everything(parts), strict=True):
        assert one.tobytes() == other.tobytes()


def everything(pooled: ComparisonPool) -> list[NDArray[Any]]:
    """All that is known of the numbers of a cohort."""
    part = pooled.part(slice(0, len(pooled.explained)))
    numbers = part.numbers
    return [
        *(numbers.row, numbers.column, numbers.value, numbers.unit),
        *(pooled.own, part.explained, part.slip, pooled.common),
    ]


def test_a_part_is_what_the_whole_says_of_it(issued: IssuedValues) -> None:
    chance = random.Random(8)  # noqa: S311 (not for secrets)
    pooled = pool([work(issued.owners[0], issued, chance) for _ in range(20)], issued)
    count = len(pooled.explained)
    whole = pooled.part(slice(0, count))
    for begin in range(0, count, 7):
        which = slice(begin, min(begin + 7, count))
        part = pooled.part(which)
        assert part.slip.tolist() == whole.slip[which].tolist()
        assert part.explained.tolist() == whole.explained[which].tolist()
        for name in ("row", "column", "value", "unit"):
            mine, theirs = (getattr(one.numbers, name) for one in (part, whole))
            assert mine.tolist() == theirs[which].tolist()


def test_of_several_numbers_of_one_quantity_the_last_counts(issued: IssuedValues) -> None:
    name = issued.quantities[0]
    typed = [Typed(name, value, 0.5, explained=False, slip=None) for value in (2.0, 5.0, 3.0)]
    pooled = pool([ComparedWork(issued.owners[0], TypedNumbers.of(typed), "")], issued)
    assert pooled.typed.value.tolist() == [3.0]


def test_noughts_unknown_quantities_and_what_fills_cells_say_nothing(issued: IssuedValues) -> None:
    names = list(issued.columns)[:8]
    values = (0.0, 4.0, 4.0, 4.0, 4.0, 5.0, 5.0, float("inf"))
    told = (False, False, False, False, True, False, False, False)
    typed = [Typed(*one, None) for one in zip(names, values, (0.5,) * 8, told, strict=True)]
    other = Typed(names[0], 4.0, 0.5, explained=False, slip=None)
    works = [
        ComparedWork(issued.owners[0], TypedNumbers.of(typed), ""),
        ComparedWork(issued.owners[1], TypedNumbers.of([other]), ""),
        ComparedWork(issued.owners[2], TypedNumbers.of(()), ""),
    ]
    pooled = pool(works, issued)
    # Three wrong fours of one student fill cells; a right one and another student's do not.
    assert pooled.typed.value.tolist() == [4.0, 5.0, 5.0, 4.0]
    assert pooled.typed.place[0].tolist() == [0, 0, 0, 1]
