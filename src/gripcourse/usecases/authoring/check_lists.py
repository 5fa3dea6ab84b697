"""The instructor's own lists in a course folder, checked before anybody needs them."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.errors import GripcourseError, Problem
from gripcourse.gradebook.deadlines import read_deadlines
from gripcourse.issuing.register_file import old_register_path
from gripcourse.issuing.roster import read_roster
from gripcourse.machine.database.home import exists, home_of
from gripcourse.machine.resources import deadlines_path
from gripcourse.policy.model import Policy
from gripcourse.policy.time_rules import zone_of
from gripcourse.variants.model import Student


def list_problems(course: Course, policy: Policy | None) -> list[Problem]:
    """Return all that is wrong with what was issued, the roster and the deadlines.

    Args:
        course: of the folder.
        policy: of the course; None where it cannot be used.
    """
    problems: list[Problem] = []
    issued, joined = _issued(course, problems)
    listed = _listed(course, issued, problems)
    path = deadlines_path(course.root)
    if path.is_file():
        zone = zone_of(policy.late if policy else None)
        # Before anything is issued the roster says who there is.
        try:
            read_deadlines(path, zone, (*issued, *joined) or listed)
        except GripcourseError as error:
            problems += _in_the_course(course, error)
    return problems


def _issued(
    course: Course, problems: list[Problem]
) -> tuple[tuple[Student, ...], tuple[Student, ...]]:
    """Return everybody of the register, and the same persons under ids that were joined."""
    if not exists(home_of(course.root)) and not old_register_path(course.root).is_file():
        return (), ()
    # 200 ms for the database that only who has issued pays.
    from gripcourse.issuing.store import read_register  # noqa: PLC0415

    try:
        register = read_register(course.root, course.id)
    except GripcourseError as error:
        problems += error.problems
        return (), ()
    return tuple(entry.student for entry in register.entries), register.joined


def _listed(
    course: Course, issued: tuple[Student, ...], problems: list[Problem]
) -> tuple[Student, ...]:
    path = course.root / "variants" / "roster.csv"
    if not path.is_file():
        return ()
    try:
        return read_roster(path, issued).students
    except GripcourseError as error:
        problems += _in_the_course(course, error)
        return ()


def _in_the_course(course: Course, error: GripcourseError) -> Iterator[Problem]:
    """Yield problems with their files as the course names all of its own."""
    for one in error.problems:
        path = Path(one.file)
        is_own = path.is_absolute() and path.is_relative_to(course.root)
        yield replace(one, file=path.relative_to(course.root).as_posix()) if is_own else one
