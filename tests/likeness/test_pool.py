"""Numbers laid side by side in portions are the same numbers."""

import random

import numpy as np
import pytest

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
@pytest.mark.parametrize("together", [1, 6, 1000])
def test_it_does_not_matter_how_many_are_looked_into_together(
    issued: IssuedValues, at_once: int, together: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    chance = random.Random(7)  # noqa: S311 (not for secrets)
    works = [work(chance.choice(issued.owners), issued, chance) for _ in range(40)]
    whole = everything(pool(works, issued))
    monkeypatch.setattr("gripcourse.likeness.pool._AT_ONCE", at_once)
    monkeypatch.setattr("gripcourse.likeness.pool._TOGETHER", together)
    parts = pool(works, issued)
    assert parts.students == tuple(one.student for one in works)
    assert whole == everything(parts)


def test_a_slip_is_as_common_as_the_students_who_made_it(issued: IssuedValues) -> None:
    """Forty works of three students say no more than three students."""
    chance = random.Random(3)  # noqa: S311 (not for secrets)
    works = [work(chance.choice(issued.owners), issued, chance) for _ in range(40)]
    pooled = pool(works, issued)
    made, answered = dict[int, set[str]](), dict[int, set[str]]()
    quantity = dict[int, int]()
    for one in pooled.parts():
        numbers = one.numbers
        of_each = (numbers.row.tolist(), numbers.column.tolist(), one.slip.tolist())
        for row, column, slip in zip(*of_each, strict=True):
            student = pooled.students[one.first + row]
            answered.setdefault(column, set()).add(student)
            made.setdefault(slip, set()).add(student)
            quantity[slip] = column
    assert len(pooled.common) > 20
    for slip, common in enumerate(pooled.common.tolist()):
        # Of a quantity twice the last counts: a slip of the first may be nobody's.
        if slip in made:
            assert common == len(made[slip]) / len(answered[quantity[slip]])


def everything(pooled: ComparisonPool) -> list[tuple[object, ...]]:
    """All that is known of each number of a cohort."""
    return [
        (one.first + row, *rest, pooled.common[slip] if slip >= 0 else None)
        for one in pooled.parts()
        for row, *rest, slip in zip(
            *(one.numbers.row.tolist(), one.numbers.column.tolist(), one.numbers.value.tolist()),
            *(one.numbers.unit.tolist(), np.nan_to_num(one.right).tolist()),
            *(one.explained.tolist(), one.slip.tolist()),
            strict=True,
        )
    ]


def test_of_several_numbers_of_one_quantity_the_last_counts(issued: IssuedValues) -> None:
    name = issued.quantities[0]
    typed = [Typed(name, value, 0.5, explained=False, slip=None) for value in (2.0, 5.0, 3.0)]
    pooled = pool([ComparedWork(issued.owners[0], TypedNumbers.of(typed), "")], issued)
    [found] = pooled.works
    assert found.typed.value.tolist() == [3.0]


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
    [found] = pooled.works
    assert found.typed.value.tolist() == [4.0, 5.0, 5.0, 4.0]
    assert found.typed.place[0].tolist() == [0, 0, 0, 1]
