"""Choices that step up: the reference is the smallest size that also satisfies its condition.

Whether a size will do may depend on what is computed from it. That is computed anew for each size
that is tried, and all else must be known before the first of them is.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from gripcourse.course.compose import direct_inputs
from gripcourse.course.quantity import Convention, Quantity

Inputs = Mapping[str, tuple[str, ...]]


@dataclass(frozen=True, slots=True)
class StepUp:
    """What decides whether a size of one choice will do.

    Attributes:
        between: ids of what is computed from the size on the way to the condition, in order of
            calculation.
        outside: ids that these and the condition use besides; none depends on the size.
    """

    between: tuple[str, ...]
    outside: tuple[str, ...]


def step_ups(quantities: Mapping[str, Quantity], convention: Convention) -> dict[str, StepUp]:
    """Return the choices of a composition that step up, by id, with what decides about a size.

    Args:
        quantities: all of the composition.
        convention: whose formulas count.
    """
    stepping = [name for name, one in quantities.items() if one.choice is not None and one.steps_up]
    if not stepping:
        return {}
    by_formula = {name: direct_inputs(one, convention) for name, one in quantities.items()}
    return {name: _step_up(quantities[name], by_formula) for name in stepping}


def inputs_of(
    quantity: Quantity, convention: Convention, ups: Mapping[str, StepUp]
) -> tuple[str, ...]:
    """Return the ids that the value of a quantity is computed from, each once.

    Args:
        quantity: of a composition.
        convention: whose formulas count.
        ups: the choices of the composition that step up.
    """
    inputs = direct_inputs(quantity, convention)
    up = ups.get(quantity.id)
    return inputs if up is None else tuple(dict.fromkeys((*inputs, *up.outside)))


def _step_up(quantity: Quantity, by_formula: Inputs) -> StepUp:
    condition = None if quantity.choice is None else quantity.choice.condition
    used = () if condition is None else condition.names
    between = tuple(name for name in _upstream(used, by_formula) if name != quantity.id)
    dependent = {quantity.id}
    for name in between:  # inputs come before what needs them
        if not dependent.isdisjoint(by_formula.get(name, ())):
            dependent.add(name)
    between = tuple(name for name in between if name in dependent)
    names = (*used, *(one for name in between for one in by_formula[name]))
    return StepUp(between, tuple(one for one in dict.fromkeys(names) if one not in dependent))


def _upstream(names: tuple[str, ...], by_formula: Inputs) -> tuple[str, ...]:
    """Return quantities and all that they are computed from, inputs before what needs them."""
    found: dict[str, None] = {}
    begun: set[str] = set()
    waiting = list(reversed(names))
    while waiting:
        name = waiting[-1]
        open_ = [one for one in by_formula.get(name, ()) if one not in begun]
        if name not in begun and open_:
            begun.add(name)
            waiting += reversed(open_)
            continue
        begun.add(name)
        found.setdefault(name, None)
        waiting.pop()
    return tuple(found)
