"""Checking that formulas do not run in a circle, in any composition of a scheme."""

from collections.abc import Iterator, Mapping
from graphlib import CycleError, TopologicalSorter

from gripcourse.course.compose import all_part_ids, direct_inputs
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Convention, Quantity
from gripcourse.errors import Problem
from gripcourse.text.words import message


def circular_names(course: Course, scheme: Scheme) -> tuple[str, ...]:
    """Return the ids that may stand in a circle in some composition of a scheme, sorted.

    All declarations of an id are taken together, whichever option brings them: what stands in no
    circle then stands in none at all. Mostly nothing is left, so that no composition needs a look;
    else those that declare the same of these ids are alike.
    """
    inputs = _all_inputs(course, scheme)
    left = _without_ends(inputs)
    users: dict[str, set[str]] = {name: set() for name in left}
    for name in left:
        for used in inputs[name] & left:
            users[used].add(name)
    return tuple(sorted(_without_ends(users)))


def _all_inputs(course: Course, scheme: Scheme) -> dict[str, set[str]]:
    """Return what each id is computed from in any composition and convention of a scheme."""
    inputs: dict[str, set[str]] = {}
    parts = [course.parts[part].quantities for part in all_part_ids(scheme)]
    for quantities in (*parts, scheme.quantities, *scheme.changed):
        for name, one in quantities.items():
            own = inputs.setdefault(name, set())
            for convention in Convention:
                own.update(direct_inputs(one, convention))
    return inputs


def _without_ends(graph: Mapping[str, set[str]]) -> set[str]:
    """Take away, again and again, every node that leads to none of those that are left."""
    left = set(graph)
    while True:
        inner = {name for name in left if graph[name] & left}
        if inner == left:
            return left
        left = inner


def check_graph(scheme: Scheme, quantities: Mapping[str, Quantity]) -> Iterator[Problem]:
    """Yield the first circle of a composition in each convention."""
    for convention in Convention:
        graph = {name: direct_inputs(one, convention) for name, one in quantities.items()}
        try:
            tuple(TopologicalSorter(graph).static_order())
        except CycleError as fault:
            circle = list(dict.fromkeys(reversed(fault.args[1])))
            first = min(circle)  # the same circle of another scheme shall read the same
            circle = circle[circle.index(first) :] + circle[: circle.index(first)]
            yield Problem(
                quantities[first].file if first in quantities else scheme.file,
                f"quantity.{first}.formula",
                message(
                    "The formulas run in a circle: {circle}.",
                    circle=" → ".join([*circle, circle[0]]),
                ),
                message("Express one of them without the others."),
            )
