"""What holds for the general view of every scheme, looked at in several variants of each."""

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from dataclasses import replace
from io import BytesIO
from itertools import combinations, product
from typing import TYPE_CHECKING

import pytest
import shapely
from ezdxf import recover

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.course.view import Face, Side
from gripcourse.drawing.paper.document import LineKind, dxf_bytes
from gripcourse.drawing.paper.sheet import FORMATS, block_box, corner_box
from gripcourse.drawing.paper.strokes import (
    Arc,
    Box,
    Line,
    Stroke,
    outside,
    points_of,
    runs_over,
    runs_through,
)
from gripcourse.drawing.paper.svg import svg_text
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.paper.title_block import TitleBlock
from gripcourse.drawing.view.contents import figure
from gripcourse.drawing.view.extension_lines import reach
from gripcourse.drawing.view.face import FaceLayout
from gripcourse.drawing.view.general_view import general_view
from gripcourse.drawing.view.layout import SCALES
from gripcourse.drawing.view.leaders import cross
from gripcourse.drawing.view.lengths import FOR_REFERENCE, length_text
from gripcourse.drawing.view.numbers import numbers_at
from gripcourse.drawing.view.placed_shapes import shown
from gripcourse.errors import CourseError
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from support.each import each, named_if_it_fails

if TYPE_CHECKING:
    from conftest import Draw, Drawn

HALF, NEARLY_HALF = 0.5, 0.42  # of the free field, that all views take
ROUNDED = 0.25  # mm of the thing: what covers a circle is a polygon
BY_FACES = 0.25  # of it, that the faces take without details
ON = 0.25  # mm of paper: half of the width of a stroke
THREE_FINGERS = {"link_lever_3", "wedge_roller_3"}  # one of them is turned into the main view
SVG = "{http://www.w3.org/2000/svg}"


def parsed(drawn: "Drawn") -> ET.Element:
    sheet = drawn.view.arranged.sheet
    svg = svg_text(drawn.view.document, sheet.width, sheet.height, "general view")
    return ET.fromstring(svg)  # noqa: S314 - our own drawing


def written(drawn: "Drawn") -> list[str]:
    return [one.text or "" for one in parsed(drawn).iter(f"{SVG}text")]


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


def test_every_scheme_has_a_general_view(course: Course) -> None:
    assert {name for name, scheme in course.schemes.items() if scheme.view is None} == set()


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
def test_everything_has_its_own_place_on_the_sheet(draw: "Draw", any_variant: str) -> None:
    view = draw(any_variant).view
    sheet = view.arranged.sheet
    groups = [
        [box.moved(view.arranged.origins[name]) for box in face.boxes]
        for name, face in view.faces.items()
    ]
    places = [at for _, (_, at) in sorted(view.arranged.details.items())]
    groups += [[one.box.moved(at)] for one, at in zip(view.details, places, strict=True)]
    tables = (block_box(sheet, len(view.rows)), corner_box(sheet), view.arranged.lines)
    groups += [[one] for one in tables]
    for first, second in combinations(groups, 2):
        pairs = product(first, second)
        assert not [pair for pair in pairs if pair[0].overlaps(pair[1])]
    boxes = [box for group in groups for box in group]
    assert not [one for one in boxes if sheet.frame.joined(one) != sheet.frame]


def test_the_views_take_half_of_what_tables_and_notes_leave_free(
    draw: "Draw", any_variants: list[str]
) -> None:
    """Of twenty variants at most one less: between two scales and two sheets there are gaps."""
    arranged = [draw(one).view.arranged for one in any_variants]
    assert sum(one.filled >= HALF for one in arranged) >= 0.95 * len(arranged)
    assert min(one.filled for one in arranged) >= NEARLY_HALF
    assert min(one.by_faces for one in arranged) >= BY_FACES


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


def test_a_dimension_measures_the_quantity_that_it_names(
    draw: "Draw", any_variants: list[str], subtests: pytest.Subtests
) -> None:
    for any_variant in any_variants:
        with named_if_it_fails(subtests, variant=any_variant):
            drawn = draw(any_variant)
            assert drawn.view.figure.measured
            scale = drawn.view.arranged.factor
            for face in drawn.view.faces.values():
                for one in face.dimensions:
                    if one.wanted.text.endswith(FOR_REFERENCE):
                        continue
                    low, high = one.wanted.span
                    measured = [
                        known.declared.quantity
                        for known in drawn.view.figure.measured
                        if abs(drawn.values[known.declared.quantity] - (high - low) / scale) < 1e-6
                    ]
                    assert measured, (
                        f"{one.wanted.text} is no quantity of any_variant {any_variant}"
                    )


@each("any_variants", "any_variant")
def test_the_numbers_of_the_drawing_are_those_of_the_solution(
    draw: "Draw", any_variant: str
) -> None:
    drawn, words = draw(any_variant), Words("ru")
    texts = written(drawn)
    for one in drawn.view.figure.measured:
        value = drawn.values[one.declared.quantity]
        if drawn.plan.quantities[one.declared.quantity].kind is Kind.FORMULA:
            value = round(value, 1)
        assert f"{one.declared.sign}{length_text(value, words)}" in texts
    for position in drawn.view.figure.positions:
        for name in position.part.sizes:
            if name in drawn.values and drawn.plan.quantities[name].unit == "mm":
                number = length_text(drawn.values[name], words)
                assert any(f"= {number}" in text for text in texts)


@each("any_variants", "any_variant")
def test_extension_lines_begin_on_something(draw: "Draw", any_variant: str) -> None:
    drawn = draw(any_variant)
    for one in drawn.view.figure.measured:
        strokes = [seen.stroke for seen in drawn.view.figure.seen[one.declared.face]]
        for point in (one.start, one.end):
            assert is_near(point, strokes), (one.declared.file, one.declared.key)


def is_near(point: Point, strokes: list[Stroke]) -> bool:
    """Tell whether a point lies on a stroke, or on the axis of what is drawn."""
    around = [
        (point[0] + x, point[1] + y)
        for x, y in ((-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2))
    ]
    return min(map(abs, point)) < 1e-6 or any(
        list(outside(one, around)) != [one] for one in strokes
    )


@each("any_variants", "any_variant")
def test_the_largest_height_covers_the_other_position_too(draw: "Draw", any_variant: str) -> None:
    drawn = draw(any_variant)
    figure, view = drawn.view.figure, drawn.plan.scheme.view
    assert view is not None
    if view.other:
        numbers = numbers_at(drawn.plan, view, drawn.values, view.other)
        moved = [
            stroke
            for part in view.parts
            if part.moves
            for one in shown(part, numbers)
            if one.face is Face.MAIN and one.kind is LineKind.OUTLINE
            for stroke in one.outline.strokes
        ]
        low, high = reach(moved, Side.RIGHT)
        known = [one.value for one in figure.measured if one.declared.side is Side.RIGHT]
        known += [one.value for one in figure.overall if one.side is Side.RIGHT]
        assert high[1] - low[1] <= max(known) + 0.2


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


@each("small_variants", "small_variant")
def test_the_list_of_parts_has_a_row_for_every_position(draw: "Draw", small_variant: str) -> None:
    view = draw(small_variant).view
    assert [row.number for row in view.rows] == [str(n + 1) for n in range(len(view.rows))]
    shown = [one for face in view.faces.values() for one in face.leaders]
    assert {row.number for row in view.rows} <= {one.note.text for one in shown}
    assert len({row.title for row in view.rows}) == len(view.rows)


@each("any_variants", "any_variant")
def test_positions_stand_in_the_order_of_their_numbers(draw: "Draw", any_variant: str) -> None:
    leaders = draw(any_variant).view.faces[Face.MAIN].leaders
    ordered = sorted(leaders, key=lambda one: one.left)
    numbers = [int(one.note.text) for one in ordered if one.note.text.isdigit()]
    assert numbers == sorted(numbers)
    assert numbers


@each("small_variants", "small_variant")
def test_a_file_of_a_drawing_is_sound(
    draw: "Draw", small_variant: str, other_language: Callable[[str], str]
) -> None:
    """Every scheme in one language, every language in some schemes."""
    is_third = int(small_variant) % 3 == 0
    drawn = draw(small_variant, "ru" if is_third else other_language(small_variant))
    document, audit = recover.read(BytesIO(dxf_bytes(drawn.view.document)))
    assert not audit.errors
    assert not audit.fixes
    assert not document.audit().errors
    figure = drawn.view.figure
    asked = len(figure.measured) + len(figure.overall)
    asked += sum(len(one.dimensions) for one in drawn.view.details)
    assert len(document.modelspace().query("DIMENSION")) == asked


@pytest.mark.parametrize("in_russian", [True, False])
@each("small_variants", "small_variant")
def test_a_drawing_speaks_its_language(
    draw: "Draw", small_variant: str, other_language: Callable[[str], str], *, in_russian: bool
) -> None:
    """Every scheme in Russian, and in one of the other languages."""
    language = "ru" if in_russian else other_language(small_variant)
    drawn = draw(small_variant, language)
    words = Words(language)
    said = " ".join(written(drawn))  # a long title stands in two lines
    assert [row.title for row in drawn.view.rows if row.title not in said] == []
    sign = "." if language == "en" else ","
    other = "," if sign == "." else "."
    numbers = [text for text in written(drawn) if re.fullmatch(r"Ø?\d+[.,]\d", text)]
    assert not [text for text in numbers if other in text], words.language


@each("small_variants", "small_variant")
def test_a_drawing_fits_into_a_report(draw: "Draw", small_variant: str) -> None:
    drawn = draw(small_variant)
    assert len(ET.tostring(parsed(drawn))) < 60_000


def test_lines_behind_a_part_are_not_seen(draw: "Draw") -> None:
    figure = draw("011").view.figure
    for face in figure.faces:
        kinds = {one.kind for one in figure.seen[face]}
        assert LineKind.OUTLINE in kinds


@each("any_variants", "any_variant")
def test_a_gripper_is_drawn_at_a_standard_scale_on_a_standard_sheet(
    draw: "Draw", any_variant: str
) -> None:
    arranged = draw(any_variant).view.arranged
    assert any(arranged.sheet in one for one in FORMATS)
    assert arranged.scale in SCALES


def test_a_drawing_is_the_same_each_time(draw: "Draw") -> None:
    drawn = draw("002")
    view = drawn.plan.scheme.view
    assert view is not None
    block = TitleBlock("002", "gripper", "General arrangement", "Somebody")
    twice = [
        dxf_bytes(general_view(drawn.plan, view, drawn.values, block, Words("ru")).document)
        for _ in range(2)
    ]
    assert twice[0] == twice[1]


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


def test_views_that_no_sheet_has_room_for_are_named_with_file_and_key(draw: "Draw") -> None:
    drawn = draw("008")
    view = drawn.plan.scheme.view
    assert view is not None
    huge = {**drawn.values, "flange_diameter": 1e7}
    block = TitleBlock("008", "gripper", "General arrangement", "Somebody")
    with pytest.raises(CourseError) as caught:
        general_view(drawn.plan, view, huge, block, Words("en"))
    (problem,) = caught.value.problems
    assert problem.file.endswith("flange.toml")
    assert problem.key == "part[1]"
    assert "A2" in str(problem.what)


def test_a_main_view_that_shows_nothing_is_named(draw: "Draw") -> None:
    drawn = draw("001")
    assert drawn.plan.scheme.view is not None
    view = replace(drawn.plan.scheme.view, parts=(), dimensions=(), labels=(), details=())
    block = TitleBlock("001", "x", "x", "")
    with pytest.raises(CourseError) as caught:
        general_view(drawn.plan, view, drawn.values, block, Words("en"))
    (problem,) = caught.value.problems
    assert (problem.file, problem.key) == (view.file, "part")


def test_every_characteristic_that_a_view_names_is_printed(draw: "Draw") -> None:
    drawn = draw("001")
    assert drawn.plan.scheme.view is not None
    many = tuple(one.id for one in drawn.plan.answered if one.kind is Kind.FORMULA)[:9]
    view = replace(drawn.plan.scheme.view, characteristics=many)
    block = TitleBlock("001", "x", "x", "")
    notes = general_view(drawn.plan, view, drawn.values, block, Words("en")).notes
    assert len(notes[0].lines) == len(many)


@pytest.mark.parametrize("declares", [True, False])
def test_what_an_asterisk_means_is_said_once(draw: "Draw", *, declares: bool) -> None:
    """By the course's own requirement, else by the program."""
    plan, values = draw("001").plan, draw("001").values
    assert plan.scheme.view is not None
    view = plan.scheme.view if declares else replace(plan.scheme.view, requirements=())
    drawn = general_view(plan, view, values, TitleBlock("001", "x", "x", ""), Words("ru"))
    svg = svg_text(drawn.document, drawn.arranged.sheet.width, drawn.arranged.sheet.height, "x")
    assert svg.count("* Размеры для справок.") == 1
    assert "Технические требования" in svg
