"""The mass of plates and of bodies turned about the axis, from their outlines."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.drawing.view.mass import mass_of
from gripcourse.drawing.view.numbers import numbers_at

if TYPE_CHECKING:
    from conftest import Draw, Drawn

STEEL = 7850


def only(drawn: "Drawn", part: str) -> float:
    """The mass of one part alone."""
    view = drawn.plan.scheme.view
    assert view is not None
    alone = replace(view, parts=tuple(one for one in view.parts if one.id == part))
    mass = mass_of(drawn.plan, alone, drawn.values)
    assert mass is not None
    return mass


def length(drawn: "Drawn", name: str) -> float:
    """A quantity, a coordinate or a measure of the view, m."""
    view = drawn.plan.scheme.view
    assert view is not None
    return float(numbers_at(drawn.plan, view, drawn.values, view.position).values[name])


def test_what_lies_all_through_is_turned_about_the_axis(draw: "Draw") -> None:
    """A flange is a disc, a cylinder a tube between two covers, one of them bored for its rod."""
    drawn = draw("008")
    disc = math.pi / 4 * length(drawn, "flange_diameter") ** 2 * length(drawn, "flange_height")
    assert only(drawn, "flange") == pytest.approx(disc * STEEL)
    bore, rod, whole = (length(drawn, one) for one in ("bore", "rod", "drive_length"))
    outer, inner = (math.pi / 4 * one**2 for one in (1.2 * bore, bore))
    volume = outer * whole - inner * (whole - bore) - math.pi / 4 * rod**2 * bore / 2
    assert only(drawn, "cylinder") == pytest.approx(volume * STEEL)


def test_what_has_a_depth_is_a_plate_on_both_sides_of_the_axis(draw: "Draw") -> None:
    drawn = draw("021")
    side, low, high = (length(drawn, one) for one in ("nut_side", "jaw_y", "slide_end"))
    wall, half, tongue = (length(drawn, one) for one in ("wall", "nut_half", "tongue_side"))
    area = (2 * half + wall) * 2 * side + wall * 2 * tongue
    assert only(drawn, "nut") == pytest.approx(2 * area * (high - low) * STEEL)


def test_three_fingers_weigh_half_as_much_again_as_the_two_that_are_drawn(draw: "Draw") -> None:
    drawn = draw("003")
    view = drawn.plan.scheme.view
    assert view is not None
    two = replace(view, around=None, parts=tuple(one for one in view.parts if one.id == "lever"))
    mass = mass_of(drawn.plan, two, drawn.values)
    assert mass is not None
    assert only(drawn, "lever") == pytest.approx(1.5 * mass)


def test_a_view_without_a_density_tells_no_mass(draw: "Draw") -> None:
    drawn = draw("016")
    assert drawn.plan.scheme.view is not None
    unknown = replace(drawn.plan.scheme.view, density=0.0)
    assert mass_of(drawn.plan, unknown, drawn.values) is None


def test_round_poles_and_windings_weigh_what_round_ones_do(draw: "Draw") -> None:
    drawn = draw("016")
    core, height, coil, wide = (
        length(drawn, one)
        for one in ("core_diameter", "core_length", "coil_height", "coil_thickness")
    )
    count = 2 * length(drawn, "magnet_count")
    assert only(drawn, "core") == pytest.approx(count * math.pi / 4 * core**2 * height * STEEL)
    ring = math.pi * (core + wide) * wide * coil
    assert only(drawn, "coil") == pytest.approx(count * ring * 5000)


@pytest.mark.parametrize(
    ("elastic_modulus", "allowed", "density"),
    [(210_000, 120, 7850), (70_000, 60, 2710), (70_000, 80, 2780)],
)
def test_a_beam_weighs_what_its_material_does(
    draw: "Draw", elastic_modulus: float, allowed: float, density: float
) -> None:
    drawn = draw("016")
    material = {"elastic_modulus_beam": elastic_modulus, "bending_stress_allowed": allowed}
    drawn = replace(drawn, values={**drawn.values, **material})
    wide, high = (length(drawn, one) for one in ("beam_width", "beam_height"))
    volume = 2 * length(drawn, "beam_half") * wide * high
    assert only(drawn, "beam") == pytest.approx(volume * density)
