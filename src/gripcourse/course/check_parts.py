"""Checking what a scheme is put together from: parts that exist, and nothing declared twice."""

from collections.abc import Iterator, Mapping

from gripcourse.course.compose import all_part_ids, part_ids
from gripcourse.course.model import Course, Scheme
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.errors import Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message


def check_parts(course: Course, scheme: Scheme) -> Iterator[Problem]:
    """Yield the parts of a scheme that do not exist, and what two of its files declare."""
    for options in pair_option_sets(scheme):
        for part in part_ids(scheme, options):
            if part not in course.parts:
                yield Problem(
                    scheme.file,
                    "parts",
                    message("There is no part '{part}'.", part=part),
                    did_you_mean(part, course.parts),
                )
        yield from (_doubled(*one) for one in _declared_twice(course, scheme, options))


def unlike_names(course: Course, scheme: Scheme) -> frozenset[str]:
    """Return the ids that two files declare as different things.

    Whoever uses one of the two would seem to be wrong with the other.
    """
    doubled = {
        name
        for options in pair_option_sets(scheme)
        for _, name, _ in _declared_twice(course, scheme, options)
    }
    parts = (course.parts[one].quantities for one in all_part_ids(scheme) if one in course.parts)
    sorts: dict[str, set[tuple[str, bool]]] = {}
    for declared in (course.constants, *parts, scheme.quantities):
        for name in doubled & declared.keys():
            one = declared[name]
            sorts.setdefault(name, set()).add((one.unit, one.kind.answered))
    return frozenset(name for name, found in sorts.items() if len(found) > 1)


def _declared_twice(
    course: Course, scheme: Scheme, options: Mapping[str, str]
) -> Iterator[tuple[str, str, str]]:
    """Yield the later file of each id that is declared twice, the id, and the earlier file."""
    declared = dict.fromkeys(course.constants, "variants/course.toml")
    ids = (part for part in part_ids(scheme, options) if part in course.parts)
    parts = [course.parts[part] for part in ids]
    for file, own in (
        *((one.file, one.quantities) for one in parts),
        (scheme.file, scheme.quantities),
    ):
        yield from ((file, name, declared[name]) for name in own if name in declared)
        declared |= dict.fromkeys(own, file)


def _doubled(file: str, name: str, other: str) -> Problem:
    return Problem(
        file,
        f"quantity.{name}",
        message("'{name}' is declared in {file} too.", name=name, file=other),
        message(
            "Remove one of them or a part, or change single keys under [override.{name}].",
            name=name,
        ),
    )
