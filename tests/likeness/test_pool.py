"""Numbers laid side by side in portions are the same numbers."""

import random

import pytest

from gripcourse.course.model import Course
from gripcourse.likeness.issued import IssuedValues, issued_values
from gripcourse.likeness.model import ComparedWork
from gripcourse.likeness.pool import pool
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
    for one, other in (
        *((getattr(whole.numbers, name), getattr(parts.numbers, name))
          for name in ("row", "column", "value", "unit")),
        *((getattr(whole, name), getattr(parts, name))
          for name in ("own", "explained", "slip", "common")),
    ):  # fmt: skip
        assert one.tobytes() == other.tobytes()


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
    assert pooled.numbers.value.tolist() == [4.0, 5.0, 5.0, 4.0]
    assert pooled.numbers.row.tolist() == [0, 0, 0, 1]
