"""The instructor's own lists in a course folder: roster and deadlines, before anybody needs them."""

from collections.abc import Collection, Iterable, Iterator

from gripcourse.course.model import Course
from gripcourse.errors import GripcourseError, Problem
from gripcourse.gradebook.deadlines import deadlines_path, people_of_deadlines, read_deadlines
from gripcourse.issuing.roster import read_roster
from gripcourse.issuing.store import read_register
from gripcourse.policy.model import Policy
from gripcourse.policy.time_rules import zone_of
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message
from gripcourse.variants.model import Student


def list_problems(course: Course, policy: Policy | None) -> list[Problem]:
    """Return all that is wrong with what was issued, the roster and the deadlines.

    Args:
        course: of the folder.
        policy: of the course; None where it cannot be read.
    """
    issued, problems = _issued(course)
    listed, found = _listed(course, issued)
    problems += found
    path = deadlines_path(course.root)
    if not path.is_file():
        return problems
    try:
        read_deadlines(path, zone_of(policy.late if policy else None))
    except GripcourseError as error:
        return [*problems, *error.problems]
    # Before anything is issued the roster says who there is; without either nobody knows.
    students = issued or listed
    return [*problems, *_nobody(path.as_posix(), people_of_deadlines(path), students)]


