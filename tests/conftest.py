"""The reference course, loaded once, and how property tests run."""

from pathlib import Path

import pytest
from hypothesis import settings

from gripcourse.course.load import load_course
from gripcourse.course.model import Course, WorkedExample
from gripcourse.course.policy import Policy
from gripcourse.course.policy_load import load_policy
from gripcourse.solver.plan import Plan, make_plan

REPOSITORY = Path(__file__).parents[1]
SCHEME = "rack_parallelogram"

# How long an example takes says something about the machine, nothing about the code.
settings.register_profile("gripcourse", deadline=None)
settings.load_profile("gripcourse")


@pytest.fixture(scope="session")
def course() -> Course:
    """The reference course."""
    return load_course(REPOSITORY)


@pytest.fixture(scope="session")
def policy(course: Course) -> Policy:
    """The policy of the reference course."""
    return load_policy(course)


@pytest.fixture(scope="session")
def example(course: Course) -> WorkedExample:
    """The example of the guide, section 5."""
    found = course.schemes[SCHEME].example
    assert found is not None
    return found


@pytest.fixture(scope="session")
def plan(course: Course, example: WorkedExample) -> Plan:
    """The corrected calculation of the worked example."""
    return make_plan(course, SCHEME, example.options)
