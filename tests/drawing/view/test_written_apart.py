"""Nothing that is written on a general view stands on anything else, in variants of each scheme."""

import math
from collections.abc import Iterator
from itertools import combinations, product
from typing import TYPE_CHECKING

from gripcourse.course.view import Face
from gripcourse.drawing.paper.strokes import Box, Line, outside, runs_over, runs_through
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.face import FaceLayout
from gripcourse.drawing.view.leaders import cross
from support.each import each

if TYPE_CHECKING:
    from conftest import Draw

ON = 0.25  # mm of paper: half of the width of a stroke


def cuts(start: Point, end: Point, box: Box) -> bool:
    """Tell whether a straight line runs through a box."""
    return list(outside(Line(start, end), box.corners)) != [Line(start, end)]


def boxes_of(face: FaceLayout) -> list[Box]:
    return [*(one.text_box for one in face.dimensions), *(one.box for one in face.leaders)]


def extension_lines(face: FaceLayout) -> Iterator[tuple[int, Point, Point]]:
    """Each extension line with the number of its dimension."""
    for number, one in enumerate(face.dimensions):
        for x, y in (one.wanted.start, one.wanted.end):
            yield number, (x, y), (one.line, y) if one.wanted.upright else (x, one.line)


@each("any_variants", "any_variant")
def test_no_number_stands_on_another_one_or_on_the_outline(draw: "Draw", any_variant: str) -> None:
    drawn = draw(any_variant)
    for name, face in drawn.view.faces.items():
        boxes = boxes_of(face)
        assert not [pair for pair in combinations(boxes, 2) if pair[0].overlaps(pair[1])]
        scale = drawn.view.arranged.factor
        extent = drawn.view.figure.extents[name]
        bare = Box(*(one * scale for one in (extent.left, extent.bottom, extent.right, extent.top)))
        assert not [one for one in boxes if one.overlaps(bare)]


@each("any_variants", "any_variant")
def test_no_line_of_a_dimension_or_a_leader_runs_through_a_number(
    draw: "Draw", any_variant: str
) -> None:
    for face in draw(any_variant).view.faces.values():
        numbers = [one.text_box for one in face.dimensions]
        for own, start, end in extension_lines(face):
            others = [box for number, box in enumerate(numbers) if number != own]
            assert not [box for box in others if cuts(start, end, box)]
        for leader in face.leaders:
            assert not [box for box in numbers if cuts(leader.note.at, leader.knee, box)]
            others = [one.box for one in face.leaders if one is not leader]
            assert not [box for box in others if cuts(leader.note.at, leader.knee, box)]
        for axis in face.axes:
            assert not [box for box in boxes_of(face) if cuts(axis.start, axis.end, box)]


@each("any_variants", "any_variant")
def test_dimension_lines_do_not_overlap(draw: "Draw", any_variant: str) -> None:
    for face in draw(any_variant).view.faces.values():
        lines = [one.box for one in face.dimensions]
        assert not [pair for pair in combinations(lines, 2) if pair[0].overlaps(pair[1])]


@each("any_variants", "any_variant")
def test_leaders_do_not_cross(draw: "Draw", any_variant: str) -> None:
    for face in draw(any_variant).view.faces.values():
        lines = [one.line for one in face.leaders]
        assert not [pair for pair in combinations(lines, 2) if cross(*pair)]


@each("any_variants", "any_variant")
def test_marks_of_details_stand_free_of_each_other_and_of_numbers(
    draw: "Draw", any_variant: str
) -> None:
    face = draw(any_variant).view.faces[Face.MAIN]
    letters = [box for mark in face.marks for box in mark.letters]
    lines = [(one.note.at, one.knee) for one in face.leaders]
    lines += [(start, end) for _, start, end in extension_lines(face)]
    assert not [one for one in lines if any(cuts(*one, box) for box in letters)]
    marks = [box for mark in face.marks for box in mark.boxes]
    boxes = [*marks, *(one.text_box for one in face.dimensions)]
    boxes += [one.box for one in face.leaders]
    assert not [pair for pair in combinations(boxes, 2) if pair[0].overlaps(pair[1])]
    rims = [mark.rim for mark in face.marks if mark.rim is not None]
    numbers = [one.text_box for one in face.dimensions]
    assert not [pair for pair in product(rims, numbers) if runs_over(*pair)]


@each("any_variants", "any_variant")
def test_no_leader_runs_through_a_stroke_or_an_arrow_of_a_section(
    draw: "Draw", any_variant: str
) -> None:
    face = draw(any_variant).view.faces[Face.MAIN]
    marks = [box for mark in face.marks for box in mark.boxes]
    assert not [one.note.text for one in face.leaders if runs_through(one.line, marks)]


@each("any_variants", "any_variant")
def test_no_extension_line_lies_on_the_stroke_of_a_section(draw: "Draw", any_variant: str) -> None:
    drawn = draw(any_variant)
    face, origin = drawn.view.faces[Face.MAIN], drawn.view.arranged.origins[Face.MAIN]
    strokes = [
        Box(mark.x - ON, box.bottom, mark.x + ON, box.top).moved(origin)
        for mark in face.marks
        for box in mark.boxes
    ]
    drawings = drawn.view.document.modelspace().query("DIMENSION")
    lines = [line for one in drawings for line in one.get_geometry_block().query("LINE")]
    for line in lines:
        start, end = line.dxf.start, line.dxf.end
        assert not runs_through(Line((start.x, start.y), (end.x, end.y)), strokes)
    assert {one.dxf.lineweight for one in lines} == {18}


@each("any_variants", "any_variant")
def test_letters_of_sections_stand_outside_of_the_circles_of_details(
    draw: "Draw", any_variant: str
) -> None:
    marks = draw(any_variant).view.faces[Face.MAIN].marks
    for rim in (one.rim for one in marks if one.rim is not None):
        x, y = rim.centre
        for box in (box for mark in marks for box in mark.letters):
            near = (min(max(x, box.left), box.right), min(max(y, box.bottom), box.top))
            assert math.dist(rim.centre, near) > rim.radius


@each("any_variants", "any_variant")
def test_positions_stand_in_the_order_of_their_numbers(draw: "Draw", any_variant: str) -> None:
    leaders = draw(any_variant).view.faces[Face.MAIN].leaders
    ordered = sorted(leaders, key=lambda one: one.left)
    numbers = [int(one.note.text) for one in ordered if one.note.text.isdigit()]
    assert numbers == sorted(numbers)
    assert numbers
