"""Checking a whole course at once: declarations, catalogues, policy, spaces and tables."""

from pathlib import Path

from gripcourse.course.check import check_course
from gripcourse.course.load import read_course
from gripcourse.course.model import Course
from gripcourse.course.policy_load import read_policy
from gripcourse.errors import GripcourseError, Problem
from gripcourse.variants.space import load_spaces
from gripcourse.variants.table import read_table
from gripcourse.virtual.mix import mix_path, read_mix


def all_problems(root: Path) -> list[Problem]:
    """Return every problem of a course, whatever file it is in."""
    course, problems = read_course(root)
    if course is None:
        return problems
    problems = [*problems, *check_course(course, thorough=True), *read_policy(course)[1]]
    problems += _mix_problems(course)
    # Spaces and tables are about the course: judging them against a broken one only adds noise.
    return problems or [*_space_problems(course), *_table_problems(course)]


def _mix_problems(course: Course) -> list[Problem]:
    """A course that nobody measures needs no virtual students."""
    return read_mix(course)[1] if mix_path(course.root).exists() else []


def _space_problems(course: Course) -> tuple[Problem, ...]:
    try:
        load_spaces(course)
    except GripcourseError as error:
        return error.problems
    return ()


def _table_problems(course: Course) -> list[Problem]:
    problems: list[Problem] = []
    for path in sorted((course.root / "variants" / "tables").glob("*.csv")):
        try:
            read_table(path, course)
        except GripcourseError as error:
            problems += error.problems
    return problems
