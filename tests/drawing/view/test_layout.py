import pytest

from gripcourse.course.view import Face
from gripcourse.drawing.paper.sheet import A2_UPRIGHT
from gripcourse.drawing.paper.strokes import Arc, Box, Line, covered, outside
from gripcourse.drawing.view.layout import Arranged, Pictured, SheetContent, arrange
from gripcourse.drawing.view.lengths import length_text
from gripcourse.text.words import Words

HALF = 0.5  # of the free field
SQUARE = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)]


def around(half: float, scale: float) -> Box:
    return Box(-half * scale, -half * scale, half * scale, half * scale)


def square(half: float, detail: float = 10.0) -> Arranged:
    """Arrange one square face."""
    pictured = Pictured(length=2 * half, detail=detail)
    found = arrange(
        SheetContent(lambda scale: {Face.MAIN: [around(half, scale)]}), pictured, rows=7, lines=4
    )
    assert found is not None
    return found


def test_what_fills_a_sheet_gets_no_larger_one() -> None:
    found = square(120)
    assert (str(found.sheet.name), found.scale) == ("A3", (1, 1))
    assert found.filled > HALF


def test_what_would_leave_most_of_a_small_sheet_empty_gets_a_larger_one() -> None:
    found = square(180)
    assert (str(found.sheet.name), found.scale) == ("A2", (1, 1))
    assert found.filled > HALF


def test_what_is_high_stands_on_an_upright_sheet() -> None:
    def high(scale: float) -> dict[Face, list[Box]]:
        return {Face.MAIN: [Box(-100 * scale, -240 * scale, 100 * scale, 240 * scale)]}

    found = arrange(SheetContent(high), Pictured(length=480, detail=10), rows=7, lines=4)
    assert found is not None
    assert found.sheet == A2_UPRIGHT


def test_what_has_fine_details_gets_a_larger_scale() -> None:
    assert square(460, detail=5).scale == (1, 4)
    assert square(460, detail=2.5).scale == (1, 2.5)


def test_details_that_no_sheet_shows_do_not_make_it_larger() -> None:
    assert square(120, detail=0.01) == square(120)


def test_the_end_stands_on_the_right_at_the_same_height_and_the_plan_below() -> None:
    def boxes(scale: float) -> dict[Face, list[Box]]:
        return {face: [around(40, scale)] for face in Face}

    found = arrange(SheetContent(boxes), Pictured(length=80, detail=5), rows=0, lines=0)
    assert found is not None
    origins = found.origins
    assert origins[Face.END][1] == origins[Face.MAIN][1]
    assert origins[Face.END][0] > origins[Face.MAIN][0]
    assert origins[Face.PLAN][0] == origins[Face.MAIN][0]
    assert origins[Face.PLAN][1] < origins[Face.MAIN][1]


def test_what_is_larger_than_any_sheet_is_not_drawn() -> None:
    pictured = Pictured(length=2e6, detail=5)
    huge = SheetContent(lambda scale: {Face.MAIN: [around(1e6, scale)]})
    assert arrange(huge, pictured, rows=0, lines=0) is None


def test_a_covered_piece_of_a_line_is_not_seen() -> None:
    line = Line((-5.0, 5.0), (15.0, 5.0))
    assert list(outside(line, SQUARE)) == [
        Line((-5.0, 5.0), (0.0, 5.0)),
        Line((10.0, 5.0), (15.0, 5.0)),
    ]


def test_a_covered_piece_of_a_line_can_be_dashed() -> None:
    line = Line((-5.0, 5.0), (15.0, 5.0))
    assert list(covered(line, SQUARE)) == [Line((0.0, 5.0), (10.0, 5.0))]


def test_a_line_that_nothing_covers_stays_whole() -> None:
    line = Line((-5.0, 12.0), (15.0, 12.0))
    assert list(outside(line, SQUARE)) == [line]


def test_of_a_circle_the_uncovered_part_is_left() -> None:
    pieces = list(outside(Arc((0.0, 0.0), 5.0), SQUARE))
    assert sum(one.high - one.low for one in pieces if isinstance(one, Arc)) == 270.0


@pytest.mark.parametrize(
    ("value", "written"),
    [(1.25, "1,25"), (0.355, "0,355"), (63.0, "63"), (106.0873, "106,1"), (4.0 / 3.0, "1,3")],
)
def test_sizes_of_a_series_are_written_exactly_and_other_lengths_to_tenths(
    value: float, written: str
) -> None:
    assert length_text(value, Words("ru")) == written
    assert length_text(value * 0.001 / 0.001, Words("ru")) == written  # SI and back
