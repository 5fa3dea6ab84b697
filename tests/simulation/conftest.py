"""Cohorts of students who do not exist: a mixed one, and ones that all do the same."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeAlias

import pytest

from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.confusion import JudgedWork
from gripcourse.simulation.in_memory import judge_in_memory
from gripcourse.simulation.mix import load_mix
from gripcourse.simulation.model import Conduct, Mix, SimulatedWork
from gripcourse.simulation.student import Classroom, work_of

COUNT, SEED = 90, 5
SCHEME = "rack_parallelogram"

WhoAll: TypeAlias = Callable[..., tuple[Classroom, Sequence[SimulatedWork]]]


@pytest.fixture(scope="session")
def mix(course: Course) -> Mix:
    """The mix of the reference course."""
    return load_mix(course)


@pytest.fixture(scope="session")
def room(course: Course, policy: Policy, mix: Mix) -> Classroom:
    """A mixed cohort over all schemes."""
    return make_classroom(course, policy, mix, COUNT, SEED)


@pytest.fixture(scope="session")
def judged(room: Classroom) -> tuple[JudgedWork, ...]:
    """What the mixed cohort did, and what the grader says."""
    return judge_in_memory(room, 1)


@pytest.fixture(scope="session")
def who_all(course: Course, policy: Policy, mix: Mix) -> WhoAll:
    """Make a small cohort that all do the same: `who_all(Conduct.SLIP, count=5)`."""

    def make(
        *conducts: Conduct, count: int = 6, seed: int = 11, **changes: object
    ) -> tuple[Classroom, Sequence[SimulatedWork]]:
        same = replace(mix, conduct=dict.fromkeys(conducts, 1.0), **changes)  # type: ignore[arg-type]
        room = make_classroom(course, policy, same, count, seed, SCHEME)
        return room, [work_of(student, room) for student in room.behaviours]

    return make
