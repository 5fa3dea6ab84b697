"""Straight lines and boxes on paper: what runs through what."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.drawing.paper.strokes import (
    Arc,
    Box,
    Line,
    covered,
    on_circle,
    outside,
    reach_of,
    runs_over,
    runs_through,
)

BOX = Box(0.0, 0.0, 4.0, 2.0)
PLACES = st.integers(-8, 24).map(lambda quarters: quarters / 4)
POINTS = st.tuples(PLACES, PLACES)


LINES = st.tuples(POINTS, POINTS).filter(lambda ends: ends[0] != ends[1])


@given(LINES.map(lambda ends: Line(*ends)))
def test_a_line_runs_through_a_box_that_covers_a_piece_of_it(line: Line) -> None:
    pieces = [piece for piece in covered(line, BOX.corners) if reach_of(piece).overlaps(BOX)]
    assert runs_through(line, [BOX]) == bool(pieces)


@pytest.mark.parametrize(
    "line",
    [
        Line((-1.0, 0.0), (5.0, 0.0)),
        Line((4.0, -1.0), (4.0, 3.0)),
        Line((-1.0, 1.0), (1.0, -1.0)),
        Line((0.0, 2.0), (-3.0, 4.0)),
    ],
    ids=["along an edge", "along another", "over a corner", "from a corner"],
)
def test_a_line_that_only_touches_a_box_does_not_run_through_it(line: Line) -> None:
    assert not runs_through(line, [BOX])


def test_a_line_runs_through_boxes_where_it_runs_through_one_of_them() -> None:
    line = Line((-1.0, 1.0), (5.0, 1.0))
    assert not runs_through(line, [])
    assert runs_through(line, [BOX.moved((0.0, 5.0)), BOX])


def test_a_plate_whose_corners_lie_on_a_circle_covers_half_of_it() -> None:
    """Rounding puts such corners a little beside the circle, in each direction differently."""
    circle = Arc((31.7, 12.3), 4.0)
    for along in range(360):
        near = [on_circle(circle.centre, 4.0, along + side) for side in (90.0, -90.0)]
        middle = on_circle(circle.centre, 50.0, along + 180.0)
        plate = [*near, *(on_circle(middle, 6.0, along + side) for side in (-90.0, 90.0))]
        for pieces in (outside(circle, plate), covered(circle, plate)):
            seen = sum(one.high - one.low for one in pieces if isinstance(one, Arc))
            assert seen == pytest.approx(180.0, abs=6.0), along


@pytest.mark.parametrize(("centre", "radius"), [((2.0, 1.0), 1.5), ((6.0, 1.0), 2.5)])
def test_a_circle_runs_over_a_box(centre: tuple[float, float], radius: float) -> None:
    assert runs_over(Arc(centre, radius), BOX)


@pytest.mark.parametrize(("centre", "radius"), [((6.0, 1.0), 1.5), ((2.0, 1.0), 3.0)])
def test_a_circle_past_a_box_or_all_round_it_does_not(
    centre: tuple[float, float], radius: float
) -> None:
    assert not runs_over(Arc(centre, radius), BOX)


@given(st.floats(0.1, 300), st.floats(-500, 500), st.floats(10, 80))
def test_an_arc_whose_middle_touches_the_edge_of_a_plate_is_hidden_by_it(
    radius: float, x: float, half: float
) -> None:
    arc = Arc((x, 0.0), radius, 90 - half, 90 + half)
    plate = Box(x - 2 * radius, -radius, x + 2 * radius, radius)
    assert list(covered(arc, plate.corners)) == [arc]
    assert not list(outside(arc, plate.corners))
