"""What a number is taken for, and how likely each is."""

import pytest

from gripcourse.grading.misreading import ANYTHING, misreadings, neighbours


@pytest.mark.parametrize(
    ("right", "taken", "how"),
    [
        (0.87, 0.78, "exchanged"),
        (45.0, 46.0, "another digit"),
        (205.0, 25.0, "lost"),
        (20.0, 0.0, "all but a zero lost"),
        (70.0, 770.0, "doubled"),
        (0.6, 6.0, "decimal sign"),
        (-12.5, -15.2, "exchanged"),
        (1.2e-7, 2.1e-7, "a small number is read as it is written"),
    ],
)
def test_a_number_is_taken_for_what_looks_like_it(right: float, taken: float, how: str) -> None:
    met = [share for number, share in misreadings(right).items() if number == pytest.approx(taken)]
    assert met, how
    assert all(0 < one < 1 for one in met)


def test_shares_leave_room_for_any_number() -> None:
    for right in (0.5, 45.0, 123.456, -7.0):
        found = misreadings(right, rows=(3.0,), alike=(9.0, 11.0))
        assert right not in found
        assert sum(found.values()) <= 1 - ANYTHING + 1e-9


def test_the_rows_above_and_below_are_told_from_others_of_the_unit() -> None:
    numbers = {"a": (1.0, "mm"), "b": (2.0, "N"), "c": (3.0, "mm"), "d": (4.0, "mm")}
    assert neighbours(numbers, "c") == ([4.0], [1.0])
    assert neighbours(numbers, "b") == ([], [])
    assert neighbours(numbers, "none") == ([], [])
