"""Bodies that go through one another are found, with their pair, their position and how deep."""

import tomllib
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.kinematics import read_kinematics
from gripcourse.course.model import Scheme
from gripcourse.course.toml_table import Table
from gripcourse.course.view_read import read_view
from gripcourse.drawing.view.interference import (
    Overlaps,
    PartPair,
    crossed_outlines,
    interference,
    together,
)
from gripcourse.text.words import Texts

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from gripcourse.errors import Problem

# A slide moves from 0 to 10 mm; `mm` is a length, `size` differs among the variants.
MOTION = """
drive = "path"
unit = "mm"
outputs = "1"
direction = "grows"
[at]
open = "0*mm"
closed = "10*mm"
[coordinate]
slide_x = { unit = "mm", formula = "path" }
"""
TEXTS = Texts({"en": "scheme"})


def scheme_of(view: str) -> Scheme:
    problems: list[Problem] = []
    found = read_view(
        Table(
            tomllib.loads(view if view.startswith("bodies") else f"bodies = true\n{view}"),
            "view.toml",
            "",
            problems,
        ),
        {},
    )
    motion = read_kinematics(Table(tomllib.loads(MOTION), "scheme.toml", "kinematics", problems))
    assert not problems, problems
    return Scheme(
        id="scheme",
        title=TEXTS,
        task=TEXTS,
        parts=(),
        options=(),
        own_rules=(),
        quantities={},
        overrides={},
        optional_overrides={},
        kinematics=motion,
        diagram=None,
        view=found,
        example=None,
        file="scheme.toml",
    )


def found_in(view: str, **more: float | list[float]) -> Overlaps:
    values = {name: np.array(one) / 1000 for name, one in more.items()}
    return interference(scheme_of(view), {}, {"mm": np.array(0.001), **values})


def part(name: str, shapes: str, declared: str = "") -> str:
    return f'[[part]]\nid = "{name}"\nnameless = true\n{declared}\n{shapes}\n'


def box(x: tuple[str | int, str], y: tuple[str, str], declared: str = "") -> str:
    return f'[[part.shape]]\nkind = "box"\nx = {[*x]}\ny = {[*y]}\n{declared}\n'


WALL = part("wall", box(("20*mm", "40*mm"), ("-30*mm", "30*mm")))
SLIDE = box(("slide_x", "slide_x + size"), ("-5*mm", "5*mm"))


def test_a_body_that_enters_another_is_found_with_its_depth() -> None:
    found = found_in(WALL + part("slide", SLIDE), size=[5, 12, 22])
    assert found.worst == pytest.approx([0, 2, 10], abs=1e-9)
    assert found.clear.tolist() == [True, False, False]
    assert found.of(0) is None
    worst = found.of(1)
    assert worst is not None
    assert worst.pair == PartPair("wall", "slide", "closed")
    assert {pair.position for pair in found.pairs} == {"open", "closed"}


def test_bodies_that_touch_do_not_interfere() -> None:
    found = found_in(WALL + part("slide", SLIDE), size=10)
    assert not found.pairs


def test_parts_that_meet_may_overlap() -> None:
    found = found_in(WALL + part("slide", SLIDE, 'meets = ["wall"]'), size=15)
    assert not found.pairs


def test_what_is_cut_out_of_a_body_leaves_room() -> None:
    bore = box(("20*mm", "40*mm"), ("-5*mm", "5*mm"), "void = true")
    assert not found_in(WALL + bore + part("slide", SLIDE), size=15).pairs
    narrow = box(("20*mm", "40*mm"), ("-4*mm", "4*mm"), "void = true")
    found = found_in(WALL + narrow + part("slide", SLIDE), size=15)
    assert found.worst == pytest.approx(1, abs=1e-9)


@pytest.mark.parametrize(("low", "overlaps"), [("3*mm", True), ("4*mm", False), ("8*mm", False)])
def test_bodies_at_different_depths_pass_one_another(low: str, *, overlaps: bool) -> None:
    deep = SLIDE + 'depth = [0, "4*mm"]\n'
    wall = part("wall", WALL.partition("\n\n")[2], f'depth = ["{low}", "9*mm"]')
    assert bool(found_in(wall + part("slide", deep), size=15).pairs) is overlaps


def test_what_is_only_drawn_is_no_body() -> None:
    assert not found_in(WALL + part("slide", SLIDE, "body = false"), size=15).pairs
    assert not found_in(WALL + part("slide", SLIDE + "body = false"), size=15).pairs
    assert not found_in(WALL + part("slide", SLIDE + 'face = "end"'), size=15).pairs


def test_a_part_collides_with_its_own_copy_across_the_axis() -> None:
    jaw = box((0, "10*mm"), ("size", "20*mm"))
    found = found_in(part("jaw", jaw, "mirror = true"), size=[1, -1.5])
    assert found.worst == pytest.approx([0, 3], abs=1e-9)


def test_a_part_that_is_there_in_some_positions_is_tested_in_those() -> None:
    slide = part("slide", SLIDE)
    big = part("big", box(("20*mm", "40*mm"), ("-9*mm", "9*mm")), 'positions = ["open"]')
    assert not found_in(big + slide, size=15).pairs
    assert found_in(big.replace("open", "closed") + slide, size=15).pairs


def test_a_part_may_be_placed_by_the_coordinates_of_another_position() -> None:
    follower = part("follower", box(("slide_x + 15*mm", "slide_x + 19*mm"), ("0*mm", "1*mm")))
    assert not found_in(WALL + follower.replace("nameless", 'placed_at = "open"\nnameless')).pairs
    assert found_in(WALL + follower).pairs


def test_round_bodies_overlap_by_what_both_fill() -> None:
    pin = '[[part.shape]]\nkind = "circle"\nat = ["19*mm", 0]\ndiameter = "4*mm"\n'
    assert found_in(WALL + part("pin", pin)).worst == pytest.approx(1, abs=0.01)
    bar = '[[part.shape]]\nkind = "bar"\nthrough = [["0*mm", 0], ["19*mm", 0]]\nwidth = "6*mm"\n'
    assert found_in(WALL + part("bar", bar)).worst == pytest.approx(2, abs=0.01)


def test_copies_in_a_row_and_round_a_point_are_bodies() -> None:
    row = box(("0*mm", "2*mm"), ("0*mm", "2*mm"))
    row += '[[part.shape.repeat]]\ncount = "size/mm"\nstep = ["4*mm", 0]\n'
    assert found_in(WALL + part("row", row), size=[5, 6, 10]).clear.tolist() == [True, False, False]
    ring = '[[part.shape]]\nkind = "circle"\nat = [0, "19*mm"]\ndiameter = "4*mm"\n'
    ring += '[[part.shape.repeat]]\ncount = "4"\nabout = [0, 0]\n'
    assert found_in(WALL + part("ring", ring)).worst == pytest.approx(1, abs=0.01)


def test_variants_with_different_options_are_tested_together() -> None:
    scheme = scheme_of(WALL + part("slide", SLIDE) + part("other", SLIDE.replace("size", "length")))
    groups: list[tuple[Mapping[str, NDArray[np.float64]], int]] = [
        ({"mm": np.array(0.001), "size": np.array([0.005, 0.015]), "mass": np.array(1.0)}, 2),
        ({"mm": np.array(0.001), "length": np.array([0.015])}, 1),
    ]
    values = together(scheme, groups)
    assert sorted(values) == ["length", "mm", "size"]
    found = interference(scheme, {}, values)
    assert found.clear.tolist() == [True, False, False]
    assert {pair.second for pair in found.pairs} == {"slide", "other"}


def test_an_outline_that_crosses_itself_is_named() -> None:
    corners = '[["0*mm", 0], ["4*mm", 0], ["0*mm", "size"], ["4*mm", "4*mm"]]'
    kite = f'[[part.shape]]\nkind = "polygon"\ncorners = {corners}\n'
    scheme = scheme_of(part("kite", kite))
    values = {"mm": np.array(0.001), "size": np.array([0.004, -0.004])}
    [(place, wrong)] = crossed_outlines(scheme, {}, values).items()
    assert place == ("view.toml", "part[1].shape[1]")
    assert wrong.tolist() == [True, True]


def test_a_view_that_is_a_picture_only_has_no_bodies() -> None:
    assert not found_in("bodies = false\n" + WALL + part("slide", SLIDE), size=15).pairs


def test_a_scheme_without_a_view_has_no_bodies() -> None:
    scheme = scheme_of("")
    assert not interference(scheme, {}, {"mm": np.zeros(3)}).pairs
    assert interference(scheme, {}, {"mm": np.zeros(3)}).clear.all()
