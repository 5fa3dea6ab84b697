"""Asking a self-check for answers comes to nothing, whoever has how much patience."""

import pytest

from gripcourse.course.model import Course
from gripcourse.policy.model import Policy, Tells
from gripcourse.simulation.asking import Asked, ask_for_answers
from gripcourse.solver.plan import default_options, make_plan, usual_values

KNOWN = 7


def asked(course: Course, policy: Policy, tells: Tells, most: int) -> Asked:
    scheme = course.schemes["rack_parallelogram"]
    plan = make_plan(course, scheme.id, default_options(scheme))
    given = {one.id: usual_values(plan)[one.id] for one in plan.givens}
    return ask_for_answers(plan, policy, given, KNOWN, most, tells)


@pytest.mark.parametrize(("tells", "most"), [(Tells.READING, 60), (Tells.SECTIONS, 15)])
def test_no_answer_is_found(course: Course, policy: Policy, tells: Tells, most: int) -> None:
    done = asked(course, policy, tells, most)
    assert done.questions == most
    assert done.found == done.known
    assert done.replies == 1  # the same is said whatever is asked: not one bit
