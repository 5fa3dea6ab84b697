"""What is seen of a gripper in its general view, and what is not."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest
import shapely

from gripcourse.course.model import Course
from gripcourse.course.view import Face, Side
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Arc, points_of
from gripcourse.drawing.paper.title_block import TitleBlock
from gripcourse.drawing.view.contents import figure
from gripcourse.drawing.view.extension_lines import reach
from gripcourse.drawing.view.general_view import general_view
from gripcourse.errors import CourseError
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from support.each import each

if TYPE_CHECKING:
    from conftest import Draw

ROUNDED = 0.25  # mm of the thing: what covers a circle is a polygon
THREE_FINGERS = {"link_lever_3", "wedge_roller_3"}  # one of them is turned into the main view


@each("any_variants", "any_variant")
def test_outlines_are_closed(draw: "Draw", any_variant: str) -> None:
    """An edge that is seen ends at another edge, seen or hidden, or at a line of break."""
    figure = draw(any_variant).view.figure
    for face in figure.faces:
        edges = [
            one for one in figure.seen[face] if one.kind not in {LineKind.CENTRE, LineKind.PHANTOM}
        ]
        lines = [shapely.LineString(points_of(one.stroke)) for one in edges]
        tree = shapely.STRtree(lines)
        for number, (edge, line) in enumerate(zip(edges, lines, strict=True)):
            ends = [shapely.Point(line.coords[place]) for place in (0, -1)]
            if edge.kind is LineKind.OUTLINE and ends[0].distance(ends[1]) > ROUNDED:
                for end in ends:
                    beside = set(tree.query(end, predicate="dwithin", distance=ROUNDED)) - {number}
                    assert beside, (face, edge.stroke)


@each("any_variants", "any_variant")
def test_the_main_view_and_that_from_the_end_are_equally_high(
    draw: "Draw", any_variant: str
) -> None:
    figure = draw(any_variant).view.figure
    if Face.END in figure.faces and draw(any_variant).plan.scheme.id not in THREE_FINGERS:
        edges = {
            face: [one.stroke for one in figure.seen[face] if one.kind is LineKind.OUTLINE]
            for face in (Face.MAIN, Face.END)
        }
        main, end = (reach(edges[face], Side.RIGHT) for face in (Face.MAIN, Face.END))
        assert main[0][1] == pytest.approx(end[0][1], abs=0.1)
        assert main[1][1] == pytest.approx(end[1][1], abs=0.1)


def test_lines_behind_a_part_are_not_seen(draw: "Draw") -> None:
    figure = draw("011").view.figure
    for face in figure.faces:
        kinds = {one.kind for one in figure.seen[face]}
        assert LineKind.OUTLINE in kinds


def test_what_the_options_do_not_bring_is_not_drawn(course: Course, draw: "Draw") -> None:
    drawn = draw("033")
    view = course.schemes["rack_parallelogram"].view
    assert view is not None
    declared = {part.id for part in view.parts}
    shown = {one.part.id for one in drawn.view.figure.positions}
    assert drawn.plan.options["mounting"] == "flange"
    assert "bayonet" in declared - shown
    assert "flange" in shown


@pytest.mark.parametrize(
    ("mounting", "holes", "outline"), [("flange", 7, 144.0), ("square_flange", 4, 110.0)]
)
def test_a_flange_is_drawn_in_the_form_and_with_the_holes_of_its_execution(
    course: Course, mounting: str, holes: int, outline: float
) -> None:
    """GOST 26063-84, table 7: a base diameter of 90 mm, D2 = 144 mm and B = 110 mm."""
    scheme = course.schemes["rack_parallelogram"]
    assert scheme.example is not None
    assert scheme.view is not None
    plan = make_plan(course, scheme.id, {**scheme.example.options, "mounting": mounting})
    shown = figure(plan, scheme.view, solve_variant(plan, scheme.example.given))
    (label,) = (one for one in shown.labelled if one.declared.face is Face.END)
    assert label.values == {"count": holes, "hole": pytest.approx(11)}
    drawn = [one.stroke for one in shown.seen[Face.END] if one.kind is LineKind.OUTLINE]
    circles = [one for one in drawn if isinstance(one, Arc) and one.radius == pytest.approx(5.5)]
    assert len({(round(one.centre[0], 6), round(one.centre[1], 6)) for one in circles}) == holes
    edges = {
        round(2 * one.radius if isinstance(one, Arc) else math.dist(one.start, one.end), 6)
        for one in drawn
    }
    assert outline in edges


def test_a_main_view_that_shows_nothing_is_named(draw: "Draw") -> None:
    drawn = draw("001")
    assert drawn.plan.scheme.view is not None
    view = replace(drawn.plan.scheme.view, parts=(), dimensions=(), labels=(), details=())
    block = TitleBlock("001", "x", "x", "")
    with pytest.raises(CourseError) as caught:
        general_view(drawn.plan, view, drawn.values, block, Words("en"))
    (problem,) = caught.value.problems
    assert (problem.file, problem.key) == (view.file, "part")
