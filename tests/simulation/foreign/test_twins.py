"""Two mistakes that come to one number: names that nobody can tell apart."""

import ast
from types import SimpleNamespace
from typing import TYPE_CHECKING, cast

import pytest

from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.simulation.foreign.kinds import Doing, ForeignMistake, Writing
from gripcourse.simulation.foreign.model import Done, ForeignWork, Habits
from gripcourse.simulation.foreign.student import calculate
from gripcourse.simulation.foreign.twins import is_written_as, same_by_value
from gripcourse.slips.candidates import candidates_of
from gripcourse.solver.plan import make_plan

if TYPE_CHECKING:
    from gripcourse.grading.model import Report


@pytest.mark.parametrize(
    ("value", "number", "writing", "same"),
    [
        (14437.5, 14400.0, Writing.FIGURES_3, True),  # a tenth, or a digit lost
        (14437.5, 14400.0, Writing.FIGURES_5, False),
        (1344.2, 1344.0, Writing.FIGURES_4, True),
        (1344.2, 1344.0, Writing.MIXED, True),
        (float("nan"), 1.0, Writing.FIGURES_3, False),
    ],
)
def test_a_number_that_was_copied_is_one_as_it_was_written(
    value: float, number: float, writing: Writing, *, same: bool
) -> None:
    assert is_written_as(value, number, writing) is same


def test_a_mistake_of_a_blank_step_may_have_a_name_where_it_shows(
    course: Course, policy: Policy
) -> None:
    """Half of the reduced modulus is half of what twice the radius would be divided by."""
    example = course.schemes["wedge_roller"].example
    assert example is not None
    plan = make_plan(course, "wedge_roller", example.options)
    given = {one.id: example.given[one.id] for one in plan.givens}
    root, shown = "reduced_modulus", "contact_stress"
    one, other = "elastic_modulus_jaw", "elastic_modulus_object"
    tree = ast.parse(f"{one}*{other}/({one} + {other})", mode="eval").body
    habits = Habits(Writing.FIGURES_5, True, 3.141592653589793, 9.81, False, 1)
    done = Done(ForeignMistake.FACTOR, root, tree)
    calculated = calculate(plan, given, habits, done)
    work = ForeignWork(
        student="v1",
        owner="v1",
        doing=Doing.MISTAKE,
        habits=habits,
        done=done,
        reaches=frozenset({root}),
        shown=frozenset({shown}),
        decisions=frozenset(),
        calculated=calculated,
        cells={shown: calculated.typed(shown)},
        sources=(),
    )
    names = tuple(one.id for one in candidates_of(plan, shown, policy.slips))
    said = SimpleNamespace(quantity=shown, slip=names[0], tied=names[1:])
    report = cast("Report", SimpleNamespace(findings=(said,)))
    found = same_by_value(
        plan, lambda name: candidates_of(plan, name, policy.slips), given, work, report
    )
    assert {(place, str(slip)) for place, slip in found} == {
        (shown, "radius_for_diameter:reduced_radius,2")
    }
