"""The sheet of series and tables, as it is printed."""

import pytest

from gripcourse.workbook.series import page_breaks

PAGE = 100.0


@pytest.mark.parametrize(
    ("heights", "breaks"),
    [
        ([(0, 40.0), (3, 60.0)], []),
        ([(0, 40.0), (3, 61.0)], [3]),
        ([(0, 40.0), (3, 50.0), (8, 30.0), (11, 71.0)], [8, 11]),
        ([(0, 10.0), (3, 300.0), (30, 20.0)], [3, 30]),
        ([(0, 300.0)], []),
        ([], []),
    ],
)
def test_a_page_ends_before_a_table_that_it_has_no_room_for(
    heights: list[tuple[int, float]], breaks: list[int]
) -> None:
    assert page_breaks(heights, PAGE) == breaks
