"""What a student reads of a wrong method: which piece of the formula, in which units."""

import pytest

from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.model import Candidate, SlipId
from gripcourse.slips.practical import practical_unit
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.text.words import LANGUAGES


def method(plan: Plan, policy: Policy, quantity: str, slip: str) -> Candidate:
    found = candidates_of(plan, quantity, policy.slips)
    return next(one for one in found if one.id == SlipId.parse(slip))


def test_a_forgotten_square_is_said_with_what_it_is_of(plan: Plan, policy: Policy) -> None:
    [said] = {
        one.hint.of("en")
        for one in candidates_of(plan, "piston_area", policy.slips)
        if str(one.id) == "power:3"
    }
    assert "computed with selected bore of the cylinder" in said
    assert said.endswith("(D) where the formula has D².")


def test_a_forgotten_root_shows_both_pieces(plan: Plan, policy: Policy) -> None:
    said = method(plan, policy, "pin_diameter_required", "power:0").hint.of("en")
    assert "4 · F_p/(π·i_τ·[τ]) where the formula has √(4 · F_p/(π·i_τ·[τ]))" in said
    assert "units" not in said


@pytest.mark.parametrize(
    ("language", "units"), [("en", "[τ] (MPa)"), ("ru", "[τ] (МПа)"), ("uk", "[τ] (МПа)")]
)
def test_who_works_in_millimetres_reads_in_which_units_the_number_comes_out(
    plan: Plan, policy: Policy, language: str, units: str
) -> None:
    """A newton is a newton in either system: only what differs is said."""
    said = method(plan, policy, "pin_diameter_required", "power:0,mm").hint.of(language)
    assert said.endswith(f": {units}.")


def test_a_square_forgotten_of_an_acceleration_is_said_in_millimetres(
    course: Course, policy: Policy
) -> None:
    """3000 mm/s² beside (9810 mm/s²)²."""
    hints = [
        one.hint.of("en")
        for scheme in course.schemes
        for one in _of_accelerations(course, scheme, policy)
    ]
    assert hints
    assert all("(mm/s²)" in one for one in hints)


def _of_accelerations(course: Course, scheme: str, policy: Policy) -> list[Candidate]:
    example = course.schemes[scheme].example
    assert example is not None
    plan = make_plan(course, scheme, example.options)
    return [
        one
        for quantity in plan.answered
        for one in candidates_of(plan, quantity.id, policy.slips)
        if one.kind == "power" and one.said.practical
        if any("acceleration" in name for name in one.said.introduced)
    ]


def test_a_quantity_is_introduced_once(plan: Plan, policy: Policy) -> None:
    """Of two methods that both name the bore the second has its symbol alone."""
    bore = method(plan, policy, "piston_area", "power:3")
    radius = method(plan, policy, "piston_area", "radius_for_diameter:bore,0.5")
    for language in LANGUAGES:
        title = plan.quantities["bore"].short_title.of(language)
        assert title in bore.hint.of(language)
        assert title in radius.hint.of(language)
        assert title not in radius.hint_after([bore]).of(language)
        assert radius.hint_after([bore]).of(language).endswith(": D.")


def test_a_term_is_called_as_a_factor_is(plan: Plan, policy: Policy) -> None:
    """By its title and symbol, where it is a quantity and no longer piece of a formula."""
    for one in candidates_of(plan, "overall_length", policy.slips):
        for name in one.said.introduced:
            assert plan.quantities[name].short_title.of("en") in one.hint.of("en")
    terms = [
        one
        for one in candidates_of(plan, "overall_length", policy.slips)
        if one.kind == "term_left_out" and one.said.introduced
    ]
    assert terms


@pytest.mark.parametrize(
    ("unit", "practical"),
    [
        ("m", "mm"),
        ("mm", "mm"),
        ("m/s**2", "mm/s**2"),
        ("m**2", "mm**2"),
        ("kN", None),
        ("s", None),
        ("deg", None),
        ("bar", "MPa"),
        ("N*m", "N*mm"),
        ("N/m", "N/mm"),
        ("kg", "t"),
        ("mm**4", "mm**4"),
        ("l/min", "mm**3/s"),
    ],
)
def test_practical_units_have_the_names_that_people_know(unit: str, practical: str | None) -> None:
    assert practical_unit(unit) == practical
