"""Mechanisms of textbook statics, solved as free bodies and compared with numbers found by hand."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.proofs.equilibrium.model import Mechanism
from gripcourse.proofs.equilibrium.places import intersection, placed
from gripcourse.proofs.equilibrium.read import FOLDER, read_mechanisms
from gripcourse.proofs.equilibrium.statics import Solution, solve

LEVER = """
bodies = ["lever"]
[point]
O = { x = "0", y = "0" }
A = { x = "-2", y = "0" }
B = { x = "3", y = "0" }
[joint]
pivot = { kind = "pin", between = ["lever", "ground"], at = "O" }
effort = { kind = "force", between = ["lever", "ground"], at = "B", direction = "-pi/2" }
[load]
weight = { on = "lever", at = "A", force = "load", direction = "-pi/2" }
"""
TOGGLE = """
bodies = ["knee"]
[let]
rise = "0.2"
[point]
K = { x = "0", y = "rise" }
L = { x = "-1", y = "0" }
R = { x = "1", y = "0" }
[joint]
left = { kind = "link", between = ["knee", "ground"], at = "K", to = "L" }
right = { kind = "link", between = ["knee", "ground"], at = "K", to = "R" }
spin = { kind = "couple", between = ["knee", "ground"] }
[load]
push = { on = "knee", at = "K", force = "load", direction = "-pi/2" }
"""
WEDGE = """
bodies = ["block", "wedge"]
[let]
slope = "pi/18"
slip = "atan(0.3)"
[point]
P = { x = "0", y = "0" }
[joint]
face = { kind = "contact", between = ["block", "wedge"], at = "P", direction = "pi/2 + slope", friction_angle = "slip" }
wall = { kind = "slider", between = ["block", "ground"], at = "P", along = "pi/2" }
floor = { kind = "slider", between = ["wedge", "ground"], at = "P", along = "0" }
push = { kind = "force", between = ["wedge", "ground"], at = "P", direction = "pi" }
[load]
weight = { on = "block", at = "P", force = "load", direction = "-pi/2" }
"""  # noqa: E501
BEAM = """
bodies = ["overhang", "beam"]
[point]
A = { x = "0", y = "0" }
B = { x = "4", y = "0" }
C = { x = "6", y = "0" }
[joint]
left = { kind = "pin", between = ["beam", "ground"], at = "A" }
right = { kind = "force", between = ["beam", "ground"], at = "B", direction = "pi/2" }
section = { kind = "weld", between = ["overhang", "beam"], at = "B" }
[load]
weight = { on = "overhang", at = "C", force = "load", direction = "-pi/2" }
"""
LADDER = """
bodies = ["ladder"]
[point]
foot = { x = "0", y = "0" }
top = { x = "3", y = "4" }
[joint]
floor = { kind = "contact", between = ["ladder", "ground"], at = "foot", direction = "pi/2", friction = "0.4" }
wall = { kind = "contact", between = ["ladder", "ground"], at = "top", direction = "pi" }
[point.middle]
x = "1.5"
y = "2"
[load]
weight = { on = "ladder", at = "middle", force = "load", direction = "-pi/2" }
"""  # noqa: E501
GEAR = """
bodies = ["wheel"]
[point]
O = { x = "0", y = "0" }
M = { x = "0", y = "-0.05" }
[joint]
shaft = { kind = "pin", between = ["wheel", "ground"], at = "O" }
teeth = { kind = "mesh", between = ["wheel", "ground"], at = "M", direction = "0", pressure_angle = "pi/9" }
[load]
torque = { on = "wheel", moment = "-0.05*load" }
"""  # noqa: E501
ROW = """
bodies = ["plate"]
[point]
C = { x = "0", y = "0" }
W = { x = "0.5", y = "0" }
[joint]
springs = { kind = "row", between = ["plate", "ground"], at = "C", direction = "pi/2", count = "4", pitch = "1" }
stay = { kind = "force", between = ["plate", "ground"], at = "C", direction = "0" }
[load]
weight = { on = "plate", at = "W", force = "load", direction = "-pi/2" }
"""  # noqa: E501
BOLTS = """
bodies = ["bracket"]
[point]
C = { x = "0", y = "0" }
W = { x = "3", y = "0" }
[joint]
bolts = { kind = "grid", between = ["bracket", "ground"], at = "C", count = "2", pitch = "1", rows = "2", row_pitch = "2" }
[load]
weight = { on = "bracket", at = "W", force = "load", direction = "-pi/2" }
"""  # noqa: E501
SHARED = """
bodies = ["beam"]
[point]
A = { x = "0", y = "0" }
B = { x = "2", y = "0" }
C = { x = "1", y = "0" }
[joint]
left = { kind = "pin", between = ["beam", "ground"], at = "A" }
right = { kind = "pin", between = ["beam", "ground"], at = "B" }
[relation]
alike = { of = { left_x = "1", right_x = "-1" }, gives = "0.2*load" }
[load]
weight = { on = "beam", at = "C", force = "load", direction = "-pi/2" }
push = { on = "beam", at = "A", force = "load", direction = "0" }
"""


def mechanism_of(course: Course, folder: Path, text: str) -> Mechanism:
    (folder / "variants" / FOLDER).mkdir(parents=True)
    (folder / "variants" / FOLDER / "one.toml").write_text(text, encoding="utf-8")
    [found], problems = read_mechanisms(replace(course, root=folder))
    assert problems == []
    return found


def solved(mechanism: Mechanism, loads: tuple[float, ...] = (100.0,)) -> Solution:
    known = placed(mechanism, "", {"load": np.array(loads)}, {})
    full = {name: np.broadcast_to(value, len(loads)) for name, value in known.items()}
    return solve(mechanism, full, {})


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        # Archimedes: 100·2 = F·3.
        pytest.param(LEVER, {"effort_force": 200 / 3, "pivot_y": 500 / 3}, id="lever"),
        # Two equal bars, each at rise 0.2 over 1: F/(2 sin θ), in compression.
        pytest.param(TOGGLE, {"left_force": -50 / np.sin(np.arctan(0.2))}, id="toggle"),
        # A block raised by a wedge whose face alone is rough: P = W·tan(α + φ).
        pytest.param(WEDGE, {"push_force": 100 * np.tan(np.pi / 18 + np.arctan(0.3))}, id="wedge"),
        # A beam on two supports 4 apart, loaded 2 beyond the right one.
        pytest.param(
            BEAM,
            {"left_y": -50, "right_force": 150, "section_moment": 200, "section_y": 100},
            id="beam with an overhang",
        ),
        # A ladder 3 out and 4 up, its weight in the middle, at a smooth wall: H = W·3/(2·4).
        pytest.param(
            LADDER,
            {"wall_normal": 37.5, "floor_normal": 100, "floor_tangent": -37.5},
            id="ladder",
        ),
        # T = F_t·r; the separating force is F_t·tan 20°.
        pytest.param(
            GEAR,
            {
                "teeth_tangent": 100,
                "teeth_normal": 100 * np.tan(np.pi / 9),
                "teeth_force": 100 / np.cos(np.pi / 9),
                "shaft_x": -100,
            },
            id="gear",
        ),
        # Equal springs at ±0.5 and ±1.5: P/n + P·e·x/Σx² = 25 + 100·0.5·1.5/5.
        pytest.param(ROW, {"springs_mean": 25, "springs_largest": 40}, id="row of springs"),
        # Four bolts at (±0.5, ±1), load 3 off: √((M·y/Σr²)² + (P/4 + M·x/Σr²)²), Σr² = 5.
        pytest.param(BOLTS, {"bolts_largest": np.hypot(60, 55)}, id="group of bolts"),
        # Two fixed hinges: a relation says what equilibrium alone leaves open.
        pytest.param(SHARED, {"left_x": -40, "right_x": -60, "left_y": 50}, id="relation"),
    ],
)
def test_a_textbook_mechanism_comes_out_as_by_hand(
    course: Course, tmp_path: Path, text: str, expected: Mapping[str, float]
) -> None:
    found = solved(mechanism_of(course, tmp_path, text))
    assert found.is_solved.all()
    assert {name: found.reactions[name][0] for name in expected} == pytest.approx(expected)


def test_many_variants_at_once_come_out_as_one_by_one(course: Course, tmp_path: Path) -> None:
    mechanism = mechanism_of(course, tmp_path, BEAM)
    together = solved(mechanism, (1.0, 20.0, 300.0)).reactions
    for place, load in enumerate((1.0, 20.0, 300.0)):
        alone = solved(mechanism, (load,)).reactions
        assert {n: v[place] for n, v in together.items()} == pytest.approx(
            {n: v[0] for n, v in alone.items()}
        )


def test_what_equilibrium_leaves_open_is_named(course: Course, tmp_path: Path) -> None:
    # A slider along the axis cannot hold what is pushed along the axis, and two carry one moment.
    text = LEVER.replace(
        'effort = { kind = "force", between = ["lever", "ground"], at = "B", direction = "-pi/2" }',
        'effort = { kind = "force", between = ["lever", "ground"], at = "O", direction = "0" }',
    )
    found = solved(mechanism_of(course, tmp_path, text))
    assert not found.is_solved.any()
    assert np.isnan(found.reactions["pivot_x"]).all()
    assert found.loose == {"pivot_x", "effort_force"}


@pytest.mark.parametrize(("side", "y"), [(1, 4.0), (-1, -4.0)])
def test_circles_meet_left_and_right_of_the_way_between_their_centres(side: int, y: float) -> None:
    start, end = (np.zeros(1), np.zeros(1)), (np.full(1, 6.0), np.zeros(1))
    found = intersection(start, end, np.full(1, 5.0), np.full(1, 5.0), side)
    assert (found[0][0], found[1][0]) == pytest.approx((3.0, y))


def test_circles_that_do_not_meet_give_no_point() -> None:
    start, end = (np.zeros(1), np.zeros(1)), (np.full(1, 9.0), np.zeros(1))
    assert np.isnan(intersection(start, end, np.ones(1), np.ones(1), 1)[0]).all()
