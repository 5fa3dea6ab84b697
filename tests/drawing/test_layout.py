from gripcourse.course.view import Face
from gripcourse.drawing.layout import arrange
from gripcourse.drawing.sheet import A3, A4
from gripcourse.drawing.strokes import Arc, Box, Line, outside

SQUARE = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)]


def around(half: float, scale: float) -> Box:
    return Box(-half * scale, -half * scale, half * scale, half * scale)


def test_what_fits_onto_a_small_sheet_gets_no_larger_one() -> None:
    found = arrange(lambda scale: {Face.MAIN: around(30, scale)}, rows=3, lines=2)
    assert found.sheet == A4
    assert found.scale == (2, 1)


def test_what_needs_a_large_sheet_gets_one() -> None:
    found = arrange(lambda scale: {Face.MAIN: around(100, scale)}, rows=3, lines=2)
    assert found.sheet == A3
    assert found.scale == (1, 1)


def test_the_end_stands_on_the_right_at_the_same_height_and_the_plan_below() -> None:
    def boxes(scale: float) -> dict[Face, Box]:
        return {face: around(40, scale) for face in Face}

    origins = arrange(boxes, rows=0, lines=0).origins
    assert origins[Face.END][1] == origins[Face.MAIN][1]
    assert origins[Face.END][0] > origins[Face.MAIN][0]
    assert origins[Face.PLAN][0] == origins[Face.MAIN][0]
    assert origins[Face.PLAN][1] < origins[Face.MAIN][1]


def test_what_is_larger_than_any_sheet_is_drawn_at_the_smallest_scale() -> None:
    found = arrange(lambda scale: {Face.MAIN: around(1e6, scale)}, rows=3, lines=2)
    assert found.scale == (1, 100)


def test_a_covered_piece_of_a_line_is_not_seen() -> None:
    line = Line((-5.0, 5.0), (15.0, 5.0))
    assert list(outside(line, SQUARE)) == [
        Line((-5.0, 5.0), (0.0, 5.0)),
        Line((10.0, 5.0), (15.0, 5.0)),
    ]


def test_a_line_that_nothing_covers_stays_whole() -> None:
    line = Line((-5.0, 12.0), (15.0, 12.0))
    assert list(outside(line, SQUARE)) == [line]


def test_of_a_circle_the_uncovered_part_is_left() -> None:
    pieces = list(outside(Arc((0.0, 0.0), 5.0), SQUARE))
    assert sum(one.high - one.low for one in pieces if isinstance(one, Arc)) == 270.0
