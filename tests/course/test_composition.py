"""What is computed alike has one key, whatever order its options are in."""

from gripcourse.course.composition import Composition
from gripcourse.solver.plan import Plan, plan_of

OPTIONS = {"mounting": "flange", "drive": "pneumatic"}


def test_the_order_of_options_makes_no_other_composition() -> None:
    turned = dict(reversed(OPTIONS.items()))
    assert {Composition.of("press", OPTIONS), Composition.of("press", turned)} == {
        Composition("press", (("drive", "pneumatic"), ("mounting", "flange")))
    }


def test_what_is_chosen_is_read_back() -> None:
    assert Composition.of("press", OPTIONS).options == OPTIONS


def test_a_plan_is_made_of_its_composition(plan: Plan) -> None:
    again = plan_of(plan.course, plan.composition)
    assert (again.composition, again.options) == (plan.composition, plan.options)
    assert list(again.options) == [option.id for option in plan.scheme.options]
