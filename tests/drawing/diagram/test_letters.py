"""Placing symbols: near what they mean, off each other, off the lines, on the sheet."""

import math

import numpy as np
import pytest
import shapely

from gripcourse.drawing.diagram.letters import covered_lengths, strokes_of, write_letters
from gripcourse.drawing.diagram.marks import (
    ArcMark,
    Fill,
    Letter,
    Mark,
    Path,
    Point,
    RingMark,
    circle,
    cut_under,
    mirrored,
    settled,
    shifted,
)
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Box

SHEET = Box(-50, -50, 50, 50)
NOTHING = strokes_of([])


def covered(box: Box, strokes: shapely.STRtree) -> float:
    row = np.array([[box.left, box.bottom, box.right, box.top]])
    return float(covered_lengths(row, strokes)[0])


def path(*points: Point, line: LineKind = LineKind.OUTLINE, under: bool = False) -> Path:
    return Path(points, line, under=under)


def test_a_symbol_stands_close_above_its_place() -> None:
    [written] = write_letters([Letter("F", ((0.0, 0.0),))], NOTHING, SHEET)
    assert 0 < written.box.bottom < 1
    assert written.box.left < 0 < written.box.right
    assert (written.base, written.below) == ("F", "")


def test_a_subscript_hangs_behind_its_letter() -> None:
    [written] = write_letters([Letter("D_max", ((0.0, 0.0),))], NOTHING, SHEET)
    assert (written.base, written.below) == ("D", "max")
    assert 0 < written.offset < written.box.right - written.box.left


def test_two_symbols_at_one_place_stand_apart() -> None:
    one = Letter("D_max", ((0.0, 0.0),))
    first, second = write_letters([one, one], NOTHING, SHEET)
    assert not first.box.overlaps(second.box)


def test_a_symbol_moves_away_from_a_line() -> None:
    lines = strokes_of([path((-20, 2), (20, 2))])
    [written] = write_letters([Letter("F", ((0.0, 0.0),))], lines, SHEET)
    assert covered(written.box, lines) == 0


def test_a_symbol_does_not_leave_the_sheet() -> None:
    corner = Box(-50, -50, 0.5, 0.5)
    [written] = write_letters([Letter("F", ((0.0, 0.0),))], NOTHING, corner)
    assert corner.joined(written.box) == corner


def test_the_first_of_free_places_is_taken() -> None:
    lines = strokes_of([path((-8, y), (8, y)) for y in range(-8, 9)])
    [written] = write_letters([Letter("F", ((0.0, 0.0), (30.0, 0.0)))], lines, SHEET)
    assert written.box.left > 20


@pytest.mark.parametrize(
    ("line", "length"),
    [
        (path((-5, 1), (5, 1)), 4.0),
        (path((1, -5), (1, 5)), 2.0),
        (path((-1, -1), (5, 5)), 2 * math.sqrt(2)),
        (path((0, 3), (4, 3)), 0.0),
        (path((-9, 1), (-5, 1)), 0.0),
    ],
)
def test_the_line_under_a_box_is_measured(line: Path, length: float) -> None:
    assert covered(Box(0, 0, 4, 2), strokes_of([line])) == pytest.approx(length)


def test_a_symbol_stands_nearest_to_what_it_names() -> None:
    low, high = ((-9.0, 0.0), (9.0, 0.0)), ((-9.0, 6.0), (9.0, 6.0))
    letters = [Letter("a", ((0.0, 0.0),), (low,)), Letter("b", ((0.0, 6.0),), (high,))]
    lines = strokes_of([path(*low), path(*high)])
    for written, own, other in zip(
        write_letters(letters, lines, SHEET), (low, high), (high, low), strict=True
    ):
        box = shapely.box(
            *(written.box.left, written.box.bottom, written.box.right, written.box.top)
        )
        assert box.distance(shapely.LineString(own)) < box.distance(shapely.LineString(other))


def test_a_symbol_that_finds_no_room_gets_a_leader() -> None:
    lines = strokes_of([path((-8, y), (8, y)) for y in range(-8, 9)])
    [written] = write_letters([Letter("F", ((0.0, 0.0),))], lines, SHEET)
    assert written.leader[0] == (0.0, 0.0)
    assert not written.has_arrow
    assert len(written.marks) == 1


def test_a_leader_is_drawn_to_where_its_symbol_moves() -> None:
    tip = ((5.0, 0.0), 0.0)
    [first] = write_letters([Letter("D", (tip[0],), (), (tip,), 6.0)], NOTHING, SHEET)
    wall = strokes_of([path((x, -3), (x, 3)) for x in (11.5, 12.5, 13.5)])
    [second] = write_letters([Letter("D", (tip[0],), (), (tip,), 6.0)], wall, SHEET)
    for written in (first, second):
        end = written.leader[-1]
        near = shapely.box(
            written.box.left, written.box.bottom, written.box.right, written.box.top
        ).distance(shapely.Point(end))
        assert near < 1
    assert first.leader[-1] != second.leader[-1]


def test_a_rod_ends_at_the_ring_of_its_joint() -> None:
    rod, ring = path((0, 0), (10, 0), under=True), RingMark((0.0, 0.0), 1.0, LineKind.OUTLINE)
    cut = [mark for mark in cut_under([rod, ring]) if isinstance(mark, Path)]
    assert [mark.points for mark in cut] == [((1.0, 0.0), (10.0, 0.0))]


def test_a_rod_through_a_joint_is_cut_in_two() -> None:
    rod, ring = path((0, 0), (10, 0), under=True), RingMark((5.0, 0.0), 1.0, LineKind.OUTLINE)
    cut = [mark for mark in cut_under([rod, ring]) if isinstance(mark, Path)]
    assert len(cut) == 2
    assert sum(math.dist(*mark.points) for mark in cut) == pytest.approx(8)


@pytest.mark.parametrize(
    "mark",
    [
        path((0, 1), (2, 3)),
        ArcMark((1.0, 2.0), 3.0, 0.4, 1.1, LineKind.THIN),
        circle((1.0, 2.0), 3.0, LineKind.THIN),
        Fill(((0.0, 1.0), (1.0, 1.0), (0.0, 2.0))),
        RingMark((1.0, 2.0), 1.0, LineKind.OUTLINE),
        Letter("F", ((1.0, 2.0),)),
    ],
)
def test_a_mirror_image_of_a_mirror_image_is_the_thing_itself(mark: Mark) -> None:
    assert mirrored(mark) != mark
    again = mirrored(mirrored(mark))
    if isinstance(mark, ArcMark) and isinstance(again, ArcMark):
        assert again.start == pytest.approx(mark.start)
        again = ArcMark(again.centre, again.radius, mark.start, again.sweep, again.line)
    assert again == mark


@pytest.mark.parametrize(
    "mark",
    [
        path((1.0, 2.0), (3.0, 4.0)),
        Fill(((1.0, 2.0), (3.0, 4.0), (5.0, 7.0))),
        circle((1.0, 2.0), 3.0, LineKind.OUTLINE),
        RingMark((1.0, 2.0), 3.0, LineKind.OUTLINE),
        Letter("F", ((1.0, 2.0),), (((3.0, 4.0), (5.0, 6.0)),), (((1.0, 2.0), 0.5),)),
    ],
)
def test_a_last_digit_that_processors_round_otherwise_moves_nothing(mark: Mark) -> None:
    assert settled(shifted(mark, 1e-12, -1e-12)) == settled(mark)
