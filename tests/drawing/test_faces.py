"""What the faces of a general view show of every scheme."""

import math
from collections import defaultdict
from collections.abc import Mapping
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.view import Face
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Arc, Line
from support.each import each, named_if_it_fails

if TYPE_CHECKING:
    from conftest import Draw


@each("any_variants", "any_variant")
def test_every_gripper_is_seen_from_two_sides(draw: "Draw", any_variant: str) -> None:
    faces = draw(any_variant).view.figure.faces
    assert len(faces) == 2
    assert Face.MAIN in faces


def test_three_fingers_are_seen_at_120_degrees(draw: "Draw", smallest: Mapping[str, str]) -> None:
    drawn = draw(smallest["link_lever_3"])
    assert drawn.values["finger_count"] == 3
    ends = [
        one.stroke.end
        for one in drawn.view.figure.seen[Face.END]
        if isinstance(one.stroke, Line) and one.kind is LineKind.CENTRE
    ]
    farthest = max(math.hypot(*one) for one in ends)
    angles = [
        round(math.degrees(math.atan2(y, x)))
        for x, y in ends
        if math.isclose(math.hypot(x, y), farthest)
    ]
    assert sorted(angles) == [-150, -30, 90]


def test_the_holes_of_the_flange_are_those_of_its_table(
    draw: "Draw", any_variants: list[str], subtests: pytest.Subtests
) -> None:
    for any_variant in any_variants:
        with named_if_it_fails(subtests, variant=any_variant):
            drawn = draw(any_variant)
            if drawn.plan.options.get("mounting", "flange") != "flange":
                continue
            figure = drawn.view.figure
            face = next(one for one in figure.faces if one is not Face.MAIN)
            [label] = [one for one in figure.labelled if {"count", "hole"} <= set(one.values)]
            holes = [
                one.stroke
                for one in figure.seen[face]
                if isinstance(one.stroke, Arc)
                and one.stroke.is_circle
                and abs(2 * one.stroke.radius - label.values["hole"]) < 1e-6
                and abs(2 * math.hypot(*one.stroke.centre) - drawn.values["flange_bolt_circle"])
                < 1e-6
            ]
            assert len(holes) == label.values["count"]


TOOTHED = ("rack_parallelogram", "pinion_racks", "worm_sector", "cross_cylinder")


@pytest.mark.parametrize("scheme", TOOTHED)
def test_teeth_are_drawn_by_their_tip_pitch_and_root_lines(
    draw: "Draw", smallest: Mapping[str, str], scheme: str
) -> None:
    drawn = draw(smallest[scheme])
    radii = defaultdict(set)
    for one in drawn.view.figure.seen[Face.MAIN]:
        if isinstance(one.stroke, Arc):
            radii[one.kind].add(round(one.stroke.radius, 6))
    pitch = drawn.values.get("pitch_radius", drawn.values.get("pivot_spacing", 0.0) / 2)
    module = drawn.values.get("module", pitch / 25)
    assert round(pitch + module, 6) in radii[LineKind.OUTLINE]
    assert round(pitch, 6) in radii[LineKind.CENTRE]
    assert round(pitch - 1.25 * module, 6) in radii[LineKind.THIN]


def test_a_bayonet_shank_has_its_two_lugs(
    draw: "Draw", any_variants: list[str], subtests: pytest.Subtests
) -> None:
    for any_variant in any_variants:
        with named_if_it_fails(subtests, variant=any_variant):
            drawn = draw(any_variant)
            if drawn.plan.options.get("mounting") != "bayonet":
                continue
            collar = drawn.values["bayonet_collar"]
            lugs = [
                one.stroke
                for one in drawn.view.figure.seen[Face.END]
                if isinstance(one.stroke, Arc)
                and not one.stroke.is_circle
                and one.kind is LineKind.OUTLINE
                and one.stroke.centre == (0.0, 0.0)
                and one.stroke.radius > collar / 2
            ]
            assert {round((one.low + one.high) / 2) for one in lugs} >= {90, 270}
