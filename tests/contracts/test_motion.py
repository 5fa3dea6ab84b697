"""The force ratio of every scheme is the virtual work of its own links, wherever the drive stands.

The closed form of a declaration is compared with a numerical derivative of the declared position
of the jaw: the two share nothing but the geometry.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
import pytest

from gripcourse.course.kinematics import Kinematics
from gripcourse.course.model import Convention, Course
from gripcourse.solver.motion import Array, coordinates, declared_ratio, drive_at, work_ratio
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import Values, evaluate, to_si
from gripcourse.text.units import factor
from gripcourse.variants.model import Variant

STILL = {"vacuum_cups", "electromagnet"}  # nothing moves in them
# Where the coordinate of the jaw is not the face that touches the object.
NOT_THE_FACE = {"prism_lever": "it is the ridge of the prism, along the grip at the largest object"}
DRAWN = 3
PLACES = 5
STEP = 1e-3  # of the drive's path between the largest and the smallest object


@dataclass(frozen=True, slots=True)
class Case:
    """A mechanism that moves: its plan, its kinematics, and what is known of it, SI.

    Attributes:
        name: of the example or the variant.
        plan, motion: of the scheme with the options of the case.
        known: givens and decisions, frictionless where the scheme says so.
        values: of every quantity, with the friction of the case.
    """

    name: str
    plan: Plan
    motion: Kinematics
    known: Values
    values: Values


@pytest.fixture
def cases(
    course: Course, scheme_id: str, drawn_of: Callable[[str, int], tuple[Variant, ...]]
) -> tuple[Case, ...]:
    """The worked example and drawn variants of a scheme; none where nothing moves."""
    scheme = course.schemes[scheme_id]
    motion = scheme.kinematics
    if motion is None:
        return ()
    assert scheme.example is not None
    example = scheme.example
    chosen = example.chosen[Convention.CORRECTED]
    tried = [Variant("example", scheme_id, example.options, {**example.given, **chosen})]
    tried += drawn_of(scheme_id, DRAWN)
    return tuple(case(course, motion, one) for one in tried)


def case(course: Course, motion: Kinematics, variant: Variant) -> Case:
    """Solve a variant with and without friction."""
    plan = make_plan(course, variant.scheme, variant.options, Convention.CORRECTED)
    given = to_si(plan, variant.given)
    lossless = to_si(plan, {**variant.given, **motion.lossless})
    return Case(
        f"{variant.id} {dict(variant.options)}",
        plan,
        motion,
        {name: np.asarray(value) for name, value in lossless.items()},
        evaluate(plan, given).values,
    )


def places(one: Case) -> Array:
    """Return positions of the drive from the largest object to the smallest, SI."""
    values = evaluate(one.plan, one.known).values
    ends = [float(drive_at(one.motion, values, end)) for end in ("at_max", "at_min")]
    return np.linspace(*ends, PLACES)


def test_the_force_ratio_is_the_virtual_work_of_the_links(cases: tuple[Case, ...]) -> None:
    faults = []
    for one in cases:
        drive = places(one)
        step = STEP * float(drive[-1] - drive[0])
        for position in one.motion.ratio:
            declared = declared_ratio(one.plan, one.motion, one.known, position, drive)
            worked = work_ratio(one.plan, one.motion, one.known, position, drive, step)
            if not np.allclose(declared, worked, rtol=1e-6, atol=0):
                faults.append(f"{one.name} {position}: {declared} is not {worked}")
    assert faults == []


def states(one: Case) -> Iterator[tuple[str, str, str]]:
    """Yield each position with a quantity that describes it and the coordinate that gives it."""
    for position, state in one.motion.state.items():
        for quantity, coordinate in state.items():
            if quantity.endswith(f"_{position}"):  # the others are set for the ratio alone
                yield position, quantity, coordinate


def test_what_describes_a_position_are_the_coordinates_there(cases: tuple[Case, ...]) -> None:
    faults = []
    for one in cases:
        for position, quantity, coordinate in states(one):
            drive = drive_at(one.motion, one.values, position)
            found = float(coordinates(one.motion, one.values, drive)[coordinate])
            declared = float(one.values[quantity])
            if not math.isclose(found, declared, rel_tol=1e-9, abs_tol=1e-9):
                faults.append(f"{one.name} {position}: {quantity} {declared} is not {found}")
    assert faults == []


def test_jaws_close_while_the_drive_goes_on(cases: tuple[Case, ...]) -> None:
    faults = []
    for one in cases:
        stops = [float(drive_at(one.motion, one.values, position)) for position in one.motion.at]
        if not stops[0] <= stops[1] < stops[2]:
            faults.append(f"{one.name}: open, at_max, at_min at {stops}")
        drive = np.linspace(stops[0], stops[2], 50)
        if not (np.diff(coordinates(one.motion, one.values, drive)[one.motion.output]) < 0).all():
            faults.append(f"{one.name}: a jaw opens")
    assert faults == []


def test_jaws_travel_from_open_to_the_smallest_object(cases: tuple[Case, ...]) -> None:
    faults = []
    for one in cases:
        if one.plan.scheme.id in NOT_THE_FACE:
            continue
        stops = {position: drive_at(one.motion, one.values, position) for position in one.motion.at}
        jaw = {
            position: float(coordinates(one.motion, one.values, drive)[one.motion.output])
            for position, drive in stops.items()
        }
        travel = jaw["open"] - jaw["at_min"]
        if not math.isclose(travel, float(one.values["jaw_travel"]), rel_tol=1e-6):
            faults.append(f"{one.name}: the jaw travels {travel}, not {one.values['jaw_travel']}")
    assert faults == []


def test_joints_have_a_place_wherever_the_drive_stands(cases: tuple[Case, ...]) -> None:
    faults = []
    for one in cases:
        stops = [drive_at(one.motion, one.values, position) for position in one.motion.at]
        where = coordinates(one.motion, one.values, np.linspace(stops[0], stops[2], 25))
        named = {name for point in one.motion.points.values() for name in point}
        lost = [name for name in sorted(named) if not np.isfinite(where[name]).all()]
        if lost or not named:
            faults.append(f"{one.name}: {lost}")
    assert faults == []


def test_what_does_not_move_is_known(course: Course) -> None:
    assert {one.id for one in course.schemes.values() if one.kinematics is None} == STILL
    assert all(
        factor(one.kinematics.unit) > 0
        for one in course.schemes.values()
        if one.kinematics is not None
    )
