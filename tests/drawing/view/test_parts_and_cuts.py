"""A general view says a size once, names the part that is seen, and cuts what nothing covers."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import pytest
import shapely

from gripcourse.course.view import Face, Side, ViewPart
from gripcourse.drawing.paper.strokes import points_of
from gripcourse.drawing.view.details import details_of
from gripcourse.drawing.view.numbers import numbers_at
from gripcourse.drawing.view.placed_shapes import Shown, shown
from support.each import each

if TYPE_CHECKING:
    from conftest import Draw, Drawn

NEAR = 1e-3  # mm
ON_THE_LINE = 0.3  # mm that a mark may lie beside what has no inside, such as a spring
TENTH = 0.05  # mm
MAIN = Face.MAIN
UPRIGHT = {Side.LEFT, Side.RIGHT}
CLOSED = 3  # corners of what covers anything


def parts_of(drawn: "Drawn") -> list[tuple[ViewPart, list[Shown]]]:
    """The parts of a view with what the main face shows of them, what lies in front last."""
    view = drawn.plan.scheme.view
    assert view is not None
    numbers = numbers_at(drawn.plan, view, drawn.values, view.position)
    there = [one for one in view.parts if not one.positions or view.position in one.positions]
    return [(one, [x for x in shown(one, numbers) if x.face is MAIN]) for one in there]


def area(one: Shown) -> shapely.Geometry:
    mask = one.outline.mask
    return shapely.Polygon(mask).buffer(0) if len(mask) >= CLOSED else shapely.Polygon()


@each("any_variants", "any_variant")
def test_a_position_points_at_the_part_that_it_names(draw: "Draw", any_variant: str) -> None:
    drawn = draw(any_variant)
    parts = parts_of(drawn)
    for position in drawn.view.figure.positions:
        mark = shapely.Point(position.mark)
        seen = [
            part.id
            for part, shapes in parts
            if any(area(one).buffer(NEAR).contains(mark) for one in shapes)
        ]
        if seen[-1:] != [position.part.id]:
            own = next(shapes for part, shapes in parts if part is position.part)
            lines = [
                shapely.LineString([(x.start), (x.end)])
                for one in own
                if len(one.outline.mask) < CLOSED
                for x in one.outline.strokes
                if hasattr(x, "start")
            ]
            assert min((mark.distance(one) for one in lines), default=1) <= ON_THE_LINE, (
                position.part.id,
                seen,
            )


@each("any_variants", "any_variant")
def test_no_size_is_written_twice(draw: "Draw", any_variant: str) -> None:
    shown_sizes = draw(any_variant).view.figure
    measured = [one.declared.quantity for one in shown_sizes.measured]
    assert len(measured) == len(set(measured))
    for overall in shown_sizes.overall:
        for one in shown_sizes.measured:
            same_way = (overall.side in UPRIGHT) == (one.declared.side in UPRIGHT)
            same_face = overall.face is one.declared.face
            ends = zip((overall.start, overall.end), (one.start, one.end), strict=True)
            along = 1 if overall.side in UPRIGHT else 0
            is_same = all(abs(a[along] - b[along]) < TENTH for a, b in ends)
            assert not (same_way and same_face and is_same), one.declared.quantity


@each("any_variants", "any_variant")
def test_what_is_cut_is_not_behind_another_part(draw: "Draw", any_variant: str) -> None:
    drawn = draw(any_variant)
    parts = parts_of(drawn)
    hatched = [shapely.Polygon(one.rings[0], one.rings[1:]) for one in drawn.view.figure.cuts[MAIN]]
    lying = [(part.id, one) for part, shapes in parts for one in shapes]
    assert hatched or not any(one.hatch for _, one in lying)
    for number, (_, one) in enumerate(lying):
        if one.hatch:
            before = shapely.union_all([area(later) for _, later in lying[number + 1 :]])
            own = shapely.Polygon(one.ring).buffer(0)
            for cut in hatched:
                if own.buffer(NEAR).contains(cut) and own.intersects(cut):
                    assert cut.intersection(before).area <= NEAR


def test_teeth_are_left_whole_in_a_section(draw: "Draw", smallest: Mapping[str, str]) -> None:
    """GOST 2.402: between their tips and their roots a section of a wheel is not hatched."""
    drawn = draw(smallest["pinion_racks"])
    values = drawn.values
    root = values["module"] * (values["gear_teeth"] / 2 - 1.25)
    view = drawn.plan.scheme.view
    assert view is not None
    section = next(
        one for one in details_of(drawn.view.figure, drawn.plan, view, values) if one.is_section
    )
    edges = {abs(point[1]) for seen in section.seen for point in points_of(seen.stroke)}
    middle = [
        y
        for cut in section.cuts
        for x, y in cut.rings[0]
        if abs(x) < values["face_width"] / 2 + NEAR
    ]
    assert max(map(abs, middle)) == pytest.approx(root)
    assert any(one == pytest.approx(root + 2.25 * values["module"]) for one in edges)
