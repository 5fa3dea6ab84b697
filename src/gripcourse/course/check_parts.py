"""Checking what a scheme is put together from: parts that exist, and nothing declared twice."""

from collections.abc import Iterator, Mapping

from gripcourse.course.compose import all_part_ids, part_ids, used_names
from gripcourse.course.model import Course, Scheme
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.errors import Problem
from gripcourse.formula.tree import CONSTANTS
from gripcourse.text.suggestion import did_you_mean, shortened
from gripcourse.text.words import counted, message


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


def check_empty_parts(course: Course) -> Iterator[Problem]:
    """Yield the parts that declare nothing, with what their users would find in them.

    All that is computed from what is not there would be reported too.
    """
    for part in course.parts.values():
        users = [one for one in course.schemes.values() if part.id in all_part_ids(one)]
        if not (part.is_empty and users):
            continue  # a part without users is spare, whatever it says
        lacking = sorted({name for one in users for name in _names_lacking(course, one)})
        if lacking:
            what = counted(
                "The file declares nothing, and its schemes lack {count} name: {names}.",
                "The file declares nothing, and its schemes lack {count} names: {names}.",
                len(lacking),
                names=shortened(lacking),
            )
            remedy = message("Declare them here, or bring the file back as it was.")
        else:
            what = message("The file declares nothing.")
            remedy = message("Declare its quantities: [quantity.NAME]; or remove the file.")
        yield Problem(part.file, "", what, remedy)


def lacks_a_part(course: Course, scheme: Scheme) -> bool:
    """Tell whether a part of a scheme does not exist, or declares nothing."""
    used = all_part_ids(scheme)
    return any(one not in course.parts or course.parts[one].is_empty for one in used)


def _names_lacking(course: Course, scheme: Scheme) -> set[str]:
    """Return the names that formulas of a scheme use and nothing of it declares."""
    parts = [course.parts[one] for one in all_part_ids(scheme) if one in course.parts]
    declared = [*(one.quantities for one in parts), scheme.quantities]
    known = {*course.constants, *CONSTANTS}.union(*declared)
    return used_names(one for own in declared for one in own.values()) - known


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
