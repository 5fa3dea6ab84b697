"""What mistakes make of formulas and of digits."""

import ast

import numpy as np
import pytest

from gripcourse.simulation.foreign.distort import distorted, wrong_digits
from gripcourse.simulation.foreign.kinds import MISTAKES, ForeignMistake
from gripcourse.simulation.foreign.practical import parsed

BORE = "sqrt(4*drive_force/(pi*supply_pressure*cylinder_efficiency))"


def made(text: str, kind: ForeignMistake, known: frozenset[str] = frozenset()) -> set[str]:
    return {ast.unparse(one) for one in distorted(parsed(text), kind, known, known)}


@pytest.mark.parametrize(
    ("text", "kind", "wrong"),
    [
        (BORE, ForeignMistake.EFFICIENCY, "sqrt(4 * drive_force / (pi * supply_pressure * 1))"),
        (
            BORE,
            ForeignMistake.POWER,
            "4 * drive_force / (pi * supply_pressure * cylinder_efficiency)",
        ),
        ("a*cos(b)", ForeignMistake.FUNCTION, "a * sin(b)"),
        ("a*cos(b)", ForeignMistake.DEGREES, "a * cos(b * 57.29577951308232)"),
        ("a + b", ForeignMistake.SIGN, "a - b"),
        ("2*a", ForeignMistake.FACTOR, "a"),
        ("pi*diameter**2", ForeignMistake.RADIUS, "pi * (diameter * 0.5) ** 2"),
        ("max(a, b)", ForeignMistake.MEAN, "mean(a, b)"),
        ("a + atan(b/c)", ForeignMistake.RATIO, "a + b / c * 0.017453292519943295"),
        ("a*(b + c)", ForeignMistake.BRACKETS, "a * b + c"),
        ("cos(b)/(c*(d + e))", ForeignMistake.BRACKETS, "cos(b) / c * (d + e)"),
        ("lookup('t.c', d)", ForeignMistake.TABLE_ROW, "lookup_row_after('t.c', d)"),
    ],
)
def test_a_mistake_changes_one_place(text: str, kind: ForeignMistake, wrong: str) -> None:
    assert wrong in made(text, kind)


def test_the_other_end_is_taken_only_where_it_is_known() -> None:
    assert made("a*angle_at_min", ForeignMistake.RANGE_END) == set()
    known = frozenset({"angle_at_max"})
    assert made("a*angle_at_min", ForeignMistake.RANGE_END, known) == {"a * angle_at_max"}


def test_no_digits_come_out_right(rng: np.random.Generator) -> None:
    wrong = {wrong_digits(125.0, rng) for _ in range(200)}
    assert {215.0, 152.0, 25.0} <= wrong
    assert all(one >= 0 for one in wrong)


def test_every_kind_says_where_it_comes_from() -> None:
    assert set(MISTAKES) == set(ForeignMistake)
    assert all(one.weight > 0 and "own estimate" in one.source for one in MISTAKES.values())


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(5)
