"""Checking the notes of a course: the schemes and quantities that they name."""

from collections.abc import Iterator
from typing import Final

from gripcourse.course.compose import all_part_ids
from gripcourse.course.model import Course, Scheme
from gripcourse.errors import Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

_FILE: Final = "variants/course.toml"


def check_notes(course: Course) -> Iterator[Problem]:
    """Yield every scheme and quantity of a note that the course does not have."""
    if not course.notes:
        return
    known = {name for scheme in course.schemes.values() for name in _declared(course, scheme)}
    for note in course.notes:
        for name in note.schemes:
            if name not in course.schemes:
                what = message("The course has no scheme '{scheme}'.", scheme=name)
                remedy = did_you_mean(name, course.schemes)
                yield Problem(_FILE, f"{note.key}.schemes", what, remedy)
        for name in note.quantities:
            if name not in known:
                what = message("There is no quantity '{name}'.", name=name)
                yield Problem(_FILE, f"{note.key}.quantities", what, did_you_mean(name, known))


def _declared(course: Course, scheme: Scheme) -> Iterator[str]:
    """Yield the quantities that some variant of a scheme has."""
    yield from scheme.quantities
    for part in all_part_ids(scheme):
        if part in course.parts:
            yield from course.parts[part].quantities
