"""Two columns: read down the first, then the second, of about one height."""

from types import SimpleNamespace

import pytest

from gripcourse.documents.two_columns import groups, two_columns


def rows(*lengths: int) -> list[SimpleNamespace]:
    return [SimpleNamespace(text="x" * length) for length in lengths]


@pytest.mark.parametrize(
    ("lengths", "first"),
    [((), 0), ((9,), 1), ((9, 9), 1), ((9, 9, 9), 2), ((500, 9, 9, 9), 1), ((9, 9, 9, 500), 3)],
)
def test_the_higher_column_is_as_low_as_it_can_be(lengths: tuple[int, ...], first: int) -> None:
    every = rows(*lengths)
    left, right = two_columns(every, "text")
    assert [*left, *right] == every
    assert len(left) == first


def test_groups_keep_the_order_and_none_is_higher_than_a_part_of_a_page() -> None:
    for count in range(1, 40):
        every = rows(*(30 + 45 * (number % 4) for number in range(count)))
        parted = groups(every, "text")
        assert [row for group in parted for row in group] == every
        assert all(sum(len(row.text) for row in group) < 1000 for group in parted)


def test_groups_part_where_both_columns_come_out_even() -> None:
    """One long row stands beside three short ones rather than beside nothing."""
    every = rows(*([200, 9, 9, 9, 9] * 3))
    assert [len(group) for group in groups(every, "text")] == [5, 5, 5]
