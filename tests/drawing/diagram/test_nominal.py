"""The diagram of an assignment: the type of the mechanism, from which no answer can be measured."""

from dataclasses import replace
from datetime import date
from pathlib import Path

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.documents.assignment_sheet import sheet_values
from gripcourse.drawing.diagram.nominal import nominal_values
from gripcourse.drawing.diagram.places import is_placed, stops_of
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import make_plan
from gripcourse.text.words import Words
from gripcourse.variants.model import Issued, Student, Variant
from support.issued_table import issued_table

ENGLISH = Words("en")
BELTS = Path(__file__).parents[3] / "examples" / "belt_drive"


def issued(variant: Variant) -> Issued:
    student = Student("s017", "Olena", "RT-41", "", "en", "")
    return Issued(student, variant, date(2025, 2, 10), None, "3fa912bc77aa" + "0" * 52)


def first_of_each(course: Course) -> list[Variant]:
    table = issued_table(course)
    return list({variant.scheme: variant for variant in reversed(table)}.values())


def test_two_variants_of_one_composition_have_one_picture(policy: Policy, course: Course) -> None:
    for variant in first_of_each(course)[::4]:
        plan = make_plan(course, variant.scheme, variant.options)
        larger = {name: 1.07 * value for name, value in variant.given.items()}
        first, second = (
            sheet_values(issued(one), plan, policy, course, ENGLISH)["diagram"]
            for one in (variant, replace(variant, id="900", given=larger))
        )
        assert str(first.address) == str(second.address), variant.scheme
        assert replace(first, address=second.address) == second, variant.scheme


def test_the_type_of_every_composition_can_be_drawn(course: Course) -> None:
    """Of the second course too: what an example's own option does not need has a default."""
    courses = (course, load_course(BELTS))
    faults = []
    for of, scheme in [(each, one) for each in courses for one in each.schemes.values()]:
        for options in pair_option_sets(scheme):
            plan = make_plan(of, scheme.id, options)
            assert scheme.diagram is not None
            stops = stops_of(plan, scheme.diagram, nominal_values(plan))
            if not is_placed(stops.values()):
                faults.append(f"{scheme.id} {options}")
    assert faults == []
