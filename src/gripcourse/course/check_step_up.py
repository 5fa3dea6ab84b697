"""Checking choices that step up: whether a size will do can be told before it is taken."""

from collections.abc import Iterator, Mapping
from graphlib import CycleError, TopologicalSorter

from gripcourse.course.quantity import Convention, Quantity
from gripcourse.course.step_up import StepUp, inputs_of, step_ups
from gripcourse.errors import Problem
from gripcourse.text.words import Message, message


def check_step_up(quantities: Mapping[str, Quantity]) -> Iterator[Problem]:
    """Yield what is wrong with the choices of a composition that step up.

    Args:
        quantities: all of the composition, whose formulas run in no circle.
    """
    for convention in Convention:
        ups = step_ups(quantities, convention)
        faults = [fault for name, up in ups.items() for fault in _faults(quantities[name], up, ups)]
        yield from faults
        if ups and not faults:
            yield from _circle(quantities, convention, ups)


def _faults(one: Quantity, up: StepUp, ups: Mapping[str, StepUp]) -> Iterator[Problem]:
    condition = None if one.choice is None else one.choice.condition
    if condition is not None and not up.between and one.id not in condition.names:
        what = message("The condition does not depend on the size: no larger one would satisfy it.")
        yield _problem(one, what, message("Write a condition on the size, or leave step_up out."))
    for other in up.between:
        if other in ups:
            what = message(
                "The condition depends on '{other}', which steps up itself and by this size.",
                other=other,
            )
            yield _problem(one, what, message("Let one of the two step up."))


def _circle(
    quantities: Mapping[str, Quantity], convention: Convention, ups: Mapping[str, StepUp]
) -> Iterator[Problem]:
    """Yield the circle in which choices wait for each other, if there is one."""
    graph = {name: inputs_of(one, convention, ups) for name, one in quantities.items()}
    try:
        tuple(TopologicalSorter(graph).static_order())
    except CycleError as fault:
        circle = list(dict.fromkeys(reversed(fault.args[1])))
        first = min(name for name in circle if name in ups)
        circle = circle[circle.index(first) :] + circle[: circle.index(first)]
        what = message(
            "To step up by the condition, a size needs what depends on it: {circle}.",
            circle=" → ".join([*circle, first]),
        )
        yield _problem(
            quantities[first], what, message("Write a condition that needs no such value.")
        )


def _problem(one: Quantity, what: Message, remedy: Message) -> Problem:
    return Problem(one.file, f"quantity.{one.id}.condition", what, remedy)
