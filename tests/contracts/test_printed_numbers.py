"""Numbers printed in the literature, or of another method, come out of the course."""

from gripcourse.course.model import Course
from gripcourse.proofs.calculations import PrintedCalculation, prove_calculation
from gripcourse.proofs.model import Verdict
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant


def test_a_printed_number_comes_out(calculation: PrintedCalculation) -> None:
    result = prove_calculation(calculation)
    assert result.problems == ()
    assert result.verdict is Verdict.HOLDS
    assert result.compared > 0


def test_every_scheme_has_a_worked_example(course: Course) -> None:
    assert [one.id for one in course.schemes.values() if one.example is None] == []


def test_the_guide_at_its_own_gravity_and_at_the_courses(course: Course) -> None:
    example = course.schemes["rack_parallelogram"].example
    assert example is not None
    plan = make_plan(course, "rack_parallelogram", example.options)
    given = {name: value for name, value in example.given.items() if name != "gravity"}
    # the guide, section 5, and erratum 16: 3851 N with the course's own constant
    assert round(solve_variant(plan, {**given, "gravity": 10.0})["grip_force"]) == 3900
    assert round(solve_variant(plan, given)["grip_force"], 1) == 3850.6
