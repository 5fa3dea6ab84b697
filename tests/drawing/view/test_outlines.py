"""What a shape looks like, what it covers, and what it fills: the same, drawn or compared."""

import math

import pytest
import shapely

from gripcourse.drawing.paper.strokes import Line, points_of
from gripcourse.drawing.view.outlines import Outline, outline

THICK, THIN, LONG = 10.0, 6.0, 40.0


def filled(found: Outline) -> shapely.Geometry:
    whole = shapely.Polygon(found.mask)
    assert whole.is_valid
    return whole


def is_closed(found: Outline) -> bool:
    """Whether each stroke begins where another one ends, on the rim of what is covered."""
    lines = [shapely.LineString(points_of(one)) for one in found.strokes]
    rim = filled(found).exterior
    ends = sorted(
        tuple(round(x, 6) for x in one.coords[place]) for one in lines for place in (0, -1)
    )
    return ends[::2] == ends[1::2] and all(rim.buffer(0.05).contains(one) for one in lines)


@pytest.mark.parametrize("turn", [0.0, 50.0, 200.0])
def test_a_tapered_bar_is_two_circles_and_all_between_them(turn: float) -> None:
    x, y = LONG * math.cos(math.radians(turn)), LONG * math.sin(math.radians(turn))
    found = outline("taper", {"start": (0.0, 0.0), "end": (x, y), "widths": (THICK, THIN)})
    circles = [
        shapely.Point(at).buffer(wide / 2, quad_segs=64)
        for at, wide in (((0.0, 0.0), THICK), ((x, y), THIN))
    ]
    assert filled(found).symmetric_difference(shapely.MultiPolygon(circles).convex_hull).area < 0.5
    assert is_closed(found)


def test_of_a_tapered_bar_within_its_thicker_end_that_end_is_left() -> None:
    found = outline("taper", {"start": (0.0, 0.0), "end": (1.0, 0.0), "widths": (THICK, THIN)})
    assert filled(found).area == pytest.approx(math.pi * THICK**2 / 4, rel=0.01)


@pytest.mark.parametrize("bend", [-120.0, -30.0, 30.0, 120.0])
def test_a_bar_is_round_outside_of_its_bends(bend: float) -> None:
    end = (LONG * (1 + math.cos(math.radians(bend))), LONG * math.sin(math.radians(bend)))
    chain = [(0.0, 0.0), (LONG, 0.0), end]
    through = [number for point in chain for number in point]
    found = outline("bar", {"through": through, "width": [THIN]})
    exact = shapely.LineString(chain).buffer(THIN / 2, quad_segs=64)
    assert filled(found).symmetric_difference(exact).area < 0.5
    assert is_closed(found)


def test_a_section_lies_across_the_middle_of_its_bar() -> None:
    needs = {"through": [0.0, 0.0, 0.0, LONG], "width": [THIN], "length": [THICK]}
    found = outline("section", needs)
    assert filled(found).equals_exact(
        shapely.box(-THIN / 2, 15.0, THIN / 2, 25.0).normalize(), 1e-9, normalize=True
    )
    assert sum(isinstance(one, Line) for one in found.strokes) == 4
