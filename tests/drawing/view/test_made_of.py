"""The steel of a part follows from the stress that its variant allows; the mass counts it."""

from dataclasses import replace

import numpy as np
import pytest

from gripcourse.course.model import Course, Scheme
from gripcourse.course.view import View
from gripcourse.drawing.view.made_of import made_of
from gripcourse.drawing.view.mass import mass_of
from gripcourse.drawing.view.numbers import Numbers
from gripcourse.formula.evaluate import evaluate
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant

MEGA = 1e6
STEELS = {  # MPa, least yield stress after the handbook; written down a second time
    "steel C22": 245,
    "steel C35": 315,
    "steel C45": 340,
    "steel C45+QT": 540,
    "steel 41Cr4+QT": 750,
    "steel 66Mn4": 785,
    "steel 60Si7": 1175,
}
LIGHT_ALLOYS = {"EN AW-6060 T6": 145, "EN AW-2024 T4": 295}


def plan_of(course: Course, scheme: Scheme) -> Plan:
    """The plan of a worked example."""
    assert scheme.example is not None
    return make_plan(course, scheme.id, scheme.example.options)


def view_of(scheme: Scheme) -> View:
    """The general view of a scheme."""
    assert scheme.view is not None
    return scheme.view


def steel(course: Course, scheme_id: str, part: str, **allowed: float) -> str:
    """What the parts list names where a variant allows such stresses, MPa."""
    scheme = course.schemes[scheme_id]
    values = {name: np.asarray(one * MEGA) for name, one in allowed.items()}
    numbers = Numbers(values, plan_of(course, scheme))
    view = view_of(scheme)
    [found] = [made_of(one, view, numbers).material for one in view.parts if one.id == part]
    assert found is not None
    return found.of("en")


@pytest.mark.parametrize("allowed", [100, 120, 135, 136, 216, 252, 256, 260, 300, 314])
def test_what_a_variant_allows_a_lever_is_about_two_fifths_to_half_of_its_steels_yield_stress(
    course: Course, allowed: float
) -> None:
    named = steel(course, "link_lever_3", "lever", bending_stress_allowed=allowed)
    assert 0.39 * STEELS[named] <= allowed <= 0.5 * STEELS[named]


@pytest.mark.parametrize("allowed", [65, 68, 90, 108, 126, 130, 150])
def test_what_a_variant_allows_a_pin_is_about_a_fifth_to_three_tenths_of_its_steels_yield_stress(
    course: Course, allowed: float
) -> None:
    named = steel(course, "link_lever_3", "pin", shear_stress_allowed=allowed)
    assert 0.19 * STEELS[named] <= allowed <= 0.3 * STEELS[named]


def test_a_prism_that_is_one_with_its_finger_asks_for_its_own_strength_too(course: Course) -> None:
    allowed = {"bending_stress_allowed": 100.0, "jaw_bending_stress_allowed": 375.0}
    assert steel(course, "screw", "jaw", **allowed) == "steel 41Cr4+QT"
    assert steel(course, "screw", "jaw", bending_stress_allowed=100.0) == "steel C22"


@pytest.mark.parametrize("scheme_id", ["electromagnet", "vacuum_cups"])
@pytest.mark.parametrize(
    ("elastic_modulus", "allowed", "named"),
    [
        (210_000, 120, "steel C22"),
        (210_000, 160, "steel C45"),
        (70_000, 50, "EN AW-6060 T6"),
        (72_000, 70, "EN AW-6060 T6"),
        (70_000, 80, "EN AW-2024 T4"),
    ],
)
def test_a_beam_is_of_the_material_whose_modulus_and_stress_it_was_calculated_with(
    course: Course, scheme_id: str, elastic_modulus: float, allowed: float, named: str
) -> None:
    given = {"elastic_modulus_beam": elastic_modulus, "bending_stress_allowed": allowed}
    assert steel(course, scheme_id, "beam", **given) == named


def test_what_asks_for_no_strength_is_of_what_the_view_names(course: Course) -> None:
    assert steel(course, "screw", "body") == "steel 41Cr4"
    assert steel(course, "screw", "nut") == "bronze"


def test_the_mass_counts_the_steel_that_the_list_names(course: Course) -> None:
    scheme = course.schemes["prism_lever"]
    assert scheme.example is not None
    plan, view = plan_of(course, scheme), view_of(scheme)
    values = solve_variant(plan, scheme.example.given)
    lever = replace(view, parts=tuple(one for one in view.parts if one.id == "lever"))
    named = steel(
        course, "prism_lever", "lever", bending_stress_allowed=values["bending_stress_allowed"]
    )
    heavy = tuple(
        replace(one, density=2 * one.density) if one.material.of("en") == named else one
        for one in view.grades
    )
    usual = mass_of(plan, lever, values)
    assert usual is not None
    assert mass_of(plan, replace(lever, grades=heavy), values) == pytest.approx(2 * usual)


def test_no_row_of_a_table_may_allow_a_stress_that_no_steel_bears(course: Course) -> None:
    """Bounds refuse it with a sentence; they stand beside the givens that the views name."""
    views = [view_of(one) for one in course.schemes.values()]
    strong = [one for one in views if one.strength]
    declared = [course.schemes.values(), course.parts.values()]
    greatest = {
        one.id: np.asarray(one.bounds[1] * MEGA)
        for owners in declared
        for owner in owners
        for one in owner.quantities.values()
        if one.id in {"shear_stress_allowed", "screw_stress_allowed"} or "bending" in one.id
    }
    assert len(strong) == 17
    for view in strong:
        known = {one.material.of("en"): one.yield_stress for one in view.grades}
        assert known == STEELS | (LIGHT_ALLOYS if view.elastic_modulus else {})
        for formula in (each for asked in view.strength.values() for each in asked):
            assert evaluate(formula, "MPa", greatest, {}) <= 1175 * MEGA, formula.text
