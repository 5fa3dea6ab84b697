"""Numbers are traced to the variant that they come from, at the precision that was typed."""

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from gripcourse.likeness.cells import SparseTable
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.trace import Clue, Origin, rank

ROWS = 200
QUANTITIES = ("force", "bore", "angle", "torque", "speed")
RNG = np.random.default_rng(3)
TABLE = RNG.lognormal([7, 4, 2, 3, 1], 0.6, (ROWS, 5))


def issued_of(table: NDArray[np.float64]) -> IssuedValues:
    return IssuedValues(
        owners=tuple(f"{row:03d}" for row in range(len(table))),
        quantities=QUANTITIES,
        values=[SparseTable.of_table(table)],
        kind=np.zeros(len(table), np.intp),
        families=np.arange(5)[None, :],
        discrete=np.zeros(5, bool),
    )


ISSUED = issued_of(TABLE)


def clue(value: float, *names: str) -> Clue:
    """A number typed with three figures."""
    typed = float(f"{value:.2e}")
    half = 10.0 ** (math.floor(math.log10(abs(typed))) - 2) / 2
    return Clue(f"{typed:g}", dict.fromkeys(names or QUANTITIES, (typed, half)))


def traced(owner: int, columns: tuple[int, ...]) -> tuple[Origin, ...]:
    return rank([clue(TABLE[owner, column]) for column in columns], ISSUED)


@pytest.mark.parametrize("owner", range(0, ROWS, 20))
def test_four_numbers_tell_whose_they_are(owner: int) -> None:
    first, *rest = traced(owner, (0, 1, 2, 3))
    assert first.owner == f"{owner:03d}"
    assert first.odds > 100
    assert all(one.odds < 1 for one in rest)
    assert [one.quantity for one in first.matches] == ["force", "bore", "angle", "torque"]


def test_more_numbers_give_larger_odds() -> None:
    odds = [traced(7, columns)[0].odds for columns in ((0, 1), (0, 1, 2), (0, 1, 2, 3))]
    assert odds == sorted(odds)


def test_a_number_whose_meaning_is_known_says_more() -> None:
    values = TABLE[7]
    unknown = rank([clue(values[0]), clue(values[1])], ISSUED)
    known = rank([clue(values[0], "force"), clue(values[1], "bore")], ISSUED)
    assert known[0].owner == "007"
    assert known[0].odds > unknown[0].odds


def test_one_misread_number_does_not_hide_the_origin() -> None:
    right = [clue(TABLE[7, column]) for column in range(5)]
    first = rank([*right, clue(123_456.0)], ISSUED)[0]
    assert first.owner == "007"
    assert first.odds > 10
    assert first.matches[-1].quantity == ""
    assert math.isnan(first.matches[-1].value)


def test_numbers_of_nobody_have_no_good_odds() -> None:
    assert rank([clue(123_456.0)], ISSUED) == ()
    strange = rank([clue(TABLE[7, 0]), clue(123_456.0), clue(234_567.0)], ISSUED)
    assert strange[0].odds < 1


def test_a_coarse_number_still_counts_with_three_figures() -> None:
    # 5 may stand for 5,00, not for 5,4
    close = Clue("5", dict.fromkeys(QUANTITIES, (5.0, 0.5)))
    for origin in rank([close], ISSUED):
        assert origin.matches[0].value == pytest.approx(5.0, abs=0.0101)


def test_zeros_and_empty_clues_lead_nowhere() -> None:
    assert rank([], ISSUED) == ()
    assert rank([Clue("0", dict.fromkeys(QUANTITIES, (0.0, 0.5))), Clue("x", {})], ISSUED) == ()


def test_another_version_of_the_same_person_speaks_against_nobody() -> None:
    twin = issued_of(np.vstack((TABLE, TABLE[7])))
    clues = [clue(TABLE[7, column]) for column in range(3)]
    alone = rank(clues, ISSUED)[0]
    strangers = rank(clues, twin)[:2]
    same = rank(clues, twin, {one.owner: "anna" for one in strangers})[:2]
    assert max(one.odds for one in strangers) <= 1
    assert all(one.odds == pytest.approx(alone.odds, rel=0.1) for one in same)
