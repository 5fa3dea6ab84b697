"""Leader lines find their way between numbers and marks of sections."""

from itertools import combinations, pairwise

import pytest

from gripcourse.drawing.paper.strokes import Box, runs_through
from gripcourse.drawing.view.leaders import Leader, Note, cross, place_leaders

BELOW = Box(0.0, 0.0, 150.0, 60.0)
HEIGHT = 5.0
# Two planes that are looked at from both ends, each marked by a stroke with its arrow and letter.
MARKS = (Box(40.0, 50.0, 56.0, 58.0), Box(100.0, 50.0, 116.0, 58.0))


def notes(*places: tuple[float, float]) -> list[Note]:
    return [Note(str(number), HEIGHT, at) for number, at in enumerate(places, 1)]


def through(leaders: list[Leader], boxes: tuple[Box, ...]) -> list[str]:
    return [one.note.text for one in leaders if runs_through(one.line, boxes)]


def test_each_shelf_moves_by_itself_where_no_row_as_a_whole_is_free_of_marks() -> None:
    """The pins lie in the planes; what lies between them has its shelf there."""
    leaders = place_leaders(
        notes((20.0, 20.0), (55.0, 40.0), (75.0, 30.0), (101.0, 40.0), (140.0, 20.0)),
        BELOW,
        (),
        MARKS,
    )
    assert not through(leaders, MARKS)
    assert [one.note.text for one in leaders] == ["1", "2", "3", "4", "5"]
    assert all(one.left + one.note.width < other.left for one, other in pairwise(leaders))
    assert not [pair for pair in combinations((one.line for one in leaders), 2) if cross(*pair)]


def test_a_line_runs_through_a_mark_rather_than_through_a_number() -> None:
    wide = (Box(-80.0, 50.0, 230.0, 58.0),)
    number = (Box(20.0, 40.0, 40.0, 44.0),)
    leaders = place_leaders(notes((25.0, 20.0), (90.0, 20.0)), BELOW, number, wide)
    assert through(leaders, wide) == ["1", "2"]
    assert not through(leaders, number)


def test_a_row_that_is_free_stays_as_it_is() -> None:
    places = notes((20.0, 20.0), (60.0, 40.0), (100.0, 20.0))
    assert place_leaders(places, BELOW, (), ()) == place_leaders(
        places, BELOW, (), (Box(140.0, 50.0, 150.0, 58.0),)
    )


@pytest.mark.parametrize("found", [[], notes((20.0, 20.0))])
def test_few_notes_are_no_trouble(found: list[Note]) -> None:
    everywhere = (Box(-500.0, 50.0, 500.0, 58.0),)
    assert len(place_leaders(found, BELOW, everywhere, everywhere)) == len(found)
