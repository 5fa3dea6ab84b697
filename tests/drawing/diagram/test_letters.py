"""Placing symbols: near what they mean, off each other, off the lines, on the sheet."""

import math

import pytest

from gripcourse.drawing.diagram.letters import LetterBox, covered_lengths, lines_of, write_letters
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
)
from gripcourse.drawing.paper.document import LineKind

SHEET = LetterBox(-50, -50, 50, 50)
NOTHING = lines_of([])


def path(*points: Point, line: LineKind = LineKind.OUTLINE, under: bool = False) -> Path:
    return Path(points, line, under=under)


def test_a_symbol_stands_close_above_its_place() -> None:
    [written] = write_letters([Letter("F", ((0.0, 0.0),))], NOTHING, SHEET)
    assert 0 < written.box.low < 1
    assert written.box.left < 0 < written.box.right
    assert (written.base, written.below) == ("F", "")


def test_a_subscript_hangs_behind_its_letter() -> None:
    [written] = write_letters([Letter("D_max", ((0.0, 0.0),))], NOTHING, SHEET)
    assert (written.base, written.below) == ("D", "max")
    assert 0 < written.offset < written.box.right - written.box.left


def test_two_symbols_at_one_place_stand_apart() -> None:
    one = Letter("D_max", ((0.0, 0.0),))
    first, second = write_letters([one, one], NOTHING, SHEET)
    assert first.box.overlap(second.box) == 0


def test_a_symbol_moves_away_from_a_line() -> None:
    lines = lines_of([path((-20, 2), (20, 2))])
    [written] = write_letters([Letter("F", ((0.0, 0.0),))], lines, SHEET)
    assert covered_lengths([written.box], lines)[0] == 0


def test_a_symbol_does_not_leave_the_sheet() -> None:
    corner = LetterBox(-50, -50, 0.5, 0.5)
    [written] = write_letters([Letter("F", ((0.0, 0.0),))], NOTHING, corner)
    assert corner.holds(written.box)


def test_the_first_of_free_places_is_taken() -> None:
    lines = lines_of([path((-8, y), (8, y)) for y in range(-8, 9)])
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
    assert covered_lengths([LetterBox(0, 0, 4, 2)], lines_of([line]))[0] == pytest.approx(length)


def test_an_axis_under_a_symbol_counts_less() -> None:
    box = LetterBox(0, 0, 4, 2)
    axis = lines_of([path((-5, 1), (5, 1), line=LineKind.CENTRE)])
    assert 0 < covered_lengths([box], axis)[0] < 4


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
