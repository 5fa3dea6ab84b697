"""Checking a whole course at once: declarations, catalogues, policy, spaces and tables."""

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from gripcourse.course.check import check_course
from gripcourse.course.load import read_course
from gripcourse.course.model import Course
from gripcourse.errors import GripcourseError, Problem
from gripcourse.issuing.store import read_register
from gripcourse.machine.doctor import checks
from gripcourse.policy.load import load_policy, read_policy
from gripcourse.simulation.mix import mix_path, read_mix
from gripcourse.text.words import Words, message
from gripcourse.usecases.samples import samples
from gripcourse.usecases.styles import style_problems
from gripcourse.usecases.templates import filling_problems, read_templates, sample_documents
from gripcourse.variants.space import Space, load_spaces
from gripcourse.variants.table import read_table

# What every document of every course needs of a machine; its fonts are asked for by the course.
_NEEDED = ("pango", "harfbuzz-subset", "translation")


def all_problems(root: Path) -> list[Problem]:
    """Return every problem of a course, whatever file it is in, and of this machine with it."""
    course, problems = read_course(root)
    if course is None:
        return problems
    problems = [*problems, *check_course(course, thorough=True), *read_policy(course)[1]]
    problems += _mix_problems(course)
    problems += register_problems(course)
    # Spaces, tables and filled pages are about the course: judging them against a broken one only
    # adds noise.
    is_sound = not problems
    templates, words = course.root / "templates", Words(course.language)
    read, unread = read_templates(templates)
    problems += [*unread, *style_problems(templates)]
    if is_sound:
        spaces, found = _spaces(course)
        problems += [*found, *_table_problems(course)]
        for sample in islice(samples(course, load_policy(course), spaces, words), 1):
            documents, hindered = sample_documents(sample)
            problems += [*hindered, *filling_problems(documents, templates, words, read)]
    return [*problems, *_machine_problems(root)]


def _machine_problems(root: Path) -> Iterator[Problem]:
    for check in checks(root):
        if not check.ok and check.name.split()[0] in _NEEDED:
            what = message("{fault}.", fault=check.message)
            yield Problem("", check.name, what, check.remedy)


def register_problems(course: Course) -> tuple[Problem, ...]:
    """Return what is wrong with what was issued from a course."""
    try:
        read_register(course.root, course.id)
    except GripcourseError as error:
        return error.problems
    return ()


def _mix_problems(course: Course) -> list[Problem]:
    """A course that nobody measures needs no virtual students."""
    return read_mix(course)[1] if mix_path(course.root).exists() else []


def _spaces(course: Course) -> tuple[tuple[Space, ...], tuple[Problem, ...]]:
    try:
        return load_spaces(course), ()
    except GripcourseError as error:
        return (), error.problems


def _table_problems(course: Course) -> list[Problem]:
    problems: list[Problem] = []
    for path in sorted((course.root / "variants" / "tables").glob("*.csv")):
        try:
            read_table(path, course)
        except GripcourseError as error:
            problems += error.problems
    return problems
